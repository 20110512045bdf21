// So that a picture that nobody waits for any more can be given up in its middle: what draws it asks every so often,
// and draws what is large in pieces. The GL takes commands much faster than it carries them out, so now and then what
// it has taken is waited for, or the question would come too early to mean anything.
#pragma once

#include "render/gl.hpp"

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
