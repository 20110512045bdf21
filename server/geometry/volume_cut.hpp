// The kept state behind a volume layer: its property with gradients, and the slices of the current direction.
#pragma once

#include "annotations/camera.hpp"
#include "ciel/slab.hpp"
#include "geometry/scene_geometry.hpp"

#include <array>
#include <span>

namespace ciel::geometry {

// Parallel slabs of one thickness that cover the mesh; slice i is the cut of slab i's middle plane. The direction and
// places are of dot(normal, offset from the mesh's origin).
struct Slabs {
    Vec3d normal{};
    double first = 0, thickness = 1; // where slab 0 begins
    std::vector<SlabMesh> slices;    // empty where not asked for yet
    std::shared_ptr<const SlabMesh> boundary;

    [[nodiscard]] std::size_t memory_bytes() const;
};

// What a ray along `length` loses where the volume is densest, as an exponent.
[[nodiscard]] double largest_loss(std::span<const std::array<double, 2>> opacity_points, double unit_length,
                                  double length);

// Of a volume whose scene gives no number: slabs as thick whatever they are across, so that a picture is as fine from
// any side and takes as long. Thinner ones, if the mesh is not too large, where opacity rises steeply: that looks like
// a surface, on which each slab is a step. `length`: of all slabs; `mean_edge`: of the mesh's bounds.
[[nodiscard]] std::size_t usual_slices(double length, double mean_edge, std::size_t vertices, double steepest);
// How fast what a ray loses in a unit length, as an exponent, changes with the property, by the range of that.
[[nodiscard]] double steepness(std::span<const std::array<double, 2>> opacity_points);

// While something moves, one slice in so many is drawn, each for a slab so many times as thick. Odd, so that the
// slices of a still serve: the middle plane of the thick slab is that of one of the thin ones.
// Larger for a mesh of more vertices, so that it can be turned as well. Smaller where a slab would take much of a ray's
// light: of what changes within that, only what is in front should be seen. `loss`: of all slabs together.
[[nodiscard]] std::size_t moving_stride(std::size_t slices, std::size_t vertices, double loss);

struct VolumeCut {
    std::string key; // of the property: array, step
    std::shared_ptr<const std::vector<float>> values;
    std::vector<Vec3f> gradients;
    std::vector<std::array<float, 2>> limits; // by cell
    std::shared_ptr<const SlabMesh> boundary;
    std::shared_ptr<const Slabs> slabs;
    std::string slabs_key;
    std::size_t stride = 1; // of the slices that are there: all, or those that are drawn while something moves
    std::uint64_t identity, revision = 0;

    VolumeCut();
    void use_property(const std::string& name, std::size_t step, store::LoadedDataset& loaded);
    // One slice in `every`, if not all are there. False when stopped; what was there before is kept then.
    bool cut(const std::string& place, const store::ScalarField& planes, Vec3d normal, std::size_t slices,
             std::size_t every, Extraction extraction, const std::stop_token& stop);
    [[nodiscard]] std::size_t memory_bytes() const;
};

// That of the first volume that is shown, for all of them: slabs across different directions cannot be mixed in their
// order.
[[nodiscard]] scene::VolumeLayer::Direction slab_direction(const scene::Scene& scene);
// The axis that was asked for, unless the camera looks along slabs across it somewhere: of a ray in one slab only its
// end is known. Then, and of itself, the axis nearest to the view, its sign left out; or the view's own direction,
// which is taken too for a still that looks along slabs across that axis somewhere.
[[nodiscard]] Vec3d slab_normal(scene::VolumeLayer::Direction direction, const annotations::Camera& camera,
                                bool moving);

} // namespace ciel::geometry
