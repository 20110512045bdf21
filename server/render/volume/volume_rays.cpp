#include "render/volume/volume_rays.hpp"

#include "render/context/pacing.hpp"
#include "render/context/shader_program.hpp"

#include <algorithm>
#include <glm/matrix.hpp>

namespace server::render {
namespace {

constexpr float never = 1e30F; // a depth behind everything; the constant `never` of the shaders

enum Unit : int { limits_unit = 0, opaque_unit = 2, first_part_unit = 3, kept_unit = first_part_unit + most_ray_parts };
static_assert(kept_unit < 16); // OpenGL guarantees 16 texture units per program stage

void set_later_parts(const ShaderProgram& program) {
    for (int i = 1; i < most_ray_parts; ++i) program.set(("part_" + std::to_string(i)).c_str(), first_part_unit + i);
}

void bind_later_parts(const Gl& gl, const RaySheets& rays) {
    for (int i = 1; i < most_ray_parts; ++i)
        bind(gl, first_part_unit + i, i < rays.count ? rays.parts[static_cast<std::size_t>(i)].texture() : 0);
}

} // namespace

VolumeView::Rays VolumeView::rays_of_pixels() const {
    const glm::dvec2 corner(1 / transform->projection[0][0], 1 / transform->projection[1][1]);
    const glm::dvec2 step = 2.0 * corner / glm::dvec2(width, height);
    if (frame->camera.parallel) return {{}, {}, -corner, step};
    return {-corner, step, {}, {}};
}

void VolumeView::set_rays(const ShaderProgram& program) const {
    const Rays rays = rays_of_pixels();
    program.set("ray_corner", glm::vec2(rays.corner));
    program.set("ray_step", glm::vec2(rays.step));
    program.set("side_corner", glm::vec2(rays.side_corner));
    program.set("side_step", glm::vec2(rays.side_step));
}

glm::vec2 VolumeView::parallel_depths() const {
    if (!frame->camera.parallel) return {0, 0};
    // NDC z = b - a * depth runs from -1 (nearest depth) to 1 (farthest depth).
    const double a = transform->projection[2][2], b = transform->projection[3][2];
    return {static_cast<float>((b + 1) / a), static_cast<float>(-2 / a)};
}

double VolumeView::eye_along(const ciel::Vec3d& normal) const {
    return glm::dot(glm::dvec3(normal[0], normal[1], normal[2]), glm::dvec3(glm::inverse(transform->view)[3]));
}

// If so, the shader part_fragment moves entries of rays away from the eye, because boundary faces may coincide.
bool VolumeView::eye_is_in_bounds() const {
    const ciel::Vec3d& eye = frame->camera.position;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (eye[axis] < frame->bounds_min[axis] || eye[axis] > frame->bounds_max[axis]) return false;
    return !frame->camera.parallel;
}

RayPlaces VolumeView::places() const {
    return {transform->view, transform->projection, width, height, frame->camera.parallel, eye_is_in_bounds()};
}

PixelBox VolumeView::seen_box(int pixels_across, int pixels_up) const {
    const glm::dmat4 to_clip = transform->projection * transform->view;
    const glm::dvec2 size(pixels_across, pixels_up);
    glm::dvec2 from = size, to(0);
    for (unsigned corner = 0; corner < 8; ++corner) {
        glm::dvec4 offset(0, 0, 0, 1);
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            offset[axis] = (corner >> a & 1U) != 0 ? high[a] : low[a];
        }
        const glm::dvec4 clip = to_clip * offset;
        if (!(clip.w > 0)) return {0, 0, pixels_across, pixels_up};
        const glm::dvec2 at = (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * size;
        from = glm::min(from, at);
        to = glm::max(to, at);
    }
    constexpr double beside = 2; // margin in pixels, for rounding and for programs that read neighbors of a pixel
    const glm::ivec2 first(glm::clamp(glm::floor(from - beside), glm::dvec2(0), size));
    const glm::ivec2 last(glm::clamp(glm::ceil(to + beside), glm::dvec2(first), size));
    return {first.x, first.y, last.x - first.x, last.y - first.y};
}

VolumeRays::VolumeRays(const Gl& gl)
    : gl_(gl), first_part_(make_part_program(gl, true)), next_part_(make_part_program(gl, false)),
      kept_program_(make_kept_program(gl)), copy_program_(make_limits_copy_program(gl)), kept_(gl), nearest_(gl) {
    gl_.GenQueries(1, &query_);
    gl_.GenVertexArrays(1, &no_array_);
}

void VolumeRays::begin(const VolumeView& view) {
    view_ = view;
    in_use_ = 0;
    gl_.Disable(GL_BLEND);
    if (view_.is_clipped()) find_kept();
}

const RaySheets& VolumeRays::find(const VolumeBuffers& buffers) {
    const auto end = std::next(sheets_.begin(), static_cast<std::ptrdiff_t>(in_use_));
    const auto found = std::find_if(sheets_.begin(), end,
                                    [&](const RaySheets& rays) { return rays.boundary == buffers.boundary_places(); });
    if (found != end) return *found;
    RaySheets& rays = end != sheets_.end() ? *end : sheets_.emplace_back(gl_);
    // All transparent layers of one frame have the same ray parts, so they are found only once.
    if (const RayPlaces places = view_.places(); rays.boundary != buffers.boundary_places() || rays.places != places) {
        rays.boundary = 0; // not valid if anything below throws
        find_parts(buffers, rays);
        rays.boundary = buffers.boundary_places();
        rays.places = places;
    }
    find_limits(rays);
    ++in_use_;
    return rays;
}

void VolumeRays::find_parts(const VolumeBuffers& buffers, RaySheets& rays) {
    const glm::mat4 transform(view_.transform->projection * view_.transform->view);
    for (const ShaderProgram* program : {&first_part_, &next_part_}) {
        program->use();
        program->set("transform", transform);
        program->set("parallel_depths", view_.parallel_depths());
    }
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_MIN);
    buffers.bind_boundary();
    gl_.ClearColor(never, never, never, never);
    rays.parts[0].size(GL_RG32F, view_.width, view_.height);
    rays.parts[0].begin();
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    first_part_.use();
    first_part_.set("eye_in_bounds", view_.eye_is_in_bounds() ? 1.0F : 0.0F);
    buffers.draw(buffers.whole_boundary());
    rays.count = 1;
    next_part_.use();
    next_part_.set("before", int{first_part_unit});
    gl_.Enable(GL_CULL_FACE);
    while (rays.count < most_ray_parts && find_next_part(buffers, rays, rays.count)) ++rays.count;
    gl_.Disable(GL_CULL_FACE);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.Disable(GL_BLEND);
}

