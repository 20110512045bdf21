#include "render/volume/volume_painter.hpp"

#include "color/transfer_table.hpp"
#include "render/context/pacing.hpp"
#include "render/context/shader_program.hpp"
#include "render/target/per_sample.hpp"
#include "render/volume/slab_angle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

namespace server::render {
namespace {

constexpr int table_unit = 1; // texture unit of the transfer table; VolumeRays does not use this unit
enum Unit : int { picture_unit = 0, opaque_unit = 1, covered_unit = 2, limits_unit = 3 }; // compositing programs

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }

// Returns (a, b): value * a + b is a position in the transfer table, from 0 to 1. An empty range maps to the middle.
glm::vec2 normalisation(const color::ColorScale& scale) {
    const color::TableExtent extent = color::table_extent(scale);
    const auto [low, high] = extent.values(scale.range);
    if (!(high > low)) return {0, static_cast<float>((0.5 + 0.5 * extent.halves_below) / extent.width())};
    return {static_cast<float>(1 / (high - low)), static_cast<float>(-low / (high - low))};
}

double thickness_of(const Volume& volume) { return volume.thickness * static_cast<double>(volume.stride); }

// The picture of all volumes is multiplied by this. A volume of smaller opacity has a table with less extinction.
float largest_opacity(const Frame& frame) {
    float largest = 0;
    for (const Volume& volume : frame.volumes) largest = std::max(largest, volume.opacity);
    return largest;
}

int coarseness_of(const Frame& frame) {
    int coarseness = 1;
    for (const Volume& volume : frame.volumes) coarseness = std::max(coarseness, volume.coarseness);
    return coarseness;
}

GLint format_of_picture(const Frame& frame) {
    const bool in_bytes = std::ranges::all_of(frame.volumes, [](const Volume& volume) { return volume.in_bytes; });
    return in_bytes && !frame.volumes.empty() ? GL_RGBA8 : GL_RGBA32F;
}

void check_directions(const Frame& frame) {
    for (const Volume& volume : frame.volumes) {
        if (volume.normal != frame.volumes[0].normal)
            throw ciel::Error(
                "the volumes of one picture are sliced in different directions; give all volumes the same direction");
        if (!std::isfinite(volume.first) || !std::isfinite(volume.thickness))
            throw ciel::Error(
                "the slices of a volume have a position or a distance that is not a finite number; both must "
                "be finite");
    }
}

} // namespace

VolumePainter::VolumePainter(const Gl& gl)
    : gl_(gl), picture_program_(make_volume_picture_program(gl, RaysOfPicture::one_for_each_pixel)),
      sample_program_(make_volume_picture_program(gl, RaysOfPicture::one_for_samples)),
      coarse_program_(make_volume_picture_program(gl, RaysOfPicture::one_for_several_pixels)), rays_(gl), reach_(gl),
      coverage_(gl), picture_(gl), together_(gl) {
    gl_.GenVertexArrays(1, &no_array_);
}

void VolumePainter::draw(const Frame& frame, const annotations::ViewTransform& transform, Target& target) {
    draw_each(
        frame, transform, {}, [&target] { target.bind_again(); }, frame.samples > 1 && surfaces_ != 0);
}

GLuint VolumePainter::picture_until(const Frame& frame, const annotations::ViewTransform& transform,
                                    const LayerInVolumes& layer) {
    together_.size(GL_RGBA32F, frame.width, frame.height);
    together_.begin();
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    draw_each(
        frame, transform, layer, [this] { together_.begin(); }, false);
    return together_.texture();
}

