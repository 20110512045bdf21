#include "render/volume_painter.hpp"

#include "render/mesh_buffers.hpp"
#include "render/shaders.hpp"
#include "render/transfer_table.hpp"

#include <algorithm>
#include <glm/matrix.hpp>

namespace ciel::render {
namespace {

constexpr float never = 1e30F; // as in the programs

enum Unit : int { limits_unit = 0, table_unit = 1, opaque_unit = 2, first_part_unit = 3, kept_unit = 7 };
static_assert(first_part_unit + most_ray_parts <= kept_unit);

glm::dvec3 vector_of(const Vec3d& v) { return {v[0], v[1], v[2]}; }

void bind(const Gl& gl, int unit, GLuint texture) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.ActiveTexture(GL_TEXTURE0);
}

void filter(const Gl& gl, GLint how) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, how);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, how);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

// Value * a + b runs from 0 to 1 over the range; a range of no width sends everything to the middle.
glm::vec2 normalisation(const std::array<float, 2>& range) {
    const double width = static_cast<double>(range[1]) - static_cast<double>(range[0]);
    if (!(width > 0)) return {0, 0.5F};
    return {static_cast<float>(1 / width), static_cast<float>(-static_cast<double>(range[0]) / width)};
}

} // namespace

VolumePainter::VolumePainter(const Gl& gl)
    : gl_(gl), first_part_(make_part_program(gl, true)), next_part_(make_part_program(gl, false)),
      kept_program_(make_kept_program(gl)), limits_program_(make_limits_program(gl)),
      picture_program_(make_volume_picture_program(gl)), kept_(make_sheet()), limits_(make_sheet()),
      picture_(make_sheet()), together_(make_sheet()) {
    for (Sheet& part : parts_) part = make_sheet();
    gl_.GenQueries(1, &query_);
    gl_.GenVertexArrays(1, &no_array_);
}

VolumePainter::Sheet VolumePainter::make_sheet() const {
    Sheet sheet;
    gl_.GenTextures(1, &sheet.texture);
    gl_.GenFramebuffers(1, &sheet.framebuffer);
    return sheet;
}

void VolumePainter::size(Sheet& sheet, GLint format, int width, int height) const {
    if (sheet.width == width && sheet.height == height) return;
    gl_.BindTexture(GL_TEXTURE_2D, sheet.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    filter(gl_, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sheet.texture, 0);
    sheet.width = 0; // not usable until it is known to be complete
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the GL driver cannot draw a volume to " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels of floats; ask for a smaller picture");
    sheet.width = width;
    sheet.height = height;
}

void VolumePainter::begin(const Sheet& sheet) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
    gl_.Viewport(0, 0, sheet.width, sheet.height);
}

void VolumePainter::draw(const Frame& frame, const ViewTransform& transform, Target& target) {
    draw_each(frame, transform, surfaces_, [&target] { target.bind_again(); });
}

GLuint VolumePainter::picture_until(const Frame& frame, const ViewTransform& transform, GLuint depth) {
    size(together_, GL_RGBA32F, frame.width, frame.height);
    begin(together_);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    draw_each(frame, transform, depth == 0 ? surfaces_ : depth, [this] { begin(together_); });
    return together_.texture;
}

void VolumePainter::draw_each(const Frame& frame, const ViewTransform& transform, GLuint depth,
                              const std::function<void()>& bind_picture) {
    frame_ = &frame;
    transform_ = &transform;
    opaque_ = depth;
    gl_.Disable(GL_DEPTH_TEST);
    gl_.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    for (std::size_t i = 0; i < frame.volumes.size(); ++i) {
        const Volume& volume = frame.volumes[i];
        width_ = std::max(1, frame.width / std::max(1, volume.coarseness));
        height_ = std::max(1, frame.height / std::max(1, volume.coarseness));
        draw_volume(volume, i);
        bind_picture();
        put_on_picture(volume);
    }
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_DEPTH_TEST);
}

