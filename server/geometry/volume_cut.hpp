// The state that is kept between updates for a volume layer: its property with gradients, and its slices.
#pragma once

#include "annotations/camera.hpp"
#include "color/slab_triangles.hpp"
#include "geometry/scene_geometry.hpp"

#include <array>
#include <span>

namespace server::geometry {

// Parallel slabs of equal thickness that cover the mesh. Slice i is the cut by the middle plane of slab i. Positions
// along the normal are values of dot(normal, offset from Geometry::origin).
struct Slabs {
    ciel::Vec3d normal{};
    double first = 0, thickness = 1;          // position of the start of slab 0; thickness of a slab
    std::vector<color::SlabTriangles> slices; // a slice is empty if it is not cut yet
    std::shared_ptr<const color::SlabTriangles> boundary;

    [[nodiscard]] std::size_t memory_bytes() const;
};

// Returns the optical depth of a ray of this length at the greatest opacity of the points. `unit_length`: length after
// which a ray has the opacity of the points.
[[nodiscard]] double largest_loss(std::span<const std::array<double, 2>> opacity_points, double unit_length,
                                  double length);

// Returns the number of slices in a still picture, if the scene does not give it. A slab has about the same thickness
// from every direction of view. It is thinner if the opacity rises steeply, because a steep rise looks like a surface
// with a visible step at each slab. `length`: thickness of all slabs together; `mean_edge`: mean edge of the mesh's
// bounds; `steepest`: from steepness().
[[nodiscard]] std::size_t usual_slices(double length, double mean_edge, std::size_t vertices, double steepest);
// Returns the greatest slope of the extinction (per unit length) over the property, scaled to the range 0 to 1.
[[nodiscard]] double steepness(std::span<const std::array<double, 2>> opacity_points);

// Returns the stride of the slices in an interactive picture. Each slice replaces `stride` slabs by one thick slab. The
// stride is odd, so that slices of a still picture can be reused. It is greater for a mesh with more vertices. It is
// smaller if a thick slab would absorb much light: only its front should be visible, but the slice averages over its
// whole thickness. `loss`: optical depth of all slabs together (largest_loss).
[[nodiscard]] std::size_t moving_stride(std::size_t slices, std::size_t vertices, double loss);

struct VolumeCut {
    std::string key;             // identifies the property: step and array
    store::Values values;        // floats, relative to value_origin
    bool has_own_values = false; // false if `values` are those of the dataset
    double value_origin = 0;
    std::vector<ciel::Vec3f> gradients;
    std::vector<std::uint8_t> filled; // by cell (SlabProperty)
    std::shared_ptr<const color::SlabTriangles> boundary;
    std::shared_ptr<const Slabs> slabs;
    std::string slabs_key;
    std::size_t stride = 1; // stride of the slices that are cut: 1, or that of interactive pictures
    std::uint64_t identity, revision = 0;

    VolumeCut();
    // Loads the property and its gradients. `origin`: point to which positions are relative.
    void use_property(const std::string& name, std::size_t step, store::LoadedDataset& loaded,
                      const ciel::Vec3d& origin);
    // Cuts every `every`-th of `slices` slices, unless these slices are already cut. `place`: identifies the planes
    // (plane_name). Returns false if `stop` was requested; the earlier slices are then kept.
    bool cut(const std::string& place, const store::ScalarField& planes, ciel::Vec3d normal, std::size_t slices,
             std::size_t every, ciel::Extraction extraction, const std::stop_token& stop);
    [[nodiscard]] std::size_t memory_bytes() const;
};

// Returns the direction of the first volume. All volumes use it, because slabs of two directions cannot be sorted
// together by depth.
[[nodiscard]] scene::VolumeLayer::Direction slab_direction(const scene::CheckedScene& checked);
// Returns the requested axis, unless some camera ray is nearly parallel to the slabs: such a ray may stay within one
// slab, where values are known only at its end. Then, and if no axis is requested, returns the axis nearest to the
// viewing direction. An axis is taken in its positive direction. In a still picture, returns the viewing direction
// itself for `screen`, and also if some camera ray is nearly parallel to the slabs of the chosen axis.
[[nodiscard]] ciel::Vec3d slab_normal(scene::VolumeLayer::Direction direction, const annotations::ViewCamera& camera,
                                      bool moving);

} // namespace server::geometry
