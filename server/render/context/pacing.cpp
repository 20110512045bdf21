#include "render/context/pacing.hpp"

#include "ciel/types.hpp"

#include <algorithm>

namespace server::render {
namespace {

constexpr std::chrono::duration<double> between_waits{0.1}; // a cancelled picture stops after about this time
constexpr std::size_t first_piece = 1536;                   // indices, a multiple of 6 as in piece_of()
constexpr std::size_t most_growth = 4;
constexpr std::size_t piece_of_buffer = std::size_t{4} << 20U; // bytes per glBufferSubData

void draw_piece(const Gl& gl, GLenum primitive, std::size_t first, std::size_t count, GLint base) {
    gl.DrawElementsBaseVertex(primitive, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                              reinterpret_cast<const void*>( // NOLINT(performance-no-int-to-ptr): GL's own way
                                  first * sizeof(ciel::Index)),
                              base);
}

} // namespace

void Pacing::begin(const std::function<void()>& check_wanted) {
    check_wanted_ = check_wanted;
    waited_ = Clock::now();
    drawn_ = 0;
    until_wait_ = first_piece;
    if (is_asking()) check_wanted_();
}

void Pacing::pass() {
    if (!is_asking()) return;
    if (Clock::now() - waited_ > between_waits / 2) wait();
    until_wait_ = std::min(until_wait_, drawn_ + first_piece);
    check_wanted_();
}

std::size_t Pacing::piece_of(std::size_t count) const {
    // A piece has a multiple of 6 indices, so that it has whole lines and triangles.
    constexpr std::size_t whole = 6;
    const std::size_t left = (until_wait_ - drawn_ + whole - 1) / whole * whole;
    return std::min(count, left);
}

void Pacing::drawn(std::size_t count) {
    drawn_ += count;
    if (drawn_ >= until_wait_) {
        const std::size_t done = drawn_;
        const auto since = waited_;
        wait();
        const std::chrono::duration<double> took = waited_ - since;
        const double fitting =
            static_cast<double>(done) * (between_waits / std::max(took, between_waits / most_growth));
        until_wait_ = std::max(static_cast<std::size_t>(fitting), first_piece / most_growth);
    }
    check_wanted_();
}

void Pacing::wait() {
    gl_.Finish();
    waited_ = Clock::now();
    drawn_ = 0;
}

void next_pass(const Gl& gl) {
    if (gl.pacing != nullptr) gl.pacing->pass();
}

void fill_buffer(const Gl& gl, GLenum target, std::size_t bytes, const void* data) {
    const bool in_one = gl.pacing == nullptr || !gl.pacing->is_asking() || bytes <= piece_of_buffer;
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes), in_one ? data : nullptr, GL_STREAM_DRAW);
    if (in_one) return;
    for (std::size_t begin = 0; begin < bytes; begin += piece_of_buffer) {
        const std::size_t size = std::min(piece_of_buffer, bytes - begin);
        gl.BufferSubData(target, static_cast<GLintptr>(begin), static_cast<GLsizeiptr>(size),
                         static_cast<const std::byte*>(data) + begin);
        gl.pacing->pass();
    }
}

void draw_elements(const Gl& gl, GLenum primitive, std::size_t first, std::size_t count, GLint base) {
    if (count == 0) return;
    if (gl.pacing == nullptr || !gl.pacing->is_asking()) return draw_piece(gl, primitive, first, count, base);
    while (count > 0) {
        const std::size_t piece = gl.pacing->piece_of(count);
        draw_piece(gl, primitive, first, piece, base);
        gl.pacing->drawn(piece);
        first += piece;
        count -= piece;
    }
}

bool AnySamples::passed() {
    end();
    GLuint any = 0;
    gl_.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &any);
    return any != 0;
}

void AnySamples::end() {
    if (!ended_) gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
    ended_ = true;
}

} // namespace server::render
