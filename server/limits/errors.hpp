// Errors with their own error code in protocol/openrpc.json. All other errors are plain Error.
#pragma once

#include "ciel/types.hpp"

namespace server::limits {

class NotFound : public ciel::Error {
public:
    using ciel::Error::Error;
};
class LimitReached : public ciel::Error {
public:
    using ciel::Error::Error;
};
class NotAllowed : public ciel::Error {
public:
    using ciel::Error::Error;
};

} // namespace server::limits
