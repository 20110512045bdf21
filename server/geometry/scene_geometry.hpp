// Makes the geometry of a scene. Keeps one Query per iso-value and slice, so that only changes are computed again.
#pragma once

#include "geometry/geometry.hpp"
#include "scene/checked_scene.hpp"

#include <functional>
#include <map>
#include <stop_token>

namespace server::geometry {

struct Cut; // cut.hpp
struct Boundary;
struct VolumeCut;

// Called before each visible layer is made, and after the last. `of`: number of visible layers.
using LayersMade = std::function<void(std::size_t done, std::size_t of)>;

// Not thread-safe.
class SceneGeometry {
public:
    explicit SceneGeometry(ciel::Extraction extraction);
    ~SceneGeometry();
    SceneGeometry(SceneGeometry&&) noexcept;
    SceneGeometry& operator=(SceneGeometry&&) noexcept;

    // Returns null if `stop` was requested. Throws Error, and limits::LimitReached when the kept state exceeds
    // `most_bytes` (by at most one surface); the next call may pass another scene. `moving`: makes volumes coarser.
    [[nodiscard]] std::shared_ptr<const Geometry> update(const scene::CheckedScene& checked,
                                                         const std::stop_token& stop = {},
                                                         std::size_t most_bytes = SIZE_MAX, bool moving = false,
                                                         const LayersMade& layers_made = {});
    [[nodiscard]] std::size_t memory_bytes() const; // query state and surfaces

private:
    using Key = std::pair<std::string, std::size_t>; // layer id, index of the value
    void forget_all();
    void forget_all_but(const scene::CheckedScene& checked);

    ciel::Extraction extraction_;
    std::shared_ptr<store::LoadedDataset> loaded_;
    ciel::Vec3d origin_{}; // origin of all kept shapes
    std::map<Key, Cut> cuts_;
    std::map<Key, Boundary> boundaries_;
    std::map<std::string, VolumeCut> volumes_; // by layer
};

} // namespace server::geometry
