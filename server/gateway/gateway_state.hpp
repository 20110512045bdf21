// State shared by all connections and routes.
#pragma once

#include "gateway/access.hpp"
#include "gateway/asio.hpp"
#include "gateway/connections.hpp"
#include "gateway/peer_owner.hpp"
#include "gateway/remote_address.hpp"
#include "gateway/service.hpp"
#include "gateway/static_files.hpp"
#include "logging/log_limiter.hpp"

#include <array>
#include <atomic>

namespace server::gateway {

struct Counters { // values that GET /metrics shows
    std::atomic<std::uint64_t> connections{0}, refused_connections{0}, websockets_open{0};
    std::array<std::atomic<std::uint64_t>, 6> responses{}; // HTTP responses, by status / 100
    std::atomic<std::uint64_t> texts_received{0}, texts_sent{0}, frames_sent{0}, frames_dropped{0}, bytes_sent{0};
};

struct GatewayState {
    GatewayState(Service& service_, const GatewayOptions& options, AccessRules access_);

    Service& service;
    std::string prefix, version, own_user; // own_user: name of the process's user
    AccessRules access;
    StaticFiles files;
    Counters counters;
    Connections connections;
    TrustedProxies proxies;
    std::size_t most_files; // file descriptor limit of the process
    logging::LogLimiter log_limiter;
    PeerOwners owners;
    asio::thread_pool probe_thread{1};             // answers /readyz and /metrics even while all workers are busy
    std::atomic<std::uint64_t> guesses_waiting{0}; // number of delayed answers to wrong tokens
    std::atomic<bool> draining{false};
    std::atomic<std::uint64_t> next_connection_id{1};
};

} // namespace server::gateway
