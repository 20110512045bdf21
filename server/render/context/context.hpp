// An off-screen OpenGL context without a window: one kind per .cpp.
#pragma once

#include "render/context/backend.hpp"
#include "render/context/gl.hpp"

#include <memory>
#include <string>

namespace ciel::render {

// Belongs to the thread that made it. Drawing goes to framebuffer objects: there is no default framebuffer.
class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    // False when the context has been lost; only destroying it is left then.
    [[nodiscard]] virtual bool make_current() = 0;
    virtual void release() = 0;
    // Takes the context away as a reset of the GPU does: make_current fails from now on.
    virtual void lose() = 0;
    [[nodiscard]] virtual Gl::Loader loader() const = 0;
    [[nodiscard]] virtual std::string description() const = 0; // which device, for logs
};

// Each throws Error saying why there is none.
[[nodiscard]] std::unique_ptr<Context> make_egl_device_context();
[[nodiscard]] std::unique_ptr<Context> make_egl_surfaceless_context();
[[nodiscard]] std::unique_ptr<Context> make_osmesa_context();

struct ChosenContext {
    std::unique_ptr<Context> context;
    Backend backend;
    std::string selection; // a sentence for logs: what was chosen and why what comes before it was not
};
// `automatic` tries them in the order of the enumeration. Throws Error naming each that was tried and why it failed.
[[nodiscard]] ChosenContext make_context(Backend backend);

// Makes `context` the thread's current one and releases the one before it, even of another library: two libraries
// that share Mesa's dispatch table must not both believe theirs is current. False when it is lost.
[[nodiscard]] bool make_current(Context& context);
void forget_current(const Context& context); // before it is destroyed

} // namespace ciel::render
