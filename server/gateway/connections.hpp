// Every open connection, so that draining reaches each and the limit can be kept.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>

namespace ciel::gateway {

// Thread-safe.
class Connections {
public:
    // Registers a connection as long as it lives. `drain` asks the connection to end soon, from any thread, and never
    // blocks; it may still be called once while the ticket is being destroyed.
    class Ticket {
    public:
        Ticket(Connections& connections, std::function<void()> drain);
        ~Ticket();
        Ticket(const Ticket&) = delete;
        Ticket& operator=(const Ticket&) = delete;

    private:
        Connections& connections_;
        std::uint64_t id_;
    };

    [[nodiscard]] std::size_t count() const;
    void drain_all();

private:
    mutable std::mutex mutex_;
    std::uint64_t next_id_ = 1;
    std::map<std::uint64_t, std::function<void()>> drains_;
};

} // namespace ciel::gateway
