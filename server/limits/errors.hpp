// Errors that a client can tell apart (the contract has a code for each); any other is an Error.
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
