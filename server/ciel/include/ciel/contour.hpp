// Iso-surfaces and slices of a mesh: functions for single surfaces, and an incremental Contour for sliders (paper,
// algorithms 1 to 4). Cell and point ids in the results are the caller's. All functions may be called on any thread and
// use all threads of the parallel loop, unless Options::threads or with_threads (parallel.hpp) limits them.
#pragma once

#include "ciel/clip_surface.hpp"
#include "ciel/extract.hpp"
#include "ciel/mesh.hpp"
#include "ciel/sweep.hpp"

#include <optional>
#include <vector>

namespace ciel {

struct Options {
    Algorithm algorithm = Algorithm::signatures; // affects time only: all algorithms give the same surface, bit by bit
    Decider decider = Decider::isolate_high;
    std::optional<Normals> normals = Normals::gradient; // nullopt: the surface has no normals
    // Blocks of mesh.topology() to look at, in any order; nullopt: all. The surface is then the part of the whole
    // surface in these blocks (Query::set_blocks). The surfaces of disjoint sets of blocks make up the whole surface,
    // so several processes can share the work. Surface::chunks names the blocks of a surface.
    std::optional<std::vector<Index>> blocks{};
    unsigned threads = 0; // most threads that a call uses, the caller's included; 0: all. The surface is the same.
};

// Extracts iso-surfaces of one field incrementally: a new level costs only the blocks whose surface changes. Shares
// ownership of the field and its mesh. Not thread-safe; `at` uses Options::threads threads. The constructor throws
// Error for a field that was not made from a Mesh, and if a block of Options::blocks does not exist.
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

// Cuts the mesh at all levels in one pass over its blocks, without a Surface. `on_cut` gets each block's cut at each
// level; see OnCut for order and threads. Ids in the cuts are the caller's, and cell_begin is 0. Ignores
// Options::normals, since cuts have no normals. Returns false when `stop` was requested; some cuts are then missing.
// Throws Error if Options::blocks is set, on another number of values, and for a field that was not made from a Mesh.
bool sweep(const Field& field, std::span<const double> levels, const OnCut& on_cut, const Options& options = {},
           const StopToken& stop = {});
bool sweep(const Mesh& mesh, const ArrayView& values, std::span<const double> levels, const OnCut& on_cut,
           const Options& options = {}, const StopToken& stop = {});

// Returns the part of a surface of `mesh` inside all half-spaces, which are in the caller's coordinates. values: one
// per point of the mesh, or empty; the result has them interpolated at its points. `slack` is a length: points at most
// this far outside a plane are kept, so that rounding does not tear a surface in the plane. Throws Error on another
// number of values. The result cannot be clipped or interpolated again, because its new points lie on no edge of the
// mesh.
[[nodiscard]] ClippedSurface clip(const Surface& surface, const Mesh& mesh, const ArrayView& values,
                                  std::span<const HalfSpace> planes, double slack = 0);

// Interpolates `values` at the points of the surface. values: one row per point of the mesh, or with `of_cells` per
// cell; points then get the means that Field::from_cells makes. Returns one row of the same width per point of the
// surface, row by row. Throws Error on another number of rows, and for a clipped surface. If `values` are the points of
// the mesh, the result is the positions of the surface's points in double precision; Surface::positions are floats.
[[nodiscard]] std::vector<double> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values,
                                              bool of_cells = false);

// Returns the least-squares gradient at each point of the mesh, in the caller's order (paper, section 3). values: one
// per point; throws Error on another number. The gradient of a point is zero if none of its cells has both a volume
// and finite values at all corners.
[[nodiscard]] std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values);

// Returns the boundary of the cells whose values lie in `range`, wound outwards. values: one per cell with `of_cells`,
// else one per point; then all points of a cell must lie in the range. Throws Error on another number of values.
[[nodiscard]] Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range,
                                bool of_cells = false);

} // namespace ciel
