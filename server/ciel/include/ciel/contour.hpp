// Iso-surfaces and slices of a mesh: functions for single surfaces, and an incremental Contour for sliders (paper,
// algorithms 1 to 4). Cell and point ids in the results are the caller's.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/mesh.hpp"

#include <optional>
#include <vector>

namespace ciel {

struct Options {
    Algorithm algorithm = Algorithm::signatures; // affects time only: all algorithms give the same surface, bit by bit
    Decider decider = Decider::isolate_high;
    std::optional<Normals> normals = Normals::gradient; // nullopt: the surface has no normals
};

// Extracts iso-surfaces of one field incrementally: a new level costs only the blocks whose surface changes. Shares
// ownership of the field and its mesh. Not thread-safe; `at` uses all threads of the parallel loop. The constructor
// throws Error for a field that was not made from a Mesh.
class Contour {
public:
    explicit Contour(const Field& field, const Options& options = {});
    ~Contour();
    Contour(Contour&&) noexcept;
    Contour& operator=(Contour&&) noexcept;

    // Sets the field of another array or time step. Its mesh must be the same Mesh, or one made from it with
    // Mesh::moved; throws Error for any other. The topology is reused.
    void set(const Field& field);
    // Writes the surface at `level` to `out` and reuses its buffers. A point counts as high when value >= level.
    // Returns false, with `out` unspecified, when `stop` was requested; the Contour stays usable.
    bool at(double level, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns the iso-surface at one level, or one per level. values: one per point of the mesh, in the caller's order.
// Throws Error on another number of values.
[[nodiscard]] Surface contour(const Mesh& mesh, const ArrayView& values, double level, const Options& options = {});
[[nodiscard]] std::vector<Surface> contour(const Mesh& mesh, const ArrayView& values, std::span<const double> levels,
                                           const Options& options = {});

// Returns the cut through the mesh by the plane through `origin` perpendicular to `normal` (paper, section 2.1). The
// polygons face along `normal`, which may have any length. Throws Error when it is zero or not finite.
[[nodiscard]] Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options = {});

// Interpolates `values` at the points of the surface. values: one row per point of the mesh. Returns one row of the
// same width per point of the surface, row by row. Throws Error on another number of rows. If `values` are the points
// of the mesh, the result is the positions of the surface's points in double precision; Surface::positions are floats.
[[nodiscard]] std::vector<double> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values);

// Returns the least-squares gradient at each point of the mesh, in the caller's order (paper, section 3). values: one
// per point; throws Error on another number. The gradient of a point is zero if none of its cells has both a volume
// and finite values at all corners.
[[nodiscard]] std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values);

// Returns the boundary of the cells whose values lie in `range`, wound outwards. values: one per cell with `of_cells`,
// else one per point; then all points of a cell must lie in the range. Throws Error on another number of values.
[[nodiscard]] Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range,
                                bool of_cells = false);

} // namespace ciel