void VolumePainter::draw_each(const Frame& frame, const annotations::ViewTransform& transform,
                              const LayerInVolumes& layer, const std::function<void()>& bind_picture, bool per_sample) {
    check_directions(frame);
    const int coarseness = coarseness_of(frame);
    const float opacity = largest_opacity(frame);
    view_ = {&frame, &transform, layer.depth == 0 ? surfaces_ : layer.depth, std::max(1, frame.width / coarseness),
             std::max(1, frame.height / coarseness)};
    load_buffers(frame);
    slab_angle_ = frame.volumes.empty() ? 0 : slab_angle(view_, frame.volumes[0].normal);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    rays_.begin(view_);
    for (std::size_t i = 0; i < frame.volumes.size(); ++i) {
        const Volume& volume = frame.volumes[i];
        prepare(volume, slot_of(i), opacity > 0 ? static_cast<double>(volume.opacity) / opacity : 0);
    }
    rays_.finish();
    next_pass(gl_);
    draw_slabs(frame, layer);
    gl_.Disable(GL_DEPTH_TEST);
    next_pass(gl_);
    if (has_coverage()) find_coverage(frame);
    bind_picture();
    put_on_picture(opacity, coarseness > 1, per_sample);
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_DEPTH_TEST);
}

VolumePainter::Slot& VolumePainter::slot_of(std::size_t volume) {
    while (slots_.size() <= volume) slots_.emplace_back(gl_);
    return *std::next(slots_.begin(), static_cast<std::ptrdiff_t>(volume));
}

void VolumePainter::load_buffers(const Frame& frame) {
    for (std::size_t i = 0; i < frame.volumes.size(); ++i) {
        Slot& slot = slot_of(i);
        slot.buffers = frame.volumes[i].stride == 1 ? &slot.all : &slot.some;
        slot.buffers->load(frame.volumes[i]);
        next_pass(gl_);
        const auto& [low, high] = slot.buffers->bounds();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            view_.low[axis] = i == 0 ? low[axis] : std::min(view_.low[axis], double{low[axis]});
            view_.high[axis] = i == 0 ? high[axis] : std::max(view_.high[axis], double{high[axis]});
        }
    }
}

void VolumePainter::prepare(const Volume& volume, Slot& slot, double share) {
    load_table(volume, slot.table, share);
    slot.rays = &rays_.find(*slot.buffers);
    use_programs(volume, slot);
}

void VolumePainter::load_table(const Volume& volume, Table& kept, double share) {
    if (kept.texture == 0) gl_.GenTextures(1, &kept.texture);
    if (kept.is_made && kept.scale == volume.scale && kept.opacity_points == volume.opacity_points &&
        kept.share == share)
        return;
    const color::TransferTable table = color::make_transfer_table(volume.scale, volume.opacity_points, share);
    gl_.BindTexture(GL_TEXTURE_2D, kept.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, color::TransferTable::columns, color::TransferTable::rows, 0, GL_RGBA,
                   GL_FLOAT, table.texels.data());
    filter(gl_, GL_NEAREST);
    kept.densest = 0;
    for (std::size_t i = 3; i < table.texels.size(); i += 4)
        kept.densest = std::max(kept.densest, double{table.texels[i]});
    kept.is_made = true;
    kept.scale = volume.scale;
    kept.opacity_points = volume.opacity_points;
    kept.share = share;
}

void VolumePainter::use_programs(const Volume& volume, Slot& slot) {
    const double table_width = color::table_extent(volume.scale).width();
    const SlabProgramKind kind{
        slot.rays->count,           volume.shaded, view_.is_clipped(), view_.opaque != 0, view_.frame->camera.parallel,
        color::TransferTable::rows, table_width};
    const auto made = [&](auto& programs, auto make, const SlabProgramKind& wanted) {
        const auto found = programs.find(wanted);
        return &(found != programs.end() ? found : programs.emplace(wanted, make(gl_, wanted)).first)->second;
    };
    slot.inner = made(slot.inner_programs, make_inner_program,
                      {1, volume.shaded, false, false, false, color::TransferTable::rows, table_width});
    slot.inner->use();
    set_light(*slot.inner, volume);
    slot.slice = made(slot.slice_programs, make_slice_program, kind);
    slot.edge = made(slot.edge_programs, make_edge_program, kind);
    set_rays(*slot.slice, volume);
    set_rays(*slot.edge, volume);
    const RaysAcross across = rays_across(volume);
    slot.edge->set("across", glm::vec3(across.per_depth));
    slot.edge->set("start", glm::vec3(across.start - glm::dvec3(volume.first, 0, 0)));
    slot.edge->set("half_slab", static_cast<float>(thickness_of(volume) / 2));
    slot.edge->set("last_slab", static_cast<float>(slot.buffers->slices().size() - 1));
    if (view_.frame->camera.parallel) slot.edge->set("parallel_depths", view_.parallel_depths());
}

