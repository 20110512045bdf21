// Functions that cut a mesh: contour, slice, sweep and threshold.
#include "options.hpp"

#include "ciel/parallel.hpp"

namespace ciel::python {

namespace {

std::vector<PySurface> contour_at_levels(const Options& options, const Mesh& mesh, const py::array& values,
                                         const std::vector<double>& levels, bool of_cells) {
    const ArrayView numbers = view_of(values, "values");
    const py::gil_scoped_release free;
    std::vector<PySurface> surfaces;
    with_threads(options.threads, [&] {
        Contour cut(field_of(mesh, numbers, of_cells), options);
        for (const double level : levels) {
            Surface surface;
            cut.at(level, surface);
            surfaces.push_back(surface_of(std::move(surface), mesh));
        }
    });
    return surfaces;
}

PySurface contour_at_level(const Options& options, const Mesh& mesh, const py::array& values, double level,
                           bool of_cells) {
    return std::move(contour_at_levels(options, mesh, values, {level}, of_cells).front());
}

PySurface slice_at(const Options& options, const Mesh& mesh, const std::array<double, 3>& origin,
                   const std::array<double, 3>& normal) {
    const py::gil_scoped_release free;
    return surface_of(slice(mesh, origin, normal, options), mesh);
}

Surface surface_of_cut(Index block, const BlockPolygons& cut) {
    Surface surface;
    surface.positions.assign(cut.positions.begin(), cut.positions.end());
    surface.points.assign(cut.points.begin(), cut.points.end());
    surface.polygon_offset.insert(surface.polygon_offset.end(), cut.polygon_end.begin(), cut.polygon_end.end());
    surface.polygon_vertex.assign(cut.polygon_point.begin(), cut.polygon_point.end());
    surface.polygon_cell.assign(cut.polygon_cell.begin(), cut.polygon_cell.end());
    surface.chunks.push_back({block, 0, static_cast<Index>(cut.polygon_count())});
    return surface;
}

void sweep_levels(const Mesh& mesh, const py::array& values, const std::vector<double>& levels,
                  const py::function& callback, bool of_cells, const std::string& algorithm, const std::string& decider,
                  unsigned threads) {
    const Options options{
        .algorithm = algorithm_of(algorithm), .decider = decider_of(decider), .normals = {}, .threads = threads};
    const ArrayView numbers = view_of(values, "values");
    const OnCut on_cut = [&](std::size_t level, Index block, const BlockPolygons& cut) {
        PySurface surface = surface_of(surface_of_cut(block, cut), mesh);
        const py::gil_scoped_acquire python;
        callback(level, std::move(surface));
    };
    const py::gil_scoped_release free;
    with_threads(threads, [&] { sweep(field_of(mesh, numbers, of_cells), levels, on_cut, options); });
}

PySurface threshold_in(const Mesh& mesh, const py::array& values, const std::array<double, 2>& range, bool of_cells) {
    const ArrayView numbers = view_of(values, "values");
    const py::gil_scoped_release free;
    return surface_of(threshold(mesh, numbers, range, of_cells), mesh);
}

void add_surfaces_at_values(py::module_& module) {
    const std::string one =
        with_options_text("Returns the iso-surface of values at one level. values: (V,), or with of_cells (C,).");
    const std::string several = with_options_text(
        "Returns a list of the iso-surfaces at several levels, (L,). Faster than one call for each level.");
    const std::string plane = with_options_text(
        "Returns the cut of the mesh by a plane. The plane contains origin, (3,), and is perpendicular to normal,\n"
        "(3,). normal may have any length; the normals of the polygons have its direction.");
    with_option_keywords([&](const auto&... options) {
        module.def("contour", with_options(&contour_at_level), py::arg("mesh"), py::arg("values"), py::arg("level"),
                   py::kw_only(), py::arg("of_cells") = false, options..., one.c_str());
        module.def("contour", with_options(&contour_at_levels), py::arg("mesh"), py::arg("values"), py::kw_only(),
                   py::arg("levels"), py::arg("of_cells") = false, options..., several.c_str());
        module.def("slice", with_options(&slice_at), py::arg("mesh"), py::arg("origin"), py::arg("normal"),
                   py::kw_only(), options..., plane.c_str());
    });
}

} // namespace

void add_cuts(py::module_& module) {
    add_surfaces_at_values(module);
    module.def(
        "sweep", &sweep_levels, py::arg("mesh"), py::arg("values"), py::arg("levels"), py::arg("callback"),
        py::kw_only(), py::arg("of_cells") = false, py::arg("algorithm") = "signatures",
        py::arg("decider") = "isolate-high", py::arg("threads") = 0,
        "Cuts the mesh at all levels, (L,), in one pass. Calls callback(i, surface) with the part of the iso-surface\n"
        "at levels[i] in one block, without normals. The calls come from several threads, with the blocks in any\n"
        "order, and a call may begin before another call has ended: use a lock, or threads=1. Parts of different\n"
        "blocks share no points. values: (V,), or with of_cells (C,). threads: largest number of threads that the\n"
        "call uses; 0: all threads.");
    module.def(
        "threshold", &threshold_in, py::arg("mesh"), py::arg("values"), py::arg("range"), py::arg("of_cells") = false,
        "Returns the boundary of the cells whose values lie in range: (min, max), both included. values: (V,), or\n"
        "with of_cells (C,). With (V,), the values at all points of a cell must lie in the range.");
}

} // namespace ciel::python
