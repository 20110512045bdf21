#include "gateway/context.hpp"

#include "gateway/target.hpp"

namespace ciel::gateway {

Context::Context(session::Server& server_, const GatewayOptions& options, AccessRules access_)
    : server(server_), prefix(normal_prefix(options.prefix)), version(options.version), access(std::move(access_)),
      files(options.webclient.empty() ? StaticFiles() : StaticFiles(options.webclient)) {}

session::Readiness ReadinessProbe::check(session::Server& server) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return server.last_readiness();
    if (!checked_ || std::chrono::steady_clock::now() - *checked_ > std::chrono::seconds(1)) {
        last_ = server.readiness();
        checked_ = std::chrono::steady_clock::now();
    }
    return last_;
}

} // namespace ciel::gateway
