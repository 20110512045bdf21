// A volume as ciel draws it, of 100 box-aligned slices at 1024 x 1024 pixels; the slices are kept from picture to
// picture, as they are while a camera turns.
#include "bench/case.hpp"
#include "ciel/slab.hpp"
#include "render/renderer.hpp"

#include <algorithm>

namespace ciel::bench {

namespace {

constexpr std::size_t slice_count = 100;
constexpr int side = 1024;
constexpr std::size_t moving_stride = 5;

class Pictures {
public:
    explicit Pictures(const Case& data)
        : data_(data), gradients_(vertex_gradients(*data.topology, data.mesh, *data.values)),
          limits_(cell_limits(data.mesh, *data.values)),
          boundary_(slab_boundary(data.mesh, {*data.values, gradients_, limits_})) {
        for (std::size_t i = 0; i < data.mesh.positions.size(); ++i) {
            const double at = data.mesh.origin[i % 3] + data.mesh.positions[i];
            low_[i % 3] = i < 3 ? at : std::min(low_[i % 3], at);
            high_[i % 3] = i < 3 ? at : std::max(high_[i % 3], at);
        }
        frame_.width = frame_.height = side;
        frame_.origin = data.mesh.origin;
        frame_.bounds_min = low_;
        frame_.bounds_max = high_;
        frame_.camera = render::default_camera(low_, high_, 1);
        frame_.samples = 1;
    }

    std::uint64_t cut() {
        const Vec3d normal{0, 1, 0};
        const Field planes = field_of(
            data_, std::make_shared<const std::vector<float>>(plane_distance(data_.mesh, data_.mesh.origin, normal)));
        volume_.normal = normal;
        volume_.first = planes.range()[0];
        volume_.thickness = (double{planes.range()[1]} - planes.range()[0]) / slice_count;
        std::vector<double> places;
        for (std::size_t i = 0; i < slice_count; ++i)
            places.push_back(volume_.first + (static_cast<double>(i) + 0.5) * volume_.thickness);
        (void)sweep(*data_.topology, data_.mesh, planes, places, SlabSink{{*data_.values, gradients_, limits_}},
                    slices_);
        volume_.slices = slices_;
        volume_.boundary = &boundary_;
        volume_.revision = ++revision_;
        volume_.identity = 1;
        const auto [lowest, highest] = std::ranges::minmax(*data_.values);
        volume_.scale.range = {lowest, highest};
        volume_.unit_length = 0.3 * (high_[1] - low_[1]);
        std::uint64_t triangles = 0;
        for (const SlabMesh& slice : slices_) triangles += slice.triangles.size() / 3;
        return triangles;
    }

    std::uint64_t draw(bool shaded, std::size_t stride) {
        volume_.shaded = shaded;
        volume_.stride = stride;
        volume_.coarseness = stride > 1 ? 2 : 1;
        frame_.volumes = {volume_};
        renderer_.draw(frame_, image_);
        std::uint64_t triangles = 0;
        for (std::size_t i = stride / 2; i < slices_.size(); i += stride) triangles += slices_[i].triangles.size() / 3;
        return triangles;
    }

    // Of the picture, in per cent.
    [[nodiscard]] double covered_share() const {
        std::size_t covered = 0;
        for (std::size_t i = 0; i < image_.rgb.size(); i += 3)
            covered += image_.rgb[i] + image_.rgb[i + 1] + image_.rgb[i + 2] > 0 ? 1 : 0;
        return 300.0 * static_cast<double>(covered) / static_cast<double>(image_.rgb.size());
    }

private:
    const Case& data_;
    std::vector<Vec3f> gradients_;
    std::vector<std::array<float, 2>> limits_;
    SlabMesh boundary_;
    std::vector<SlabMesh> slices_;
    Vec3d low_{}, high_{};
    render::Volume volume_;
    render::Frame frame_;
    render::Image image_;
    render::Renderer renderer_{render::Backend::automatic};
    std::uint64_t revision_ = 0;
};

} // namespace

Table volume_table(const Case& data) {
    Table table{"volume", {}, {}};
    Pictures pictures(data);
    table.rows.push_back(measure("100 slices along y, cut", [&] { return pictures.cut(); }));
    table.rows.push_back(measure("1024 x 1024, shaded", [&] { return pictures.draw(true, 1); }));
    table.rows.push_back(measure("1024 x 1024, unshaded", [&] { return pictures.draw(false, 1); }));
    table.figures.push_back({"picture covered by the volume", pictures.covered_share(), "%"});
    table.rows.push_back(
        measure("moving: 20 slices at 512 x 512, shaded", [&] { return pictures.draw(true, moving_stride); }));
    return table;
}

} // namespace ciel::bench
