#include "render/context/gl_context.hpp"

#include "ciel/types.hpp"

namespace server::render {
namespace {

struct Kind {
    Backend backend;
    std::unique_ptr<GlContext> (*make)();
};

constexpr Kind kinds[] = {
    {Backend::egl_device, make_egl_device_context},
    {Backend::egl_surfaceless, make_egl_surfaceless_context},
    {Backend::osmesa, make_osmesa_context},
};

thread_local GlContext* current = nullptr;

} // namespace

ChosenContext make_context(Backend backend) {
    if (current != nullptr) { // another library may fail to create a context while this context is current
        current->release();
        current = nullptr;
    }
    std::string failures;
    for (const Kind& kind : kinds) {
        if (backend != Backend::automatic && backend != kind.backend) continue;
        try {
            auto context = kind.make();
            std::string chosen(name_of(kind.backend));
            chosen.append(", ").append(context->description());
            if (!failures.empty()) chosen.append("; tried before: ").append(failures);
            return {std::move(context), kind.backend, std::move(chosen)};
        } catch (const ciel::Error& error) {
            if (!failures.empty()) failures += "; ";
            failures.append(name_of(kind.backend)).append(": ").append(error.what());
        }
    }
    throw ciel::Error("no OpenGL 3.3 context could be created: " + failures +
                      "; install libegl1 and libgl1-mesa-dri, or libosmesa6, or a GPU's driver");
}

bool make_current(GlContext& context) {
    if (current != nullptr && current != &context) current->release();
    current = context.make_current() ? &context : nullptr;
    return current != nullptr;
}

void forget_current(const GlContext& context) {
    if (current == &context) current = nullptr;
}

} // namespace server::render
