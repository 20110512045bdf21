// Registry of open connections. Enforces the connection limits and drains all connections.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace ciel::gateway {

struct ConnectionRules {
    std::size_t most = 128;
    std::size_t reserved = 32;   // of these, for authorized connections (token or own user); at most half
    std::size_t of_address = 64; // per counting_key(); an empty key is not counted
};

// Called from any thread, cut with the registry locked: neither may block or call back. Both may still be called once
// during the ticket's destruction.
struct ConnectionHooks {
    std::function<void()> drain; // end soon
    std::function<void()> cut;   // end now
};

// Thread-safe. At a limit, a new connection closes the oldest one that may be closed. WebSockets and connections in an
// authorized request are never closed. If none may be closed, the new connection is refused.
class Connections {
    struct Entry;

public:
    explicit Connections(const ConnectionRules& rules = {}) : rules_(rules) {}

    // Registers a connection as long as it lives.
    class Ticket {
    public:
        ~Ticket();
        Ticket(const Ticket&) = delete;
        Ticket& operator=(const Ticket&) = delete;

        [[nodiscard]] bool is_refused() const { return is_refused_; } // it gets a refusal and is closed

        // Call when a request's head is complete. A `key` that is not empty also counts the connection for that
        // address until the request ends. Returns false if the address is at its limit.
        [[nodiscard]] bool begin_request(bool let_in, const std::string& key);
        void end_request(); // never called for a WebSocket: its request stays open

    private:
        friend class Connections;
        Ticket(Connections& connections, std::uint64_t id, bool is_refused)
            : connections_(connections), id_(id), is_refused_(is_refused) {}

        Connections& connections_;
        std::uint64_t id_;
        bool is_refused_;
    };

    // `key`: counting_key() of the peer. `needs_room`: file descriptors are short, so another connection must be cut.
    // Returns null if the connection must be closed without an answer: 32 refusals are pending, or needs_room.
    [[nodiscard]] std::shared_ptr<Ticket> open(const std::string& key, bool needs_room, ConnectionHooks hooks);

    [[nodiscard]] std::size_t count() const; // including refused and cut ones that have not ended
    [[nodiscard]] std::uint64_t cut_count() const;
    void drain_all();

private:
    struct Entry {
        ConnectionHooks hooks;
        std::string key;
        std::string request_key; // of the current request
        bool is_refused = false, is_cut = false;
        bool is_let_in = false; // the last request was authorized
        bool is_busy = false;   // a WebSocket, or in an authorized request

        [[nodiscard]] bool counts() const { return !is_refused && !is_cut; }
    };
    using Entries = std::map<std::uint64_t, Entry>; // by age

    // REQUIRE: the lock.
    template <typename Predicate>
    [[nodiscard]] std::size_t count_if(const Predicate& holds) const;
    template <typename Predicate>
    bool cut_oldest(const Predicate& holds); // false if all matching ones are busy
    [[nodiscard]] std::size_t count_of(const std::string& key) const;
    [[nodiscard]] bool make_room(const std::string& key, bool needs_room);

    const ConnectionRules rules_;
    mutable std::mutex mutex_;
    std::uint64_t next_id_ = 1, cut_count_ = 0;
    Entries entries_;
};

} // namespace ciel::gateway
