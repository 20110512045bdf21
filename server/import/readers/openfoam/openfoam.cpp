// OpenFOAM cases. The input is the case's directory, its controlDict, or a .foam file.
#include "ciel/types.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/openfoam/openfoam_fields.hpp"
#include "import/readers/openfoam/openfoam_mesh.hpp"

#include <algorithm>
#include <set>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace server::importer {

namespace {

void add_block(vtkMultiBlockDataSet* multiblock, vtkDataObject* block, const std::string& name) {
    const unsigned at = multiblock->GetNumberOfBlocks();
    multiblock->SetBlock(at, block);
    multiblock->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

vtkSmartPointer<vtkPolyData> as_polygons(const FoamSurface& surface, vtkPoints* points) {
    auto polygons = vtkSmartPointer<vtkPolyData>::New();
    polygons->SetPoints(points);
    polygons->SetPolys(surface.faces);
    return polygons;
}

class OpenFoamSource : public Source {
public:
    explicit OpenFoamSource(const std::string& input) : foam_(input) {
        require_regular_files_of(foam_);
        infos_ = list_foam_fields(foam_);
    }

    [[nodiscard]] std::string format() const override {
        return foam_.is_decomposed ? "OpenFOAM case (decomposed)" : "OpenFOAM case";
    }
    [[nodiscard]] const std::vector<double>& times() const override { return foam_.times; }

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        const double time = foam_.times[step];
        lost_ = foam_.lost;
        facts_.clear();
        for (std::size_t i = 0; i < foam_.regions.size(); ++i) {
            const std::string& region = foam_.regions[i];
            const auto share = [&](double done) {
                progress((static_cast<double>(i) + done) / static_cast<double>(foam_.regions.size()));
            };
            share(0);
            const FoamMesh& mesh = mesh_at(region, time);
            share(0.5);
            auto blocks = region_blocks(region, time, mesh);
            if (foam_.regions.size() == 1)
                tree = blocks;
            else
                add_block(tree, blocks, shown(region));
        }
        return tree;
    }

    void add_known(InputGrids& input_grids, const RunningCounts& first) const override {
        for (InputGrid& surface : input_grids.surfaces)
            if (const auto known = facts_.find(surface.data); known != facts_.end()) surface.facts = known->second;
        ciel::Index first_point = first.points, first_cell = first.cells; // ids continue from region to region
        for (const std::string& region : foam_.regions) {
            const FoamMesh& mesh = meshes_.at(region).mesh;
            for (const auto& [a, b] : mesh.same_points)
                input_grids.same_points.emplace_back(first_point + a, first_point + b);
            input_grids.joined_faces += mesh.joined_faces;
            input_grids.single_faces += mesh.single_faces;
            for (const auto& [name, cells] : mesh.cell_zones) {
                NamedCells& zone = input_grids.named_cells.emplace_back(NamedCells{zone_name(region, name), {}});
                for (const ciel::Index cell : cells) zone.cells.push_back(first_cell + cell);
            }
            first_point += static_cast<ciel::Index>(mesh.points->GetNumberOfPoints());
            first_cell += static_cast<ciel::Index>(mesh.grid->GetNumberOfCells());
        }
    }

    // Returns "0.5/p", "processor*/0.5/p" for a decomposed case, or "0.5/*/p" for several regions.
    [[nodiscard]] std::string file_of(const ArrayName& array, std::size_t step) const override {
        const FoamRoot& root = foam_.roots.front();
        const auto at = root.times.find(foam_.times[step]);
        if (at == root.times.end()) return "";
        const bool has_regions = foam_.regions.size() > 1;
        const std::filesystem::path one = plain_or_compressed(at->second / foam_.regions.front() / array.name);
        const std::string name = one.empty() ? array.name : one.filename().string();
        const std::filesystem::path in = at->second / (has_regions ? "*" : foam_.regions.front());
        const std::string file = (in / name).lexically_relative(root.directory).string();
        return foam_.is_decomposed ? "processor*/" + file : file;
    }

    [[nodiscard]] std::vector<std::filesystem::path> files_of(std::size_t step,
                                                              const std::set<std::string>& names) const override {
        const double time = foam_.times[step];
        std::vector<std::filesystem::path> files;
        for (const std::string& region : foam_.regions) {
            for (std::filesystem::path& file : foam_mesh_files(foam_, region, time))
                if (!file.empty()) files.push_back(std::move(file));
            for (const FoamRoot& root : foam_.roots)
                if (const auto at = root.times.find(time); at != root.times.end())
                    for (const std::string& name : names)
                        if (auto file = plain_or_compressed(at->second / region / name); !file.empty())
                            files.push_back(std::move(file));
        }
        return files;
    }

    [[nodiscard]] std::map<std::string, std::string> units() const override {
        std::map<std::string, std::string> units;
        for (const auto& [name, info] : infos_) units[name] = info.units;
        return units;
    }

    [[nodiscard]] std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const override {
        std::vector<ArrayName> listed;
        for (const auto& [name, info] : infos_) listed.push_back({FieldOf::cells, name});
        return listed;
    }

    [[nodiscard]] std::vector<std::string> notes() const override { return foam_.notes; }
    [[nodiscard]] std::vector<std::string> lost() const override { return {lost_.begin(), lost_.end()}; }
    [[nodiscard]] std::string length_units() const override { return "m"; } // OpenFOAM uses SI units

private:
    struct Known {
        std::vector<std::filesystem::path> files;
        FoamMesh mesh;
    };

    const FoamMesh& mesh_at(const std::string& region, double time) {
        std::vector<std::filesystem::path> files = foam_mesh_files(foam_, region, time);
        Known& known = meshes_[region];
        if (known.files != files) {
            known = {}; // frees the old mesh before the new mesh is read
            known.mesh = read_foam_mesh(foam_, region, time);
            known.files = std::move(files);
        }
        lost_.insert(lost_.end(), known.mesh.lost.begin(), known.mesh.lost.end());
        return known.mesh;
    }

    [[nodiscard]] std::string zone_name(const std::string& region, const std::string& name) const {
        const auto regions_with_it = std::count_if(meshes_.begin(), meshes_.end(), [&](const auto& known) {
            return known.second.mesh.cell_zones.contains(name);
        });
        return regions_with_it > 1 ? shown(region) + "/" + name : name;
    }
    static std::string shown(const std::string& region) { return region.empty() ? "defaultRegion" : region; }

    // Returns the grid, patches and zones as VTK blocks with the names that source/input_grids.cpp recognizes.
    vtkSmartPointer<vtkMultiBlockDataSet> region_blocks(const std::string& region, double time, const FoamMesh& mesh) {
        const auto fields = read_foam_fields(foam_, region, time, mesh, infos_, lost_);
        vtkNew<vtkUnstructuredGrid> cells;
        cells->ShallowCopy(mesh.grid);
        vtkNew<vtkMultiBlockDataSet> boundary, face_zones;
        for (const auto& [name, arrays] : fields) cells->GetCellData()->AddArray(arrays.cells);
        for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
            const auto patch = as_polygons(mesh.patches[i], mesh.points);
            store::PatchFacts& facts = facts_[patch];
            facts.type = mesh.patches[i].type;
            for (const auto& [name, arrays] : fields) {
                if (arrays.patches[i] != nullptr) patch->GetCellData()->AddArray(arrays.patches[i]);
                if (arrays.patches[i] != nullptr || !arrays.conditions[i].empty())
                    facts.conditions[name] = arrays.conditions[i];
            }
            add_block(boundary, patch, mesh.patches[i].name);
        }
        for (const FoamSurface& zone : mesh.face_zones)
            add_block(face_zones, as_polygons(zone, mesh.points), zone.name);
        auto multiblock = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        add_block(multiblock, cells, "internalMesh");
        add_block(multiblock, boundary, "boundary");
        add_block(multiblock, face_zones, "faceZones");
        return multiblock;
    }

    FoamCase foam_;
    FoamFieldInfos infos_;
    std::map<std::string, Known> meshes_; // by region
    std::vector<std::string> lost_;
    // Keys: surfaces of the step that was read last. The caller keeps the surfaces alive.
    std::map<vtkDataSet*, store::PatchFacts> facts_;
};

} // namespace

bool is_openfoam(const Head& head) { return is_foam_case(head.path, head.directory, head.extension); }

std::unique_ptr<Source> open_openfoam(const Inputs& inputs, const SourceOptions&) {
    return std::make_unique<OpenFoamSource>(inputs.front());
}

} // namespace server::importer
