// Framebuffer of the picture: color and depth, multisampled or not.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"
#include "render/target/touched_tiles.hpp"

#include <array>
#include <vector>

namespace server::render {

// The GL objects exist until the GL context is destroyed. A change of size keeps their names.
class Target {
public:
    explicit Target(const Gl& gl);

    // Uses at most `samples` samples per pixel. Throws Error if the GL cannot draw this size.
    void begin(int width, int height, int samples);
    // Reads the pixels of the box into the image, which is resized to the whole picture.
    void read(const PixelBox& box, Image& image);
    // Returns the window depth at a pixel counted from the top left; 1 where nothing was drawn.
    [[nodiscard]] float read_depth(int x, int y);
    void bind_again();
    // Returns the samples' offsets from the middle of a pixel to the right and up, in pixels; (0, 0) for a single
    // sample.
    [[nodiscard]] std::vector<std::array<float, 2>> sample_places() const;
    // Copies the depth of one sample per pixel to a framebuffer of the same size with GL_DEPTH_COMPONENT24.
    void copy_depth(GLuint framebuffer);

private:
    struct Layer { // a framebuffer with its color and depth buffers
        GLuint framebuffer = 0, color = 0, depth = 0;
        int width = 0, height = 0, samples = -1;
    };
    void allocate(Layer& layer, int width, int height, int samples);
    // Returns single_; first resolves the buffers `what` of a multisampled target into it.
    Layer& resolved(GLbitfield what);

    const Gl& gl_;
    Layer single_, multisampled_;
    Layer* drawn_ = nullptr;
    // Buffer for a band of rows. read() reads RGBA and removes A, because llvmpipe reads RGBA ten times as fast as RGB.
    std::vector<std::uint8_t> rgba_;
};

} // namespace server::render
