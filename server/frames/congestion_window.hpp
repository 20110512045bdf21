// Congestion window of a view. It limits the bytes in flight, so that the line is busy but has no queue. As in TCP
// Vegas (Brakmo and Peterson, 1995), the window grows while acknowledgements come as early as the earliest
// acknowledgement so far, and shrinks when acknowledgements are late. As in BBR (Cardwell et al., ACM Queue 14(5),
// 2016), it shrinks to the bytes that the line delivers in a round trip.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace server::frames {

// CongestionWindow is deterministic: it reads no clock. It is not thread-safe.
class CongestionWindow {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Seconds = std::chrono::duration<double>;

    // `unknown_line`: number of frames that may be in flight before the first acknowledgement.
    explicit CongestionWindow(std::uint64_t unknown_line) : unknown_line_(unknown_line) {}

    // Frame numbers must ascend. A still picture takes no room, because a newer frame replaces its bytes that are not
    // sent yet. Frames after an unacknowledged still picture do not measure the line, because the still picture delays
    // them.
    void sent(std::uint32_t frame, std::size_t bytes, bool still, Time now);
    // Acknowledges a frame and all earlier frames. Returns true if at least one of them was in flight.
    bool acknowledged(std::uint32_t frame, Time now);

    // Returns whether the window has room for one more frame with the size in bytes of the last frame.
    [[nodiscard]] bool has_room() const;
    // Reports that a due frame waited for room. If no frame waits, the window is large enough and does not grow.
    void held_back() { held_back_ = true; }

    [[nodiscard]] std::size_t frames_on_the_way() const { return on_the_way_.size(); }
    [[nodiscard]] std::size_t bytes_on_the_way() const { return sent_bytes_ - delivered_bytes_; }
    // Returns the rate of the line in bytes per second; 0 if unknown. The rate is measured only when the line is full.
    [[nodiscard]] double rate() const { return rate_ ? rate_->value : 0; }

private:
    struct Frame {
        std::uint32_t number;
        std::size_t bytes;
        bool measures; // false for a still picture and for frames after an unacknowledged still picture
        Time sent;
        Time since;                   // approximate time from which the line carries `bytes_on_the_way`
        std::size_t bytes_on_the_way; // in flight just after this frame was sent
    };
    struct Known {
        double value;
        Time at;
    };

    struct Highest {
        double current = 0, before = 0;
        void add(double rate, bool begins); // `begins`: whether a new period begins with this rate
        [[nodiscard]] double value() const { return current > before ? current : before; }
    };

    void learn(const Frame& frame, Time now);
    void shrink(const Frame& frame, double carried, double late, Time now);
    void grow(std::size_t bytes);

    std::uint64_t unknown_line_;
    std::deque<Frame> on_the_way_;
    std::uint32_t newest_still_ = 0;
    std::size_t sent_bytes_ = 0, delivered_bytes_ = 0, last_bytes_ = 0;
    Time last_acknowledged_{};
    std::optional<Known> soonest_; // shortest time from a frame to its acknowledgement, in seconds
    std::size_t soonest_bytes_ = 0;
    std::optional<Known> rate_;
    Highest delivered_; // bytes in flight per round trip; an upper estimate, so that the window is never too small
    Highest carried_;   // rate of the line
    double carried_by_last_ = 0; // rate measured by the previous acknowledged frame
    Time best_since_{};
    std::optional<double> window_; // bytes; none before the first acknowledgement
    Time may_shrink_{};
    unsigned late_frames_ = 0;  // late frames in a row
    unsigned later_frames_ = 0; // frames in a row, none much earlier than the one before
    double last_late_ = 0;      // seconds
    bool held_back_ = false, doubles_ = true;
};

} // namespace server::frames
