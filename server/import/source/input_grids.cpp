#include "import/source/input_grids.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkCompositeDataSet.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

namespace server::importer {

namespace {

// Readers put zones, which are copies of cells, into VTK blocks with these names (OpenFOAM cases, Exodus files).
constexpr std::string_view cell_sets[] = {"cellZones", "Element Sets"};
constexpr std::string_view face_zones = "faceZones"; // the solver gives no values on these surfaces

// VTK blocks that readers insert. The name of an input grid does not include them.
constexpr std::string_view containers[] = {"boundary", "zones",     "cellZones",      "faceZones",
                                           "Patches",  "Side Sets", "Element Blocks", "Element Sets"};
constexpr std::string_view interiors[] = {"internalMesh", "Internal"}; // leaves that get their parent's name

struct Leaf {
    std::vector<std::string> path;
    vtkSmartPointer<vtkDataSet> data;
    int dimension = 0;
    int whole = -1;
    bool has_name = true; // false: an unnamed piece
};

int dimension_of(vtkUnstructuredGrid* grid) {
    vtkNew<vtkGenericCell> cell;
    vtkNew<vtkCellTypes> types;
    grid->GetCellTypes(types);
    int dimension = 0;
    for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i) {
        const int type = types->GetCellType(i);
        if (type == VTK_EMPTY_CELL) continue;
        if (type == VTK_CONVEX_POINT_SET) return 3;
        cell->SetCellType(type);
        dimension = std::max(dimension, cell->GetCellDimension());
    }
    return dimension;
}

template <typename Grid>
int dimension_of_grid(Grid* grid) {
    int dims[3];
    grid->GetDimensions(dims);
    return static_cast<int>(std::count_if(dims, dims + 3, [](int n) { return n > 1; }));
}

int dimension_of(vtkDataSet* data) {
    if (data->GetNumberOfCells() == 0) return 0;
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data)) return dimension_of(grid);
    if (auto* grid = vtkStructuredGrid::SafeDownCast(data)) return dimension_of_grid(grid);
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(data)) return dimension_of_grid(grid);
    if (auto* grid = vtkImageData::SafeDownCast(data)) return dimension_of_grid(grid);
    if (auto* surface = vtkPolyData::SafeDownCast(data)) return surface->GetNumberOfPolys() > 0 ? 2 : 1;
    return 0;
}

void walk(vtkDataObject* data, std::vector<std::string>& path, std::vector<Leaf>& leaves);
void walk_pieces(vtkPartitionedDataSet* pieces, std::vector<std::string>& path, std::vector<Leaf>& leaves);

const char* name_in(vtkInformation* information) {
    const bool named = information != nullptr && information->Has(vtkCompositeDataSet::NAME()) != 0;
    return named ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
}

void walk_child(vtkDataObject* child, vtkInformation* information, unsigned index, std::vector<std::string>& path,
                std::vector<Leaf>& leaves) {
    if (child == nullptr) return;
    const char* name = name_in(information);
    path.emplace_back(name != nullptr && *name != '\0' ? std::string(name) : std::to_string(index));
    walk(child, path, leaves);
    path.pop_back();
}

void walk(vtkDataObject* data, std::vector<std::string>& path, std::vector<Leaf>& leaves) {
    if (auto* set = vtkDataSet::SafeDownCast(data)) {
        leaves.push_back({path, set, dimension_of(set)});
    } else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data)) {
        for (unsigned i = 0; i < blocks->GetNumberOfBlocks(); ++i)
            walk_child(blocks->GetBlock(i), blocks->HasMetaData(i) != 0 ? blocks->GetMetaData(i) : nullptr, i, path,
                       leaves);
    } else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data)) {
        for (unsigned i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
            walk_child(collection->GetPartitionedDataSet(i),
                       collection->HasMetaData(i) != 0 ? collection->GetMetaData(i) : nullptr, i, path, leaves);
    } else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(data)) { // or its subclass vtkMultiPieceDataSet
        walk_pieces(pieces, path, leaves);
    }
}

