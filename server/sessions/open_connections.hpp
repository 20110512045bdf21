// The open WebSockets of the process, for notifications.
#pragma once

#include "sessions/connection.hpp"

#include <map>
#include <mutex>

namespace server::sessions {

// All members of OpenConnections are thread-safe.
class OpenConnections {
public:
    void add(std::shared_ptr<Connection> connection) {
        const std::scoped_lock lock(mutex_);
        const auto id = connection->id;
        open_[id] = std::move(connection);
    }
    void remove(std::uint64_t id) {
        std::shared_ptr<Connection> last; // destroyed after the lock is released
        const std::scoped_lock lock(mutex_);
        if (const auto found = open_.find(id); found != open_.end()) {
            last = std::move(found->second);
            open_.erase(found);
        }
    }
    [[nodiscard]] std::shared_ptr<Connection> find(std::uint64_t id) const {
        const std::scoped_lock lock(mutex_);
        const auto found = open_.find(id);
        return found == open_.end() ? nullptr : found->second;
    }
    void send_all(const std::string& text) const {
        const std::scoped_lock lock(mutex_);
        for (const auto& [id, connection] : open_)
            if (connection->send_text) connection->send_text(text);
    }
    [[nodiscard]] std::size_t size() const {
        const std::scoped_lock lock(mutex_);
        return open_.size();
    }

private:
    mutable std::mutex mutex_;
    std::map<std::uint64_t, std::shared_ptr<Connection>> open_;
};

} // namespace server::sessions
