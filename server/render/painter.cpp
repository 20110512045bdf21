#include "render/painter.hpp"

#include "render/frame/frame_properties.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <unordered_map>

namespace server::render {
namespace {

std::string text_of(const Gl& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

constexpr int limits_unit = 2, occlusion_unit = 2; // texture units; ColorScales uses units 0 and 1

// The plain program is faster than the full program, because a software rasterizer also spends time on unused features.
bool is_plain(const Primitives& primitives, const Frame& frame) {
    return !primitives.lines && !primitives.points && primitives.scalars.empty() && !primitives.normals.empty() &&
           frame.clip.empty();
}

} // namespace

Painter::Painter(const Gl& gl)
    : gl_(gl), pacing_(gl_), renderer_name_(text_of(gl_, GL_RENDERER)), version_(text_of(gl_, GL_VERSION)),
      triangles_(make_triangle_program(gl_)), plain_(make_plain_program(gl_)), normals_(make_normals_program(gl_)),
      occluded_(make_occluded_program(gl_)), lines_(make_line_program(gl_)), points_(make_point_program(gl_)),
      scales_(gl_), target_(gl_), picture_(gl_, target_), opaque_depth_(gl_), occlusion_(gl_), slopes_(gl_),
      transparent_(gl_), transparent_points_(gl_), peeling_(gl_), volumes_(gl_), overlay_(gl_) {
    gl_.pacing = &pacing_;
    gl_.Enable(GL_PROGRAM_POINT_SIZE);
    set_first_state();
}

const Image& Painter::draw(const Frame& frame, const AfterStage& after) {
    try {
        const Image& image = draw_paced(frame, after);
        pacing_.end();
        return image;
    } catch (...) { // the GL state is unknown after an exception
        pacing_.end();
        set_first_state();
        throw;
    }
}

// Sets the GL state that draw_paced() expects at its start and restores at its end.
void Painter::set_first_state() {
    for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_DEPTH_CLAMP})
        gl_.Disable(off);
    for (std::size_t i = 0; i < most_clip_planes; ++i) gl_.Disable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.ClearDepth(1);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.ActiveTexture(GL_TEXTURE0);
    set_cover_part(0);
}

void Painter::set_cover_part(float part) {
    gl_.UseProgram(lines_.id);
    gl_.Uniform1f(lines_.cover_part, part);
}

const Image& Painter::draw_paced(const Frame& frame, const AfterStage& after) {
    const auto finished = [&](DrawStage stage) {
        if (!after) return;
        gl_.Finish();
        after(stage);
    };
    transform_ = annotations::view_transform(frame);
    clip_planes_ = frame.clip.size();
    if (clip_planes_ > most_clip_planes)
        throw ciel::Error("a picture can have at most " + std::to_string(most_clip_planes) +
                          " clip planes; remove some of them");
    origin_ = frame.origin;
    remarks_.clear();
    width_ = height_ = 0; // pick() finds nothing after a failed draw
    pacing_.begin(frame.check_wanted);
    load_scales(frame);
    upload(frame);
    finished(DrawStage::upload);
    overlay_.prepare(frame);
    pacing_.pass();
    picture_.begin({frame.width, frame.height, frame.samples, frame.background_top, frame.background_bottom},
                   touched_by(frame));
    enable_clip_planes(true);
    draw_opaque(frame);
    pacing_.pass();
    find_slopes(frame);
    draw_opaque_points(frame);
    pacing_.pass();
    gl_.Enable(GL_BLEND);
    if (!has_overlays_in_layers(frame)) draw_lines(frame);
    pacing_.pass();
    draw_transparent(frame);
    gl_.Disable(GL_BLEND);
    enable_clip_planes(false);
    pacing_.pass();
    overlay_.draw(frame);
    finished(DrawStage::draw);
    const Image& image = picture_.read();
    finished(DrawStage::read);
    width_ = frame.width;
    height_ = frame.height;
    return image;
}

// Clip planes must be off for shaders that write no gl_ClipDistance.
void Painter::enable_clip_planes(bool on) {
    for (std::size_t i = 0; i < clip_planes_; ++i) {
        const auto plane = static_cast<GLenum>(GL_CLIP_DISTANCE0 + i);
        if (on)
            gl_.Enable(plane);
        else
            gl_.Disable(plane);
    }
}

void Painter::load_scales(const Frame& frame) {
    scales_.begin();
    scale_rows_.clear();
    for (const Primitives& primitives : frame.primitives)
        scale_rows_.push_back(primitives.scalars.empty() ? ScaleRow{} : scales_.row_of(primitives.scale));
    scales_.upload();
}

