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
    std::uint64_t memory = UINT64_MAX;        // free on the machine or in the container
    std::uint64_t address_space = UINT64_MAX; // left below the process's limit (RLIMIT_AS)
    std::uint64_t allowed = UINT64_MAX;       // left below a limit on what the program counts itself
};

// Owns one GL context. Must be created and used on one thread. The constructor throws Error naming the back ends that
// were tried and why each failed, or when the address space does not suffice for a context. The next draw recreates a
// context that is lost or ran out of memory.
class Renderer {
public:
    // `spare` returns the memory left to the process. It is called before a context is created, and with a software GL
    // also before a picture that needs more memory than the context keeps. A picture or context that does not fit is
    // refused. Empty: nothing is refused. `on_kept` is called with kept_memory() whenever that changes, and before the
    // memory is allocated.
    explicit Renderer(Backend backend, std::function<Spare()> spare = {},
                      std::function<void(std::uint64_t)> on_kept = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    // Throws Error when arrays of a mesh do not fit together, a color map does not exist, the camera is not finite,
    // there are too many clip planes, the GL cannot draw this size, or the memory does not suffice
    // (picture_memory.hpp). Passes on exceptions of check_wanted. After an exception, the next draw works as usual.
    // `after` is called after each stage, for benchmarks, once the GL has finished the stage.
    void draw(const Frame& frame, Image& image, const AfterStage& after = {});
    // Like the other draw, but without a copy: the renderer owns the image, which is valid until its next draw.
    const Image& draw(const Frame& frame, const AfterStage& after = {});
    // Sentences for the user about content that the last picture leaves out, such as layers beyond the limit.
    [[nodiscard]] const std::vector<std::string>& remarks() const;
    // Finds the world position of the nearest mesh at a pixel of the last picture, counted from the top left. Returns
    // false where there is no mesh.
    bool pick(int x, int y, Vec3d& position);
    [[nodiscard]] const std::string& gl_renderer() const; // GL_RENDERER
    [[nodiscard]] const std::string& gl_version() const;
    [[nodiscard]] Backend backend() const;
    // For logs: the chosen back end and device, and why the back ends tried before failed.
    [[nodiscard]] const std::string& selection() const;
    // Throws Error when there is no memory for this frame; draws nothing.
    void check_memory(const Frame& frame) const;
    // Returns the estimated bytes that the context keeps allocated: those of its largest picture.
    [[nodiscard]] std::uint64_t kept_memory() const;
    void give_back_memory(); // destroys the context; the next draw recreates it in a few tenths of a second
    // Destroys the GL context as a GPU reset would; for tests.
    void simulate_context_loss();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns the back ends that can create a context on this machine. The first call tries them. Thread-safe.
[[nodiscard]] const std::vector<Backend>& available_backends();

} // namespace ciel::render