// Returns false if no ray enters the mesh again. The part is then invalid.
bool VolumeRays::find_next_part(const VolumeBuffers& buffers, RaySheets& rays, int part) {
    Sheet& sheet = rays.parts[static_cast<std::size_t>(part)];
    sheet.size(GL_RG32F, view_.width, view_.height);
    sheet.begin();
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    render::bind(gl_, first_part_unit, rays.parts[static_cast<std::size_t>(part - 1)].texture());
    gl_.CullFace(GL_BACK);
    AnySamples drawn(gl_, query_);
    buffers.draw(buffers.whole_boundary());
    if (!drawn.passed()) return false;
    gl_.CullFace(GL_FRONT);
    buffers.draw(buffers.whole_boundary());
    return true;
}

void VolumeRays::find_kept() {
    kept_.size(GL_RG32F, view_.width, view_.height);
    kept_.begin();
    const glm::dmat4 to_eye = glm::transpose(glm::inverse(view_.transform->view));
    std::array<glm::vec4, most_clip_planes> planes;
    planes.fill({0, 0, 0, 1});
    for (std::size_t i = 0; i < view_.frame->clip.size(); ++i) {
        const auto& [x, y, z, offset] = view_.frame->clip[i];
        planes[i] = glm::vec4(to_eye * glm::dvec4(x, y, z, offset));
    }
    kept_program_.use();
    view_.set_rays(kept_program_);
    kept_program_.set("planes", planes);
    cover_box();
}

void VolumeRays::find_limits(RaySheets& rays) {
    rays.limits.size(GL_RGBA32F, view_.width, view_.height);
    rays.limits.begin();
    gl_.ClearColor(never, never, never, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    render::bind(gl_, opaque_unit, view_.opaque);
    render::bind(gl_, kept_unit, view_.is_clipped() ? kept_.texture() : 0);
    render::bind(gl_, first_part_unit, rays.parts[0].texture());
    if (!limits_programs_.contains(rays.count))
        limits_programs_.emplace(rays.count, make_limits_program(gl_, rays.count));
    const ShaderProgram& program = limits_programs_.at(rays.count);
    program.use();
    program.set("first_part", int{first_part_unit});
    set_later_parts(program);
    bind_later_parts(gl_, rays);
    program.set("between_planes", int{kept_unit});
    program.set("has_planes", view_.is_clipped() ? 1.0F : 0.0F);
    program.set("opaque", int{opaque_unit});
    program.set("has_opaque", view_.opaque != 0 ? 1.0F : 0.0F);
    program.set("viewport", glm::vec2(view_.width, view_.height));
    const glm::dmat4& projection = view_.transform->projection;
    program.set("depth_row", glm::vec2(projection[2][2], projection[3][2]));
    program.set("parallel", view_.frame->camera.parallel ? 1.0F : 0.0F);
    cover_box();
}

void VolumeRays::set_units(const ShaderProgram& program) {
    program.set("limits", int{limits_unit});
    program.set("first_part", int{first_part_unit});
    program.set("between_planes", int{kept_unit});
    set_later_parts(program);
}

void VolumeRays::bind(const RaySheets& rays) const {
    render::bind(gl_, limits_unit, rays.limits.texture());
    render::bind(gl_, first_part_unit, rays.parts[0].texture());
    render::bind(gl_, kept_unit, view_.is_clipped() ? kept_.texture() : 0);
    bind_later_parts(gl_, rays);
}

void VolumeRays::finish() {
    begins_ = in_use_ == 0 ? 0 : sheets_.front().limits.texture();
    if (in_use_ < 2) return;
    nearest_.size(GL_RGBA32F, view_.width, view_.height);
    nearest_.begin();
    gl_.ClearColor(never, never, never, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_MIN);
    copy_program_.use();
    copy_program_.set("limits", int{limits_unit});
    auto sheet = sheets_.begin();
    for (std::size_t i = 0; i < in_use_; ++i, ++sheet) {
        render::bind(gl_, limits_unit, sheet->limits.texture());
        cover_box();
    }
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.Disable(GL_BLEND);
    begins_ = nearest_.texture();
}

void VolumeRays::cover_box() const {
    const PixelBox box = view_.seen_box(view_.width, view_.height);
    gl_.Scissor(box.left, box.bottom, box.width, box.height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Disable(GL_SCISSOR_TEST);
}

} // namespace server::render
