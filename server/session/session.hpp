// A session: one scene with its history, kept between connections and shared by any number of them.
#pragma once

#include "session/frame_workers.hpp"
#include "session/history.hpp"
#include "session/scene_geometry.hpp"
#include "session/services.hpp"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace ciel::session {

class View; // view.hpp

// One state of the scene. Immutable.
struct SceneVersion {
    std::uint64_t revision = 0;
    Document document;
    scene::Scene scene;    // the document, parsed
    std::size_t bytes = 0; // of the document and the scene
    std::shared_ptr<store::LoadedDataset> loaded;
    Clock::time_point changed;
};

// Parses a document, opens its dataset and checks the names in it. Throws scene::Invalid, NotFound, LimitReached.
[[nodiscard]] std::shared_ptr<const SceneVersion> make_version(const Services& services, nlohmann::json document,
                                                               std::uint64_t revision);

struct SessionStatus {
    std::shared_ptr<const SceneVersion> version;
    bool can_undo = false, can_redo = false;
};

// What a new session can undo and redo: merge patches, nearest step first (session.open in the contract).
struct Steps {
    std::vector<nlohmann::json> undo, redo;
};

// Thread-safe. Changes are applied in order; each that changes the document has a new revision, is heard by the other
// subscribed connections and offered to all views.
class Session {
public:
    // Steps beyond the limits are left out.
    Session(std::string id, const Services& services, std::shared_ptr<const SceneVersion> first,
            const Steps& steps = {});

    [[nodiscard]] const std::string& id() const { return id_; }
    [[nodiscard]] Clock::time_point opened() const { return opened_; }
    [[nodiscard]] SessionStatus status() const; // counts as use
    [[nodiscard]] std::shared_ptr<const SceneVersion> newest() const;
    // `author`: the connection that is not told, for it has the answer. Throw as make_version does, changing nothing.
    SessionStatus patch(const nlohmann::json& merge_patch, const std::string& gesture, std::uint64_t author);
    SessionStatus replace(nlohmann::json document, std::uint64_t author);
    SessionStatus undo(std::uint64_t author); // the status as it is when there is nothing to undo
    SessionStatus redo(std::uint64_t author);

    void subscribe(std::uint64_t connection);
    void add_view(const std::shared_ptr<View>& view); // throws LimitReached; the view is offered the newest scene
    void remove_view(std::uint32_t view);
    void disconnect(std::uint64_t connection); // its views and its subscription
    void close();                              // all views
    void dataset_changed();                    // it has grown, or was replaced: the same scene is shown anew

    // The geometry of a version, made on the calling thread; others wait. Null when stopped. Throws Error,
    // LimitReached.
    [[nodiscard]] std::shared_ptr<const Geometry> geometry(const SceneVersion& version, const std::stop_token& stop,
                                                           bool moving = false);
    void release_geometry(); // memory of a session that nobody looks at

    [[nodiscard]] bool is_idle_since(Clock::time_point time) const; // no connection, and not used since
    [[nodiscard]] Clock::time_point last_used() const;
    [[nodiscard]] std::size_t memory_bytes() const { return surface_bytes_; } // query state and surfaces
    [[nodiscard]] std::size_t view_count() const;

private:
    SessionStatus move_in_history(Document (History::*move)(Document), std::uint64_t author);
    // The next three REQUIRE the lock. change: throws LimitReached before anything has changed.
    SessionStatus change(std::shared_ptr<const SceneVersion> next, History after, std::uint64_t author);
    void tell_others(std::uint64_t author) const;
    [[nodiscard]] SessionStatus current() const;

    void charge_surfaces(); // REQUIRES geometry_mutex_, as the next one does. Throws LimitReached.
    void forget_surfaces();

    const std::string id_;
    const Services& services_;
    const Clock::time_point opened_ = Clock::now();

    mutable std::mutex mutex_;
    std::shared_ptr<const SceneVersion> version_;
    History history_;
    Memory::Charge documents_;
    std::set<std::uint64_t> subscribers_;
    std::map<std::uint32_t, std::shared_ptr<View>> views_;
    mutable Clock::time_point used_;

    std::mutex geometry_mutex_; // never taken while holding mutex_
    SceneGeometry scene_geometry_;
    Memory::Charge surfaces_;
    std::atomic<std::size_t> surface_bytes_{0}; // as charged: read without the lock
};

} // namespace ciel::session