void VolumePainter::draw_volume(const Volume& volume, std::size_t slot) {
    VolumeBuffers& buffers = buffers_of(slot);
    buffers.load(volume);
    load_table(volume, slot);
    gl_.Enable(GL_BLEND);
    const int parts = find_parts(buffers);
    gl_.Disable(GL_BLEND);
    find_kept();
    find_limits(parts);
    gl_.Enable(GL_BLEND);
    draw_slabs(volume, buffers, parts);
}

VolumeBuffers& VolumePainter::buffers_of(std::size_t slot) {
    while (buffers_.size() <= slot) buffers_.emplace_back(gl_);
    return *std::next(buffers_.begin(), static_cast<std::ptrdiff_t>(slot));
}

int VolumePainter::find_parts(const VolumeBuffers& buffers) {
    const glm::mat4 transform(transform_->projection * transform_->view);
    for (const ShaderProgram* program : {&first_part_, &next_part_}) {
        program->use();
        program->set("transform", transform);
        program->set("parallel_depths", parallel_depths());
    }
    gl_.BlendEquation(GL_MIN);
    buffers.bind_boundary();
    gl_.ClearColor(never, never, never, never);
    size(parts_[0], GL_RG32F, width_, height_);
    begin(parts_[0]);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    first_part_.use();
    first_part_.set("eye_in_bounds", eye_is_in_bounds() ? 1.0F : 0.0F);
    buffers.draw(buffers.whole_boundary());
    int parts = 1;
    next_part_.use();
    next_part_.set("before", int{first_part_unit});
    gl_.Enable(GL_CULL_FACE);
    while (parts < most_ray_parts && find_next_part(buffers, parts)) ++parts;
    gl_.Disable(GL_CULL_FACE);
    gl_.BlendEquation(GL_FUNC_ADD);
    return parts;
}

// False, and to be ignored, where no ray enters the mesh again.
bool VolumePainter::find_next_part(const VolumeBuffers& buffers, int part) {
    size(parts_[part], GL_RG32F, width_, height_);
    begin(parts_[part]);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    bind(gl_, first_part_unit, parts_[part - 1].texture);
    gl_.CullFace(GL_BACK);
    gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, query_);
    buffers.draw(buffers.whole_boundary());
    gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
    GLuint any = 0;
    gl_.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &any);
    if (any == 0) return false;
    gl_.CullFace(GL_FRONT);
    buffers.draw(buffers.whole_boundary());
    return true;
}

