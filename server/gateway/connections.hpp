// Registry of open connections. Enforces the connection limits and drains all connections.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace server::gateway {

struct ConnectionRules {
    std::size_t most = 128;
    // This many of the `most` connections are reserved for authorized connections, but at most half of `most`.
    std::size_t reserved = 32;
    std::size_t of_address = 64; // most connections with the same counting_key(); an empty key has no limit
    std::size_t refused = 32;    // most refused connections open at once; further refused connections get no answer
};

// The hooks are called from any thread. They must not block or call Connections, because `cut` runs while the mutex of
// Connections is locked. While the ticket is being destroyed, each hook may still be called once. `drain` may also be
// called shortly afterwards.
struct ConnectionHooks {
    std::function<void()> drain; // asks the connection to end soon
    std::function<void()> cut;   // closes the connection at once
};

// Thread-safe. At a limit, closes the oldest connection that is counted for this limit, but never a WebSocket or a
// connection with an authorized request in progress. If no connection can be closed, refuses the new connection.
class Connections {
    struct Entry;

public:
    explicit Connections(const ConnectionRules& rules = {}) : rules_(rules) {}

    // The connection stays registered until its ticket is destroyed.
    class Ticket {
    public:
        ~Ticket();
        Ticket(const Ticket&) = delete;
        Ticket& operator=(const Ticket&) = delete;

        [[nodiscard]] bool is_refused() const { return is_refused_; } // if true, answer 503 and close

        // Call this when the head of a request is complete. `let_in`: whether the request is authorized; then the
        // connection is not closed to make room. `key`: counting_key() of a client behind a proxy, else empty; the
        // client is counted until the request ends. Returns false if the client is at its limit.
        [[nodiscard]] bool begin_request(bool let_in, const std::string& key);
        void end_request(); // for a WebSocket: call it when the WebSocket has closed

    private:
        friend class Connections;
        Ticket(Connections& connections, std::uint64_t id, bool is_refused)
            : connections_(connections), id_(id), is_refused_(is_refused) {}

        Connections& connections_;
        std::uint64_t id_;
        bool is_refused_;
    };

    // `key`: counting_key() of the peer. `needs_room`: another connection must be closed, because file descriptors are
    // short. A refused connection gets a ticket with is_refused(). Returns null if a refused connection must be closed
    // without an answer: `needs_room` is true, or ConnectionRules::refused other refused connections are open.
    [[nodiscard]] std::shared_ptr<Ticket> open(const std::string& key, bool needs_room, ConnectionHooks hooks);

    [[nodiscard]] std::size_t count() const; // including refused and closed connections that have not ended yet
    [[nodiscard]] std::uint64_t cut_count() const;
    void drain_all();

private:
    struct Entry {
        ConnectionHooks hooks;
        std::string key;
        std::string request_key; // key of begin_request(); empty between requests
        bool is_refused = false, is_cut = false;
        bool is_let_in = false; // whether the latest request was authorized
        bool is_busy = false;   // whether it is a WebSocket or has an authorized request in progress

        [[nodiscard]] bool counts() const { return !is_refused && !is_cut; }
    };
    using Entries = std::map<std::uint64_t, Entry>; // by ascending id, so that the oldest connection is first

    // The functions below require mutex_ to be held.
    template <typename Predicate>
    [[nodiscard]] std::size_t count_if(const Predicate& holds) const;
    template <typename Predicate>
    bool cut_oldest(const Predicate& holds); // returns false if all matching connections are busy
    [[nodiscard]] std::size_t count_of(const std::string& key) const;
    [[nodiscard]] bool make_room(const std::string& key, bool needs_room);

    const ConnectionRules rules_;
    mutable std::mutex mutex_;
    std::uint64_t next_id_ = 1, cut_count_ = 0;
    Entries entries_;
};

} // namespace server::gateway
