// Finds the cell that contains a point, and the weights of its vertices there.
#pragma once

#include "ciel/cell_faces.hpp"
#include "store/dataset.hpp"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace ciel::probe {

using Weights = std::vector<std::pair<Index, double>>; // mesh vertex, share; shares sum to 1

// Immutable, safe to use from any thread; keeps the dataset.
class Locator {
public:
    Locator(std::shared_ptr<const store::Dataset> dataset, std::size_t mesh, std::size_t coordinates);

    // Returns the cell that contains a world position, or `none`. A cell contains a point if its faces wind around it
    // (solid angles after Van Oosterom and Strackee 1983), so it need not be convex. Faces are fans around their
    // centroid, the same for both cells, so cells have no gaps between them.
    [[nodiscard]] Index cell_at(const Vec3d& position) const;
    // Weights are linear in the tetrahedra (cell centre, face centroid, edge): exact for linear fields.
    [[nodiscard]] Weights weights_in(Index cell, const Vec3d& position) const;
    [[nodiscard]] const store::Dataset& dataset() const { return *dataset_; }
    [[nodiscard]] Index nearest_vertex(Index cell, const Vec3d& position) const;

private:
    [[nodiscard]] Vec3d point(Index vertex) const; // offset from the mesh's origin
    [[nodiscard]] std::vector<Index> vertices(Index cell) const;
    [[nodiscard]] double winding(Index cell, const Vec3d& at) const; // in units of 4 pi: 1 inside, 0 outside
    template <class Vertices>
    [[nodiscard]] Vec3d centroid(const Vertices& vertices) const;

    std::shared_ptr<const store::Dataset> dataset_;
    FaceMeshView mesh_;
    CellFaces faces_;
    std::vector<std::array<Vec3f, 2>> boxes_; // low and high corner of each run of cells
};

// Cache of locators, made on first use. Thread-safe.
class Locators {
public:
    [[nodiscard]] std::shared_ptr<const Locator> get(const std::shared_ptr<store::Dataset>& dataset, std::size_t step);
    void forget();      // releases the datasets that they keep
    void forget_lost(); // those whose files were truncated or rewritten

private:
    struct Kept {
        const float* positions; // identify mesh and coordinates: mapped once, also after a refresh
        std::shared_ptr<const Locator> locator;
    };
    std::mutex mutex_;
    std::vector<Kept> kept_; // newest last, at most a few
};

} // namespace ciel::probe
