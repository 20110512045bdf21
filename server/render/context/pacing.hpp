// So that a picture that nobody waits for any more can be given up in its middle: what draws it asks every so often,
// and draws what is large in pieces. The GL takes commands much faster than it carries them out, so now and then what
// it has taken is waited for, or the question would come too early to mean anything.
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

    // As Frame::check_wanted, for the picture that follows. Empty: nothing is asked, waited for or divided.
    void begin(const std::function<void()>& check_wanted);
    void end() { check_wanted_ = nullptr; }
    // Between two passes: what comes may take longer by far than what was.
    void pass();
    [[nodiscard]] bool is_asking() const { return static_cast<bool>(check_wanted_); }
    // Of `count` indices, so many may be drawn now; then the same is told to drawn().
    [[nodiscard]] std::size_t piece_of(std::size_t count) const;
    void drawn(std::size_t count);

private:
    using Clock = std::chrono::steady_clock;
    void wait();

    const Gl& gl_;
    std::function<void()> check_wanted_;
    Clock::time_point waited_;               // last
    std::size_t drawn_ = 0, until_wait_ = 0; // indices, since then
};

// Between two passes, where the GL has a pacing.
void next_pass(const Gl& gl);

// Calls work(begin, end) for consecutive pieces of [0, count), a few milliseconds each, and next_pass after each.
// Copies and sorts on the CPU go through it, so that they can be given up too.
template <typename Work>
void in_pieces(const Gl& gl, std::size_t count, const Work& work) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    for (std::size_t begin = 0; begin < count; begin += piece) {
        work(begin, std::min(begin + piece, count));
        next_pass(gl);
    }
}

// Fills the buffer bound to `target`, as glBufferData with GL_STREAM_DRAW does; in pieces where the GL's pacing asks.
// Given up, the buffer holds a part of the data.
void fill_buffer(const Gl& gl, GLenum target, std::size_t bytes, const void* data);
// As glDrawElementsBaseVertex does, of Index; in pieces where the GL's pacing asks for it.
void draw_elements(const Gl& gl, GLenum primitive, std::size_t first, std::size_t count, GLint base = 0);

// Asks whether anything that is drawn during its life is seen.
class AnySamples {
public:
    AnySamples(const Gl& gl, GLuint query) : gl_(gl), query_(query) { gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, query_); }
    ~AnySamples() { end(); }
    AnySamples(const AnySamples&) = delete;
    AnySamples& operator=(const AnySamples&) = delete;
    // Ends it, and waits for the answer.
    [[nodiscard]] bool passed();

private:
    void end();

    const Gl& gl_;
    GLuint query_;
    bool ended_ = false;
};

} // namespace ciel::render
