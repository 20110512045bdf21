#include "render/target.hpp"

#include <algorithm>

namespace ciel::render {
namespace {

// From the bottom row up, as GL reads, to rows from the top.
void drop_alpha(const std::uint8_t* rgba, int width, int height, std::uint8_t* rgb) {
    const auto row_bytes = 4 * static_cast<std::size_t>(width);
    for (int row = height - 1; row >= 0; --row) {
        const std::uint8_t* from = rgba + static_cast<std::size_t>(row) * row_bytes;
        for (int x = 0; x < width; ++x, from += 4, rgb += 3) {
            rgb[0] = from[0];
            rgb[1] = from[1];
            rgb[2] = from[2];
        }
    }
}

} // namespace

Target::Target(const Gl& gl) : gl_(gl) {
    for (Layer* layer : {&single_, &multisampled_}) {
        gl_.GenFramebuffers(1, &layer->framebuffer);
        gl_.GenRenderbuffers(1, &layer->color);
        gl_.GenRenderbuffers(1, &layer->depth);
    }
}

void Target::allocate(Layer& layer, int width, int height, int samples) {
    if (layer.width == width && layer.height == height && layer.samples == samples) return;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, layer.color);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, layer.color);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, layer.depth);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, layer.depth);
    layer.samples = -1; // not usable until it is known to be complete
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("the GL driver cannot draw a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels; ask for a smaller one");
    }
    layer.width = width;
    layer.height = height;
    layer.samples = samples;
}

void Target::begin(int width, int height, int samples) {
    GLint largest = 0;
    GLint most_samples = 0;
    gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    gl_.GetIntegerv(GL_MAX_SAMPLES, &most_samples);
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels cannot be drawn; each side may have 1 to " + std::to_string(largest));
    }
    samples = std::min(samples, most_samples);
    drawn_ = samples > 1 ? &multisampled_ : &single_;
    allocate(*drawn_, width, height, samples > 1 ? samples : 0);
    bind_again();
}

void Target::bind_again() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer);
    gl_.Viewport(0, 0, drawn_->width, drawn_->height);
}

void Target::copy_depth(GLuint framebuffer) {
    const int width = drawn_->width;
    const int height = drawn_->height;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_->framebuffer);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

Target::Layer& Target::resolved(GLbitfield what) {
    if (drawn_ == &single_) return single_;
    const int width = drawn_->width;
    const int height = drawn_->height;
    allocate(single_, width, height, 0);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_->framebuffer);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.framebuffer);
    gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
    return single_;
}

void Target::read_color(Image& image) {
    const Layer& layer = resolved(GL_COLOR_BUFFER_BIT);
    const auto pixels = static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height);
    rgba_.resize(4 * pixels);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, layer.framebuffer);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, layer.width, layer.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    image.width = layer.width;
    image.height = layer.height;
    image.rgb.resize(3 * pixels);
    drop_alpha(rgba_.data(), layer.width, layer.height, image.rgb.data());
}

float Target::read_depth(int x, int y) {
    const Layer& layer = resolved(GL_DEPTH_BUFFER_BIT);
    float depth = 1;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, layer.framebuffer);
    gl_.ReadPixels(x, layer.height - 1 - y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
}

} // namespace ciel::render
