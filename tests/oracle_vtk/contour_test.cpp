// Iso-surfaces of tetrahedra have the area and the points that VTK's two contour filters give.
#include "ciel/extract.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

#include <vtkCellType.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkContourFilter.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangle.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <set>

namespace ciel::test {
namespace {

struct Measure {
    double area = 0;
    std::int64_t points = 0;
};

vtkSmartPointer<vtkUnstructuredGrid> as_grid(const Polyhedra& mesh, const std::vector<float>& values) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> scalars;
    for (Id v = 0; v < mesh.vertex_count(); ++v) {
        points->InsertNextPoint(mesh.position(v).data());
        scalars->InsertNextValue(values[v]);
    }
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points);
    grid->GetPointData()->SetScalars(scalars);
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        const Loop base = mesh.loops(c)[0]; // wound outwards, so the fourth vertex is behind it
        std::set<Id> corners;
        for (const Loop& loop : mesh.loops(c)) corners.insert(loop.begin(), loop.end());
        for (Id v : base) corners.erase(v);
        const vtkIdType ids[] = {base[0], base[2], base[1], *corners.begin()};
        grid->InsertNextCell(VTK_TETRA, 4, ids);
    }
    return grid;
}

using Triangle = double[3][3];

double area_of(const Triangle& p) { return vtkTriangle::TriangleArea(p[0], p[1], p[2]); }

Measure measure(vtkPolyData* surface) {
    Measure result;
    result.points = surface->GetNumberOfPoints();
    for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c) {
        vtkNew<vtkIdList> ids;
        surface->GetCellPoints(c, ids);
        Triangle p;
        for (int i = 0; i < 3; ++i) surface->GetPoint(ids->GetId(i), p[i]);
        result.area += area_of(p);
    }
    return result;
}

Measure measure(const Surface& surface) {
    Measure result;
    result.points = static_cast<std::int64_t>(surface.points.size());
    const std::vector<Index> triangles = triangulate(surface);
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        Triangle p;
        for (std::size_t i = 0; i < 3; ++i) std::copy_n(surface.positions[triangles[t + i]].begin(), 3, p[i]);
        result.area += area_of(p);
    }
    return result;
}

template <typename Filter>
Measure contour(vtkUnstructuredGrid* grid, double value) {
    vtkNew<Filter> filter;
    filter->SetInputData(grid);
    filter->SetValue(0, value);
    filter->ComputeNormalsOff();
    if constexpr (std::is_same_v<Filter, vtkContour3DLinearGrid>) filter->MergePointsOn();
    filter->Update();
    return measure(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
}

class AgainstVtk : public testing::TestWithParam<double> {};

TEST_P(AgainstVtk, SameAreaAndSamePoints) {
    const Polyhedra input = tetrahedra({{16, 14, 15}, 0.2, 141});
    const std::vector<float> values = bumps_field(input, 142);
    const Assembled assembled = assemble(view(input));
    const Topology topology(assembled.mesh.view());
    std::vector<float> stored;
    for (Index v : assembled.original_vertex) stored.push_back(values[v]);
    const Field field(topology, stored, kept_by_test);
    const auto grid = as_grid(input, values);
    for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        Query query(topology, kept(assembled.mesh.view()), algorithm);
        query.set_field(field);
        Surface surface;
        ASSERT_TRUE(query.extract(GetParam(), false, surface));
        const Measure ours = measure(surface);
        ASSERT_GT(ours.points, 500);
        for (const Measure& theirs :
             {contour<vtkContourFilter>(grid, GetParam()), contour<vtkContour3DLinearGrid>(grid, GetParam())}) {
            EXPECT_EQ(ours.points, theirs.points);
            EXPECT_NEAR(ours.area, theirs.area, 1e-5 * theirs.area);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Values, AgainstVtk, testing::Values(0.3, 0.45, 0.5, 0.61, 0.75));

} // namespace
} // namespace ciel::test
