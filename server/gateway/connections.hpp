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
    // How many of `most` connections are kept for authorized ones (token or own user); at most half of `most`.
    std::size_t reserved = 32;
    std::size_t of_address = 64; // most connections per counting_key(); connections with an empty key are not counted
    std::size_t refused = 32;    // most refused connections that are open at once; further ones get no answer
};

// Callbacks of one connection, called from any thread. They must not block or call Connections: `cut` is called with
// its mutex locked. Each can still be called once while the ticket is being destroyed, and `drain` shortly afterwards,
// too.
struct ConnectionHooks {
    std::function<void()> drain; // asks the connection to end soon
    std::function<void()> cut;   // closes the connection at once
};

// Connections is thread-safe. At a limit, Connections closes the oldest connection that counts for this limit, to make
// room for a new one. It never closes a WebSocket or a connection in an authorized request. If only these are left, it
// refuses the new connection.
class Connections {
    struct Entry;

public:
    explicit Connections(const ConnectionRules& rules = {}) : rules_(rules) {}

    // Keeps its connection registered until the ticket is destroyed.
    class Ticket {
    public:
        ~Ticket();
        Ticket(const Ticket&) = delete;
        Ticket& operator=(const Ticket&) = delete;

        [[nodiscard]] bool is_refused() const { return is_refused_; } // true: to be answered with 503 and closed

        // Call when the head of a request is complete. `let_in`: the request is authorized, so the connection is not
        // closed for another one. `key`: counting_key() of a client behind a proxy; if it is not empty, the connection
        // counts for that client, too, until the request ends. Returns false if the client is at its limit.
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

    // Registers a connection. `key`: counting_key() of the peer. `needs_room`: file descriptors are short, so another
    // connection must be closed. Returns null if the connection must be closed without an answer: it is refused, and
    // either needs_room is set, or ConnectionRules::refused other refused connections are still open.
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
        bool is_let_in = false; // the latest request was authorized
        bool is_busy = false;   // is a WebSocket, or has an authorized request in progress

        [[nodiscard]] bool counts() const { return !is_refused && !is_cut; }
    };
    using Entries = std::map<std::uint64_t, Entry>; // by ascending id: the oldest connection first

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

} // namespace ciel::gateway
