#include "frames/picture.hpp"
#include "methods/base64.hpp"
#include "methods/scene_source.hpp"
#include "wire/pictures/png.hpp"

namespace server::methods {

namespace {
// Memory in sizes of the PNG file: the file and three base64 copies (result, JSON, text), each 4/3 as large.
constexpr std::size_t copies_of_a_picture = 5;
} // namespace

protocol::PictureRenderResult picture_render(CallContext& context, const protocol::PictureRenderParams& params) {
    frames::check_picture_size(context.server.limits(), params.width, params.height);
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const geometry::ViewSize size{static_cast<std::uint32_t>(params.width), static_cast<std::uint32_t>(params.height)};
    const std::size_t pixel_bytes = 3 * std::size_t{size.width} * size.height;
    context.making.change(pixel_bytes);
    // Makes the geometry on this thread, so that the picture worker is free for other calls meanwhile.
    const auto geometry = source.geometry(progress);
    geometry::require_read(*geometry);
    progress.begin("waiting");
    std::vector<std::string> remarks;
    const render::Image image = context.server.picture_workers().run([&](engine::Worker& worker) {
        context.check_wanted();
        progress.begin("drawing");
        render::Image drawn;
        render::Frame frame = frames::picture_of(*geometry, source.version().checked, size, worker.still_samples());
        frame.check_wanted = [&] { context.check_wanted(); };
        worker.renderer().draw(frame, drawn);
        remarks = frames::remarks_on(*geometry, worker.renderer());
        return drawn;
    });
    context.check_wanted();
    progress.begin("writing");
    std::vector<std::uint8_t> png;
    wire::encode_png(image.width, image.height, image.rgb, png);
    context.making.change(pixel_bytes + copies_of_a_picture * png.size());
    context.server.counters().count_picture(png.size());
    return {"image/png",    params.width,       params.height, static_cast<std::int64_t>(source.version().revision),
            geometry->time, std::move(remarks), base64(png)};
}

} // namespace server::methods
