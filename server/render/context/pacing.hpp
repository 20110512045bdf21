// Cancels a picture that is no longer wanted. Drawing code calls check_wanted regularly, and divides large draws and
// uploads into pieces. The GL accepts commands much faster than it executes them. So Pacing waits for the GL now and
// then; without these waits, all checks would come before the GL has drawn anything.
#pragma once

#include "render/context/gl.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

namespace ciel::render {

class Pacing {
public:
    explicit Pacing(const Gl& gl) : gl_(gl) {}
    Pacing(const Pacing&) = delete;
    Pacing& operator=(const Pacing&) = delete;

    // Starts a picture with its Frame::check_wanted. If check_wanted is empty, Pacing does not check, wait or divide
    // until end(). begin(), pass() and drawn() pass on exceptions of check_wanted.
    void begin(const std::function<void()>& check_wanted);
    void end() { check_wanted_ = nullptr; }
    // Call between two drawing passes. The next piece is small again, because the next pass may be much slower.
    void pass();
    [[nodiscard]] bool is_asking() const { return static_cast<bool>(check_wanted_); }
    // Returns how many of `count` indices to draw now. Call drawn() with this number after drawing them.
    [[nodiscard]] std::size_t piece_of(std::size_t count) const;
    void drawn(std::size_t count);

private:
    using Clock = std::chrono::steady_clock;
    void wait();

    const Gl& gl_;
    std::function<void()> check_wanted_;
    Clock::time_point waited_;               // time of the last wait for the GL
    std::size_t drawn_ = 0, until_wait_ = 0; // indices drawn since the last wait; number at which to wait
};

// Calls Pacing::pass() if `gl.pacing` is set.
void next_pass(const Gl& gl);

// Calls work(begin, end) for consecutive pieces of [0, count), a few milliseconds each, and next_pass after each.
// Makes copies and sorts on the CPU cancellable.
template <typename Work>
void in_pieces(const Gl& gl, std::size_t count, const Work& work) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    for (std::size_t begin = 0; begin < count; begin += piece) {
        work(begin, std::min(begin + piece, count));
        next_pass(gl);
    }
}

// Fills the buffer bound to `target`, as glBufferData with GL_STREAM_DRAW does. Uploads in pieces while
// Pacing::is_asking(). If cancelled, the buffer holds only a part of the data.
void fill_buffer(const Gl& gl, GLenum target, std::size_t bytes, const void* data);
// Draws as glDrawElementsBaseVertex does, with indices of type Index. Draws in pieces while Pacing::is_asking().
void draw_elements(const Gl& gl, GLenum primitive, std::size_t first, std::size_t count, GLint base = 0);

// Occlusion query: whether any sample drawn during its lifetime passes the depth test.
class AnySamples {
public:
    AnySamples(const Gl& gl, GLuint query) : gl_(gl), query_(query) { gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, query_); }
    ~AnySamples() { end(); }
    AnySamples(const AnySamples&) = delete;
    AnySamples& operator=(const AnySamples&) = delete;
    // Ends the query and waits for its result.
    [[nodiscard]] bool passed();

private:
    void end();

    const Gl& gl_;
    GLuint query_;
    bool ended_ = false;
};

} // namespace ciel::render
