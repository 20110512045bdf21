#include "import/readers/openfoam/openfoam_fields.hpp"

#include "ciel/types.hpp"
#include "import/parsers/openfoam/field.hpp"
#include "import/parsers/openfoam/macros.hpp"
#include "import/parsers/openfoam/reader.hpp"
#include "import/parsers/openfoam/units.hpp"
#include "store/no_value.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>

namespace server::importer {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t head_bytes = 4096;
constexpr double no_value{store::no_value}; // conversion to float gives the bits of store::no_value again

struct FieldHead {
    std::string class_name, units;
};

FieldHead read_head(const fs::path& file) {
    try {
        const std::string head = read_foam_file(file, head_bytes);
        return {FoamReader(head, file.string()).format().class_name, openfoam_units(head)};
    } catch (const ciel::Error&) {
        return {};
    }
}

std::map<std::string, fs::path> files_in(const fs::path& directory) {
    std::map<std::string, fs::path> files;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory, missing)) {
        if (entry.is_directory()) continue;
        const bool is_compressed = entry.path().extension() == ".gz";
        files.emplace((is_compressed ? entry.path().stem() : entry.path().filename()).string(), entry.path());
    }
    return files;
}

FoamField read_field(const fs::path& file, std::size_t cells) {
    const auto load = [&file](std::string_view name) -> std::optional<std::string> {
        const fs::path included = file.parent_path() / name;
        if (!fs::exists(included)) return std::nullopt;
        return read_foam_file(included);
    };
    const std::string text = expand_foam_macros(read_foam_file(file), file.string(), load);
    FoamField field = parse_foam_field(text, file.string(), cells);
    const std::size_t needed = field.cells.is_uniform ? 1 : cells;
    if (const std::size_t found = field.cells.numbers.size() / static_cast<std::size_t>(field.components);
        found != needed)
        throw ciel::Error(file.string() + ": has values for " + std::to_string(found) + " of " + std::to_string(cells) +
                          " cells");
    return field;
}

// The field of one piece; nullopt if it could not be read.
using PieceField = std::optional<FoamField>;

class ArrayMaker {
public:
    ArrayMaker(const FoamMesh& mesh, const std::vector<PieceField>& fields, const std::vector<fs::path>& files,
               int components)
        : mesh_(mesh), fields_(fields), files_(files), width_(static_cast<std::size_t>(components)) {
        is_single_ = std::all_of(fields.begin(), fields.end(),
                                 [](const PieceField& field) { return !field || field->is_single_precision; });
    }

    FoamArrays run(const std::string& name) {
        FoamArrays arrays;
        std::size_t cells = 0;
        for (const FoamPiece& piece : mesh_.pieces) cells = std::max(cells, piece.first_cell + piece.cell_count);
        std::vector<double> values(cells * width_, no_value);
        for (std::size_t i = 0; i < mesh_.pieces.size(); ++i)
            if (fields_[i])
                copy(fields_[i]->cells, mesh_.pieces[i].cell_count, &values[mesh_.pieces[i].first_cell * width_]);
        arrays.cells = make_array(name, values);
        for (const FoamSurface& patch : mesh_.patches) {
            std::string condition;
            arrays.patches.push_back(patch_array(name, patch, condition));
            arrays.conditions.push_back(std::move(condition));
        }
        return arrays;
    }

private:
    void copy(const FoamValues& from, std::size_t items, double* to) const {
        for (std::size_t i = 0; i < items * width_; ++i) to[i] = from.numbers[from.is_uniform ? i % width_ : i];
    }

