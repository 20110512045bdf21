// Iso-surfaces and slices of a mesh: functions for one call, and an incremental Contour for sliders (paper, algorithms
// 1 to 4). Cell and point ids in the results are the caller's.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/mesh.hpp"

#include <optional>
#include <vector>

namespace ciel {

struct Options {
    Algorithm algorithm = Algorithm::signatures; // all give the same bits
    Decider decider = Decider::isolate_high;
    std::optional<Normals> normals = Normals::gradient; // nullopt: no normals
};

// State of one viewer's surface, kept between levels: a slider step costs only the parts that change. Shares ownership
// of the field and its mesh. Not thread-safe; `at` uses all threads of the parallel loop. Throws Error for a field that
// was not made from a Mesh.
class Contour {
public:
    explicit Contour(const Field& field, const Options& options = {});
    ~Contour();
    Contour(Contour&&) noexcept;
    Contour& operator=(Contour&&) noexcept;

    // Sets another array or time step of the same mesh, which may have moved points. The topology is reused. Throws
    // Error for a field of another mesh.
    void set(const Field& field);
    // Replaces `out` and reuses its buffers. High means value >= level. Returns false, with `out` unspecified, when
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

// Cut by the plane through `origin` perpendicular to `normal` (paper, section 2.1). The polygons face along the normal.
// Throws Error when `normal` is zero or not finite.
[[nodiscard]] Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options = {});

// values: one row per point of the mesh. Returns one row of the same width per point of the surface, interleaved.
// Throws Error on another number of rows.
[[nodiscard]] std::vector<float> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values);

// Least-squares gradient at each point of the mesh, in the caller's order (paper, section 3). Zero at a point without a
// cell that has both a volume and all its values. Throws Error on another number of values.
[[nodiscard]] std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values);

// The boundary of the cells whose value lies in `range`, wound outwards. values: one per point (a cell is kept where
// all of its points are in the range) or, with `of_cells`, one per cell.
[[nodiscard]] Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range,
                                bool of_cells = false);

} // namespace ciel
