// Off-screen OpenGL: draws a frame into an image. Only server/render uses GL.
#pragma once

#include "render/context/backend.hpp"
#include "render/frame/frame.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ciel::render {

// Bytes that the process can still allocate.
struct Spare {
    std::uint64_t memory = UINT64_MAX;        // of the machine or the container
    std::uint64_t address_space = UINT64_MAX; // up to the process's limit
};

// Owns one GL context. Must be created and used on one thread. The constructor throws Error naming the back ends that
// were tried and why each failed, or when the address space does not suffice for a context. The next draw recreates a
// context that is lost or ran out of memory.
class Renderer {
public:
    // `spare` is called before each picture; a picture that does not fit is refused. Empty: no picture is refused.
    explicit Renderer(Backend backend, std::function<Spare()> spare = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    // Throws Error when arrays of a mesh do not fit together, a color map does not exist, the camera is not finite,
    // there are too many clip planes, the GL cannot draw this size, or the memory does not suffice
    // (picture_memory.hpp). Passes on what check_wanted throws. The next draw is not affected.
    // `after` is called after each stage, for benchmarks. The GL finishes the stage first, so stages do not overlap.
    void draw(const Frame& frame, Image& image, const AfterStage& after = {});
    // The same without a copy: the renderer owns the image, which is valid until its next draw.
    const Image& draw(const Frame& frame, const AfterStage& after = {});
    // Sentences about what the last frame does not show in full.
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
    // Estimated bytes kept for the next picture: those of the context's largest picture.
    [[nodiscard]] std::uint64_t kept_memory() const;
    void give_back_memory(); // destroys the context; the next draw recreates it in a few tenths of a second
    // Loses the context as a reset of the GPU does; for tests.
    void simulate_context_loss();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns the back ends that can create a context on this machine.
[[nodiscard]] std::vector<Backend> available_backends();

} // namespace ciel::render