void VolumePainter::find_kept() {
    if (!is_clipped()) return;
    size(kept_, GL_RG32F, width_, height_);
    begin(kept_);
    const glm::dmat4 to_eye = glm::transpose(glm::inverse(transform_->view));
    std::array<glm::vec4, most_clip_planes> planes;
    planes.fill({0, 0, 0, 1});
    for (std::size_t i = 0; i < frame_->clip.size(); ++i) {
        const auto& [x, y, z, offset] = frame_->clip[i];
        planes[i] = glm::vec4(to_eye * glm::dvec4(x, y, z, offset));
    }
    kept_program_.use();
    set_rays(kept_program_);
    kept_program_.set("planes", planes);
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void VolumePainter::find_limits(int parts) {
    size(limits_, GL_RGBA32F, width_, height_);
    begin(limits_);
    bind(gl_, opaque_unit, opaque_);
    bind(gl_, kept_unit, is_clipped() ? kept_.texture : 0);
    limits_program_.use();
    bind(gl_, first_part_unit, parts_[0].texture);
    limits_program_.set("first_part", int{first_part_unit});
    bind_later_parts(limits_program_, parts);
    limits_program_.set("parts", parts);
    limits_program_.set("between_planes", int{kept_unit});
    limits_program_.set("has_planes", is_clipped() ? 1.0F : 0.0F);
    limits_program_.set("opaque", int{opaque_unit});
    limits_program_.set("has_opaque", opaque_ != 0 ? 1.0F : 0.0F);
    limits_program_.set("viewport", glm::vec2(width_, height_));
    limits_program_.set("depth_row", glm::vec2(transform_->projection[2][2], transform_->projection[3][2]));
    limits_program_.set("parallel", frame_->camera.parallel ? 1.0F : 0.0F);
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void VolumePainter::load_table(const Volume& volume, std::size_t slot) {
    while (tables_.size() <= slot) {
        tables_.emplace_back();
        gl_.GenTextures(1, &tables_.back().texture);
    }
    Table& kept = tables_[slot];
    bind(gl_, table_unit, kept.texture);
    if (kept.is_made && kept.scale == volume.scale && kept.opacity_points == volume.opacity_points) return;
    const TransferTable table = make_transfer_table(volume);
    gl_.BindTexture(GL_TEXTURE_2D, kept.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, TransferTable::columns, TransferTable::rows, 0, GL_RGBA, GL_FLOAT,
                   table.texels.data());
    filter(gl_, GL_NEAREST);
    kept.is_made = true;
    kept.scale = volume.scale;
    kept.opacity_points = volume.opacity_points;
}

// An inner wall in front of an eye inside is an exit and an entry at once, and either may come first.
bool VolumePainter::eye_is_in_bounds() const {
    const Vec3d& eye = frame_->camera.position;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (eye[axis] < frame_->bounds_min[axis] || eye[axis] > frame_->bounds_max[axis]) return false;
    return !frame_->camera.parallel;
}

glm::vec2 VolumePainter::parallel_depths() const {
    if (!frame_->camera.parallel) return {0, 0};
    // z = a * -depth + b runs from -1 to 1.
    const double a = transform_->projection[2][2], b = transform_->projection[3][2];
    return {static_cast<float>((b + 1) / a), static_cast<float>(-2 / a)};
}

void VolumePainter::bind_later_parts(const ShaderProgram& program, int parts) const {
    for (int i = 1; i < most_ray_parts; ++i) {
        program.set(("part_" + std::to_string(i)).c_str(), first_part_unit + i);
        bind(gl_, first_part_unit + i, i < parts ? parts_[i].texture : 0);
    }
}

VolumePainter::Rays VolumePainter::rays_of_pixels() const {
    const glm::dvec2 corner(1 / transform_->projection[0][0], 1 / transform_->projection[1][1]);
    const glm::dvec2 step = 2.0 * corner / glm::dvec2(width_, height_);
    if (frame_->camera.parallel) return {{}, {}, -corner, step};
    return {-corner, step, {}, {}};
}

// Of the program in use.
void VolumePainter::set_rays(const ShaderProgram& program) const {
    const Rays rays = rays_of_pixels();
    program.set("ray_corner", glm::vec2(rays.corner));
    program.set("ray_step", glm::vec2(rays.step));
    program.set("side_corner", glm::vec2(rays.side_corner));
    program.set("side_step", glm::vec2(rays.side_step));
}

void VolumePainter::set_slabs(const ShaderProgram& program, const Volume& volume, double thickness, int parts) const {
    program.use();
    set_rays(program);
    program.set("transform", glm::mat4(transform_->projection * transform_->view));
    program.set("view", glm::mat4(transform_->view));
    program.set("to_share", normalisation(volume.scale.range));
    program.set("parallel_depths", parallel_depths());
    const Rays rays = rays_of_pixels();
    const glm::dvec3 normal = glm::dmat3(transform_->view) * vector_of(volume.normal); // along the eye's axes
    const glm::dvec2 sideways(normal);
    program.set("across_corner", static_cast<float>(glm::dot(sideways, rays.corner) - normal.z));
    program.set("across_step", glm::vec2(sideways * rays.step));
    program.set("start_corner", static_cast<float>(eye_place(volume) + glm::dot(sideways, rays.side_corner)));
    program.set("start_step", glm::vec2(sideways * rays.side_step));
    program.set("half_slab", static_cast<float>(thickness / 2));
    program.set("density", static_cast<float>(1 / volume.unit_length));
    // Where the property changes by less than a third of its range along the whole mesh there is no surface to light.
    program.set("steepness", static_cast<float>(0.1 * transform_->scale * transform_->scale));
    program.set("limits", int{limits_unit});
    program.set("table", int{table_unit});
    program.set("between_planes", int{kept_unit});
    bind_later_parts(program, parts);
}

void VolumePainter::draw_slabs(const Volume& volume, const VolumeBuffers& buffers, int parts) {
    const double thickness = volume.thickness * static_cast<double>(volume.stride);
    const SlabProgramKind kind{parts, volume.shaded, is_clipped(), TransferTable::rows};
    const ShaderProgram& slice = slice_program(kind);
    const ShaderProgram& edge = edge_program(kind);
    const std::size_t slabs = buffers.slices().size();
    set_slabs(slice, volume, thickness, parts);
    set_slabs(edge, volume, thickness, parts);
    edge.set("first_place", static_cast<float>(volume.first));
    edge.set("last_slab", static_cast<float>(slabs - 1));

    size(picture_, GL_RGBA32F, width_, height_);
    begin(picture_);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    bind(gl_, limits_unit, limits_.texture);
    for (const std::size_t slab : back_to_front(volume, slabs)) {
        const auto place = static_cast<float>(volume.first + (static_cast<double>(slab) + 0.5) * thickness);
        if (buffers.boundary_of_slabs()[slab].count > 0) {
            edge.use();
            edge.set("slab", static_cast<float>(slab));
            edge.set("slice_place", place);
            buffers.bind_boundary();
            buffers.draw(buffers.boundary_of_slabs()[slab]);
        }
        slice.use();
        slice.set("slice_place", place);
        buffers.bind_slices();
        buffers.draw(buffers.slices()[slab]);
    }
}

double VolumePainter::eye_place(const Volume& volume) const {
    return glm::dot(vector_of(volume.normal), glm::dvec3(glm::inverse(transform_->view)[3]));
}

// Rays run up on one side of the eye and down on the other.
std::vector<std::size_t> VolumePainter::back_to_front(const Volume& volume, std::size_t slabs) const {
    const glm::dmat4 back = glm::inverse(transform_->view);
    const glm::dvec3 normal = vector_of(volume.normal);
    const double thickness = volume.thickness * static_cast<double>(volume.stride);
    double eye = (eye_place(volume) - volume.first) / thickness; // in slabs
    if (frame_->camera.parallel) eye = glm::dot(normal, glm::dvec3(back[2])) > 0 ? 1e9 : -1e9;
    const auto below = static_cast<std::size_t>(std::clamp(std::floor(eye), 0.0, static_cast<double>(slabs)));
    std::vector<std::size_t> order;
    for (std::size_t slab = 0; slab < below; ++slab) order.push_back(slab);
    for (std::size_t slab = slabs; slab > below; --slab) order.push_back(slab - 1);
    return order;
}

const ShaderProgram& VolumePainter::slice_program(const SlabProgramKind& kind) {
    const auto found = slice_programs_.find(kind);
    return found != slice_programs_.end() ? found->second
                                          : slice_programs_.emplace(kind, make_slice_program(gl_, kind)).first->second;
}

const ShaderProgram& VolumePainter::edge_program(const SlabProgramKind& kind) {
    const auto found = edge_programs_.find(kind);
    return found != edge_programs_.end() ? found->second
                                         : edge_programs_.emplace(kind, make_edge_program(gl_, kind)).first->second;
}

void VolumePainter::put_on_picture(const Volume& volume) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, picture_.texture);
    filter(gl_, volume.coarseness > 1 ? GL_LINEAR : GL_NEAREST);
    picture_program_.use();
    picture_program_.set("volume", 0);
    picture_program_.set("viewport", glm::vec2(frame_->width, frame_->height));
    picture_program_.set("opacity", volume.opacity);
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace ciel::render
