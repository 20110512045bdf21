// Errors with their own error code in protocol/openrpc.json. All other errors are plain Error.
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
