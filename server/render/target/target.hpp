// Render target: color and depth, multisampled or not.
#pragma once

#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"
#include "render/target/touched_tiles.hpp"

#include <array>
#include <vector>

namespace ciel::render {

// Its GL objects live as long as their context; a change of size reallocates behind the same names.
class Target {
public:
    explicit Target(const Gl& gl);

    // Binds it for drawing. Throws Error when the GL cannot draw this size.
    void begin(int width, int height, int samples);
    // Reads these pixels into the image, which is resized to the whole picture.
    void read(const PixelBox& box, Image& image);
    // Depth at a pixel counted from the top left, 1 where nothing was drawn.
    [[nodiscard]] float read_depth(int x, int y);
    void bind_again();
    // Returns the sample positions of a pixel, from its middle to the right and up; (0, 0) for a single sample.
    [[nodiscard]] std::vector<std::array<float, 2>> sample_places() const;
    // Copies the depth of one sample per pixel to another framebuffer of this size with GL_DEPTH_COMPONENT24.
    void copy_depth(GLuint framebuffer);

private:
    struct Layer { // one framebuffer with its two buffers
        GLuint framebuffer = 0, color = 0, depth = 0;
        int width = 0, height = 0, samples = -1;
    };
    void allocate(Layer& layer, int width, int height, int samples);
    Layer& resolved(GLbitfield what); // the layer to read from

    const Gl& gl_;
    Layer single_, multisampled_;
    Layer* drawn_ = nullptr;
    std::vector<std::uint8_t> rgba_; // a band; from llvmpipe, reading RGBA and dropping A is ten times as fast as RGB
};

} // namespace ciel::render
