// Errors with their own code in the contract. All others are plain Error.
#pragma once

#include "ciel/types.hpp"

namespace ciel::limits {

class NotFound : public Error {
public:
    using Error::Error;
};
class LimitReached : public Error {
public:
    using Error::Error;
};
class NotAllowed : public Error {
public:
    using Error::Error;
};

} // namespace ciel::limits
