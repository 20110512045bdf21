// A session: one scene with its history, kept between connections and shared by any number of them.
#pragma once

#include "sessions/history.hpp"
#include "sessions/services.hpp"
#include "sessions/version.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace ciel::sessions {

struct SessionStatus {
    std::shared_ptr<const SceneVersion> version;
    bool can_undo = false, can_redo = false;
};

// Undo and redo steps of a new session: merge patches, nearest step first (session.open in the contract).
struct Steps {
    std::vector<nlohmann::json> undo, redo;
};

// A view of the session's scene. Both callbacks run under the session's lock and must not call the session.
struct Viewer {
    std::uint64_t connection = 0;
    std::function<void(std::shared_ptr<const SceneVersion>)> offer; // the newest version
    std::function<void()> close;                                    // the last call
};

// Thread-safe. Changes are applied in order. A change of the document makes a new revision, which is sent to the other
// subscribed connections and offered to all viewers.
class Session {
public:
    // Drops steps beyond the limits. Throws LimitReached when there is no memory for the documents.
    Session(std::string id, const Services& services, std::shared_ptr<const SceneVersion> first,
            const Steps& steps = {});

    [[nodiscard]] const std::string& id() const { return id_; }
    [[nodiscard]] Clock::time_point opened() const { return opened_; }
    [[nodiscard]] SessionStatus status() const; // counts as use
    [[nodiscard]] std::shared_ptr<const SceneVersion> newest() const;
    // `author`: connection that made the change; it gets the answer instead of a notification. Throw as make_version
    // does, and LimitReached; then nothing has changed.
    SessionStatus patch(const nlohmann::json& merge_patch, const std::string& gesture, std::uint64_t author);
    SessionStatus replace(nlohmann::json document, std::uint64_t author);
    SessionStatus undo(std::uint64_t author); // returns the current status if there is nothing to undo
    SessionStatus redo(std::uint64_t author);

    void subscribe(std::uint64_t connection);
    void add_viewer(std::uint32_t id, Viewer viewer); // throws LimitReached; it is offered the newest version
    void remove_viewer(std::uint32_t id);
    void disconnect(std::uint64_t connection); // its viewers and its subscription
    void close();                              // all viewers
    void dataset_changed();                    // it has grown or was replaced: offers the same scene again

    [[nodiscard]] bool is_idle_since(Clock::time_point time) const; // no connection, and not used since `time`
    [[nodiscard]] Clock::time_point last_used() const;
    [[nodiscard]] std::size_t viewer_count() const;

private:
    SessionStatus move_in_history(Document (History::*move)(Document), std::uint64_t author);
    // The next three REQUIRE the lock. change: throws LimitReached and then changes nothing.
    SessionStatus change(std::shared_ptr<const SceneVersion> next, History after, std::uint64_t author);
    void tell_others(std::uint64_t author) const;
    [[nodiscard]] SessionStatus current() const;

    const std::string id_;
    const Services& services_;
    const Clock::time_point opened_ = Clock::now();

    mutable std::mutex mutex_;
    std::shared_ptr<const SceneVersion> version_;
    History history_;
    limits::Memory::Charge documents_;
    std::set<std::uint64_t> subscribers_;
    std::map<std::uint32_t, Viewer> viewers_;
    mutable Clock::time_point used_;
};

} // namespace ciel::sessions
