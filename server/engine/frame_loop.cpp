#include "engine/frame_loop.hpp"

#include "frames/batches.hpp"
#include "frames/picture.hpp"
#include "frames/pixel_grid.hpp"
#include "geometry/viewpoint.hpp"
#include "store/files/files.hpp"

#include <algorithm>

namespace server::engine {
namespace {

float elapsed_ms(Clock::time_point since) {
    return std::chrono::duration<float, std::milli>(Clock::now() - since).count();
}

wire::FrameHeader header_of(const View& view, const FrameRequest& request, const geometry::Geometry& geometry) {
    wire::FrameHeader header;
    header.kind = request.stream == Stream::image ? wire::FrameKind::image : wire::FrameKind::geometry;
    header.flags = request.still ? wire::still : 0;
    header.view = view.id();
    header.revision = request.version->revision;
    header.width = request.size.width;
    header.height = request.size.height;
    header.time = geometry.time;
    header.triangles = static_cast<std::uint32_t>(geometry.triangles);
    header.wait_ms = std::chrono::duration<float, std::milli>(request.started - request.version->changed).count();
    return header;
}

struct GivenUp {};
struct GivesWay {};

// Throws if the frame must not be finished. The renderer calls this function between its passes.
void check_wanted(const FrameRequest& request, const FrameWorkers& workers) {
    if (request.stop.stop_requested() || workers.draining()) throw GivenUp();
    if (request.gives_way_at(Clock::now()) && workers.has_waiting()) throw GivesWay();
}

std::vector<std::string> lacking_in(const geometry::Geometry& geometry, const scene::Lighting& lighting,
                                    Stream stream) {
    std::vector<std::string> lacking = geometry.lacking;
    lacking.insert(lacking.end(), geometry.remarks.begin(), geometry.remarks.end());
    if (stream != Stream::geometry) return lacking;
    for (const geometry::VolumeDrawable& volume : geometry.volumes)
        lacking.push_back("layer " + volume.layer +
                          " is a volume and has no polygons; choose the stream of images to see the volume");
    if (lighting.on && lighting.ambient_occlusion.on)
        lacking.emplace_back("ambient occlusion is not drawn in the stream of polygons; choose the stream of images to "
                             "see the occlusion");
    return lacking;
}

// Returns the grid step of the polygons to send; nothing if the client already has them on a grid that is fine enough.
std::optional<double> grid_to_send(View& view, const FrameRequest& request, const geometry::Geometry& geometry) {
    const double aspect = static_cast<double>(request.size.width) / std::max(request.size.height, 1U);
    const annotations::ViewCamera camera = geometry::camera_of(geometry, request.version->scene().camera, aspect);
    frames::ContentKey key = frames::content_of(geometry);
    if (view.shows(key, frames::surely_fine_grid(geometry, camera, request.size))) return {};
    return view.grid_of_new(std::move(key), frames::needed_grid(geometry, camera, request.size));
}

} // namespace

void show_frame(View& view, Worker& worker, bool still) {
    const auto request = view.take(still);
    if (!request) return;
    try {
        const auto geometry = view.session().geometry(*request->version, request->stop, !request->still);
        if (!geometry) return view.give_up();
        if (!geometry->awaited.empty()) {
            view.tell_lacking(*request, lacking_in(*geometry, request->version->scene().lighting, request->stream),
                              *geometry, std::nullopt);
            return view.wait();
        }
        wire::FrameHeader header = header_of(view, *request, *geometry);
        header.extract_ms = elapsed_ms(request->started);
        const auto drawing = Clock::now();
        std::vector<std::vector<std::uint8_t>> messages;
        wire::ArrayIds ids;
        std::optional<std::vector<std::string>> drawn;
        if (request->still || request->stream != Stream::image) drawn.emplace();
        if (request->stream == Stream::image) {
            const std::optional<double> scale = request->still ? std::nullopt : std::optional(request->scale);
            const std::function<void()> check = [&] { check_wanted(*request, worker.all()); };
            const auto& image = frames::draw(*geometry, request->version->checked, request->size, scale,
                                             worker.renderer(), worker.still_samples(), check);
            header.draw_ms = elapsed_ms(drawing);
            if (drawn) drawn = worker.renderer().remarks();
            if (request->still && request->stop.stop_requested()) return view.give_up();
            messages.push_back(frames::image_message(header, image, request->moving));
        } else if (const auto grid = grid_to_send(view, *request, *geometry)) {
            auto encoded =
                frames::geometry_messages(header, *geometry, request->size.pixel_ratio, *grid, request->held);
            messages = std::move(encoded.payloads);
            ids = std::move(encoded.ids);
        }
        view.tell_lacking(*request, lacking_in(*geometry, request->version->scene().lighting, request->stream),
                          *geometry, drawn);
        view.deliver(*request, std::move(messages), std::move(ids),
                     {header.wait_ms, header.extract_ms, header.draw_ms, header.encode_ms});
    } catch (const GivenUp&) {
        view.give_up();
    } catch (const GivesWay&) {
        view.give_way();
    } catch (const std::exception& error) {
        view.fail(*request, store::sentence_for_clients(error));
    }
}

} // namespace server::engine
