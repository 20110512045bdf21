#include "render/context.hpp"
#include "render/painter.hpp"

#include <optional>

namespace ciel::render {
namespace {

struct BackendName {
    Backend backend;
    const char* name;
};
constexpr BackendName backend_names[] = {
    {Backend::automatic, "auto"},
    {Backend::egl_device, "egl-device"},
    {Backend::egl_surfaceless, "egl-surfaceless"},
    {Backend::osmesa, "osmesa"},
};

// The stills of a large screen stay below: nobody waits for a new context there.
constexpr std::int64_t most_kept_pixels = 12 << 20;

std::int64_t pixels_of(const Frame& frame) { return std::int64_t{frame.width} * frame.height; }

} // namespace

struct Renderer::State {
    ChosenContext chosen;
    Gl gl;
    std::optional<Painter> painter;
    std::int64_t drawn_pixels = 0; // of the last frame

    explicit State(Backend backend) : chosen(make_context(backend)) { start(); }

    void start() {
        if (!make_current(*chosen.context)) throw Error("a new OpenGL context was lost at once");
        gl = Gl::load(chosen.context->loader());
        painter.emplace(gl);
    }
    [[nodiscard]] bool is_lost() {
        return !make_current(*chosen.context) ||
               (gl.GetGraphicsResetStatus != nullptr && gl.GetGraphicsResetStatus() != GL_NO_ERROR);
    }
    // Objects of the GL live as long as their context, so what a very large picture has taken goes with that.
    [[nodiscard]] bool is_much_larger_than(const Frame& frame) const {
        return drawn_pixels > most_kept_pixels && pixels_of(frame) < drawn_pixels / 2;
    }
    // The same back end as before: a server must not go on in software without anybody having been told.
    void rebuild() {
        const Backend backend = chosen.backend;
        painter.reset();
        chosen.context.reset();
        chosen = make_context(backend);
        start();
    }
};

Renderer::Renderer(Backend backend) : state_(std::make_unique<State>(backend)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

void Renderer::draw(const Frame& frame, Image& image, const AfterStage& after) { image = draw(frame, after); }

const Image& Renderer::draw(const Frame& frame, const AfterStage& after) {
    if (state_->is_lost() || state_->is_much_larger_than(frame)) state_->rebuild();
    state_->drawn_pixels = pixels_of(frame);
    const Image& image = state_->painter->draw(frame, after);
    if (!state_->is_lost()) return image;
    state_->rebuild(); // while drawing: what was read is no picture
    return state_->painter->draw(frame, after);
}

const std::vector<std::string>& Renderer::remarks() const { return state_->painter->remarks(); }

bool Renderer::pick(int x, int y, Vec3d& position) {
    return !state_->is_lost() && state_->painter->pick(x, y, position);
}

void Renderer::simulate_context_loss() { state_->chosen.context->lose(); }

const std::string& Renderer::gl_renderer() const { return state_->painter->renderer_name(); }
const std::string& Renderer::gl_version() const { return state_->painter->version(); }
const std::string& Renderer::selection() const { return state_->chosen.selection; }
Backend Renderer::backend() const { return state_->chosen.backend; }

std::vector<Backend> available_backends() {
    std::vector<Backend> available;
    for (const BackendName& named : backend_names) {
        if (named.backend == Backend::automatic) continue;
        try {
            const Renderer renderer(named.backend);
            available.push_back(named.backend);
        } catch (const Error&) {
            continue; // asking whether it is there is what this is for
        }
    }
    return available;
}

const char* name_of(Backend backend) {
    for (const BackendName& named : backend_names)
        if (named.backend == backend) return named.name;
    return "unknown";
}

Backend backend_named(const std::string& name) {
    std::string known;
    for (const BackendName& named : backend_names) {
        if (name == named.name) return named.backend;
        known += (known.empty() ? "" : ", ") + std::string(named.name);
    }
    throw Error("there is no GL back end '" + name + "'; there are " + known);
}

} // namespace ciel::render