void Painter::upload(const Frame& frame) {
    assign_buffers(frame);
    std::vector<ScaledPrimitives> transparent;
    std::vector<ScaledPrimitives> points;
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        const Primitives& primitives = frame.primitives[i];
        if (primitives.indices.empty()) continue;
        if (!is_transparent(primitives)) {
            buffers(i).load(primitives);
            pacing_.pass();
        } else if (primitives.color[3] > 0 && primitives.points) {
            points.push_back({&primitives, scale_rows_[i]});
        } else if (primitives.color[3] > 0) {
            check_primitives(primitives);
            transparent.push_back({&primitives, scale_rows_[i]});
        }
    }
    const glm::mat4 view(transform_.view);
    const glm::vec4 depth_row(view[0].z, view[1].z, view[2].z, view[3].z);
    transparent_.load(transparent, depth_row, !is_peeled(frame));
    pacing_.pass();
    transparent_points_.load(points, depth_row);
}

// Primitives keep their buffers if their index in the frame changes. Transparent triangles and points have their own
// buffers in transparent_ and transparent_points_.
void Painter::assign_buffers(const Frame& frame) {
    std::unordered_map<std::uint64_t, PrimitiveBuffers*> holding;
    std::vector<PrimitiveBuffers*> rest;
    for (PrimitiveBuffers& buffers : buffers_)
        if (buffers.identity() == 0 || !holding.emplace(buffers.identity(), &buffers).second) rest.push_back(&buffers);
    slots_.assign(frame.primitives.size(), nullptr);
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        const auto found = holding.find(frame.primitives[i].identity);
        if (is_transparent(frame.primitives[i]) || found == holding.end()) continue;
        slots_[i] = found->second;
        holding.erase(found);
    }
    for (const auto& [identity, buffers] : holding) rest.push_back(buffers);
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        if (slots_[i] != nullptr || is_transparent(frame.primitives[i])) continue;
        if (rest.empty()) rest.push_back(&buffers_.emplace_back(gl_));
        slots_[i] = rest.back();
        rest.pop_back();
    }
}

// Frames with volumes or several samples touch all tiles, because clearing and reading take little of their time.
TouchedTiles Painter::touched_by(const Frame& frame) const {
    TouchedTiles touched(frame.width, frame.height);
    if (frame.samples > 1 || !frame.volumes.empty()) {
        touched.touch_all();
        return touched;
    }
    for (const Primitives& primitives : frame.primitives)
        if (!primitives.indices.empty() && primitives.color[3] > 0) touched.touch(primitives, transform_);
    overlay_.touch(touched, frame.height);
    return touched;
}

void Painter::use(const Program& program, const Frame& frame) {
    const glm::mat4 view(transform_.view);
    const glm::mat4 projection(transform_.projection);
    gl_.UseProgram(program.id);
    gl_.UniformMatrix4fv(program.view, 1, GL_FALSE, glm::value_ptr(view));
    gl_.UniformMatrix4fv(program.projection, 1, GL_FALSE, glm::value_ptr(projection));
    gl_.Uniform1f(program.scale, static_cast<float>(transform_.scale));
    gl_.Uniform1f(program.parallel, frame.camera.parallel ? 1.0F : 0.0F);
    gl_.Uniform3f(program.lights, frame.lighting.ambient, frame.lighting.headlight, frame.lighting.key_light);
    // Unused planes are set to (0, 0, 0, 1), which clips nothing. llvmpipe may still clip by a plane after glDisable.
    std::array<std::array<float, 4>, most_clip_planes> planes{};
    planes.fill({0, 0, 0, 1});
    std::copy(frame.clip.begin(), frame.clip.end(), planes.begin());
    gl_.Uniform4fv(program.clip, most_clip_planes, planes[0].data());
    gl_.Uniform1i(program.scale_colors, 0);
    gl_.Uniform1i(program.scale_rules, 1);
    gl_.Uniform2f(program.viewport, static_cast<float>(frame.width), static_cast<float>(frame.height));
    scales_.bind();
}

// Vertices of the plain program have only position and normal, so color and lighting are uniforms.
void Painter::use_look(const Frame& frame, const Primitives& primitives) {
    const glm::dmat4& projection = transform_.projection;
    const bool parallel = frame.camera.parallel;
    const double right = parallel ? 0 : 1 / projection[0][0], up = parallel ? 0 : 1 / projection[1][1];
    gl_.Uniform4f(plain_.look, static_cast<float>(2 * right / frame.width), static_cast<float>(2 * up / frame.height),
                  static_cast<float>(-right), static_cast<float>(-up));
    gl_.Uniform4f(plain_.solid, primitives.color[0], primitives.color[1], primitives.color[2], primitives.color[3]);
    gl_.Uniform1f(plain_.lit, primitives.lit ? 1.0F : 0.0F);
}

