#include "import/mesh/fingerprint.hpp"

#include "store/format/checksum.hpp"

#include <span>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace server::importer {

namespace {

class Hasher {
public:
    void add(const std::string& text) { text_ += text + '\n'; }
    void add(vtkDataArray* array) {
        if (array == nullptr) return add("none");
        const auto bytes =
            static_cast<std::size_t>(array->GetNumberOfValues()) * static_cast<std::size_t>(array->GetDataTypeSize());
        add(store::checksum({static_cast<const std::byte*>(array->GetVoidPointer(0)), bytes}));
    }
    void add(vtkCellArray* cells) {
        if (cells == nullptr) return add("none");
        add(cells->GetOffsetsArray());
        add(cells->GetConnectivityArray());
    }
    template <typename Number>
    void add_numbers(const Number* values, std::size_t count) {
        add(store::checksum(std::as_bytes(std::span(values, count))));
    }
    [[nodiscard]] std::string value() const { return store::checksum(std::as_bytes(std::span(text_))); }

private:
    std::string text_;
};

template <typename Grid>
void add_dimensions(Grid* grid, Hasher& hash) {
    int dims[3];
    grid->GetDimensions(dims);
    hash.add_numbers(dims, 3);
}

void add_cells(const InputGrid& input_grid, Hasher& hash) {
    hash.add(input_grid.name);
    hash.add(std::to_string(input_grid.data->GetNumberOfPoints()));
    hash.add(input_grid.data->GetCellGhostArray());
    hash.add(input_grid.data->GetPointData()->GetArray("IBlank"));
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input_grid.data)) {
        hash.add(grid->GetCells());
        hash.add(grid->GetCellTypesArray());
        hash.add(grid->GetFaces());
        hash.add(grid->GetFaceLocations());
    }
    if (auto* surface = vtkPolyData::SafeDownCast(input_grid.data)) hash.add(surface->GetPolys());
    if (auto* grid = vtkStructuredGrid::SafeDownCast(input_grid.data)) add_dimensions(grid, hash);
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(input_grid.data)) add_dimensions(grid, hash);
    if (auto* grid = vtkImageData::SafeDownCast(input_grid.data)) add_dimensions(grid, hash);
}

void add_positions(vtkDataSet* data, Hasher& hash) {
    if (auto* set = vtkPointSet::SafeDownCast(data); set != nullptr && set->GetPoints() != nullptr)
        hash.add(set->GetPoints()->GetData());
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(data)) {
        hash.add(grid->GetXCoordinates());
        hash.add(grid->GetYCoordinates());
        hash.add(grid->GetZCoordinates());
    }
    if (auto* image = vtkImageData::SafeDownCast(data)) {
        double bounds[6];
        image->GetBounds(bounds);
        hash.add_numbers(bounds, 6);
    }
}

} // namespace

Fingerprint fingerprint(const InputGrids& input_grids) {
    Hasher cells;
    Hasher positions;
    for (const InputGrid& input_grid : input_grids.volumes) {
        add_cells(input_grid, cells);
        add_positions(input_grid.data, positions);
    }
    for (const InputGrid& input_grid : input_grids.surfaces) add_cells(input_grid, cells);
    for (const InputGrid& input_grid : input_grids.zones) add_cells(input_grid, cells);
    return {cells.value(), positions.value()};
}

} // namespace server::importer
