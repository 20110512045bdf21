// Cancels a picture that is no longer wanted. Draws and uploads are divided into pieces, and Frame::check_wanted, which
// may throw, is called between two pieces. The GL accepts commands much faster than it executes them, so Pacing also
// waits for the GL.
#pragma once

#include "render/context/gl.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

namespace server::render {

class Pacing {
public:
    explicit Pacing(const Gl& gl) : gl_(gl) {}
    Pacing(const Pacing&) = delete;
    Pacing& operator=(const Pacing&) = delete;

    // If `check_wanted` is empty, Pacing does not check, wait or divide draws. Exceptions of check_wanted are
    // propagated.
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
    Clock::time_point waited_; // time of the last wait for the GL
    // drawn_: number of indices drawn since the last wait. until_wait_: value of drawn_ at which the next wait happens.
    std::size_t drawn_ = 0, until_wait_ = 0;
};

void next_pass(const Gl& gl);

// Divides the indices below `count` into pieces of a few milliseconds. Calls work(begin, end) and then next_pass() for
// each, so that work of the CPU can be cancelled.
template <typename Work>
void in_pieces(const Gl& gl, std::size_t count, const Work& work) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    for (std::size_t begin = 0; begin < count; begin += piece) {
        work(begin, std::min(begin + piece, count));
        next_pass(gl);
    }
}

// Works like glBufferData with GL_STREAM_DRAW, in pieces if Pacing::is_asking(). Cancelling leaves incomplete data.
void fill_buffer(const Gl& gl, GLenum target, std::size_t bytes, const void* data);
// Works like glDrawElementsBaseVertex, in pieces if Pacing::is_asking(). `first`: position in the bound index buffer.
void draw_elements(const Gl& gl, GLenum primitive, std::size_t first, std::size_t count, GLint base = 0);

// Occlusion query. It finds whether any sample passes the depth test between the constructor and passed().
class AnySamples {
public:
    AnySamples(const Gl& gl, GLuint query) : gl_(gl), query_(query) { gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, query_); }
    ~AnySamples() { end(); }
    AnySamples(const AnySamples&) = delete;
    AnySamples& operator=(const AnySamples&) = delete;
    [[nodiscard]] bool passed();

private:
    void end();

    const Gl& gl_;
    GLuint query_;
    bool ended_ = false;
};

} // namespace server::render
