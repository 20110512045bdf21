#include "frames/frame_window.hpp"

#include <algorithm>
#include <utility>

namespace ciel::frames {
namespace {

using std::chrono::seconds;

constexpr double tolerance = 0.03;    // seconds: a browser's animation frame and its decoder come and go by as much
constexpr double very_late = 0.2;     // seconds, which is no stumble of the browser
constexpr unsigned late_in_a_row = 5; // less than that counts then: a queue makes every frame late, a busy browser some
constexpr double longest_route = 1;   // seconds; what takes longer does so by its own length
constexpr seconds soonest_lasts{10};  // a route may have become longer for good
constexpr seconds rate_lasts{30};
constexpr seconds best_lasts{2}; // to 4
constexpr double full = 0.9; // of the best rate: a late frame that was delivered more slowly waited for something else
constexpr std::size_t most_frames = 64;

} // namespace

void FrameWindow::sent(std::uint32_t frame, std::size_t bytes, bool still, Time now) {
    if (still) {
        newest_still_ = frame;
        on_the_way_.push_back({frame, 0, false, now, 0});
        return;
    }
    const bool is_behind_still =
        !on_the_way_.empty() && newest_still_ >= on_the_way_.front().number; // which is not acknowledged
    sent_bytes_ += bytes;
    last_bytes_ = bytes;
    on_the_way_.push_back({frame, bytes, !is_behind_still, now, bytes_on_the_way()});
}

bool FrameWindow::has_room() const {
    if (on_the_way_.empty()) return true;
    if (!window_) return on_the_way_.size() < unknown_line_;
    return on_the_way_.size() < most_frames && static_cast<double>(bytes_on_the_way() + last_bytes_) <= *window_;
}

bool FrameWindow::acknowledged(std::uint32_t frame, Time now) {
    std::optional<Frame> newest;
    while (!on_the_way_.empty() && on_the_way_.front().number <= frame) {
        newest = on_the_way_.front();
        delivered_bytes_ += newest->bytes;
        on_the_way_.pop_front();
    }
    if (!newest) return false;
    if (newest->measures) {
        if (!window_) window_ = static_cast<double>(unknown_line_ * newest->bytes);
        learn(*newest, now);
    }
    held_back_ = held_back_ && !has_room();
    return true;
}

void FrameWindow::learn(const Frame& frame, Time now) {
    const double took = Seconds(now - frame.sent).count();
    if (!soonest_ || took <= soonest_->value || now - soonest_->at > soonest_lasts) {
        soonest_ = {took, now};
        soonest_bytes_ = frame.bytes;
    }
    if (rate_ && now - rate_->at > rate_lasts) rate_.reset();
    const double more_bytes = frame.bytes > soonest_bytes_ ? static_cast<double>(frame.bytes - soonest_bytes_) : 0;
    const double late = took - soonest_->value - (rate_ ? more_bytes / rate_->value : 0);
    const double delivered = static_cast<double>(frame.bytes_on_the_way) / took; // Little's law
    const double best = proven(delivered, now);
    late_frames_ = late > tolerance ? late_frames_ + 1 : 0;
    if (late_frames_ >= late_in_a_row || late > very_late)
        shrink(frame, delivered, best, late, now);
    else if (late_frames_ == 0 && held_back_ && took < longest_route)
        grow(frame.bytes);
}

double FrameWindow::proven(double rate, Time now) {
    if (held_back_ && now - best_since_ > best_lasts) { // less than there was room for says nothing of the line
        best_before_ = std::exchange(best_, 0);
        best_since_ = now;
    }
    best_ = std::max(best_, rate);
    return std::max(best_, best_before_);
}

void FrameWindow::shrink(const Frame& frame, double delivered, double proven, double late, Time now) {
    if (now < may_shrink_) return; // what was sent before the last time comes late as well
    may_shrink_ = now + (now - frame.sent);
    const auto bytes = static_cast<double>(frame.bytes);
    if (std::exchange(doubles_, false) && late <= very_late) { // the line was not full all the time: no measure of it
        window_ = static_cast<double>(bytes_on_the_way()) + bytes;
        return;
    }
    // A busy browser is late as well, however little is on the way: what the line has carried it can carry.
    window_ = std::max(proven * (soonest_->value + tolerance), bytes);
    if (delivered >= full * proven && (!rate_ || delivered >= rate_->value)) rate_ = {delivered, now};
}

void FrameWindow::grow(std::size_t bytes) {
    const auto more = static_cast<double>(bytes);
    if (doubles_)
        *window_ += more;
    else // in a round trip a frame, or what the line carries in the tolerance
        *window_ += std::min(more, rate() > 0 ? rate() * tolerance : more) * more / *window_;
}

} // namespace ciel::frames
