#include "engine/sessions.hpp"

#include "limits/errors.hpp"
#include "logging/log.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

namespace server::engine {
namespace {

// 128 random bits, because a client that guesses the id of a session may change the scene.
std::string random_id() {
    static constexpr char digits[] = "0123456789abcdef";
    std::random_device source;
    std::string id;
    for (int word = 0; word < 4; ++word)
        for (auto [bits, i] = std::pair{source(), 0}; i < 8; ++i, bits >>= 4) id += digits[bits & 15];
    return id;
}

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

void tell_closed(const OpenSession& session, const char* why, const OpenSession::LoggedCall& by) {
    logging::log_event(logging::LogLevel::info, "session closed",
                       {{"session", logging::short_id(session.id())},
                        {"why", why},
                        {"seconds", seconds_since(session.opened())},
                        {"request", by.request},
                        {"user", by.user},
                        {"remote", by.remote}});
}

// The line names the call that opened the session, because the server ended it.
void tell_closed(const OpenSession& session, const char* why) { tell_closed(session, why, session.opener()); }

OpenSession::LoggedCall logged(const Caller& by) { return {by.connection.user, by.connection.remote, by.request}; }

} // namespace

std::shared_ptr<OpenSession> Sessions::find(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const auto found = sessions_.find(id);
    if (found == sessions_.end())
        throw limits::NotFound("there is no session " + logging::short_id(id) + "...; open one with session.open");
    return found->second;
}

std::shared_ptr<OpenSession> Sessions::open(const std::string& id, const std::function<nlohmann::json()>& document,
                                            const Caller& by, const sessions::UndoRedoSteps& steps) {
    const auto begun = Clock::now();
    const auto check = [&] { // requires mutex_ to be held
        if (stopped_)
            throw limits::LimitReached(
                "the server is about to stop and opens no new sessions; try again after its restart");
        if (sessions_.size() >= services_.limits.sessions && !drop_longest_left())
            throw limits::LimitReached("the server already has " + std::to_string(sessions_.size()) +
                                       " sessions, which is its limit; close a session first");
    };
    expire(Clock::now());
    {
        const std::scoped_lock lock(mutex_);
        if (const auto found = sessions_.find(id); found != sessions_.end()) return found->second;
        check();
    }
    // The scene is checked without the lock, because this may open a dataset and take long.
    auto first = sessions::accept_scene(services_, document(), 1, by.request);
    const std::scoped_lock lock(mutex_);
    if (const auto found = sessions_.find(id); found != sessions_.end()) return found->second;
    check();
    const std::string name = id.empty() ? random_id() : id;
    auto session = std::make_shared<OpenSession>(name, services_, std::move(first), logged(by), steps);
    sessions_[name] = session;
    logging::log_event(logging::LogLevel::info, "session opened",
                       {{"session", logging::short_id(name)},
                        {"dataset", session->newest()->scene().dataset},
                        {"request", by.request},
                        {"user", by.connection.user},
                        {"remote", by.connection.remote},
                        {"ms", 1000 * seconds_since(begun)}});
    return session;
}

// Drops the session that has been unused for the longest time, among those without a connection. Returns false if every
// session has a connection. The client of a dropped session sends its scene again.
bool Sessions::drop_longest_left() {
    auto longest = sessions_.end();
    for (auto entry = sessions_.begin(); entry != sessions_.end(); ++entry)
        if (entry->second->is_idle_since(Clock::time_point::max()) &&
            (longest == sessions_.end() || entry->second->last_used() < longest->second->last_used()))
            longest = entry;
    if (longest == sessions_.end()) return false;
    tell_closed(*longest->second, "the limit on sessions");
    sessions_.erase(longest);
    return true;
}

void Sessions::close(const std::string& id, const Caller& by) {
    const auto session = find(id);
    session->close();
    const std::scoped_lock lock(mutex_);
    if (sessions_.erase(id) > 0) tell_closed(*session, "by a client", logged(by));
}

std::shared_ptr<View> Sessions::open_view(OpenSession& session, const std::shared_ptr<sessions::Connection>& connection,
                                          geometry::ViewSize size, Stream stream, wire::MovingCodec moving) {
    const auto shared = find(session.id());
    std::uint32_t id = 0;
    {
        const std::scoped_lock lock(mutex_);
        if (stopped_)
            throw limits::LimitReached(
                "the server is about to stop and opens no new views; try again after its restart");
        id = ++last_view_;
    }
    auto view = std::make_shared<View>(id, shared, connection, services_, size, stream, moving);
    shared->subscribe(connection->id);
    shared->add_viewer(
        id, {connection->id, [view](auto version) { view->offer(std::move(version)); }, [view] { view->close(); }});
    const std::scoped_lock lock(mutex_);
    std::erase_if(views_, [](const auto& entry) { return entry.second.expired(); });
    views_[id] = view;
    return view;
}

std::shared_ptr<View> Sessions::view(std::uint32_t id, std::uint64_t connection) {
    const std::scoped_lock lock(mutex_);
    const auto found = views_.find(id);
    auto view = found == views_.end() ? nullptr : found->second.lock();
    if (!view || view->connection_id() != connection)
        throw limits::NotFound("this connection has no view " + std::to_string(id) + "; open one with view.open");
    return view;
}

void Sessions::close_view(std::uint32_t id, std::uint64_t connection) {
    const auto closing = view(id, connection);
    closing->session().remove_viewer(id);
    const std::scoped_lock lock(mutex_);
    views_.erase(id);
}

void Sessions::connection_closed(std::uint64_t connection) {
    for (const auto& session : all()) {
        session->disconnect(connection);
        // A worker frees the surfaces, because a running extraction may lock the geometry for a while. post_later() is
        // used, because a still picture would give way to a job of post().
        if (session->is_idle_since(Clock::time_point::max()))
            services_.workers.post_later(Clock::now(), [session](Worker&) {
                if (session->is_idle_since(Clock::time_point::max())) session->release_geometry();
            });
    }
}

void Sessions::connection_has_room(std::uint64_t connection) {
    std::vector<std::shared_ptr<View>> waiting;
    {
        const std::scoped_lock lock(mutex_);
        for (const auto& [id, weak] : views_)
            if (auto view = weak.lock(); view && view->connection_id() == connection)
                waiting.push_back(std::move(view));
    }
    for (const auto& view : waiting) view->look_again();
}

void Sessions::dataset_changed(const std::string& dataset) {
    for (const auto& session : all())
        if (session->newest()->scene().dataset == dataset) session->dataset_changed();
}

void Sessions::expire(Clock::time_point now) {
    const std::scoped_lock lock(mutex_);
    const auto limit = now - std::chrono::seconds(services_.limits.session_idle_seconds);
    std::erase_if(sessions_, [&](const auto& entry) {
        if (!entry.second->is_idle_since(limit)) return false;
        tell_closed(*entry.second, "idle");
        return true;
    });
}

void Sessions::release_geometry(Clock::time_point unused_since) {
    for (const auto& session : all()) session->release_idle_geometry(unused_since);
}

void Sessions::make_room() {
    const std::uint64_t wanted = services_.memory.most() / 4;
    if (services_.memory.room() >= wanted) return;
    std::vector<std::pair<Clock::time_point, std::shared_ptr<OpenSession>>> longest_unused_first;
    for (auto& session : all()) longest_unused_first.emplace_back(session->last_used(), std::move(session));
    std::ranges::sort(longest_unused_first, {}, [](const auto& entry) { return entry.first; });
    for (const auto& [used, session] : longest_unused_first) {
        session->release_idle_geometry(Clock::time_point::max());
        if (services_.memory.room() >= wanted) return;
    }
}

void Sessions::stop_opening() {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
}

void Sessions::close_all() {
    for (const auto& session : all()) {
        session->close();
        tell_closed(*session, "the server stops");
    }
    const std::scoped_lock lock(mutex_);
    sessions_.clear();
    views_.clear();
}

std::vector<std::shared_ptr<OpenSession>> Sessions::all() const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::shared_ptr<OpenSession>> list;
    for (const auto& [id, session] : sessions_) list.push_back(session);
    return list;
}

} // namespace server::engine
