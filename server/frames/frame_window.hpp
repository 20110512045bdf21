// How much of a view may be on its way: as much as keeps the line busy, and no more, so that nothing queues in it.
// Grows while acknowledgements come as early as ever and shrinks when they come later, as TCP Vegas does (Brakmo and
// Peterson, 1995), to what was delivered in a round trip (BBR: Cardwell et al., ACM Queue 14(5), 2016).
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace ciel::frames {

// A function of what it is told: it asks no clock. Not thread-safe.
class FrameWindow {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Seconds = std::chrono::duration<double>;

    // `unknown_line`: frames that may be on their way before the first acknowledgement.
    explicit FrameWindow(std::uint64_t unknown_line) : unknown_line_(unknown_line) {}

    // Frames count up. A still takes no room, for a newer frame takes the place of what is left of it; and what follows
    // it says nothing about the line, for it comes later by the still's length.
    void sent(std::uint32_t frame, std::size_t bytes, bool still, Time now);
    // A frame and all before it. Returns whether any was on the way.
    bool acknowledged(std::uint32_t frame, Time now);

    // For one more as long as the last.
    [[nodiscard]] bool has_room() const;
    // A frame was due and had to wait for room. Without it the window is wide enough, and stays as it is.
    void held_back() { held_back_ = true; }

    [[nodiscard]] std::size_t frames_on_the_way() const { return on_the_way_.size(); }
    [[nodiscard]] std::size_t bytes_on_the_way() const { return sent_bytes_ - delivered_bytes_; }
    // Bytes a second of the line, once it has been full; 0 before.
    [[nodiscard]] double rate() const { return rate_ ? rate_->value : 0; }

private:
    struct Frame {
        std::uint32_t number;
        std::size_t bytes;
        bool measures; // neither a still nor behind one
        Time sent;
        std::size_t bytes_on_the_way; // itself included
    };
    struct Known {
        double value;
        Time at;
    };

    void learn(const Frame& frame, Time now);
    // A frame was delivered at this rate. Returns the highest of the last seconds.
    double proven(double rate, Time now);
    void shrink(const Frame& frame, double delivered, double proven, double late, Time now);
    void grow(std::size_t bytes);

    std::uint64_t unknown_line_;
    std::deque<Frame> on_the_way_;
    std::uint32_t newest_still_ = 0;
    std::size_t sent_bytes_ = 0, delivered_bytes_ = 0, last_bytes_ = 0;
    std::optional<Known> soonest_; // of acknowledgements, seconds
    std::size_t soonest_bytes_ = 0;
    std::optional<Known> rate_;
    double best_ = 0, best_before_ = 0; // rates of delivery, of this span of time and of the one before
    Time best_since_{};
    std::optional<double> window_; // bytes; none before the first acknowledgement
    Time may_shrink_{};
    unsigned late_frames_ = 0; // in a row
    bool held_back_ = false, doubles_ = true;
};

} // namespace ciel::frames
