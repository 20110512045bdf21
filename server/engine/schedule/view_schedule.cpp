#include "engine/schedule/view_schedule.hpp"

#include <utility>

namespace server::engine {
namespace {

constexpr std::chrono::milliseconds quiet{150};       // time from the last change or frame to a still picture
constexpr std::chrono::milliseconds patience{500};    // a superseded frame that has run for less is not cancelled
constexpr std::chrono::milliseconds others_wait{500}; // after it, a still picture gives way to waiting frames
constexpr unsigned most_ways_given = 3;               // a still picture gives way at most this many times

} // namespace

bool FrameTurn::gives_way_at(Time now) const { return gives_way && now - started > others_wait; }

void ViewSchedule::offer(Version version, Time now) {
    if (newest_ && version->revision < newest_->revision) return;
    newest_ = version;
    mailbox_ = std::move(version);
    still_wanted_ = nullptr;
    quiet_until_ = now + quiet;
    if (working_ && (working_on_still_ || (!gave_up_ && now - started_ > patience))) stop_.request_stop();
}

bool ViewSchedule::again() {
    if (!newest_) return false;
    mailbox_ = newest_;
    still_wanted_ = nullptr;
    if (working_) stop_.request_stop();
    return true;
}

void ViewSchedule::acknowledged(Time now) { quiet_until_ = now + quiet; }

void ViewSchedule::close() {
    closed_ = true;
    stop_.request_stop();
}

bool ViewSchedule::begin(bool still, bool has_room, Time now) {
    (still ? still_posted_ : posted_) = false;
    const bool is_due = still ? still_wanted_ && !posted_ && now >= quiet_until_ : has_change();
    return is_due && has_room && !closed_ && !working_;
}

FrameTurn ViewSchedule::take(bool still, Time now) {
    stop_ = std::stop_source();
    started_ = now;
    working_ = true;
    working_on_still_ = still;
    return {still ? still_wanted_ : std::exchange(mailbox_, nullptr), still, still && gave_way_ < most_ways_given,
            stop_.get_token(), started_};
}

void ViewSchedule::made(const FrameTurn& turn, bool still_follows, Time now) {
    still_wanted_ = still_follows && !has_change() ? turn.version : nullptr;
    gave_up_ = false;
    gave_way_ = 0;
    // The pause begins now: a still picture right after a slow frame would delay the next interactive frame.
    quiet_until_ = now + quiet;
    working_ = false;
}

void ViewSchedule::had_no_room(const FrameTurn& turn) {
    if (!turn.still && !has_change()) mailbox_ = turn.version;
    working_ = false;
}

void ViewSchedule::given_up() {
    gave_up_ = !working_on_still_;
    working_ = false;
}

void ViewSchedule::waits() {
    still_wanted_ = nullptr;
    working_ = false;
}

void ViewSchedule::gave_way(Time now) {
    ++gave_way_;
    quiet_until_ = now; // its time in the queue counts from now
    working_ = false;
}

void ViewSchedule::failed() {
    still_wanted_ = nullptr;
    working_ = false;
}

} // namespace server::engine
