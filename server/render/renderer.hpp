// Off-screen OpenGL: a frame -> an image. The only folder that knows GL.
#pragma once

#include "render/context/backend.hpp"
#include "render/frame/frame.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ciel::render {

// Bytes that the process can still take.
struct Spare {
    std::uint64_t memory = UINT64_MAX;        // of the machine or the container
    std::uint64_t address_space = UINT64_MAX; // up to the process's limit
};

// Owns one GL context; make and use it on one thread only. Throws Error naming the back ends that were tried and why
// each failed. A lost context is rebuilt by the next draw, and so is one that ran out of memory.
class Renderer {
public:
    // `spare` is asked before each picture; a picture that does not fit is refused. Empty: none is.
    explicit Renderer(Backend backend, std::function<Spare()> spare = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    // Throws Error when arrays of a mesh do not fit together, a color map does not exist, the camera is not finite,
    // the size is more than the GL can do or the memory is not enough (picture_memory.hpp), and what check_wanted
    // throws; the next draw is not affected. `after` is for who measures: each stage is finished before it is called,
    // which costs what the GL would have done side by side.
    void draw(const Frame& frame, Image& image, const AfterStage& after = {});
    // The same without a copy: the picture is the renderer's, until its next draw.
    const Image& draw(const Frame& frame, const AfterStage& after = {});
    // Of the last frame: what it does not show in full, as sentences.
    [[nodiscard]] const std::vector<std::string>& remarks() const;
    // World position under a pixel of the last drawn frame; false where there is only background.
    bool pick(int x, int y, Vec3d& position);
    [[nodiscard]] const std::string& gl_renderer() const; // GL_RENDERER
    [[nodiscard]] const std::string& gl_version() const;
    [[nodiscard]] Backend backend() const;
    // For logs: the back end and device that were chosen, and why those before them were not.
    [[nodiscard]] const std::string& selection() const;
    // Throws Error when there is no memory for this frame; draws nothing.
    void check_memory(const Frame& frame) const;
    // Bytes that its pictures have taken and that it keeps for the next.
    [[nodiscard]] std::uint64_t kept_memory() const;
    void give_back_memory(); // all of it; the next draw takes it again, which costs a few tenths of a second
    // Takes the context away as a reset of the GPU does, for tests of what follows.
    void simulate_context_loss();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Those that can make a context on this machine.
[[nodiscard]] std::vector<Backend> available_backends();

} // namespace ciel::render
