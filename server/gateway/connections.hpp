// Every open connection: draining reaches each, and the limits of connections are kept.
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
    std::size_t reserved =
        32; // of these, for connections that have shown the token or are the own user's; at most half
    std::size_t of_address = 64; // by counting_key(); an empty key is not counted
};

// What is done to a connection from outside. Both are called from any thread, cut under a lock: they must neither block
// nor call back. They may still be called once while the ticket is being destroyed.
struct ConnectionHooks {
    std::function<void()> drain; // end soon
    std::function<void()> cut;   // end now
};

// Thread-safe. Where a place is wanted and none is free, the oldest connection is cut that is neither a WebSocket nor
// in a request that was let in; where there is none, the new one is refused.
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

        // A request's head is complete. `key`, unless empty, counts the connection for another address until the
        // request ends; false: that address has too many already.
        [[nodiscard]] bool begin_request(bool let_in, const std::string& key);
        void end_request(); // never of a WebSocket, which stays in its request

    private:
        friend class Connections;
        Ticket(Connections& connections, std::uint64_t id, bool is_refused)
            : connections_(connections), id_(id), is_refused_(is_refused) {}

        Connections& connections_;
        std::uint64_t id_;
        bool is_refused_;
    };

    // `key`: counting_key() of the peer. `needs_room`: the process is short of descriptors, so a connection must go for
    // this one. Null when it is to be closed without a word: too many are being refused already.
    [[nodiscard]] std::shared_ptr<Ticket> open(const std::string& key, bool needs_room, ConnectionHooks hooks);

    [[nodiscard]] std::size_t count() const; // all that still live
    [[nodiscard]] std::uint64_t cut_count() const;
    void drain_all();

private:
    struct Entry {
        ConnectionHooks hooks;
        std::string key;
        std::string request_key; // of the request under way
        bool is_refused = false, is_cut = false;
        bool is_let_in = false; // its last request was
        bool is_busy = false;   // a WebSocket, or in a request that was let in

        [[nodiscard]] bool counts() const { return !is_refused && !is_cut; }
    };
    using Entries = std::map<std::uint64_t, Entry>; // by age

    // REQUIRE: the lock.
    template <typename Predicate>
    [[nodiscard]] std::size_t count_if(const Predicate& holds) const;
    template <typename Predicate>
    bool cut_oldest(const Predicate& holds); // false when all that hold are busy
    [[nodiscard]] std::size_t count_of(const std::string& key) const;
    [[nodiscard]] bool make_room(const std::string& key, bool needs_room);

    const ConnectionRules rules_;
    mutable std::mutex mutex_;
    std::uint64_t next_id_ = 1, cut_count_ = 0;
    Entries entries_;
};

} // namespace ciel::gateway
