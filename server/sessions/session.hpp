// A session is one scene with its history. It is kept between connections, and any number of connections may share it.
#pragma once

#include "sessions/accept_scene.hpp"
#include "sessions/history.hpp"
#include "sessions/session_services.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace server::sessions {

struct SessionStatus {
    std::shared_ptr<const SceneVersion> version;
    bool can_undo = false, can_redo = false;
};

// A history that a client gives to a new session, as merge patches. The first step of each list is the step next to the
// scene (session.open in the contract).
struct UndoRedoSteps {
    std::vector<nlohmann::json> undo, redo;
};

// Both callbacks are called while the session is locked, and must not call the session.
struct Viewer {
    std::uint64_t connection = 0;
    std::function<void(std::shared_ptr<const SceneVersion>)> offer; // gives the newest version to the view
    std::function<void()> close;                                    // closes the view; called last
};

struct Author {
    std::uint64_t connection = 0; // the connection that made the change, which gets no notification
    std::string request;          // id of the request that made the change
};

// Thread-safe. A change makes a new revision. The revision is sent to all subscribers except its author, and offered to
// all viewers.
class Session {
public:
    // Drops `steps` beyond the history's limits. Throws LimitReached if there is no memory for the documents.
    Session(std::string id, const SessionServices& services, std::shared_ptr<const SceneVersion> first,
            const UndoRedoSteps& steps = {});

    [[nodiscard]] const std::string& id() const { return id_; }
    [[nodiscard]] Clock::time_point opened() const { return opened_; }
    [[nodiscard]] SessionStatus status() const; // also marks the session as used
    [[nodiscard]] std::shared_ptr<const SceneVersion> newest() const;
    // patch, replace, undo and redo throw LimitReached and the exceptions of accept_scene(). The session is then
    // unchanged.
    SessionStatus patch(const nlohmann::json& merge_patch, const std::string& gesture, const Author& author);
    SessionStatus replace(nlohmann::json document, const Author& author);
    SessionStatus undo(const Author& author); // returns the current status if there is nothing to undo
    SessionStatus redo(const Author& author);

    void tell(const std::string& notification) const; // sends the notification to all subscribed connections
    void subscribe(std::uint64_t connection);
    void add_viewer(std::uint32_t id, Viewer viewer); // offers the viewer the newest version; throws LimitReached
    void remove_viewer(std::uint32_t id);
    void disconnect(std::uint64_t connection); // closes the connection's viewers, ends its subscription
    void close();                              // closes all viewers, ends all subscriptions
    void dataset_changed(); // call when the dataset has grown or was replaced; offers the scene again

    // Returns whether the session has no subscriber and no viewer, and has not been used since `time`.
    [[nodiscard]] bool is_idle_since(Clock::time_point time) const;
    [[nodiscard]] Clock::time_point last_used() const;
    [[nodiscard]] std::size_t viewer_count() const;

private:
    SessionStatus move_in_history(Document (History::*move)(Document), const Author& author);
    // change, tell_others and current require mutex_ to be held. If change throws LimitReached, nothing has changed.
    SessionStatus change(std::shared_ptr<const SceneVersion> next, History after, const Author& author);
    void tell_others(std::uint64_t author) const;
    [[nodiscard]] SessionStatus current() const;

    const std::string id_;
    const SessionServices& services_;
    const Clock::time_point opened_ = Clock::now();

    mutable std::mutex mutex_;
    std::shared_ptr<const SceneVersion> version_;
    History history_;
    limits::Memory::Charge documents_;
    std::set<std::uint64_t> subscribers_;
    std::map<std::uint32_t, Viewer> viewers_;
    mutable Clock::time_point used_;
};

} // namespace server::sessions
