#include "render/surfaces/ambient_occlusion.hpp"

#include "render/surfaces/ambient_occlusion_shaders.hpp"
#include "render/target/sheet.hpp"

#include <string>

namespace server::render {
namespace {

// Limit of the radius as a share of the picture's height. With a larger radius, samples would be too far apart.
constexpr double most_reach = 0.25;

enum Unit : int { found_unit = 0, depth_unit = 1, normals_unit = 2 };

} // namespace

AmbientOcclusion::AmbientOcclusion(const Gl& gl)
    : gl_(gl), find_(make_occlusion_program(gl)), even_out_(make_even_light_program(gl)) {
    for (Sheet* sheet : {&found_, &even_}) {
        gl_.GenTextures(1, &sheet->texture);
        gl_.GenFramebuffers(1, &sheet->framebuffer);
    }
    gl_.GenVertexArrays(1, &no_array_);
}

void AmbientOcclusion::allocate(const Sheet& sheet, GLint format) const {
    gl_.BindTexture(GL_TEXTURE_2D, sheet.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, format, width_, height_, 0, GL_RGBA, GL_FLOAT, nullptr);
    filter(gl_, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sheet.texture, 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error(
            "the GL driver cannot draw the ambient occlusion of a picture of this size; ask for a smaller "
            "picture, or switch ambient occlusion off");
}

void AmbientOcclusion::resize(int width, int height) {
    if (width_ == width && height_ == height) return;
    width_ = width;
    height_ = height;
    try {
        allocate(found_, GL_RGBA32F);
        allocate(even_, GL_RG32F);
    } catch (const ciel::Error&) {
        width_ = height_ = 0; // the next call allocates again
        throw;
    }
}

void AmbientOcclusion::cover(const Sheet& sheet) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sheet.framebuffer);
    gl_.Viewport(0, 0, width_, height_);
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void AmbientOcclusion::find(const Frame& frame, const annotations::ViewTransform& transform,
                            const OpaqueDepth& opaque) {
    const bool fine = frame.samples > 1;
    stride_ = fine ? 1 : 2;
    resize((frame.width + stride_ - 1) / stride_, (frame.height + stride_ - 1) / stride_);
    gl_.Disable(GL_DEPTH_TEST);
    bind(gl_, found_unit, found_.texture);
    bind(gl_, depth_unit, opaque.texture());
    bind(gl_, normals_unit, opaque.normals());

    const glm::dmat4& projection = transform.projection;
    const double radius = frame.occlusion.radius;
    const bool parallel = frame.camera.parallel;
    const double per_depth = parallel ? 1 / radius : 1;
    const glm::dvec2 corner(per_depth / projection[0][0], per_depth / projection[1][1]);
    find_.use();
    find_.set("stride", stride_);
    find_.set("lines", fine ? 3 : 2);
    find_.set("steps", fine ? 6 : 4);
    find_.set("parallel", parallel ? 1.0F : 0.0F);
    find_.set("corner", glm::vec2(-corner));
    find_.set("pixel", glm::vec2(2.0 * corner / glm::dvec2(frame.width, frame.height)));
    find_.set("depth_row", glm::vec2(parallel ? radius * projection[2][2] : projection[2][2],
                                     parallel ? projection[3][2] : projection[3][2] / radius));
    find_.set("reach", static_cast<float>(projection[1][1] * frame.height / 2 * (parallel ? radius : 1)));
    find_.set("most_reach", static_cast<float>(most_reach * frame.height));
    find_.set("depths", int{depth_unit});
    find_.set("normals", int{normals_unit});
    cover(found_);
    even_out_.use();
    even_out_.set("found", int{found_unit});
    cover(even_);
    gl_.Enable(GL_DEPTH_TEST);
}

} // namespace server::render