void VolumePainter::set_rays(const ShaderProgram& program, const Volume& volume) const {
    program.use();
    set_light(program, volume);
    const VolumeView::Rays rays = view_.rays_of_pixels();
    program.set("rays", glm::vec4(rays.corner, rays.step));
    program.set("pixel_size", 1.0F / glm::vec2(view_.width, view_.height));
    VolumeRays::set_units(program);
}

VolumePainter::RaysAcross VolumePainter::rays_across(const Volume& volume) const {
    const VolumeView::Rays rays = view_.rays_of_pixels();
    const glm::dvec3 normal = glm::dmat3(view_.transform->view) * vector_of(volume.normal); // in eye space
    const glm::dvec2 sideways(normal);
    return {{glm::dot(sideways, rays.corner) - normal.z, sideways * rays.step},
            {view_.eye_along(volume.normal) + glm::dot(sideways, rays.side_corner), sideways * rays.side_step}};
}

// REQUIRES: `program` is the GL program in use (ShaderProgram::use()).
void VolumePainter::set_light(const ShaderProgram& program, const Volume& volume) const {
    program.set("transform", glm::mat4(view_.transform->projection * view_.transform->view));
    program.set("view", glm::mat4(view_.transform->view));
    program.set("to_share", normalisation(volume.scale));
    program.set("density", static_cast<float>(1 / volume.unit_length));
    program.set("scale", static_cast<float>(view_.transform->scale));
    program.set("table", int{table_unit});
}

bool VolumePainter::has_coverage() const { return view_.frame->samples > 1 && view_.width == view_.frame->width; }

void VolumePainter::find_coverage(const Frame& frame) {
    Covered wanted{view_.places(), frame.samples, frame.clip, {}};
    std::vector<const VolumeBuffers*> buffers; // consecutive volumes with the same boundary have one entry
    for (std::size_t i = 0; i < frame.volumes.size(); ++i) {
        const VolumeBuffers* own = slot_of(i).buffers;
        if (!wanted.boundaries.empty() && wanted.boundaries.back() == own->boundary_places()) continue;
        wanted.boundaries.push_back(own->boundary_places());
        buffers.push_back(own);
    }
    if (wanted == covered_) return;
    covered_ = {}; // not valid if anything below throws
    coverage_.begin(view_);
    for (const VolumeBuffers* own : buffers) coverage_.add(*own);
    coverage_.finish();
    gl_.Enable(GL_BLEND);
    covered_ = std::move(wanted);
}

