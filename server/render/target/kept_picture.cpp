#include "render/target/kept_picture.hpp"

#include "render/context/shader_program.hpp"

#include <algorithm>
#include <cmath>

namespace server::render {
namespace {

constexpr double most_by_tiles = 0.6; // largest share of dirty tiles; above it, one full clear is faster

constexpr const char* background_fragment = R"(#version 330 core
uniform vec3 top;
uniform vec3 bottom;
uniform float height;
out vec4 picture;
void main() { picture = vec4(mix(bottom, top, gl_FragCoord.y / height), 1.0); }
)";

// Rounds to a multiple of 1/255, because full clears and scissored clears may round other values differently.
float as_byte(float channel) { return std::round(std::clamp(channel, 0.0F, 1.0F) * 255) / 255; }

void copy(const Image& from, const PixelBox& box, Image& to) {
    const auto stride = 3 * static_cast<std::size_t>(from.width);
    for (int row = from.height - box.bottom - box.height; row < from.height - box.bottom; ++row) {
        const auto first = static_cast<std::size_t>(row) * stride + 3 * static_cast<std::size_t>(box.left);
        std::copy_n(from.rgb.data() + first, 3 * static_cast<std::size_t>(box.width), to.rgb.data() + first);
    }
}

} // namespace

KeptPicture::KeptPicture(const Gl& gl, Target& target)
    : gl_(gl), target_(target),
      program_(link_stages(gl_, {{GL_VERTEX_SHADER, cover_vertex}, {GL_FRAGMENT_SHADER, background_fragment}})),
      top_(gl_.GetUniformLocation(program_, "top")), bottom_(gl_.GetUniformLocation(program_, "bottom")),
      height_(gl_.GetUniformLocation(program_, "height")) {
    gl_.GenVertexArrays(1, &no_array_);
}

void KeptPicture::begin(const Background& background, const TouchedTiles& touched) {
    const bool again = is_drawn_ && background == background_ && background.samples <= 1;
    is_drawn_ = false; // remains false if begin() throws
    target_.begin(background.width, background.height, background.samples);
    background_ = background;
    touched_ = touched;
    if (!again) is_clean_known_ = false;
    gl_.DepthMask(GL_TRUE);
    if (is_clean_known_ && dirty_.share() <= most_by_tiles) {
        clear(dirty_.boxes());
    } else {
        clear({});
        if (again && !is_clean_known_) keep_background();
    }
    dirty_ = touched_;
    is_drawn_ = true;
}

// Called only for the second of two frames with the same background, because a single picture does not need clean_.
void KeptPicture::keep_background() {
    target_.read({0, 0, background_.width, background_.height}, clean_);
    target_.bind_again();
    picture_ = clean_;
    shown_ = TouchedTiles(background_.width, background_.height);
    is_clean_known_ = true;
}

void KeptPicture::clear(const std::vector<PixelBox>& boxes) {
    const auto& bottom = background_.bottom;
    gl_.ClearColor(as_byte(bottom[0]), as_byte(bottom[1]), as_byte(bottom[2]), 1);
    const bool plain = background_.top == bottom;
    const auto clear_one = [&] {
        gl_.Clear(plain || boxes.empty() ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
        if (!plain) gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    };
    gl_.Disable(GL_DEPTH_TEST);
    gl_.UseProgram(program_);
    gl_.Uniform3f(top_, background_.top[0], background_.top[1], background_.top[2]);
    gl_.Uniform3f(bottom_, bottom[0], bottom[1], bottom[2]);
    gl_.Uniform1f(height_, static_cast<float>(background_.height));
    gl_.BindVertexArray(no_array_);
    if (boxes.empty()) clear_one();
    gl_.Enable(GL_SCISSOR_TEST);
    for (const PixelBox& box : boxes) {
        gl_.Scissor(box.left, box.bottom, box.width, box.height);
        clear_one();
    }
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Enable(GL_DEPTH_TEST);
}

const Image& KeptPicture::read() {
    if (!is_clean_known_) {
        target_.read({0, 0, background_.width, background_.height}, picture_);
        return picture_;
    }
    for (const PixelBox& box : shown_.boxes(&touched_)) copy(clean_, box, picture_);
    for (const PixelBox& box : touched_.boxes()) target_.read(box, picture_);
    shown_ = touched_;
    return picture_;
}

} // namespace server::render
