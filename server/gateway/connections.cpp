#include "gateway/connections.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace server::gateway {
Connections::Ticket::~Ticket() {
    const std::lock_guard lock(connections_.mutex_);
    connections_.entries_.erase(id_);
}

bool Connections::Ticket::begin_request(bool let_in, const std::string& key) {
    const std::lock_guard lock(connections_.mutex_);
    Entry& entry = connections_.entries_.at(id_);
    const bool has_room = key.empty() || connections_.count_of(key) < connections_.rules_.of_address;
    entry.is_let_in = let_in && has_room;
    entry.is_busy = entry.is_let_in;
    if (has_room) entry.request_key = key;
    return has_room;
}

void Connections::Ticket::end_request() {
    const std::lock_guard lock(connections_.mutex_);
    Entry& entry = connections_.entries_.at(id_);
    entry.is_busy = false;
    entry.request_key.clear();
}

template <typename Predicate>
std::size_t Connections::count_if(const Predicate& holds) const {
    return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), [&](const auto& each) {
        return each.second.counts() && holds(each.second);
    }));
}

template <typename Predicate>
bool Connections::cut_oldest(const Predicate& holds) {
    const auto oldest = std::find_if(entries_.begin(), entries_.end(), [&](const auto& each) {
        return each.second.counts() && !each.second.is_busy && holds(each.second);
    });
    if (oldest == entries_.end()) return false;
    oldest->second.is_cut = true;
    ++cut_count_;
    oldest->second.hooks.cut();
    return true;
}

std::size_t Connections::count_of(const std::string& key) const {
    return count_if([&](const Entry& entry) { return entry.key == key || entry.request_key == key; });
}

bool Connections::make_room(const std::string& key, bool needs_room) {
    const auto any = [](const Entry&) { return true; };
    const auto same_key = [&](const Entry& entry) { return entry.key == key; };
    const auto unknown = [](const Entry& entry) { return !entry.is_let_in; };
    if (!key.empty() && count_of(key) >= rules_.of_address && !cut_oldest(same_key)) return false;
    const std::size_t reserved = std::min(rules_.reserved, rules_.most / 2);
    if (count_if(unknown) >= rules_.most - reserved) return cut_oldest(unknown);
    if (needs_room || count_if(any) >= rules_.most) return cut_oldest(any);
    return true;
}

std::shared_ptr<Connections::Ticket> Connections::open(const std::string& key, bool needs_room, ConnectionHooks hooks) {
    const std::lock_guard lock(mutex_);
    Entry entry;
    entry.hooks = std::move(hooks);
    entry.key = key;
    entry.is_refused = !make_room(key, needs_room);
    const auto refused =
        std::count_if(entries_.begin(), entries_.end(), [](const auto& each) { return each.second.is_refused; });
    if (entry.is_refused && (needs_room || static_cast<std::size_t>(refused) >= rules_.refused)) return nullptr;
    std::shared_ptr<Ticket> ticket(new Ticket(*this, next_id_, entry.is_refused));
    entries_.emplace(next_id_++, std::move(entry));
    return ticket;
}

std::size_t Connections::count() const {
    const std::lock_guard lock(mutex_);
    return entries_.size();
}

std::uint64_t Connections::cut_count() const {
    const std::lock_guard lock(mutex_);
    return cut_count_;
}

void Connections::drain_all() {
    std::vector<std::function<void()>> drains;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [id, entry] : entries_) drains.push_back(entry.hooks.drain);
    }
    // Called without the lock, because `drain` may destroy the ticket, and the destructor of the ticket locks mutex_.
    for (const auto& drain : drains) drain();
}

} // namespace server::gateway
