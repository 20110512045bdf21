#include "render/volume/volume_coverage.hpp"

#include "ciel/types.hpp"

#include <algorithm>

namespace ciel::render {
namespace {

constexpr const char* vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 transform;
void main() { gl_Position = transform * vec4(position, 1.0); }
)";

constexpr const char* fragment = R"(#version 330 core
out vec4 share;
void main() { share = vec4(1.0); }
)";

} // namespace

VolumeCoverage::VolumeCoverage(const Gl& gl)
    : gl_(gl), program_(make_shader_program(gl, vertex, fragment)), shares_(gl) {
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.GenRenderbuffers(1, &samples_buffer_);
}

void VolumeCoverage::begin(int width, int height, int samples) {
    shares_.size(GL_R8, width, height);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width_ != width || height_ != height || samples_ != samples) {
        width_ = 0; // not usable until it is known to be complete
        GLint most = 0;
        gl_.GetIntegerv(GL_MAX_SAMPLES, &most);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, samples_buffer_);
        gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, std::min(samples, most), GL_R8, width, height);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_buffer_);
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw Error("the GL driver cannot draw the outline of a volume to " + std::to_string(width) + " x " +
                        std::to_string(height) + " pixels; ask for a smaller picture");
        width_ = width;
        height_ = height;
        samples_ = samples;
    }
    gl_.Viewport(0, 0, width, height);
    gl_.Disable(GL_BLEND);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void VolumeCoverage::add(const VolumeBuffers& buffers, const glm::mat4& transform) const {
    program_.use();
    program_.set("transform", transform);
    buffers.bind_boundary();
    buffers.draw(buffers.whole_boundary());
}

void VolumeCoverage::finish() {
    shares_.begin();
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace ciel::render
