// Off-screen OpenGL: geometry + camera -> image. The only folder that knows GL.
#pragma once

#include "ciel/types.hpp"
#include "render/annotations/annotations.hpp"
#include "render/color_scale.hpp"
#include "render/lighting.hpp"
#include "render/volume/volume.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ciel::render {

// In the order in which `automatic` tries them; hardware devices come before software ones.
enum class Backend { automatic, egl_device, egl_surfaceless, osmesa };

struct Camera {
    Vec3d position{}, target{}, up{0, 0, 1};
    double fov_degrees = 30;
    bool parallel = false;
    double parallel_height = 1;
};

// Triangles, lines or points with per-vertex attributes; borrowed for the duration of a draw.
struct Mesh {
    std::span<const Vec3f> positions; // offsets from the frame's origin
    std::span<const Vec3f> normals;   // triangles are wound about them; empty: flat shading from the triangle
    std::span<const float> scalars;   // empty: solid colour
    std::span<const Index> indices;   // 3 per triangle, 2 per line, 1 per point
    bool lines = false, points = false;
    float line_width = 1.5F, point_size = 4; // pixels
    bool on_opaque = false; // lines known to lie on an opaque surface, so on no transparent one in front of it
    ColorScale scale;       // of the scalars
    std::array<float, 4> color{0.8F, 0.8F, 0.8F, 1}; // alpha is the opacity, also of mapped colours
    std::uint64_t revision = 0;                      // same non-zero revision: same buffers, may be kept on the GPU
    std::uint64_t identity = 0;                      // which layer the buffers belong to
    bool lit = true;
};

struct Frame {
    int width = 0, height = 0;
    Vec3d origin{}; // of the positions
    Camera camera;
    Vec3d bounds_min{}, bounds_max{}; // for the depth range, in world coordinates
    std::array<float, 3> background_top{}, background_bottom{};
    // Opaque triangles, then points, then lines, then transparent triangles of all meshes, sorted from the back to the
    // front; or peeled with lines and points among them, where there are several samples or volumes or one can see
    // through those.
    std::vector<Mesh> meshes;
    // In front of what is behind them and behind what is in front, mixed where they are in the same place. All have
    // slabs across one direction.
    std::vector<Volume> volumes;
    int samples = 1; // 4: multisampled, for stills
    // At most 6: only what has dot(xyz, position) + w >= 0 is drawn, and of meshes found by pick.
    std::vector<std::array<float, 4>> clip;
    Lighting lighting;       // of what is lit
    Occlusion occlusion;     // likewise, of opaque triangles
    Annotations annotations; // over all of it
    // Called every so often while the picture is drawn, on its thread: to throw gives it up, and is handed on.
    std::function<void()> check_wanted;
};

// Rows from the top, RGB, 8 bits, no padding.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

// Of the making of a picture. Volumes and annotations go up while they are drawn.
enum class DrawStage { upload, draw, read };
using AfterStage = std::function<void(DrawStage)>;

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

    // Throws Error when arrays of a mesh do not fit together, a colour map does not exist, the camera is not finite,
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

[[nodiscard]] std::vector<Backend> available_backends();
[[nodiscard]] const char* name_of(Backend backend);
[[nodiscard]] Backend
backend_named(const std::string& name); // "auto", "egl-device", "egl-surfaceless", "osmesa"; throws Error

// The camera that shows the whole box from a direction, with a small margin; its parallel height fits as well.
[[nodiscard]] Camera default_camera(Vec3d bounds_min, Vec3d bounds_max, double aspect,
                                    double fov_degrees = Camera{}.fov_degrees);

} // namespace ciel::render
