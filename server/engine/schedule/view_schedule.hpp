// ViewSchedule: the turns of one view. Decides which scene the view draws next, and when.
#pragma once

#include "sessions/accept_scene.hpp"

#include <memory>
#include <stop_token>

namespace server::engine {

using Time = sessions::Clock::time_point;

// A frame that is being made.
struct FrameTurn {
    std::shared_ptr<const sessions::SceneVersion> version;
    bool still = false;
    bool gives_way = false; // whether a still picture that takes long lets frames of other views go first
    std::stop_token stop;   // requested when the frame must not be finished
    Time started;

    // Returns whether the frame must let frames of other views go first if any wait for a worker.
    [[nodiscard]] bool gives_way_at(Time now) const;
};

// The newest version waits in a mailbox; a version there that was not drawn is replaced. If no newer version comes for
// a short time after a frame, a still picture of the same version follows. `now`: the current time; the tests choose
// it. Not thread-safe; its View locks it.
class ViewSchedule {
public:
    using Version = std::shared_ptr<const sessions::SceneVersion>;

    void offer(Version version, Time now); // ignores a version that is older than the newest
    // Makes frames of the newest version again. Returns whether there is one.
    [[nodiscard]] bool again();
    void acknowledged(Time now); // a still picture waits again, because the user may react to the frame
    void close();

    [[nodiscard]] bool is_closed() const { return closed_; }
    // Returns whether the view may post a job: it is open, makes no frame, and has posted no job for an interactive
    // frame.
    [[nodiscard]] bool may_post() const { return !closed_ && !working_ && !posted_; }
    [[nodiscard]] bool has_change() const { return mailbox_ != nullptr; } // an interactive frame is due
    // Returns whether a still picture is wanted and no job for it is posted.
    [[nodiscard]] bool lacks_still() const { return still_wanted_ && !still_posted_; }
    [[nodiscard]] Time still_due() const { return quiet_until_; }
    // The view has posted a job; `accepted`: whether the workers took it.
    void posted(bool still, bool accepted) { (still ? still_posted_ : posted_) = accepted; }

    // A posted job has begun. Returns whether its frame is due. `has_room`: whether one more frame may be sent.
    [[nodiscard]] bool begin(bool still, bool has_room, Time now);
    // REQUIRES: begin() has just returned true. Exactly one of the functions below must follow.
    [[nodiscard]] FrameTurn take(bool still, Time now);
    // The frame is made. `still_follows`: a still picture of the same version is wanted if nothing newer waits.
    void made(const FrameTurn& turn, bool still_follows, Time now);
    void had_no_room(const FrameTurn& turn); // an interactive frame was dropped; it is made again later
    void given_up();                         // the frame was cancelled
    void waits();                            // arrays are being read from the source; a new version is offered later
    void gave_way(Time now);                 // a still picture let other views go first; it is due again at once
    void failed();

private:
    Version newest_;       // version of the last offer()
    Version mailbox_;      // null: there is no interactive frame to make
    Version still_wanted_; // drawn version that has no still picture yet
    std::stop_source stop_;
    Time started_, quiet_until_;
    bool posted_ = false, still_posted_ = false, working_ = false, working_on_still_ = false, closed_ = false;
    // Whether the last interactive frame was cancelled. The next one is finished, so that a steady drag shows frames.
    bool gave_up_ = false;
    unsigned gave_way_ = 0; // how often the wanted still picture has given way
};

} // namespace server::engine
