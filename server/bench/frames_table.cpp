// Measures the time from a change of the scene to the encoded picture (1280 x 720 pixels, PNG). Each change is measured
// twice: as a whole, then stage by stage, with each stage finished before the next stage begins.
#include "bench/case.hpp"
#include "frames/frame_of.hpp"
#include "geometry/scene_geometry.hpp"
#include "render/renderer.hpp"
#include "wire/pictures/jpeg_stream.hpp"
#include "wire/pictures/png.hpp"
#include "wire/pictures/png_stream.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace server::bench {

namespace {

constexpr int width = 1280, height = 720;
constexpr std::size_t steps = 40, uncounted = 4, least = 3;
constexpr double enough_seconds = 4;
constexpr double pi = std::numbers::pi;

constexpr std::array stage_names{"extract", "upload", "draw", "read", "PNG", "JPEG instead"};

struct Times {
    std::vector<double> wall, cpu;
};

class Laps {
public:
    explicit Laps(std::array<Times, stage_names.size()>& stages) : stages_(stages) {}
    void lap() {
        stages_[next_].wall.push_back(watch_.wall());
        stages_[next_++].cpu.push_back(watch_.cpu());
        watch_ = Stopwatch();
    }

private:
    std::array<Times, stage_names.size()>& stages_;
    std::size_t next_ = 0;
    Stopwatch watch_;
};

Row row_of(const std::string& what, const Times& times) {
    Row row;
    row.what = what;
    row.wall = spread_of(times.wall);
    row.cpu = spread_of(times.cpu);
    row.repetitions = times.wall.size();
    return row;
}

class Frames {
public:
    using Change = std::function<void(scene::Scene&, double share)>; // share: progress of the change, 0 to 1

    explicit Frames(const Case& data) : data_(data) {
        scene_.dataset = data.dataset->info().name;
        scene_.time = data.time;
        scene_.annotations = {};
    }

    void add_rows(Table& table, const std::string& what, const scene::Layer& layer, bool still, const Change& change) {
        scene_.layers = {layer};
        scene_.camera.reset();
        still_ = still;
        Times whole;
        std::array<Times, stage_names.size()> stages;
        run(change, [&](bool counted) {
            const Stopwatch watch;
            frame(nullptr);
            if (!counted) return;
            whole.wall.push_back(watch.wall());
            whole.cpu.push_back(watch.cpu());
        });
        run(change, [&](bool counted) {
            std::array<Times, stage_names.size()> dropped;
            Laps laps(counted ? stages : dropped);
            frame(&laps);
        });
        Row row = row_of(what, whole);
        row.triangles = triangles_;
        row.note = std::to_string(png_.size() / 1024) + " kB";
        table.rows.push_back(row);
        for (std::size_t i = 0; i < stages.size(); ++i)
            if (!stages[i].wall.empty()) table.rows.push_back(row_of(what + ": " + stage_names[i], stages[i]));
        if (!still) table.rows.back().note = std::to_string(jpeg_.size() / 1024) + " kB";
    }

    // A `share` of 1 is half a turn.
    void turn(scene::Scene& scene, double share) const {
        const store::MeshInfo& mesh = data_.dataset->info().meshes.front();
        ciel::Vec3d low{}, high{};
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = mesh.bounds[2 * k];
            high[k] = mesh.bounds[2 * k + 1];
        }
        const annotations::ViewCamera from = annotations::default_camera(low, high, double{width} / height);
        const double angle = share * pi, dx = from.position[0] - from.target[0], dy = from.position[1] - from.target[1];
        scene.camera = scene::Camera{};
        scene.camera->position = {from.target[0] + dx * std::cos(angle) - dy * std::sin(angle),
                                  from.target[1] + dx * std::sin(angle) + dy * std::cos(angle), from.position[2]};
        scene.camera->target = from.target;
        scene.camera->up = from.up;
        scene.camera->fov = from.fov_degrees;
    }

private:
    void run(const Change& change, const std::function<void(bool counted)>& one) {
        const Stopwatch whole;
        for (std::size_t step = 0; step < steps; ++step) {
            change(scene_, (static_cast<double>(step) + 0.5) / steps);
            one(step >= uncounted);
            if (whole.wall() > enough_seconds && step + 1 >= uncounted + least) break;
        }
    }

