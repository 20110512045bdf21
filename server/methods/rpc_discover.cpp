#include "methods/context.hpp"
#include "scene/schema.hpp"

namespace ciel::methods {

protocol::RpcDiscoverResult rpc_discover(Context&, const protocol::RpcDiscoverParams&) { return scene::contract(); }

} // namespace ciel::methods
