#include "render/renderer.hpp"

#include "render/context/gl_context.hpp"
#include "render/painter.hpp"
#include "render/picture_memory.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <thread>

namespace server::render {
namespace {

// After a picture of more pixels, a picture of less than half as many gets a new context, which frees memory. Still
// pictures of a large screen have fewer pixels, so they do not wait for a new context.
constexpr std::int64_t most_kept_pixels = 12 << 20;

// Bytes that must stay free during a draw, for the rest of the process and for shaders that are compiled.
constexpr std::uint64_t reserve = std::uint64_t{96} << 20;

// Address space in bytes of a new llvmpipe context, mostly for its threads. Only a small part becomes memory.
std::uint64_t addresses_of_a_context() {
    // MB, per context and per thread; 463 MB were measured with 2 threads.
    constexpr std::uint64_t whole = 240, of_thread = 136;
    return (whole + of_thread * std::min(32U, std::max(1U, std::thread::hardware_concurrency()))) << 20;
}

std::int64_t pixels_of(const Frame& frame) { return std::int64_t{frame.width} * frame.height; }
std::string size_of(const Frame& frame) {
    return std::to_string(frame.width) + " x " + std::to_string(frame.height) + " pixels";
}
std::string megabytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

} // namespace

struct Renderer::State {
    Backend wanted;
    std::function<Spare()> spare;
    std::function<void(std::uint64_t)> on_kept;
    std::string selection, renderer_name, version;
    Gl gl;
    std::unique_ptr<GlContext> context; // null after stop(); the next draw creates a context
    std::optional<Painter> painter;
    std::int64_t drawn_pixels = 0; // number of pixels of the last frame
    std::uint64_t kept = 0;        // estimated bytes of the largest picture of this context

    State(Backend backend, std::function<Spare()> ask, std::function<void(std::uint64_t)> tell)
        : wanted(backend), spare(std::move(ask)), on_kept(std::move(tell)) {
        start();
    }