void VolumePainter::begin_picture(const Frame& frame, const LayerInVolumes& layer) {
    picture_.size(format_of_picture(frame), view_.width, view_.height);
    if (layer.depth != 0) {
        double thickest = 0;
        for (const Volume& volume : frame.volumes) thickest = std::max(thickest, thickness_of(volume));
        reach_.begin(view_, layer, picture_, rays_across(frame.volumes[0]).per_depth / thickest);
    } else {
        picture_.begin();
    }
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void VolumePainter::draw_slabs(const Frame& frame, const LayerInVolumes& layer) {
    begin_picture(frame, layer);
    std::vector<const Slot*> slots;
    std::vector<SlabRow> rows;
    for (const Volume& volume : frame.volumes) {
        slots.push_back(&slot_of(slots.size()));
        rows.push_back({volume.first, thickness_of(volume), slots.back()->buffers->slices().size()});
    }
    const Slot* bound = nullptr;
    for (const auto& [volume, slab, share] : back_to_front(rows, eye_across(frame), pieces_of_slabs(frame))) {
        const Slot* slot = slots[volume];
        if (slot != bound) bind(gl_, table_unit, slot->table.texture);
        if (bound == nullptr || slot->rays != bound->rays) rays_.bind(*slot->rays);
        bound = slot;
        if (rows.size() > 1) thin_out(frame.volumes[volume], *slot, share);
        if (layer.depth != 0)
            draw_slab_until(frame.volumes[volume], *slot, slab);
        else
            draw_slab(frame.volumes[volume], *slot, slab);
    }
}

void VolumePainter::use_edge(const Volume& volume, const Slot& slot, std::size_t slab, double place) {
    slot.edge->use();
    slot.edge->set("slab", static_cast<float>(slab));
    slot.edge->set("slice_place", static_cast<float>(place - volume.first));
    slot.buffers->bind_boundary();
}

// The error from a wrong order of two pieces is about the product of their optical depths, so dense slabs are divided.
SlabPieces VolumePainter::pieces_of_slabs(const Frame& frame) const {
    // least_loss: largest geometric mean of the optical depths of coincident pieces. widest: limit of slab_angle_.
    constexpr double least_loss = 0.1, widest = 3;
    double first = 0, second = 0; // the two largest extinctions per unit of length
    bool moving = false;
    auto slot = slots_.begin();
    for (const Volume& volume : frame.volumes) {
        const double loss = (slot++)->table.densest / volume.unit_length;
        second = std::max(second, std::min(first, loss));
        first = std::max(first, loss);
        moving = moving || volume.stride > 1;
    }
    const double slant = std::hypot(1, std::min(slab_angle_, widest));
    return {std::sqrt(first * second) * slant / least_loss, moving ? 2U : 6U};
}

void VolumePainter::thin_out(const Volume& volume, const Slot& slot, double share) {
    for (const ShaderProgram* program : {slot.edge, slot.slice, slot.inner}) {
        program->use();
        program->set("density", static_cast<float>(share / volume.unit_length));
    }
}

void VolumePainter::draw_ranges(const VolumeBuffers& buffers, const std::vector<BoxedRange>& ranges) const {
    IndexRange together;
    for (const BoxedRange& boxed : ranges) {
        if (!reach_.meets(boxed.low, boxed.high)) continue;
        if (together.first + static_cast<std::size_t>(together.count) != boxed.range.first || together.count == 0) {
            buffers.draw(together);
            together = boxed.range;
        } else {
            together.count += boxed.range.count;
        }
    }
    buffers.draw(together);
}

void VolumePainter::draw_slab_until(const Volume& volume, const Slot& slot, std::size_t slab) const {
    const double place = volume.first + (static_cast<double>(slab) + 0.5) * thickness_of(volume);
    use_edge(volume, slot, slab, place);
    draw_ranges(*slot.buffers, slot.buffers->ranges_of_boundary(slab));
    slot.slice->use();
    set_slice(*slot.slice, volume, place);
    slot.buffers->bind_slices();
    draw_ranges(*slot.buffers, slot.buffers->ranges_of_slice(slab));
}

void VolumePainter::draw_slab(const Volume& volume, const Slot& slot, std::size_t slab) const {
    const double place = volume.first + (static_cast<double>(slab) + 0.5) * thickness_of(volume);
    if (slot.buffers->boundary_of_slabs()[slab].count > 0) {
        use_edge(volume, slot, slab, place);
        slot.buffers->draw(slot.buffers->boundary_of_slabs()[slab]);
    }
    slot.slice->use();
    set_slice(*slot.slice, volume, place);
    slot.buffers->bind_slices();
    const auto& [outer, inner] = slot.buffers->slices()[slab];
    slot.buffers->draw(outer);
    if (inner.count == 0) return;
    const double from_eye = place - view_.eye_along(volume.normal);
    if (is_full(volume, from_eye)) {
        slot.inner->use();
        slot.inner->set("half_of", half_of_slab(volume, from_eye));
    }
    slot.buffers->draw(inner);
}

// Both uniforms are in half slabs along the normal. `across`: advance of a ray per unit of depth. `start`: distance
// from the start of a ray, at depth 0, to the slice.
void VolumePainter::set_slice(const ShaderProgram& program, const Volume& volume, double place) const {
    const auto [per_depth, start] = rays_across(volume);
    const double ahead = view_.frame->camera.parallel ? per_depth.x : place - start.x;
    const double half_slabs = std::copysign(2 / thickness_of(volume), ahead);
    program.set("across", glm::vec3(half_slabs * per_depth));
    program.set("start", glm::vec3(half_slabs * (glm::dvec3(place, 0, 0) - start)));
}

bool VolumePainter::is_full(const Volume& volume, double from_eye) const {
    if (view_.opaque != 0 || view_.is_clipped() || slab_angle_ > widest_inner) return false;
    // If the eye is less than one slab from the slice, pieces begin at the eye. The inner program cannot draw these.
    return view_.frame->camera.parallel || std::abs(from_eye) > 1.01 * thickness_of(volume);
}

glm::vec4 VolumePainter::half_of_slab(const Volume& volume, double from_eye) const {
    const auto half = static_cast<float>(thickness_of(volume) / 2);
    if (!view_.frame->camera.parallel) return {0, 0, 0, half / static_cast<float>(std::abs(from_eye))};
    const glm::dvec3 normal = glm::dmat3(view_.transform->view) * vector_of(volume.normal);
    return {0, 0, -half / static_cast<float>(std::abs(normal.z)), 0};
}

double VolumePainter::eye_across(const Frame& frame) const {
    const ciel::Vec3d& normal = frame.volumes[0].normal;
    if (!frame.camera.parallel) return view_.eye_along(normal);
    const glm::dvec3 back(glm::inverse(view_.transform->view)[2]);
    const double infinity = std::numeric_limits<double>::infinity();
    return glm::dot(vector_of(normal), back) > 0 ? infinity : -infinity;
}

void VolumePainter::put_on_picture(float opacity, bool coarse, bool per_sample) const {
    bind(gl_, picture_unit, picture_.texture());
    filter(gl_, coarse ? GL_LINEAR : GL_NEAREST);
    const bool beside_surfaces = coarse && view_.opaque != 0;
    const ShaderProgram& program =
        per_sample ? sample_program_ : (beside_surfaces ? coarse_program_ : picture_program_);
    program.use();
    program.set("volume", int{picture_unit});
    program.set("viewport", glm::vec2(view_.frame->width, view_.frame->height));
    program.set("opacity", opacity);
    program.set("has_covered", has_coverage() ? 1.0F : 0.0F);
    program.set("covered", int{covered_unit});
    program.set("limits", int{limits_unit});
    bind(gl_, covered_unit, has_coverage() ? coverage_.texture() : 0);
    bind(gl_, limits_unit, rays_.begin_of_all());
    const auto cover = [&] {
        gl_.BindVertexArray(no_array_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    };
    const PixelBox box = view_.seen_box(view_.frame->width, view_.frame->height);
    gl_.Scissor(box.left, box.bottom, box.width, box.height);
    gl_.Enable(GL_SCISSOR_TEST);
    if (beside_surfaces) {
        bind(gl_, opaque_unit, view_.opaque);
        program.set("opaque", int{opaque_unit});
    }
    if (per_sample)
        draw_per_sample(gl_, program, {view_.opaque, opaque_unit}, cover);
    else
        cover();
    gl_.Disable(GL_SCISSOR_TEST);
}

} // namespace server::render
