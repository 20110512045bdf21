// Iso-surfaces and slices of a mesh (paper, algorithms 1 to 4): functions for single surfaces, and the incremental
// class Contour for sliders. Ids of cells and points in the results are the caller's ids. Positions of surfaces are
// float offsets from Mesh::stored().surface_origin; interpolate() gives them as doubles. Any thread may call the
// functions. They use all threads of parallel_for, unless Options::threads or with_threads (parallel.hpp) sets a limit.
// They throw Error when a block of Options::blocks does not exist.
#pragma once

#include "ciel/clip_surface.hpp"
#include "ciel/extract.hpp"
#include "ciel/mesh.hpp"
#include "ciel/sweep.hpp"

#include <optional>
#include <vector>

namespace ciel {

struct Options {
    Algorithm algorithm = Algorithm::signatures; // affects only the time: all algorithms give the same bits
    Decider decider = Decider::isolate_high;
    std::optional<Normals> normals = Normals::gradient; // nullopt: the surface has no normals
    // Indices of the blocks of mesh.topology() to cut, in any order; nullopt: all blocks. The result is the part of the
    // surface in these blocks (Query::set_blocks). Several processes can share the work: surfaces of disjoint sets of
    // blocks are disjoint parts of the whole surface. Surface::chunks lists the blocks of a surface.
    std::optional<std::vector<Index>> blocks{};
    // Largest number of threads that a call uses, including the calling thread; 0: all threads. Does not affect the
    // surface.
    unsigned threads = 0;
};

// Extracts iso-surfaces of one field incrementally: a block of cells is cut again only if the new level changes which
// points of the block are high (value >= level). Shares ownership of the field and its mesh. Not thread-safe. The
// constructor throws Error for a field that was not made from a Mesh, and when a block of Options::blocks does not
// exist.
class Contour {
public:
    explicit Contour(const Field& field, const Options& options = {});
    ~Contour();
    Contour(Contour&&) noexcept;
    Contour& operator=(Contour&&) noexcept;

    // Replaces the field, for example by another array or time step. The mesh of `field` must be the mesh of the old
    // field, or a mesh made from that mesh with Mesh::moved; throws Error for any other mesh. The topology is reused.
    void set(const Field& field);
    // Writes the surface at `level` to `out` and reuses the buffers of `out`. Returns false when `stop` was requested;
    // `out` is then unspecified, and the Contour stays usable. Throws Error when a stored record, value or position
    // cannot be read.
    bool at(double level, Surface& out, const StopToken& stop = {});

    // Returns the size in bytes of the data that is kept for the next level, without the mesh, the field and its
    // gradients.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Return the iso-surface at one level, or one surface for each of several levels. `values`: one for each point of the
// mesh, in the caller's order. Throw Error when `values` has another size.
[[nodiscard]] Surface contour(const Mesh& mesh, const ArrayView& values, double level, const Options& options = {});
[[nodiscard]] std::vector<Surface> contour(const Mesh& mesh, const ArrayView& values, std::span<const double> levels,
                                           const Options& options = {});

// Returns the cut through the mesh by the plane that contains `origin` and is perpendicular to `normal` (paper, section
// 2.1). `origin`: in the coordinates of the caller's points. The normals of the polygons have the direction of
// `normal`, which may have any length. Throws Error when the length is zero or not finite.
[[nodiscard]] Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options = {});

// Cuts the mesh at all levels in one pass over the blocks, without making a Surface. Calls `on_cut` with the cut of
// each block at each level; OnCut describes the order and the threads of the calls. The cuts have the caller's ids, and
// BlockPolygons::cell_begin is 0. Ignores Options::normals, because cuts have no normals. Returns false when `stop` was
// requested; some cuts are then missing. Throws Error when Options::blocks is set, when `values` has a wrong size, and
// for a field that was not made from a Mesh.
bool sweep(const Field& field, std::span<const double> levels, const OnCut& on_cut, const Options& options = {},
           const StopToken& stop = {});
bool sweep(const Mesh& mesh, const ArrayView& values, std::span<const double> levels, const OnCut& on_cut,
           const Options& options = {}, const StopToken& stop = {});

// Returns the part of a surface of `mesh` inside all half-spaces. `planes`: in the caller's coordinates. `values`: one
// for each point of the mesh, or empty; the result has the values interpolated at its vertices. `slack`: points at most
// this far outside a plane are kept, so that rounding does not tear a surface that lies in the plane; in the unit of
// HalfSpace::offset, which is a length if the normal has length 1. New vertices of the result lie on no edge of the
// mesh. Therefore interpolate, and clip with `values`, throw Error for a surface with such vertices. Throws Error when
// `values` has a wrong size.
[[nodiscard]] ClippedSurface clip(const Surface& surface, const Mesh& mesh, const ArrayView& values,
                                  std::span<const HalfSpace> planes, double slack = 0);

// Interpolates `values` at the points of the surface. `values`: one row for each point of the mesh. With `of_cells`,
// one row for each cell; each point of the mesh then gets a weighted mean of the cells around the point
// (Field::from_cells). Returns one row of the same width for each point of the surface, row by row. If `values` are the
// points of the mesh, the result is the positions of the surface's points in double precision. Throws Error when the
// number of rows is wrong, and for a surface to which `clip` added vertices.
[[nodiscard]] std::vector<double> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values,
                                              bool of_cells = false);

// Returns the least-squares gradient at each point of the mesh, in the caller's order (paper, section 3), in units of
// the values per unit of length. `values`: one for each point. The gradient at a point is zero if no cell around the
// point has both a volume and finite values at all corners. Throws Error when `values` has another size.
[[nodiscard]] std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values);

// Returns the boundary of the selected cells, wound outwards. `range`: [min, max], both included. `values`: with
// `of_cells`, one for each cell; a cell is selected if its value lies in the range. Otherwise one for each point; a
// cell is selected if the values of all its points lie in the range. Throws Error when `values` has another size.
[[nodiscard]] Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range,
                                bool of_cells = false);

} // namespace ciel