    void frame(Laps* laps) {
        const scene::CheckedScene checked(scene_, data_.loaded);
        const auto geometry = geometry_.update(checked, {}, std::numeric_limits<std::size_t>::max(), !still_);
        const render::Frame drawn = frames::frame_of(*geometry, checked, width, height, still_ ? 4 : 1);
        if (laps != nullptr) laps->lap();
        render::AfterStage after;
        if (laps != nullptr) after = [laps](render::DrawStage) { laps->lap(); };
        const render::Image& image = renderer_.draw(drawn, after);
        png_.clear();
        if (still_)
            wire::encode_png(image.width, image.height, image.rgb, png_);
        else
            png_stream_.encode(image.width, image.height, image.rgb, png_);
        if (laps != nullptr) laps->lap();
        if (laps != nullptr && !still_) {
            jpeg_.clear();
            jpeg_stream_.encode(image.width, image.height, image.rgb, jpeg_);
            laps->lap();
        }
        triangles_ = geometry->triangles;
    }

    const Case& data_;
    scene::Scene scene_;
    geometry::SceneGeometry geometry_{ciel::Extraction{}};
    render::Renderer renderer_{render::Backend::automatic};
    wire::PngStream png_stream_;
    wire::JpegStream jpeg_stream_;
    std::vector<std::uint8_t> png_, jpeg_;
    std::uint64_t triangles_ = 0; // number of triangles in the last frame
    bool still_ = false;
};

scene::Layer iso_of(const Case& data, double value) {
    scene::IsoLayer iso;
    iso.array = data.array;
    iso.values = {value};
    return {"bench", 0, true, 1, iso};
}

scene::Layer slice_of(const Case& data) {
    scene::SliceLayer slice;
    slice.axis = scene::SliceLayer::Axis::x;
    slice.color.array = data.array;
    return {"bench", 0, true, 1, slice};
}

scene::Layer volume_of(const Case& data) {
    scene::VolumeLayer volume;
    volume.array = data.array;
    return {"bench", 0, true, 1, volume};
}

} // namespace

Table frames_table(const Case& data) {
    Table table{"frames", {}, {}};
    Frames frames(data);
    const auto [low, high] = std::ranges::minmax(data.values);
    const auto value = [from = double{low}, to = double{high}](double share) { return from + (to - from) * share; };
    const auto& bounds = data.dataset->info().meshes.front().bounds;
    const auto set_value = [&](scene::Scene& scene, double share) {
        std::get<scene::IsoLayer>(scene.layers.front().kind).values = {value(0.1 + 0.8 * share)};
    };
    const auto set_place = [&](scene::Scene& scene, double share) {
        std::get<scene::SliceLayer>(scene.layers.front().kind).value = bounds[0] + (bounds[1] - bounds[0]) * share;
    };
    const auto set_camera = [&](scene::Scene& scene, double share) { frames.turn(scene, share); };
    const scene::Layer iso = iso_of(data, value(0.5)), volume = volume_of(data);
    frames.add_rows(table, "iso-value", iso, false, set_value);
    frames.add_rows(table, "slice along x", slice_of(data), false, set_place);
    frames.add_rows(table, "camera around an iso-surface", iso, false, set_camera);
    frames.add_rows(table, "camera around a volume", volume, false, set_camera);
    frames.add_rows(table, "still of an iso-surface", iso, true, set_value);
    frames.add_rows(table, "still of a volume", volume, true, set_camera);
    return table;
}

} // namespace server::bench
