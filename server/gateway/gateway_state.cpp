#include "gateway/gateway_state.hpp"

#include "gateway/target.hpp"

#include <algorithm>
#include <pwd.h>
#include <sys/resource.h>
#include <unistd.h>

namespace server::gateway {
namespace {

constexpr rlim_t enough_files = 65536; // with a higher limit, child programs that close all descriptors would be slow

ConnectionRules rules_of(const limits::Limits& limits) {
    return {limits.connections, limits.reserved_connections, limits.connections_of_address, limits.refused_connections};
}

std::string own_user_name() {
    std::array<char, 4096> text;
    passwd entry{};
    passwd* found = nullptr;
    if (::getpwuid_r(::geteuid(), &entry, text.data(), text.size(), &found) == 0 && found != nullptr)
        return found->pw_name;
    return std::to_string(::geteuid());
}

std::size_t raised_file_limit() {
    rlimit files{};
    ::getrlimit(RLIMIT_NOFILE, &files);
    if (files.rlim_cur < enough_files && files.rlim_cur < files.rlim_max) {
        files.rlim_cur = std::min(files.rlim_max, enough_files);
        ::setrlimit(RLIMIT_NOFILE, &files);
    }
    return files.rlim_cur;
}

} // namespace

GatewayState::GatewayState(Service& service_, const GatewayOptions& options, AccessRules access_)
    : service(service_), prefix(normal_prefix(options.prefix)), version(options.version), own_user(own_user_name()),
      access(std::move(access_)), files(options.webclient.empty() ? StaticFiles() : StaticFiles(options.webclient)),
      connections(rules_of(service_.limits())), proxies(options.trusted_proxies), most_files(raised_file_limit()) {}

} // namespace server::gateway
