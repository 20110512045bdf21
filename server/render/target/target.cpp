#include "render/target/target.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace server::render {
namespace {

// Rows per glReadPixels: so few that they are still in the CPU cache when their alpha is removed.
constexpr int band_rows = 32;

// Writes one store of 8 bytes and one of 4 bytes. Smaller stores that assemble the bytes in memory would stall the CPU.
void drop_alpha_of_four(const std::uint8_t* rgba, std::uint8_t* rgb) {
    static_assert(std::endian::native == std::endian::little);
    std::array<std::uint64_t, 2> pairs{};
    std::memcpy(pairs.data(), rgba, sizeof pairs);
    constexpr std::uint64_t color = 0xffffffU;
    const std::uint64_t low = (pairs[0] & color) | (pairs[0] >> 8U & color << 24U);
    const std::uint64_t high = (pairs[1] & color) | (pairs[1] >> 8U & color << 24U);
    const std::uint64_t first = low | high << 48U;
    const auto last = static_cast<std::uint32_t>(high >> 16U);
    std::memcpy(rgb, &first, sizeof first);
    std::memcpy(rgb + sizeof first, &last, sizeof last);
}

void drop_alpha(const std::uint8_t* rgba, int pixels, std::uint8_t* rgb) {
    int x = 0;
    for (; x + 4 <= pixels; x += 4, rgba += 16, rgb += 12) drop_alpha_of_four(rgba, rgb);
    for (; x < pixels; ++x, rgba += 4, rgb += 3) {
        rgb[0] = rgba[0];
        rgb[1] = rgba[1];
        rgb[2] = rgba[2];
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
    layer.samples = -1; // invalid until the framebuffer is complete
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw ciel::Error("the GL driver cannot draw a picture of " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels; ask for a smaller picture");
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
        throw ciel::Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels cannot be drawn; ask for a picture whose sides are from 1 to " +
                          std::to_string(largest));
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

std::vector<std::array<float, 2>> Target::sample_places() const {
    if (drawn_ == &single_) return {{0, 0}};
    std::vector<std::array<float, 2>> places(static_cast<std::size_t>(drawn_->samples));
    for (std::size_t i = 0; i < places.size(); ++i) {
        gl_.GetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), places[i].data());
        for (float& place : places[i]) place -= 0.5F;
    }
    return places;
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

void Target::read(const PixelBox& box, Image& image) {
    const Layer& layer = resolved(GL_COLOR_BUFFER_BIT);
    const auto stride = 3 * static_cast<std::size_t>(layer.width);
    const auto width = static_cast<std::size_t>(box.width);
    rgba_.resize(std::max(rgba_.size(), 4 * width * band_rows));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, layer.framebuffer);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    image.width = layer.width;
    image.height = layer.height;
    image.rgb.resize(stride * static_cast<std::size_t>(layer.height));
    const int top = box.bottom + box.height;
    for (int bottom = box.bottom; bottom < top; bottom += band_rows) { // GL counts rows from the bottom
        const int rows = std::min(band_rows, top - bottom);
        gl_.ReadPixels(box.left, bottom, box.width, rows, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
        for (int row = 0; row < rows; ++row)
            drop_alpha(rgba_.data() + 4 * width * static_cast<std::size_t>(row), box.width,
                       image.rgb.data() + stride * static_cast<std::size_t>(layer.height - 1 - bottom - row) +
                           3 * static_cast<std::size_t>(box.left));
    }
}

float Target::read_depth(int x, int y) {
    const Layer& layer = resolved(GL_DEPTH_BUFFER_BIT);
    float depth = 1;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, layer.framebuffer);
    gl_.ReadPixels(x, layer.height - 1 - y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
}

} // namespace server::render
