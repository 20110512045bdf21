// Part of Painter: draws points, volumes, and transparent primitives in depth order.
#include "render/frame/frame_properties.hpp"
#include "render/painter.hpp"

namespace server::render {
namespace {

// Returns the uniform of point_shaders.cpp. `factor`: framebuffer pixels per picture pixel along a side.
float line_reach(const Frame& frame, float factor) {
    const float width = widest_line(frame);
    return width > 0 ? (factor * width + 1) / 2 : 0;
}

} // namespace

// Points are drawn before lines, so that the soft edges of lines blend with them. Rays of volumes end on opaque points.
void Painter::draw_opaque_points(const Frame& frame) {
    if (!has(frame, is_opaque_points) || has_overlays_in_layers(frame)) return;
    draw_points(frame, target_.sample_places());
    if (frame.volumes.empty()) return;
    if (std::ranges::any_of(frame.primitives, is_opaque))
        opaque_depth_.go_on();
    else
        opaque_depth_.begin(frame.width, frame.height, false);
    volumes_.end_on(opaque_depth_.texture());
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_points(frame, {{0, 0}});
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    target_.bind_again();
}

void Painter::draw_points(const Frame& frame, const std::vector<std::array<float, 2>>& sample_places) {
    const auto count = static_cast<GLsizei>(std::min<std::size_t>(sample_places.size(), most_point_samples));
    use(points_, frame);
    slopes_.use(points_);
    gl_.Uniform1f(points_.line_reach, line_reach(frame, 1));
    gl_.Uniform1f(points_.point_pixels, 1);
    gl_.Uniform1i(points_.sample_count, count);
    gl_.Uniform2fv(points_.sample_places, count, sample_places[0].data());
    draw_opaque_points_with(frame);
}

void Painter::draw_opaque_points_with(const Frame& frame) {
    for (std::size_t i = 0; i < frame.primitives.size(); ++i)
        if (const Primitives& primitives = frame.primitives[i]; is_opaque_points(primitives))
            buffers(i).draw(primitives, scale_rows_[i]);
}

// Rays do not end on lines, whose soft edges would get a border without volume. So lines in front are drawn again.
void Painter::draw_volumes(const Frame& frame) {
    enable_clip_planes(false); // programs of volumes clip rays themselves and write no gl_ClipDistance
    volumes_.draw(frame, transform_, target_);
    enable_clip_planes(true);
    draw_primitives(frame, lines_, true);
}

void Painter::draw_transparent(const Frame& frame) {
    transparent_depth_drawn_ = transparent_.is_empty();
    const bool has_overlays = has_overlays_in_layers(frame);
    if (transparent_.is_empty() && !has_overlays) {
        if (!frame.volumes.empty()) draw_volumes(frame);
        return;
    }
    if (is_peeled(frame)) {
        peel_transparent(frame);
        if (has_overlays) draw_depth_of_overlays(frame);
        return;
    }
    use(triangles_, frame);
    gl_.DepthMask(GL_FALSE);
    transparent_.draw();
    gl_.DepthMask(GL_TRUE);
}

// Draws the depth of lines and points for pick(), because peeled layers write no depth to the target.
void Painter::draw_depth_of_overlays(const Frame& frame) {
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_primitives(frame, lines_);
    draw_points(frame, target_.sample_places());
    transparent_points_.draw();
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Painter::peel_transparent(const Frame& frame) {
    DepthPeeling::Picture layers;
    layers.width = frame.width;
    layers.height = frame.height;
    layers.samples = frame.samples;
    if (has_transparent_lines(frame))
        layers.join_lines = [&] {
            enable_clip_planes(true);
            draw_lines_of_layer(frame, true);
            enable_clip_planes(false);
        };
    layers.dense = !transparent_points_.is_empty();
    const bool few = frame.samples == 1 && (frame.volumes.empty() || layers.dense);
    layers.most_layers = few ? most_moving_layers : most_layers;
    layers.draw_opaque = [&] {
        enable_clip_planes(true);
        draw_depths(frame, triangles_);
        enable_clip_planes(false);
    };
    layers.draw_surfaces = [&] {
        use(peeling_.surfaces(), frame);
        peeling_.set_nearer(peeling_.surfaces(), false);
        enable_clip_planes(true);
        transparent_.draw();
        if (has_overlays_in_layers(frame)) {
            draw_lines_of_layer(frame, false);
            draw_points_of_layer(frame);
        }
        enable_clip_planes(false);
    };
    if (!transparent_points_.is_empty() && frame.volumes.empty())
        layers.draw_between = [&] {
            enable_clip_planes(true);
            draw_points_between_layers(frame);
            enable_clip_planes(false);
        };
    if (!frame.volumes.empty())
        layers.volumes = [&](GLuint depth, GLuint color) {
            return volumes_.picture_until(frame, transform_, {depth, color});
        };
    if (!frame.volumes.empty() && std::ranges::any_of(frame.primitives, is_opaque))
        layers.outlines = opaque_depth_.texture();
    enable_clip_planes(false);
    peeling_.draw(layers, target_);
    if (peeling_.was_cut())
        remarks_.push_back("more than " + std::to_string(layers.most_layers) +
                           " transparent surfaces lie behind each other, and the farthest are not drawn; show fewer "
                           "transparent layers, or make the layers less transparent");
    enable_clip_planes(true);
}

// Returns the factor for line widths and point sizes: layer pixels per picture pixel along a side.
float Painter::use_in_layers(const Frame& frame, const Program& program, bool joining) {
    const auto factor = static_cast<float>(peeling_.layer_pixels());
    use(program, frame);
    peeling_.set_nearer(program, joining);
    slopes_.use(program);
    gl_.Uniform2f(program.viewport, factor * static_cast<float>(frame.width),
                  factor * static_cast<float>(frame.height));
    return factor;
}

// If lines were drawn before all layers, their soft edges would hide transparent surfaces behind them.
void Painter::draw_lines_of_layer(const Frame& frame, bool joining) {
    const Program& program = peeling_.lines();
    const float factor = use_in_layers(frame, program, joining);
    for (std::size_t i = 0; i < frame.primitives.size(); ++i) {
        const Primitives& primitives = frame.primitives[i];
        if (!primitives.lines || primitives.indices.empty() || primitives.color[3] <= 0 ||
            (joining && primitives.color[3] >= 1))
            continue;
        use_line(program, primitives, factor);
        gl_.Uniform1f(program.number, primitives.color[3] < 1 ? static_cast<float>(i + 1) : 0.0F);
        buffers(i).draw(primitives, scale_rows_[i]);
    }
}

// Without volumes, draw_points_between_layers() blends the transparent points.
void Painter::draw_points_of_layer(const Frame& frame) {
    const Program& program = peeling_.points();
    use_for_points(frame, program);
    draw_opaque_points_with(frame);
    if (!frame.volumes.empty()) transparent_points_.draw();
}

void Painter::draw_points_between_layers(const Frame& frame) {
    const bool on_surfaces =
        has(frame, [](const Primitives& primitives) { return !is_overlay(primitives) && primitives.color[3] > 0; });
    use_for_points(frame, peeling_.between(on_surfaces));
    transparent_points_.draw();
}

void Painter::use_for_points(const Frame& frame, const Program& program) {
    const float factor = use_in_layers(frame, program, false);
    gl_.Uniform1f(program.point_pixels, factor);
    gl_.Uniform1f(program.line_reach, line_reach(frame, factor));
}

} // namespace server::render
