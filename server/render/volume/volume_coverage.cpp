// Finds the coverage of pixels by the clipped mesh. A point of a clip plane is inside the mesh if the view ray, from
// this point on, leaves the mesh once more often than it enters the mesh. Exits and entries are counted as for shadow
// volumes, after F. Crow, "Shadow algorithms for computer graphics", SIGGRAPH 1977.
#include "render/volume/volume_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace server::render {
namespace {

constexpr const char* boundary_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 transform;
uniform vec4 planes[6]; // (0, 0, 0, 1) keeps everything
out float gl_ClipDistance[6];
void main() {
    gl_Position = transform * vec4(position, 1.0);
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(planes[i].xyz, position) + planes[i].w;
}
)";

constexpr const char* facet_vertex = R"(#version 330 core
uniform mat4 transform;
uniform vec4 planes[6];
uniform vec3 middle; // of a square on the clip plane
uniform vec3 across; // from the middle to one side of the square
uniform vec3 up;
out float gl_ClipDistance[6];
void main() {
    vec3 position = middle + (float(gl_VertexID & 1) * 2.0 - 1.0) * across + (float(gl_VertexID & 2) - 1.0) * up;
    gl_Position = transform * vec4(position, 1.0);
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(planes[i].xyz, position) + planes[i].w;
}
)";

constexpr const char* fragment = R"(#version 330 core
out vec4 share;
void main() { share = vec4(1.0); }
)";

const std::array everything = [] {
    std::array<glm::vec4, most_clip_planes> planes{};
    planes.fill({0, 0, 0, 1});
    return planes;
}();

constexpr GLenum clip_plane(std::size_t index) { return GL_CLIP_DISTANCE0 + static_cast<GLenum>(index); }

} // namespace

VolumeCoverage::VolumeCoverage(const Gl& gl)
    : gl_(gl), boundary_program_(make_shader_program(gl, boundary_vertex, fragment)),
      facet_program_(make_shader_program(gl, facet_vertex, fragment)), shares_(gl) {
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.GenRenderbuffers(1, &samples_buffer_);
    gl_.GenRenderbuffers(1, &depth_buffer_);
    gl_.GenVertexArrays(1, &no_array_);
}

void VolumeCoverage::allocate(int width, int height, int samples) {
    if (width_ == width && height_ == height && samples_ == samples) return;
    width_ = 0; // invalid until the framebuffer is complete
    GLint most = 0;
    gl_.GetIntegerv(GL_MAX_SAMPLES, &most);
    const auto attach = [&](GLuint buffer, GLenum format, GLenum where) {
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, std::min(samples, most), format, width, height);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
    };
    attach(samples_buffer_, GL_R8, GL_COLOR_ATTACHMENT0);
    attach(depth_buffer_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error("the GL driver cannot draw the outline of a volume in a picture of " + std::to_string(width) +
                          " x " + std::to_string(height) + " pixels; ask for a smaller picture");
    width_ = width;
    height_ = height;
    samples_ = samples;
}

void VolumeCoverage::begin(const VolumeView& view) {
    view_ = view;
    shares_.size(GL_R8, view.width, view.height);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    allocate(view.width, view.height, view.frame->samples);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Disable(GL_BLEND);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    for (const ShaderProgram* program : {&boundary_program_, &facet_program_}) {
        program->use();
        program->set("transform", glm::mat4(view_.transform->projection * view_.transform->view));
    }
}

void VolumeCoverage::add(const VolumeBuffers& buffers) const {
    const std::size_t planes = view_.frame->clip.size();
    for (std::size_t i = 0; i < planes; ++i) gl_.Enable(clip_plane(i));
    gl_.Enable(GL_DEPTH_CLAMP); // faces beyond the near and far planes must be drawn, too
    draw_boundary(buffers, planes_but({}));
    for (std::size_t i = 0; i < planes; ++i) draw_cut(buffers, i);
    gl_.Disable(GL_DEPTH_CLAMP);
    for (std::size_t i = 0; i < planes; ++i) gl_.Disable(clip_plane(i));
}

VolumeCoverage::Planes VolumeCoverage::planes_but(std::optional<std::size_t> left_out) const {
    Planes planes = everything;
    for (std::size_t i = 0; i < view_.frame->clip.size(); ++i) {
        const auto& [x, y, z, offset] = view_.frame->clip[i];
        if (i != left_out) planes[i] = {x, y, z, offset};
    }
    return planes;
}

void VolumeCoverage::draw_boundary(const VolumeBuffers& buffers, const Planes& planes) const {
    boundary_program_.use();
    boundary_program_.set("planes", planes);
    buffers.bind_boundary();
    buffers.draw(buffers.whole_boundary());
}

// Counts the faces behind the plane in the stencil buffer, and draws the plane where the count is not zero.
void VolumeCoverage::draw_cut(const VolumeBuffers& buffers, std::size_t plane) const {
    gl_.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.Enable(GL_DEPTH_TEST);
    draw_facet(buffers, plane);
    gl_.Enable(GL_STENCIL_TEST);
    gl_.DepthMask(GL_FALSE);
    gl_.DepthFunc(GL_GREATER);
    gl_.StencilFunc(GL_ALWAYS, 0, ~0U);
    gl_.StencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    gl_.StencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    draw_boundary(buffers, everything);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.StencilFunc(GL_NOTEQUAL, 0, ~0U);
    gl_.StencilOpSeparate(GL_FRONT_AND_BACK, GL_KEEP, GL_KEEP, GL_KEEP);
    draw_facet(buffers, plane);
    gl_.Disable(GL_STENCIL_TEST);
}

void VolumeCoverage::draw_facet(const VolumeBuffers& buffers, std::size_t plane) const {
    const auto& [low, high] = buffers.bounds();
    const glm::dvec3 from(low[0], low[1], low[2]), to(high[0], high[1], high[2]), middle = 0.5 * (from + to);
    const auto& [x, y, z, offset] = view_.frame->clip[plane];
    const glm::dvec3 along(x, y, z), normal = glm::normalize(along);
    const glm::dvec3 aside = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 across = 0.5 * glm::length(to - from) * glm::normalize(glm::cross(normal, aside));
    facet_program_.use();
    facet_program_.set("planes", planes_but(plane));
    facet_program_.set("middle",
                       glm::vec3(middle - normal * ((glm::dot(along, middle) + double{offset}) / glm::length(along))));
    facet_program_.set("across", glm::vec3(across));
    facet_program_.set("up", glm::vec3(glm::cross(normal, across)));
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void VolumeCoverage::finish() {
    shares_.begin();
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace server::render
