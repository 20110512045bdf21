#include "methods/call_context.hpp"
#include "scene/contract.hpp"

namespace server::methods {

protocol::RpcDiscoverResult rpc_discover(CallContext&, const protocol::RpcDiscoverParams&) { return scene::contract(); }

} // namespace server::methods