    // Later calls use the back end of the first call: a server must not silently fall back to software.
    void start() {
        if (const std::uint64_t left = spare ? spare().address_space : UINT64_MAX; left < addresses_of_a_context())
            throw ciel::Error("drawing needs about " + megabytes(addresses_of_a_context()) + " of address space, but " +
                              megabytes(left) +
                              " are left to the server; raise the server's limit on address space (ulimit -v)");
        ChosenContext chosen = make_context(wanted);
        wanted = chosen.backend;
        selection = std::move(chosen.selection);
        context = std::move(chosen.context);
        if (!make_current(*context)) throw ciel::Error("a new OpenGL context was lost at once; check the GL driver");
        gl = Gl::load(context->loader());
        painter.emplace(gl);
        renderer_name = painter->renderer_name();
        version = painter->version();
    }
    void stop() {
        painter.reset();
        context.reset();
        drawn_pixels = 0;
        keep(0);
    }
    void keep(std::uint64_t bytes) {
        kept = bytes;
        if (on_kept) on_kept(bytes);
    }
    [[nodiscard]] bool is_lost() {
        return !painter || !make_current(*context) ||
               (gl.GetGraphicsResetStatus != nullptr && gl.GetGraphicsResetStatus() != GL_NO_ERROR);
    }
    [[nodiscard]] bool is_much_larger_than(const Frame& frame) const {
        return drawn_pixels > most_kept_pixels && pixels_of(frame) < drawn_pixels / 2;
    }
    [[nodiscard]] bool is_software() const {
        return renderer_name.find("llvmpipe") != std::string::npos ||
               renderer_name.find("softpipe") != std::string::npos;
    }
    void check_memory(const Frame& frame) const {
        const std::uint64_t needed = picture_memory(frame);
        if (!spare || !is_software() || (painter && needed <= kept)) return; // no limit, a GPU, or enough memory kept
        const std::uint64_t counted = needed - std::min(needed, kept), more = counted + reserve;
        const Spare left = spare();
        if (counted > left.allowed)
            throw ciel::Error(
                "a picture of " + size_of(frame) + " needs about " + megabytes(counted) + " of memory, but " +
                megabytes(left.allowed) +
                " are left of what the server may use; ask for a smaller picture, show fewer layers, or try "
                "again when other clients have finished");
        const std::uint64_t addresses = more + (painter ? 0 : addresses_of_a_context());
        if (more <= left.memory && addresses <= left.address_space) return;
        const bool lacks_memory = more > left.memory;
        throw ciel::Error(
            "a picture of " + size_of(frame) + " needs about " + megabytes(lacks_memory ? more : addresses) +
            " of memory, but " + megabytes(lacks_memory ? left.memory : left.address_space) +
            " are left to the server; ask for a smaller picture, show fewer layers, or give the server more memory");
    }
    [[nodiscard]] bool ran_out_of_memory() const {
        bool failed = false;
        for (int i = 0; i < 8; ++i) { // a lost context may return errors forever
            const GLenum error = gl.GetError();
            failed = failed || error == GL_OUT_OF_MEMORY;
            if (error == GL_NO_ERROR) break;
        }
        return failed;
    }
    const Image& draw(const Frame& frame, const AfterStage& after) {
        if (!painter) start();
        drawn_pixels = pixels_of(frame);
        if (const std::uint64_t needed = picture_memory(frame); needed > kept) keep(needed);
        const Image* image = nullptr;
        std::exception_ptr refused;
        bool failed = false;
        try {
            image = &painter->draw(frame, after);
        } catch (const std::bad_alloc&) {
            failed = true;
        } catch (...) {
            refused = std::current_exception();
        }
        if (failed || ran_out_of_memory()) {
            stop(); // destroys the context, because some of its buffers were not allocated
            throw ciel::Error("the server ran out of memory while it drew a picture of " + size_of(frame) +
                              "; ask for a smaller picture, or show fewer layers");
        }
        if (refused) std::rethrow_exception(refused);
        return *image;
    }
};

Renderer::Renderer(Backend backend, std::function<Spare()> spare, std::function<void(std::uint64_t)> on_kept)
    : state_(std::make_unique<State>(backend, std::move(spare), std::move(on_kept))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

void Renderer::draw(const Frame& frame, Image& image, const AfterStage& after) { image = draw(frame, after); }

const Image& Renderer::draw(const Frame& frame, const AfterStage& after) {
    if (state_->is_lost() || state_->is_much_larger_than(frame)) state_->stop();
    state_->check_memory(frame);
    const Image& image = state_->draw(frame, after);
    if (!state_->is_lost()) return image;
    state_->stop(); // the context was lost while drawing, so the image is invalid
    return state_->draw(frame, after);
}

const std::vector<std::string>& Renderer::remarks() const {
    static const std::vector<std::string> none;
    return state_->painter ? state_->painter->remarks() : none;
}

bool Renderer::pick(int x, int y, ciel::Vec3d& position) {
    return !state_->is_lost() && state_->painter->pick(x, y, position);
}

void Renderer::check_memory(const Frame& frame) const { state_->check_memory(frame); }
std::uint64_t Renderer::kept_memory() const { return state_->kept; }
void Renderer::give_back_memory() { state_->stop(); }
void Renderer::simulate_context_loss() {
    if (state_->context) state_->context->lose();
}

const std::string& Renderer::gl_renderer() const { return state_->renderer_name; }
const std::string& Renderer::gl_version() const { return state_->version; }
const std::string& Renderer::selection() const { return state_->selection; }
Backend Renderer::backend() const { return state_->wanted; }

namespace {

std::vector<Backend> find_backends() {
    std::vector<Backend> available;
    for (const Backend backend : {Backend::egl_device, Backend::egl_surfaceless, Backend::osmesa}) {
        try {
            const Renderer renderer(backend);
            available.push_back(backend);
        } catch (const ciel::Error&) {
            continue; // this back end cannot create a context
        }
    }
    return available;
}

} // namespace

const std::vector<Backend>& available_backends() {
    static const std::vector<Backend> available = find_backends();
    return available;
}

} // namespace server::render
