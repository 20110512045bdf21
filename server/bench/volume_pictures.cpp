#include "bench/volume_pictures.hpp"

#include "annotations/camera.hpp"
#include "ciel/threshold_surface.hpp"
#include "geometry/slab_sink.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace server::bench {

namespace {

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }
ciel::Vec3d array_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

class Screen {
public:
    explicit Screen(const render::Frame& frame, int coarseness)
        : half_(glm::dvec2(frame.width, frame.height) / (2.0 * coarseness)) {
        const annotations::ViewTransform transform = annotations::view_transform(frame);
        to_clip_ = transform.projection * transform.view;
    }
    [[nodiscard]] double area(const ciel::Vec3f& a, const ciel::Vec3f& b, const ciel::Vec3f& c) const {
        const glm::dvec2 from = at(a), one = at(b) - from, other = at(c) - from;
        return std::abs(one.x * other.y - one.y * other.x) / 2;
    }

private:
    [[nodiscard]] glm::dvec2 at(const ciel::Vec3f& point) const {
        const glm::dvec4 clip = to_clip_ * glm::dvec4(point[0], point[1], point[2], 1);
        return half_ * glm::dvec2(clip.x, clip.y) / clip.w;
    }
    glm::dvec2 half_;
    glm::dmat4 to_clip_{};
};

color::SlabTriangles boundary_of(const Case& data, const geometry::SlabProperty& property) {
    const ciel::BlockBoxes boxes = ciel::block_boxes(*data.topology, data.mesh.positions);
    return geometry::slab_boundary(
        ciel::threshold_surface(*data.topology, data.mesh, boxes, property.filled, ciel::CollapsedFaces::keep),
        property);
}

} // namespace

VolumePictures::VolumePictures(const Case& data)
    : data_(data), values_(converted(data.values, false)),
      gradients_(ciel::vertex_gradients(*data.topology, data.mesh, data.values)),
      filled_(geometry::filled_cells({*data.topology, values_, data.topology})), // the field is used in this call only
      boundary_(boundary_of(data, {*data.topology, values_.floats(), gradients_, filled_})) {
    frame_.width = frame_.height = side;
    frame_.origin = data.mesh.surface_origin;
    for (std::size_t i = 0; i < data.mesh.positions.size(); ++i) {
        const double at = data.mesh.origin[i % 3] + data.mesh.positions[i];
        double &low = frame_.bounds_min[i % 3], &high = frame_.bounds_max[i % 3];
        low = i < 3 ? at : std::min(low, at);
        high = i < 3 ? at : std::max(high, at);
    }
    turn_back();
    frame_.samples = 1;
    const auto [lowest, highest] = std::ranges::minmax(data.values);
    volume_.scale.range = {lowest, highest};
    volume_.unit_length = 0.3 * (frame_.bounds_max[1] - frame_.bounds_min[1]);
    volume_.opacity_points = {{0, 0}, {1, 0.9}};
    volume_.boundary = &boundary_;
    volume_.identity = 1;
}

std::uint64_t VolumePictures::cut(const ciel::Vec3d& normal) {
    const ciel::Field planes =
        field_of(data_, store::Values(ciel::plane_distance(data_.mesh, data_.mesh.surface_origin, normal)));
    volume_.normal = normal;
    volume_.first = planes.range()[0];
    volume_.thickness = (double{planes.range()[1]} - planes.range()[0]) / slice_count;
    std::vector<double> places;
    for (std::size_t i = 0; i < slice_count; ++i)
        places.push_back(volume_.first + (static_cast<double>(i) + 0.5) * volume_.thickness);
    (void)ciel::sweep(*data_.topology, data_.mesh, planes, places,
                      geometry::SlabSink{{*data_.topology, values_.floats(), gradients_, filled_}}, slices_);
    volume_.slices = slices_;
    volume_.revision = ++revision_;
    std::uint64_t triangles = 0;
    for (const color::SlabTriangles& slice : slices_) triangles += slice.triangles.size() / 3;
    return triangles;
}

std::uint64_t VolumePictures::draw(bool shaded, std::size_t stride) {
    volume_.shaded = shaded;
    volume_.stride = stride;
    volume_.coarseness = stride > 1 ? 2 : 1;
    frame_.volumes = {volume_};
    renderer_.draw(frame_, image_);
    std::uint64_t triangles = 0;
    for (std::size_t i = stride / 2; i < slices_.size(); i += stride) triangles += slices_[i].triangles.size() / 3;
    return triangles;
}

void VolumePictures::turn(double degrees) {
    annotations::ViewCamera& camera = frame_.camera;
    const glm::dvec3 target = vector_of(camera.target);
    const glm::dmat4 rotation = glm::rotate(glm::dmat4(1), glm::radians(degrees), vector_of(camera.up));
    camera.position = array_of(target + glm::dmat3(rotation) * (vector_of(camera.position) - target));
}

void VolumePictures::turn_back() {
    frame_.camera = annotations::default_camera(frame_.bounds_min, frame_.bounds_max, 1);
}

ciel::Vec3d VolumePictures::view_direction() const {
    return array_of(glm::normalize(vector_of(frame_.camera.target) - vector_of(frame_.camera.position)));
}

double VolumePictures::covered_share() const { return bench::covered_share(image_.rgb); }

double VolumePictures::samples() const {
    const Screen screen(frame_, volume_.coarseness);
    double pixels = 0;
    for (std::size_t i = volume_.stride / 2; i < slices_.size(); i += volume_.stride) {
        const color::SlabTriangles& slice = slices_[i];
        for (std::size_t k = 0; k < slice.triangles.size(); k += 3)
            pixels += screen.area(slice.vertices[slice.triangles[k]].position,
                                  slice.vertices[slice.triangles[k + 1]].position,
                                  slice.vertices[slice.triangles[k + 2]].position);
    }
    return pixels;
}

double covered_share(std::span<const std::uint8_t> rgb) {
    std::size_t covered = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) covered += rgb[i] + rgb[i + 1] + rgb[i + 2] > 0 ? 1 : 0;
    return 3.0 * static_cast<double>(covered) / static_cast<double>(rgb.size());
}

} // namespace server::bench
