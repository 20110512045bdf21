#include "render/painter.hpp"

#include "render/color_map.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace ciel::render {
namespace {

GLuint make_color_maps(const Gl& gl) {
    std::vector<std::uint8_t> pixels;
    for (const std::string& name : color_map_names())
        for (const auto& color : color_map(name)) pixels.insert(pixels.end(), {color[0], color[1], color[2], 255});
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, static_cast<GLsizei>(color_map_names().size()), 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, pixels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

std::string text_of(const Gl& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

bool is_transparent(const Mesh& mesh) { return !mesh.lines && mesh.color[3] < 1; }

bool is_opaque(const Mesh& mesh) { return !mesh.lines && !is_transparent(mesh) && !mesh.indices.empty(); }

} // namespace

Painter::Painter(const Gl& gl)
    : gl_(gl), renderer_name_(text_of(gl_, GL_RENDERER)), version_(text_of(gl_, GL_VERSION)),
      is_software_(renderer_name_.find("llvmpipe") != std::string::npos ||
                   renderer_name_.find("softpipe") != std::string::npos),
      background_(make_background_program(gl_)), triangles_(make_triangle_program(gl_)), lines_(make_line_program(gl_)),
      color_maps_(make_color_maps(gl_)), target_(gl_), transparent_(gl_), peeling_(gl_), volumes_(gl_) {
    gl_.GenVertexArrays(1, &no_array_);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void Painter::draw(const Frame& frame, Image& image) {
    transform_ = view_transform(frame);
    origin_ = frame.origin;
    width_ = height_ = 0; // nothing to pick from if this throws
    target_.begin(frame.width, frame.height, frame.samples);
    draw_background(frame);
    draw_meshes(frame, false);
    if (!frame.volumes.empty()) keep_opaque_depth(frame);
    gl_.Enable(GL_BLEND);
    draw_meshes(frame, true);
    draw_transparent(frame);
    gl_.Disable(GL_BLEND);
    target_.read_color(image);
    width_ = frame.width;
    height_ = frame.height;
}

void Painter::draw_background(const Frame& frame) {
    const auto& top = frame.background_top;
    const auto& bottom = frame.background_bottom;
    gl_.DepthMask(GL_TRUE);
    gl_.ClearColor(bottom[0], bottom[1], bottom[2], 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (top != bottom) {
        gl_.Disable(GL_DEPTH_TEST);
        gl_.UseProgram(background_.id);
        gl_.Uniform3f(background_.top, top[0], top[1], top[2]);
        gl_.Uniform3f(background_.bottom, bottom[0], bottom[1], bottom[2]);
        gl_.Uniform1f(background_.height, static_cast<float>(frame.height));
        gl_.BindVertexArray(no_array_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_.Enable(GL_DEPTH_TEST);
}

void Painter::use(const Program& program, const Frame& frame) {
    const glm::mat4 view(transform_.view);
    const glm::mat4 projection(transform_.projection);
    gl_.UseProgram(program.id);
    gl_.UniformMatrix4fv(program.view, 1, GL_FALSE, glm::value_ptr(view));
    gl_.UniformMatrix4fv(program.projection, 1, GL_FALSE, glm::value_ptr(projection));
    gl_.Uniform1f(program.scale, static_cast<float>(transform_.scale));
    gl_.Uniform1f(program.parallel, frame.camera.parallel ? 1.0F : 0.0F);
    gl_.Uniform1i(program.maps, 0);
    gl_.Uniform1f(program.map_rows, static_cast<float>(color_map_names().size()));
    gl_.Uniform2f(program.viewport, static_cast<float>(frame.width), static_cast<float>(frame.height));
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, color_maps_);
}

MeshBuffers& Painter::buffers(std::size_t slot) {
    while (buffers_.size() <= slot) buffers_.emplace_back(gl_);
    return *std::next(buffers_.begin(), static_cast<std::ptrdiff_t>(slot));
}

void Painter::draw_meshes(const Frame& frame, bool lines, bool before_volume) {
    const Program& program = lines ? lines_ : triangles_;
    use(program, frame);
    if (!lines) { // surfaces a little back, so that lines on them are not half buried
        gl_.Enable(GL_POLYGON_OFFSET_FILL);
        gl_.PolygonOffset(1, 1);
    }
    if (lines) {
        gl_.ActiveTexture(GL_TEXTURE1);
        gl_.BindTexture(GL_TEXTURE_2D, volumes_.limits());
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.Uniform1i(program.volume_limits, 1);
        gl_.Uniform1f(program.before_volume, before_volume ? 1.0F : 0.0F);
    }
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const Mesh& mesh = frame.meshes[i];
        if (mesh.lines != lines || is_transparent(mesh) || mesh.indices.empty()) continue;
        MeshBuffers& slot = buffers(i);
        // From llvmpipe buffers that are uploaded anew draw faster than kept ones.
        slot.load(mesh, !is_software_);
        if (lines) gl_.Uniform1f(program.half_width, mesh.line_width / 2);
        slot.draw();
    }
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

// Drawn again rather than copied: in the picture surfaces lie a little back, for the lines on them.
void Painter::keep_opaque_depth(const Frame& frame) {
    if (!std::ranges::any_of(frame.meshes, is_opaque)) return;
    volumes_.begin_depth(frame.width, frame.height);
    use(triangles_, frame);
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        if (!is_opaque(frame.meshes[i])) continue;
        buffers(i).load(frame.meshes[i], true);
        buffers(i).draw();
    }
    target_.bind_again();
}

// Lines leave no depth that a volume ends on: their soft edges would cut it off. So they are seen through it, and those
// in front of it are drawn again.
void Painter::draw_volumes(const Frame& frame) {
    volumes_.draw(frame, transform_, target_);
    draw_meshes(frame, true, true);
}

void Painter::draw_transparent(const Frame& frame) {
    const glm::mat4 view(transform_.view);
    transparent_.begin(glm::vec4(view[0].z, view[1].z, view[2].z, view[3].z));
    for (const Mesh& mesh : frame.meshes)
        if (is_transparent(mesh) && mesh.color[3] > 0) transparent_.add(mesh);
    transparent_depth_drawn_ = transparent_.is_empty();
    if (transparent_.is_empty()) {
        if (!frame.volumes.empty()) draw_volumes(frame);
        return;
    }
    transparent_.sort_and_upload();
    if (frame.samples > 1 || !frame.volumes.empty()) return peel_transparent(frame);
    use(triangles_, frame);
    gl_.DepthMask(GL_FALSE);
    transparent_.draw();
    gl_.DepthMask(GL_TRUE);
}

// For stills, because triangles that are sorted by their centres show where they cross or enclose each other; and where
// surfaces are inside volumes.
void Painter::peel_transparent(const Frame& frame) {
    DepthPeeling::Scene layers{frame.width, frame.height, frame.samples, {}, {}};
    layers.draw_surfaces = [&] {
        use(peeling_.program(), frame);
        gl_.Uniform1i(peeling_.program().nearer, 1);
        transparent_.draw();
    };
    if (!frame.volumes.empty())
        layers.volumes = [&](GLuint depth) { return volumes_.picture_until(frame, transform_, depth); };
    peeling_.draw(layers, target_);
    if (!frame.volumes.empty()) draw_meshes(frame, true, true);
}

bool Painter::pick(int x, int y, Vec3d& position) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    if (!transparent_depth_drawn_) {
        target_.bind_again();
        gl_.UseProgram(triangles_.id);
        gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        transparent_.draw();
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

} // namespace ciel::render
