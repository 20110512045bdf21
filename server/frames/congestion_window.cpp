#include "frames/congestion_window.hpp"

#include <algorithm>
#include <utility>

namespace server::frames {
namespace {

using std::chrono::seconds;

constexpr double tolerance = 0.03; // seconds; the animation frames and the decoder of a browser cause shorter delays
constexpr double very_late = 0.2;  // seconds; no browser delays a frame this much, so one such frame shrinks the window
constexpr double queued = 0.1;     // seconds; a later frame has waited in a queue of the line
// The window shrinks after this many late frames in a row. A queue delays all frames, but a busy browser only some.
constexpr unsigned late_in_a_row = 5;
// The same number while the window doubles and frames become later and later, which only a growing queue causes.
constexpr unsigned late_while_doubling = 3;
constexpr double noise = 0.005; // seconds by which a frame in a growing queue may be earlier than the one before
// seconds. A frame that takes longer is slow because of its size; the window does not grow for it.
constexpr double longest_route = 1;
constexpr seconds soonest_lasts{10}; // soonest_ is then measured again, because the route may have become longer
constexpr seconds rate_lasts{30};
constexpr seconds best_lasts{2}; // shortest period of Highest: while frames wait, a rate is used for 2 to 4 seconds
constexpr double full = 0.9;     // share of the best rate; at a lower rate, a late frame was not delayed by the line
constexpr std::size_t most_frames = 64;

} // namespace

void CongestionWindow::sent(std::uint32_t frame, std::size_t bytes, bool still, Time now) {
    if (still) {
        newest_still_ = frame;
        on_the_way_.push_back({frame, 0, false, now, now, 0});
        return;
    }
    const bool is_behind_still =
        !on_the_way_.empty() && newest_still_ >= on_the_way_.front().number; // a still picture is not acknowledged yet
    // Acknowledgements come in bursts. Therefore frames that were sent since the last acknowledgement may have arrived.
    const Time since = on_the_way_.empty() ? now : std::max(on_the_way_.front().sent, last_acknowledged_);
    sent_bytes_ += bytes;
    last_bytes_ = bytes;
    on_the_way_.push_back({frame, bytes, !is_behind_still, now, since, bytes_on_the_way()});
}

bool CongestionWindow::has_room() const {
    if (on_the_way_.empty()) return true;
    if (!window_) return on_the_way_.size() < unknown_line_;
    return on_the_way_.size() < most_frames && static_cast<double>(bytes_on_the_way() + last_bytes_) <= *window_;
}

bool CongestionWindow::acknowledged(std::uint32_t frame, Time now) {
    std::optional<Frame> newest;
    while (!on_the_way_.empty() && on_the_way_.front().number <= frame) {
        newest = on_the_way_.front();
        delivered_bytes_ += newest->bytes;
        on_the_way_.pop_front();
    }
    if (!newest) return false;
    last_acknowledged_ = now;
    if (newest->measures) {
        if (!window_) window_ = static_cast<double>(unknown_line_ * newest->bytes);
        learn(*newest, now);
    }
    held_back_ = held_back_ && !has_room();
    return true;
}

void CongestionWindow::learn(const Frame& frame, Time now) {
    const double took = Seconds(now - frame.sent).count();
    if (!soonest_ || took <= soonest_->value || now - soonest_->at > soonest_lasts) {
        soonest_ = {took, now};
        soonest_bytes_ = frame.bytes;
    }
    if (rate_ && now - rate_->at > rate_lasts) rate_.reset();
    const double more_bytes = frame.bytes > soonest_bytes_ ? static_cast<double>(frame.bytes - soonest_bytes_) : 0;
    const double late = took - soonest_->value - (rate_ ? more_bytes / rate_->value : 0);
    const auto bytes = static_cast<double>(frame.bytes_on_the_way);
    // The line is measured only while the window is full.
    const bool is_old = held_back_ && now - best_since_ > best_lasts;
    if (is_old) best_since_ = now;
    delivered_.add(bytes / took, is_old); // Little's law; too high if arrived bytes are not acknowledged yet
    const double carried = bytes / Seconds(now - frame.since).count();
    carried_.add(carried, is_old);
    late_frames_ = late > tolerance ? late_frames_ + 1 : 0;
    later_frames_ = late > last_late_ - noise ? later_frames_ + 1 : 0;
    last_late_ = late;
    const bool queue_grows = doubles_ && later_frames_ > late_while_doubling;
    if (late_frames_ >= (queue_grows ? late_while_doubling : late_in_a_row) || late > very_late)
        shrink(frame, carried, late, now);
    else if (late_frames_ == 0 && held_back_ && took < longest_route)
        grow(frame.bytes);
    carried_by_last_ = carried;
}

void CongestionWindow::Highest::add(double rate, bool begins) {
    if (begins) before = std::exchange(current, 0);
    current = std::max(current, rate);
}

void CongestionWindow::shrink(const Frame& frame, double carried, double late, Time now) {
    if (now < may_shrink_) return; // frames sent before the last shrink are late, too
    may_shrink_ = now + (now - frame.sent);
    // While the window doubles, few rates are known, and frames that arrive together seem fast: takes the lower rate.
    const double sure = doubles_ && late_frames_ > 1 ? std::min(carried, carried_by_last_) : carried;
    const bool is_full = sure >= full * carried_.value() && (!rate_ || sure >= rate_->value);
    const auto bytes = static_cast<double>(frame.bytes), flight = static_cast<double>(bytes_on_the_way());
    const double reach = soonest_->value + tolerance;
    if (!std::exchange(doubles_, false) || late > queued)
        // A busy browser acknowledges late even with few bytes in flight, so the window allows the highest rate so far.
        window_ = std::max(delivered_.value() * reach, bytes);
    else if (is_full) // empties the queue that doubling has built up
        window_ = std::max(std::min(std::max(delivered_.value(), carried_.value()) * reach, flight), bytes);
    else
        window_ = flight + bytes;
    if (is_full) rate_ = {sure, now};
}

void CongestionWindow::grow(std::size_t bytes) {
    const auto more = static_cast<double>(bytes);
    if (doubles_)
        *window_ += more;
    else // grows by one frame per round trip, but at most by the bytes that the line carries in `tolerance` seconds
        *window_ += std::min(more, rate() > 0 ? rate() * tolerance : more) * more / *window_;
}

} // namespace server::frames
