// Off-screen OpenGL contexts. Each file context_*.cpp has one back end.
#pragma once

#include "render/context/backend.hpp"
#include "render/context/gl.hpp"

#include <memory>
#include <string>

namespace server::render {

// Use a context only on the thread that created it. Draw only to framebuffer objects: a context need not have a default
// framebuffer.
class GlContext {
public:
    GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    virtual ~GlContext() = default;

    // Returns false when the context is lost. A lost context can only be destroyed.
    [[nodiscard]] virtual bool make_current() = 0;
    virtual void release() = 0;
    // Destroys the GL context. From then on make_current() fails, as after a GPU reset.
    virtual void lose() = 0;
    [[nodiscard]] virtual Gl::Loader loader() const = 0;
    [[nodiscard]] virtual std::string description() const = 0; // the name of the device, for logs
};

// The make functions of the back ends throw Error with the reason if they cannot create a context.
[[nodiscard]] std::unique_ptr<GlContext> make_egl_device_context();
[[nodiscard]] std::unique_ptr<GlContext> make_egl_surfaceless_context();
[[nodiscard]] std::unique_ptr<GlContext> make_osmesa_context();

struct ChosenContext {
    std::unique_ptr<GlContext> context;
    Backend backend;
    std::string selection; // for logs: the chosen back end and device, and the reasons why earlier back ends failed
};
// Makes the context current. `automatic` tries the back ends in the order of the enumeration. Throws Error if all fail.
[[nodiscard]] ChosenContext make_context(Backend backend);

// Makes `context` current on this thread. Releases the previous context first, even if it is from another library. Two
// libraries that share Mesa's dispatch table must not both have a current context. Returns false if `context` is lost.
[[nodiscard]] bool make_current(GlContext& context);
void forget_current(const GlContext& context); // call this before `context` is destroyed

} // namespace server::render