void Painter::draw_primitives(const Frame& frame, const Program& program, bool before_volume) {
    use(program, frame);
    const bool surfaces = &program == &triangles_ || &program == &occluded_;
    const Program* in_use = &program;
    if (&program == &occluded_) use_occlusion(frame);
    if (&program == &lines_) {
        slopes_.use(program);
        gl_.ActiveTexture(GL_TEXTURE0 + limits_unit);
        gl_.BindTexture(GL_TEXTURE_2D, volumes_.limits());
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.Uniform1i(program.volume_limits, limits_unit);
        gl_.Uniform1f(program.before_volume, before_volume ? 1.0F : 0.0F);
    }
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        const Primitives& primitives = frame.primitives[i];
        const Program& own = primitives.lines ? lines_ : surfaces ? program : triangles_;
        if (&own != &program || primitives.points || is_transparent(primitives) || primitives.indices.empty()) continue;
        if (primitives.lines) use_line(program, primitives, 1);
        if (const Program& fitting = &own == &triangles_ && is_plain(primitives, frame) ? plain_ : own;
            &fitting != in_use) {
            use(fitting, frame);
            in_use = &fitting;
        }
        if (in_use == &plain_) use_look(frame, primitives);
        buffers(i).draw(primitives, scale_rows_[i]);
    }
}

// `factor`: framebuffer pixels per picture pixel along a side.
void Painter::use_line(const Program& program, const Primitives& primitives, float factor) const {
    gl_.Uniform1f(program.half_width, factor * primitives.line_width / 2);
    gl_.Uniform1f(program.on_opaque, primitives.on_opaque ? 1.0F : 0.0F);
}

// Transparent triangles are drawn after lines. A pixel that a line covers partly would hide these triangles if it wrote
// depth. Therefore only a pixel that a line covers by at least half writes depth, and is drawn as fully covered.
void Painter::draw_lines(const Frame& frame) {
    if (is_peeled(frame) || transparent_.is_empty()) return draw_primitives(frame, lines_);
    const auto draw_part = [&](float part) {
        set_cover_part(part);
        draw_primitives(frame, lines_);
    };
    gl_.DepthMask(GL_FALSE);
    draw_part(1);
    gl_.DepthMask(GL_TRUE);
    draw_part(2);
    set_cover_part(0);
}

void Painter::draw_opaque(const Frame& frame) {
    const bool any = std::ranges::any_of(frame.primitives, is_opaque);
    const bool is_occluded = any && frame.occlusion.radius > 0;
    if (is_occluded || (any && !frame.volumes.empty())) draw_opaque_depth(frame, is_occluded);
    volumes_.end_on(any ? opaque_depth_.texture() : 0);
    pacing_.pass();
    if (is_occluded) occlusion_.find(frame, transform_, opaque_depth_);
    target_.bind_again();
    draw_primitives(frame, is_occluded ? occluded_ : triangles_);
}

void Painter::find_slopes(const Frame& frame) {
    slopes_.begin();
    if (std::ranges::none_of(frame.primitives, is_overlay)) return;
    if (std::ranges::any_of(frame.primitives, is_opaque)) slopes_.copy_opaque(target_, frame.width, frame.height);
    if (transparent_.is_empty()) return;
    slopes_.find_sheets(frame.width, frame.height, [&] {
        use(slopes_.program(), frame);
        transparent_.draw();
    });
    target_.bind_again();
}

void Painter::draw_opaque_depth(const Frame& frame, bool with_normals) {
    opaque_depth_.begin(frame.width, frame.height, with_normals);
    draw_depths(frame, with_normals ? normals_ : triangles_);
}

void Painter::draw_depths(const Frame& frame, const Program& program) {
    use(program, frame);
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        if (!is_opaque(frame.primitives[i])) continue;
        buffers(i).draw(frame.primitives[i], scale_rows_[i]);
    }
}

void Painter::use_occlusion(const Frame& frame) {
    gl_.ActiveTexture(GL_TEXTURE0 + occlusion_unit);
    gl_.BindTexture(GL_TEXTURE_2D, occlusion_.light());
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.Uniform1i(occluded_.occlusion, occlusion_unit);
    gl_.Uniform1f(occluded_.occlusion_stride, static_cast<float>(occlusion_.stride()));
    gl_.Uniform1f(occluded_.occlusion_strength, frame.occlusion.strength);
    gl_.Uniform1f(occluded_.occlusion_scale, static_cast<float>(1 / (transform_.scale * frame.occlusion.radius)));
}

bool Painter::pick(int x, int y, ciel::Vec3d& position) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    if (!transparent_depth_drawn_) {
        target_.bind_again();
        gl_.UseProgram(triangles_.id);
        gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        enable_clip_planes(true);
        transparent_.draw();
        enable_clip_planes(false);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        transparent_depth_drawn_ = true;
    }
    const float depth = target_.read_depth(x, y);
    if (depth >= 1) return false;
    const glm::dvec4 clip((x + 0.5) / width_ * 2 - 1, 1 - (y + 0.5) / height_ * 2, depth * 2.0 - 1, 1);
    const glm::dvec4 point = glm::inverse(transform_.projection * transform_.view) * clip;
    for (int k = 0; k < 3; ++k)
        position[static_cast<std::size_t>(k)] = point[k] / point.w + origin_[static_cast<std::size_t>(k)];
    return true;
}

} // namespace server::render
