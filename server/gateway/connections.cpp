#include "gateway/connections.hpp"

#include <utility>
#include <vector>

namespace ciel::gateway {

Connections::Ticket::Ticket(Connections& connections, std::function<void()> drain) : connections_(connections) {
    const std::lock_guard lock(connections_.mutex_);
    id_ = connections_.next_id_++;
    connections_.drains_.emplace(id_, std::move(drain));
}

Connections::Ticket::~Ticket() {
    const std::lock_guard lock(connections_.mutex_);
    connections_.drains_.erase(id_);
}

std::size_t Connections::count() const {
    const std::lock_guard lock(mutex_);
    return drains_.size();
}

void Connections::drain_all() {
    std::vector<std::function<void()>> drains;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [id, drain] : drains_) drains.push_back(drain);
    }
    for (const auto& drain : drains) drain(); // without the lock: one may end its connection, and its ticket, at once
}

} // namespace ciel::gateway
