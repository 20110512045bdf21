// Off-screen OpenGL contexts: one back end per context_*.cpp.
#pragma once

#include "render/context/backend.hpp"
#include "render/context/gl.hpp"

#include <memory>
#include <string>

namespace ciel::render {

// A context belongs to the thread that created it. It has no default framebuffer to draw to, only framebuffer objects.
class GlContext {
public:
    GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    virtual ~GlContext() = default;

    // Returns false when the context is lost. A lost context can only be destroyed.
    [[nodiscard]] virtual bool make_current() = 0;
    virtual void release() = 0;
    // Destroys the GL context, as a GPU reset would: make_current() fails from now on.
    virtual void lose() = 0;
    [[nodiscard]] virtual Gl::Loader loader() const = 0;
    [[nodiscard]] virtual std::string description() const = 0; // names the device, for logs
};

// The make functions of the back ends throw Error with the reason when they cannot create a context.
[[nodiscard]] std::unique_ptr<GlContext> make_egl_device_context();
[[nodiscard]] std::unique_ptr<GlContext> make_egl_surfaceless_context();
[[nodiscard]] std::unique_ptr<GlContext> make_osmesa_context();

struct ChosenContext {
    std::unique_ptr<GlContext> context;
    Backend backend;
    std::string selection; // for logs: the choice, and why earlier back ends failed
};
// Creates a context and makes it current. `automatic` tries the back ends in the order of the enumeration. Throws Error
// naming each back end tried and why it failed.
[[nodiscard]] ChosenContext make_context(Backend backend);

// Makes `context` current on this thread and releases the previous one, even one of another library. Two libraries
// that share Mesa's dispatch table must not both have a current context. Returns false when `context` is lost.
[[nodiscard]] bool make_current(GlContext& context);
void forget_current(const GlContext& context); // call before destroying `context`

} // namespace ciel::render