    vtkSmartPointer<vtkDataArray> make_array(const std::string& name, const std::vector<double>& values) const {
        vtkSmartPointer<vtkDataArray> array;
        if (is_single_)
            array = vtkSmartPointer<vtkFloatArray>::New();
        else
            array = vtkSmartPointer<vtkDoubleArray>::New();
        array->SetName(name.c_str());
        array->SetNumberOfComponents(static_cast<int>(width_));
        array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / width_));
        name_components(*array);
        if (is_single_)
            std::copy(values.begin(), values.end(), static_cast<float*>(array->GetVoidPointer(0)));
        else
            std::copy(values.begin(), values.end(), static_cast<double*>(array->GetVoidPointer(0)));
        return array;
    }

    // The order is that of OpenFOAM's classes symmTensor and tensor.
    static void name_components(vtkDataArray& array) {
        constexpr const char* symmetric[] = {"xx", "xy", "xz", "yy", "yz", "zz"};
        constexpr const char* full[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
        const int components = array.GetNumberOfComponents();
        if (components != 6 && components != 9) return;
        for (int c = 0; c < components; ++c) array.SetComponentName(c, components == 6 ? symmetric[c] : full[c]);
    }

    vtkSmartPointer<vtkDataArray> patch_array(const std::string& name, const FoamSurface& patch,
                                              std::string& condition) const {
        std::vector<double> values;
        bool has_values = false;
        for (std::size_t i = 0; i < mesh_.pieces.size(); ++i)
            for (const FoamPatch& own : mesh_.pieces[i].patches)
                if (own.name == patch.name && own.face_count > 0)
                    has_values = append_patch(i, own, values, condition) || has_values;
        return has_values ? make_array(name, values) : nullptr;
    }

    // Appends no_value for faces without a value. Returns whether the patch has values on piece i.
    bool append_patch(std::size_t i, const FoamPatch& patch, std::vector<double>& values, std::string& type) const {
        const auto faces = static_cast<std::size_t>(patch.face_count);
        const std::size_t begin = values.size();
        values.resize(begin + faces * width_, no_value);
        if (!fields_[i]) return false;
        const FoamField& field = *fields_[i];
        const FoamCondition* condition = field.condition(patch.name, patch.groups);
        if (condition != nullptr) type = condition->type;
        if (patch.type == "empty" || patch.type == "wedge") return false; // patches of 2D cases have no values
        if (condition != nullptr && condition->value) {
            const FoamValues& own = *condition->value;
            if (!own.is_uniform && own.numbers.size() != faces * width_)
                throw ciel::Error(files_[i].string() + ": has " + std::to_string(own.numbers.size() / width_) +
                                  " values on patch " + patch.name + ", which has " + std::to_string(faces) + " faces");
            copy(own, faces, &values[begin]);
        } else if (condition != nullptr && condition->type == "noSlip") {
            std::fill(values.begin() + static_cast<std::ptrdiff_t>(begin), values.end(), 0.0);
        } else {
            copy_from_cells(i, patch, &values[begin]);
        }
        return true;
    }

    // Used for boundary conditions without values in the file (zeroGradient, slip, symmetry).
    void copy_from_cells(std::size_t i, const FoamPatch& patch, double* to) const {
        const FoamPiece& piece = mesh_.pieces[i];
        const FoamValues& cells = fields_[i]->cells;
        const std::size_t first = static_cast<std::size_t>(patch.first_face) - piece.first_boundary_face;
        for (std::size_t face = 0; face < static_cast<std::size_t>(patch.face_count); ++face)
            for (std::size_t c = 0; c < width_; ++c)
                *to++ = cells.numbers[cells.is_uniform ? c : piece.boundary_owner[first + face] * width_ + c];
    }

    const FoamMesh& mesh_;
    const std::vector<PieceField>& fields_;
    const std::vector<fs::path>& files_;
    std::size_t width_;
    bool is_single_ = false;
};

std::string at_time(double time) {
    std::ostringstream text;
    text << " at time " << time;
    return text.str();
}

class FoamFieldReader {
public:
    FoamFieldReader(const FoamCase& foam, const std::string& region, double time, const FoamMesh& mesh,
                    std::vector<std::string>& lost)
        : time_(time), mesh_(mesh), lost_(lost) {
        for (const FoamPiece& piece : mesh.pieces) {
            const FoamRoot& root = foam.roots[piece.root];
            const auto at = root.times.find(time);
            directories_.push_back(at == root.times.end() ? fs::path() : at->second / region);
            if (at == root.times.end() && foam.is_decomposed)
                lost_.push_back("There is no directory of " + root.name + at_time(time) +
                                ": its cells have no values at that time.");
        }
    }

