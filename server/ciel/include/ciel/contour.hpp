// Iso-surfaces and slices of a mesh in one call, and kept incremental for sliders (paper, algorithms 1 to 4). Cells and
// points in the results are the caller's.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/mesh.hpp"

#include <optional>
#include <vector>

namespace ciel {

struct Options {
    Algorithm algorithm = Algorithm::signatures; // the result has the same bits with each
    Decider decider = Decider::isolate_high;
    std::optional<Normals> normals = Normals::gradient; // none: no normals
};

// One viewer's surface, kept from one level to the next: a step of a slider costs what changes. Shares the field and
// its mesh. One thread at a time; `at` uses all threads of the parallel loop.
class Contour {
public:
    explicit Contour(const Field& field, const Options& options = {});
    ~Contour();
    Contour(Contour&&) noexcept;
    Contour& operator=(Contour&&) noexcept;

    // Another array or time step of the same mesh, or of the same mesh with moved points; nothing is indexed anew.
    // Throws Error for a field of another mesh.
    void set(const Field& field);
    // Replaces `out`, whose buffers are used again. High means value >= level. False, leaving `out` unspecified, when
    // `stop` was requested; the Contour stays usable.
    bool at(double level, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// values: one per point of the mesh, in the caller's order. Throws Error on another number.
[[nodiscard]] Surface contour(const Mesh& mesh, const ArrayView& values, double level, const Options& options = {});
[[nodiscard]] std::vector<Surface> contour(const Mesh& mesh, const ArrayView& values, std::span<const double> levels,
                                           const Options& options = {});

// The cut by the plane through `origin` across `normal` (paper, section 2.1); its polygons look along the normal.
[[nodiscard]] Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options = {});

// values: of `components` each, per point of the mesh. Returns as many per point of the surface, interleaved. Throws
// Error on another number of values.
[[nodiscard]] std::vector<float> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values);

// Least-squares gradient at each point of the mesh, in the caller's order (paper, section 3); zero where a point has no
// cell, or none with a volume and all its values.
[[nodiscard]] std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values);

// The boundary of the cells whose value lies in `range`, wound outwards. values: one per point (a cell is kept where
// all of its points are in the range) or, with `of_cells`, one per cell.
[[nodiscard]] Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range,
                                bool of_cells = false);

} // namespace ciel
