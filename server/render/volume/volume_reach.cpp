#include "render/volume/volume_reach.hpp"

#include "render/context/shader_program.hpp"

#include <algorithm>
#include <cmath>

namespace server::render {
namespace {

constexpr const char* version = "#version 330 core\n";

enum Unit : int { color_unit = 0, depth_unit = 1, pixels_unit = 2 };
constexpr int tile_side = 16; // pixels

constexpr const char* pixels_fragment = R"(
uniform sampler2D color;
uniform vec2 viewport;
out float any;
void main() {
    vec2 size = vec2(textureSize(color, 0)) / viewport; // layer pixels per ray
    ivec2 from = ivec2(floor((gl_FragCoord.xy - 0.5) * size));
    ivec2 to = min(ivec2(ceil((gl_FragCoord.xy + 0.5) * size)), textureSize(color, 0));
    float most = 0.0;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) most = max(most, texelFetch(color, ivec2(x, y), 0).a);
    any = most > 0.0 ? 1.0 : 0.0;
}
)";

// Writes a depth one slab behind the layer, because a fragment may draw a piece that begins one slab in front of the
// fragment. Writes 0 if neither the ray nor a neighbor pixel's ray, which compositing also reads, meets the layer.
constexpr const char* reach_fragment = R"(
uniform sampler2D pixels;
uniform sampler2D depths;
uniform vec2 viewport;
uniform vec2 depth_row; // projection[2][2] and projection[3][2]
uniform float parallel;
uniform vec3 slabs; // number of slabs that a ray crosses per unit of depth: at the picture's corner, and change per pixel
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(pixels, 0) - 1;
    float wanted = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            wanted = max(wanted, texelFetch(pixels, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).r);
    float z = texelFetch(depths, ivec2(gl_FragCoord.xy * (vec2(textureSize(depths, 0)) / viewport)), 0).r;
    float ndc = 2.0 * z - 1.0;
    float slab = 1.05 / max(abs(dot(slabs, vec3(1.0, gl_FragCoord.xy))), 1e-30);
    if (parallel > 0.5) ndc -= depth_row.x * slab;
    else ndc = depth_row.y / (depth_row.y / (ndc + depth_row.x) + slab) - depth_row.x;
    gl_FragDepth = wanted == 0.0 ? 0.0 : z < 1.0 ? clamp(0.5 + 0.5 * ndc, 0.0, 1.0) : 1.0;
}
)";

constexpr const char* tiles_fragment = R"(
uniform sampler2D depths;
out float farthest;
void main() {
    ivec2 from = ivec2(gl_FragCoord.xy) * SIDE, to = min(from + SIDE, textureSize(depths, 0));
    farthest = 0.0;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) farthest = max(farthest, texelFetch(depths, ivec2(x, y), 0).r);
}
)";

std::string tiles_program() {
    return std::string(version) + "#define SIDE " + std::to_string(tile_side) + "\n" + tiles_fragment;
}

} // namespace

VolumeReach::VolumeReach(const Gl& gl)
    : gl_(gl), pixels_program_(make_cover_program(gl, std::string(version) + pixels_fragment)),
      reach_program_(make_cover_program(gl, std::string(version) + reach_fragment)),
      tiles_program_(make_cover_program(gl, tiles_program())), pixels_(gl), tiles_(gl) {
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.GenTextures(1, &depth_);
    gl_.GenVertexArrays(1, &no_array_);
}

void VolumeReach::size(const VolumeView& view, GLuint picture) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width_ == view.width && height_ == view.height) return;
    gl_.BindTexture(GL_TEXTURE_2D, depth_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, view.width, view.height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   nullptr);
    filter(gl_, GL_NEAREST);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    width_ = 0; // invalid until the framebuffer is complete
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error("the GL driver cannot draw volumes between transparent surfaces in a picture of " +
                          std::to_string(view.width) + " x " + std::to_string(view.height) +
                          " pixels; ask for a smaller picture");
    width_ = view.width;
    height_ = view.height;
}

void VolumeReach::find_pixels(const VolumeView& view, const LayerInVolumes& layer) {
    pixels_.size(GL_R8, view.width, view.height);
    pixels_.begin();
    bind(gl_, color_unit, layer.color);
    pixels_program_.use();
    pixels_program_.set("color", int{color_unit});
    pixels_program_.set("viewport", glm::vec2(view.width, view.height));
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void VolumeReach::begin(const VolumeView& view, const LayerInVolumes& layer, const Sheet& picture,
                        const glm::dvec3& slabs) {
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BindVertexArray(no_array_);
    find_pixels(view, layer);
    size(view, picture.texture());
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_ALWAYS);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    bind(gl_, depth_unit, layer.depth);
    bind(gl_, pixels_unit, pixels_.texture());
    reach_program_.use();
    reach_program_.set("pixels", int{pixels_unit});
    reach_program_.set("depths", int{depth_unit});
    reach_program_.set("viewport", glm::vec2(width_, height_));
    const glm::dmat4& projection = view.transform->projection;
    reach_program_.set("depth_row", glm::vec2(projection[2][2], projection[3][2]));
    reach_program_.set("parallel", view.frame->camera.parallel ? 1.0F : 0.0F);
    reach_program_.set("slabs", glm::vec3(slabs));
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    to_clip_ = view.transform->projection * view.transform->view;
    gl_.Disable(GL_DEPTH_TEST);
    read_tiles();
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.DepthMask(GL_FALSE);
}

void VolumeReach::read_tiles() {
    columns_ = (width_ + tile_side - 1) / tile_side;
    rows_ = (height_ + tile_side - 1) / tile_side;
    farthest_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    tiles_.size(GL_R32F, columns_, rows_);
    tiles_.begin();
    bind(gl_, depth_unit, depth_);
    tiles_program_.use();
    tiles_program_.set("depths", int{depth_unit});
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.ReadPixels(0, 0, columns_, rows_, GL_RED, GL_FLOAT, farthest_.data());
}

bool VolumeReach::meets(const ciel::Vec3f& low, const ciel::Vec3f& high) const {
    glm::dvec3 first(1e30), last(-1e30);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec4 place((corner & 1U) != 0 ? high[0] : low[0], (corner & 2U) != 0 ? high[1] : low[1],
                               (corner & 4U) != 0 ? high[2] : low[2], 1);
        const glm::dvec4 clip = to_clip_ * place;
        if (!(clip.w > 0)) return true; // the corner is beside or behind the eye
        const glm::dvec3 at = 0.5 + 0.5 * glm::dvec3(clip) / clip.w;
        first = glm::min(first, at);
        last = glm::max(last, at);
    }
    const auto tile = [](double place, int pixels, int count) {
        return std::clamp(static_cast<int>(std::floor(std::clamp(place, -1.0, 2.0) * pixels / tile_side)), 0,
                          count - 1);
    };
    const int left = tile(first.x, width_, columns_), right = tile(last.x, width_, columns_);
    for (int row = tile(first.y, height_, rows_); row <= tile(last.y, height_, rows_); ++row)
        for (int column = left; column <= right; ++column)
            if (farthest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column)] +
                    1e-6 >=
                first.z)
                return true;
    return false;
}

} // namespace server::render