    // Returns the names of the fields. A file without a readable header is a field if `infos` has its name.
    [[nodiscard]] std::set<std::string> names(const FoamFieldInfos& infos) const {
        std::set<std::string> names;
        for (const fs::path& directory : directories_)
            for (const auto& [name, file] : files_in(directory))
                if (infos.contains(name) || foam_field_components(read_head(file).class_name) > 0) names.insert(name);
        return names;
    }

    // Returns nullopt if no piece has values. `expected`: number of components; 0: as in the first piece with values.
    std::optional<FoamArrays> read(const std::string& name, int expected) {
        fields_.assign(mesh_.pieces.size(), std::nullopt);
        files_.assign(mesh_.pieces.size(), {});
        for (std::size_t i = 0; i < fields_.size(); ++i)
            if (!directories_[i].empty()) read_piece(name, i, expected);
        if (std::none_of(fields_.begin(), fields_.end(), [](const PieceField& field) { return field.has_value(); }))
            return std::nullopt;
        try {
            return ArrayMaker(mesh_, fields_, files_, expected).run(name);
        } catch (const ciel::Error& error) {
            lose(name, error.what());
            return std::nullopt;
        }
    }

private:
    void read_piece(const std::string& name, std::size_t i, int& expected) {
        files_[i] = plain_or_compressed(directories_[i] / name);
        try {
            if (files_[i].empty()) throw ciel::Error((directories_[i] / name).string() + ": is missing");
            FoamField field = read_field(files_[i], mesh_.pieces[i].cell_count);
            if (expected == 0) expected = field.components;
            if (field.components != expected)
                throw ciel::Error(files_[i].string() + ": has " + std::to_string(field.components) +
                                  " components, but other times or processors have " + std::to_string(expected));
            fields_[i] = std::move(field);
        } catch (const ciel::Error& error) {
            lose(name, error.what());
        }
    }

    void lose(const std::string& name, const std::string& reason) {
        lost_.push_back("The field " + name + at_time(time_) + " could not be read and has no values: " + reason);
    }

    double time_;
    const FoamMesh& mesh_;
    std::vector<std::string>& lost_;
    std::vector<fs::path> directories_; // piece -> directory of the fields; empty if there is none at this time
    std::vector<PieceField> fields_;
    std::vector<fs::path> files_;
};

} // namespace

FoamFieldInfos list_foam_fields(const FoamCase& foam) {
    FoamFieldInfos infos;
    std::map<std::string, std::map<int, std::size_t>> times; // name -> components -> number of files
    std::map<std::string, std::map<int, std::string>> units; // name -> components -> units in the first file
    for (const auto& [time, directory] : foam.roots.front().times)
        for (const std::string& region : foam.regions)
            for (const auto& [name, file] : files_in(directory / region)) {
                const FieldHead head = read_head(file);
                const int components = foam_field_components(head.class_name);
                if (components == 0) continue;
                ++times[name][components];
                units[name].try_emplace(components, head.units);
                infos[name];
            }
    for (auto& [name, info] : infos) {
        const auto& found = times[name];
        info.components = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
                              return a.second < b.second;
                          })->first;
        info.units = units[name][info.components];
    }
    return infos;
}

std::map<std::string, FoamArrays> read_foam_fields(const FoamCase& foam, const std::string& region, double time,
                                                   const FoamMesh& mesh, const FoamFieldInfos& infos,
                                                   std::vector<std::string>& lost) {
    std::map<std::string, FoamArrays> arrays;
    FoamFieldReader reader(foam, region, time, mesh, lost);
    for (const std::string& name : reader.names(infos)) {
        const auto info = infos.find(name);
        if (auto read = reader.read(name, info == infos.end() ? 0 : info->second.components))
            arrays.emplace(name, std::move(*read));
    }
    return arrays;
}

} // namespace server::importer