// An unnamed piece gets the path of its vtkPartitionedDataSet.
void walk_pieces(vtkPartitionedDataSet* pieces, std::vector<std::string>& path, std::vector<Leaf>& leaves) {
    const auto first = static_cast<std::ptrdiff_t>(leaves.size());
    for (unsigned i = 0; i < pieces->GetNumberOfPartitions(); ++i) {
        vtkDataObject* piece = pieces->GetPartitionAsDataObject(i);
        vtkInformation* information = pieces->HasMetaData(i) != 0 ? pieces->GetMetaData(i) : nullptr;
        const std::size_t before = leaves.size();
        if (name_in(information) != nullptr) {
            walk_child(piece, information, i, path, leaves);
        } else if (piece != nullptr) {
            walk(piece, path, leaves);
            for (std::size_t k = before; k < leaves.size(); ++k) leaves[k].has_name = false;
        }
    }
    if (pieces->GetNumberOfPartitions() < 2) return;
    for (auto leaf = leaves.begin() + first; leaf != leaves.end(); ++leaf) leaf->whole = static_cast<int>(first);
}

bool is_under(const Leaf& leaf, std::string_view parent) {
    return std::find(leaf.path.begin(), leaf.path.end(), parent) != leaf.path.end();
}

bool is_zone(const Leaf& leaf) {
    return std::any_of(std::begin(cell_sets), std::end(cell_sets),
                       [&](std::string_view parent) { return is_under(leaf, parent); });
}

template <std::size_t n>
bool is_one_of(const std::string& name, const std::string_view (&names)[n]) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// The outermost name is first. The leaf's own name is left out if it is in `interiors` and another name remains.
std::vector<std::string> names_of(const Leaf& leaf) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i + 1 < leaf.path.size(); ++i)
        if (!is_one_of(leaf.path[i], containers)) names.push_back(leaf.path[i]);
    if (!leaf.path.empty() && (names.empty() || !is_one_of(leaf.path.back(), interiors)))
        names.push_back(leaf.path.back());
    return names;
}

std::string joined(const std::vector<std::string>& names, std::size_t depth) {
    std::string name;
    for (std::size_t i = names.size() - std::min(depth, names.size()); i < names.size(); ++i) {
        if (!name.empty()) name += '/';
        name += names[i];
    }
    return name;
}

bool share_a_name(const Leaf& a, const Leaf& b) {
    return a.whole >= 0 && a.whole == b.whole && !a.has_name && !b.has_name;
}

std::vector<InputGrid> named(const std::vector<const Leaf*>& leaves) {
    std::size_t deepest = 1;
    std::vector<std::vector<std::string>> names;
    for (const Leaf* leaf : leaves) {
        names.push_back(names_of(*leaf));
        deepest = std::max(deepest, names.back().size());
    }
    std::vector<InputGrid> input_grids;
    std::map<std::string, int> used;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        std::size_t depth = 1;
        const auto taken = [&] {
            const std::string name = joined(names[i], depth);
            for (std::size_t other = 0; other < names.size(); ++other)
                if (other != i && joined(names[other], depth) == name && !share_a_name(*leaves[i], *leaves[other]))
                    return true;
            return false;
        };
        while (depth < deepest && leaves.size() < 1000 && taken()) ++depth;
        std::string name = joined(names[i], depth);
        if (i > 0 && share_a_name(*leaves[i - 1], *leaves[i]))
            name = input_grids.back().name;
        else if (const int earlier = used[name]++; earlier > 0)
            name.append(" ").append(std::to_string(earlier + 1));
        input_grids.push_back(
            {std::move(name), leaves[i]->data, !is_under(*leaves[i], face_zones), leaves[i]->whole, {}});
    }
    return input_grids;
}

} // namespace

InputGrids collect_input_grids(vtkDataObject* data) {
    std::vector<Leaf> leaves;
    std::vector<std::string> path;
    walk(data, path, leaves);
    std::vector<const Leaf*> volumes;
    std::vector<const Leaf*> surfaces;
    std::vector<const Leaf*> zones;
    for (const Leaf& leaf : leaves) {
        if (leaf.dimension == 3) (is_zone(leaf) ? zones : volumes).push_back(&leaf);
        if (leaf.dimension == 2) surfaces.push_back(&leaf);
    }
    InputGrids input_grids;
    input_grids.volumes = named(volumes);
    input_grids.surfaces = named(surfaces);
    input_grids.zones = named(zones);
    return input_grids;
}

void require_volumes(const InputGrids& input_grids) {
    if (!input_grids.volumes.empty()) return;
    throw ciel::Error(input_grids.surfaces.empty() ? "holds no cells; a volume mesh is needed"
                                                   : "holds only surfaces; a volume mesh is needed");
}

} // namespace server::importer
