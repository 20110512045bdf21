// The kept state behind a volume layer: its property with gradients, and the slices of the current direction.
#pragma once

#include "annotations/camera.hpp"
#include "ciel/slab.hpp"
#include "geometry/scene_geometry.hpp"

#include <array>
#include <span>

namespace ciel::geometry {

// Parallel slabs of equal thickness that cover the mesh. Slice i is the cut by the middle plane of slab i. Places are
// values of dot(normal, offset from Geometry::origin).
struct Slabs {
    Vec3d normal{};
    double first = 0, thickness = 1; // start of slab 0
    std::vector<SlabMesh> slices;    // a slice is empty if not cut yet
    std::shared_ptr<const SlabMesh> boundary;

    [[nodiscard]] std::size_t memory_bytes() const;
};

// Returns the optical depth of `length` at the largest opacity.
[[nodiscard]] double largest_loss(std::span<const std::array<double, 2>> opacity_points, double unit_length,
                                  double length);

// Returns the number of slices for a scene that gives none. Slabs have the same thickness in all directions, so that
// pictures from all sides have equal detail and cost. `length`: of all slabs; `mean_edge`: of the mesh's bounds;
// `steepest`: from steepness. If opacity rises steeply and the mesh is not too large, slabs are thinner: a steep rise
// looks like a surface, with a step per slab.
[[nodiscard]] std::size_t usual_slices(double length, double mean_edge, std::size_t vertices, double steepest);
// Returns the steepest slope of the extinction per unit length. The range of the property counts as 1.
[[nodiscard]] double steepness(std::span<const std::array<double, 2>> opacity_points);

// Returns the stride of the slices that are drawn while something moves; each stands for a slab `stride` times as
// thick.
// The stride is odd: the middle plane of a thick slab is then that of a thin one, and slices of a still are reused.
// It is larger for a mesh of more vertices, to keep drawing interactive. It is smaller where a thick slab would absorb
// much light: only the front of such a slab should be visible, but its whole extent is averaged. `loss`: optical depth
// of all slabs together (largest_loss).
[[nodiscard]] std::size_t moving_stride(std::size_t slices, std::size_t vertices, double loss);

struct VolumeCut {
    std::string key;      // of the property: array, step
    store::Values values; // floats, relative to value_origin
    double value_origin = 0;
    std::vector<Vec3f> gradients;
    std::vector<std::array<float, 2>> limits; // by cell
    std::shared_ptr<const SlabMesh> boundary;
    std::shared_ptr<const Slabs> slabs;
    std::string slabs_key;
    std::size_t stride = 1; // of the slices present: 1, or that of moving pictures
    std::uint64_t identity, revision = 0;

    VolumeCut();
    // Loads the property and its gradients. `origin`: point to which positions are relative.
    void use_property(const std::string& name, std::size_t step, store::LoadedDataset& loaded, const Vec3d& origin);
    // Cuts one in `every` of `slices` slices, unless they are present. `place`: key of the planes. Returns false if
    // stopped; the earlier slices are kept then.
    bool cut(const std::string& place, const store::ScalarField& planes, Vec3d normal, std::size_t slices,
             std::size_t every, Extraction extraction, const std::stop_token& stop);
    [[nodiscard]] std::size_t memory_bytes() const;
};

// Returns the direction of the first visible volume. All volumes use it, because slabs of two directions cannot be
// sorted together.
[[nodiscard]] scene::VolumeLayer::Direction slab_direction(const scene::Scene& scene);
// Returns the unit normal of the slabs. Takes the requested axis, unless some ray of the picture runs nearly along its
// slabs: of a ray that stays within one slab, only the end is known. Otherwise takes the axis nearest to the view, in
// its positive direction. A still takes the view's own direction for `screen`, and also if some ray runs nearly along
// the slabs of the chosen axis.
[[nodiscard]] Vec3d slab_normal(scene::VolumeLayer::Direction direction, const annotations::Camera& camera,
                                bool moving);

} // namespace ciel::geometry
