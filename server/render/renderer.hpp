// Off-screen OpenGL: draws a frame into an image. Only server/render uses GL.
#pragma once

#include "render/context/backend.hpp"
#include "render/frame/frame.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace server::render {

// Bytes that the process can still allocate.
struct Spare {
    std::uint64_t memory = UINT64_MAX;        // free on the machine or in the container
    std::uint64_t address_space = UINT64_MAX; // left below the process's limit (RLIMIT_AS)
    std::uint64_t allowed = UINT64_MAX;       // left of the limit on memory that the program itself counts
};

// Owns one GL context. A Renderer must be created and used on the same thread. The constructor throws Error if no
// context can be created. If the context is lost or runs out of memory, the next draw creates a new context.
class Renderer {
public:
    // `spare` returns the memory that is left. It is called before a context is created and, with a software GL, before
    // a picture that needs more memory than the context keeps. If the memory does not suffice, an Error is thrown.
    // `on_kept` is called with kept_memory() whenever this number changes, before the memory is allocated.
    explicit Renderer(Backend backend, std::function<Spare()> spare = {},
                      std::function<void(std::uint64_t)> on_kept = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    // Throws Error if arrays of primitives do not fit together, for an unknown color map, an unusable camera, too many
    // clip planes or a size that the GL cannot draw, and if the memory does not suffice (picture_memory.hpp).
    // Propagates exceptions of check_wanted. After an exception, the next draw works as usual. `after`: called when the
    // GL has finished a stage, for benchmarks.
    void draw(const Frame& frame, Image& image, const AfterStage& after = {});
    // Returns the image without a copy; valid until the next draw.
    const Image& draw(const Frame& frame, const AfterStage& after = {});
    // Sentences for the user about content that the last picture leaves out, such as layers beyond the limit.
    [[nodiscard]] const std::vector<std::string>& remarks() const;
    // Sets `position` to the point that the last picture shows at pixel (x, y), in world coordinates. x and y are
    // counted from the top left. Returns false if there is no primitive at this pixel.
    bool pick(int x, int y, ciel::Vec3d& position);
    [[nodiscard]] const std::string& gl_renderer() const; // GL_RENDERER
    [[nodiscard]] const std::string& gl_version() const;
    [[nodiscard]] Backend backend() const;
    // For logs: the chosen back end and device, and the reasons why earlier back ends failed.
    [[nodiscard]] const std::string& selection() const;
    // Throws Error if there is not enough memory for this frame. Draws nothing.
    void check_memory(const Frame& frame) const;
    // Returns the estimated memory of the largest picture of the context, in bytes.
    [[nodiscard]] std::uint64_t kept_memory() const;
    void give_back_memory(); // destroys the context; the next draw creates a new one in a few tenths of a second
    // Destroys the GL context as a GPU reset would; for tests.
    void simulate_context_loss();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns the back ends that can create a context on this machine. The first call tries all of them. Thread-safe.
[[nodiscard]] const std::vector<Backend>& available_backends();

} // namespace server::render
