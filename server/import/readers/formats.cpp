#include "import/readers/formats.hpp"

#include "ciel/types.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/regular_file.hpp"

#include <algorithm>
#include <fstream>
#include <vtkCONVERGECFDReader.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkTecplotReader.h>

namespace server::importer {

namespace {

bool contains(const Head& head, std::string_view text) { return head.bytes.find(text) != std::string::npos; }
bool starts(const Head& head, std::string_view text) { return head.bytes.compare(0, text.size(), text) == 0; }
bool is_hdf5(const Head& head) { return starts(head, "\x89HDF\r\n\x1a\n"); }
bool is_netcdf(const Head& head) { return starts(head, "CDF"); }

bool has_extension(const Head& head, std::initializer_list<std::string_view> extensions) {
    return std::find(extensions.begin(), extensions.end(), head.extension) != extensions.end();
}

bool is_pvd(const Head& head) { return contains(head, "<VTKFile") && contains(head, "\"Collection\""); }
bool is_series(const Head& head) { return has_extension(head, {".series"}) && contains(head, "file-series-version"); }
bool is_vtk_xml(const Head& head) { return contains(head, "<VTKFile") && !is_pvd(head); }
bool is_legacy_vtk(const Head& head) { return starts(head, "# vtk DataFile"); }
bool is_vtkhdf(const Head& head) { return is_hdf5(head) && has_extension(head, {".vtkhdf", ".hdf"}); }
bool is_converge(const Head& head) { return is_hdf5(head) && has_extension(head, {".h5"}); }
bool is_cgns(const Head& head) { return has_extension(head, {".cgns"}) && (is_hdf5(head) || contains(head, "ADF")); }
bool is_exodus(const Head& head) {
    return has_extension(head, {".e", ".ex2", ".exo", ".exoii", ".g", ".gen"}) && (is_netcdf(head) || is_hdf5(head));
}
bool is_ensight(const Head& head) { return has_extension(head, {".case", ".encas"}) && contains(head, "FORMAT"); }
bool is_tecplot(const Head& head) {
    return has_extension(head, {".tec", ".dat"}) && (contains(head, "ZONE") || contains(head, "zone"));
}
bool is_lsdyna(const Head& head) {
    return has_extension(head, {".lsdyna"}) || head.path.filename().string().find("d3plot") != std::string::npos;
}

template <typename Reader>
std::unique_ptr<Source> open_with(std::string_view format, const Inputs& inputs) {
    vtkNew<Reader> reader;
    reader->SetFileName(inputs.front().c_str());
    return std::make_unique<ReaderSource>(std::string(format), inputs.front(), reader.Get());
}

std::unique_ptr<Source> open_vtkhdf(const Inputs& inputs, const SourceOptions&) {
    vtkNew<vtkHDFReader> reader;
    reader->SetFileName(inputs.front().c_str());
    if (reader->CanReadFile(inputs.front().c_str()) == 0)
        throw ciel::Error(inputs.front() + ": is an HDF5 file but holds no VTKHDF group");
    return std::make_unique<ReaderSource>("VTKHDF", inputs.front(), reader.Get(),
                                          [&] { return arrays_of(*reader.Get()); });
}

std::unique_ptr<Source> open_converge(const Inputs& inputs, const SourceOptions&) {
    return open_with<vtkCONVERGECFDReader>("CONVERGE", inputs);
}
std::unique_ptr<Source> open_tecplot(const Inputs& inputs, const SourceOptions&) {
    return open_with<vtkTecplotReader>("Tecplot", inputs);
}

const std::vector<Format>& table() {
    static const std::vector<Format> rows{
        {"PVD collection", {".pvd"}, is_pvd, false, open_index},
        {"file series", {".series"}, is_series, false, open_index},
        {"VTK XML",
         {".vtu", ".pvtu", ".vts", ".pvts", ".vtr", ".pvtr", ".vti", ".pvti", ".vtm", ".vtmb", ".vtpd", ".vtpc"},
         is_vtk_xml,
         false,
         open_vtk_xml},
        {"legacy VTK", {".vtk"}, is_legacy_vtk, false, open_legacy_vtk},
        {"VTKHDF", {".vtkhdf", ".hdf"}, is_vtkhdf, false, open_vtkhdf},
        {"OpenFOAM", {".foam"}, is_openfoam, false, open_openfoam},
        {"EnSight Gold", {".case", ".encas"}, is_ensight, false, open_ensight},
        {"Exodus II", {".e", ".ex2", ".exo", ".exoii", ".gen"}, is_exodus, false, open_exodus},
        {"CGNS", {".cgns"}, is_cgns, false, open_cgns},
        {"LS-DYNA", {".lsdyna"}, is_lsdyna, false, open_lsdyna},
        {"Fluent", {".cas"}, is_fluent, false, open_fluent},
        {"Fluent CFF", {".cas.h5"}, is_fluent_cff, false, open_fluent_cff},
        {"CONVERGE", {".h5"}, is_converge, false, open_converge},
        {"Tecplot", {".tec", ".dat"}, is_tecplot, false, open_tecplot},
        {"PLOT3D", {".xyz", ".x", ".g", ".p3d", ".grd", ".grid", ".bin"}, is_plot3d, true, open_plot3d},
    };
    return rows;
}

bool is_zarr_folder(const Head& head) {
    std::error_code error;
    for (const char* document : {".zgroup", ".zarray", "zarr.json"})
        if (head.directory && std::filesystem::exists(head.path / document, error)) return true;
    return false;
}

Head read_head(const std::string& input) {
    Head head;
    head.path = input;
    std::error_code error;
    head.directory = std::filesystem::is_directory(head.path, error);
    require_existing(head.path);
    head.extension = head.path.extension().string();
    std::transform(head.extension.begin(), head.extension.end(), head.extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (head.directory) return head;
    require_regular(head.path);
    head.size = std::filesystem::file_size(head.path, error);
    std::ifstream file(head.path, std::ios::binary);
    if (!file) throw ciel::Error(input + ": cannot be opened; check its permissions");
    head.bytes.resize(4096);
    file.read(head.bytes.data(), static_cast<std::streamsize>(head.bytes.size()));
    head.bytes.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

std::string known_formats() {
    std::string text;
    for (const Format& format : table()) {
        text += (text.empty() ? "" : ", ") + std::string(format.name) + " (";
        for (std::size_t i = 0; i < format.extensions.size(); ++i)
            text += (i == 0 ? "" : " ") + std::string(format.extensions[i]);
        text += ")";
    }
    return text;
}

} // namespace

std::span<const Format> formats() { return table(); }

const Format& find_format(const std::string& input) {
    const Head head = read_head(input);
    const bool foam_marker = head.extension == ".foam"; // a .foam file is empty by convention
    if (!head.directory && head.bytes.empty() && !foam_marker) throw ciel::Error(input + ": is empty");
    for (const Format& format : table())
        if (format.probe(head)) return format;
    if (head.extension == ".bp")
        throw ciel::Error(input + ": is an ADIOS2 (BP) file, which CIEL does not read; write VTKHDF, VTU or Exodus");
    if (is_zarr_folder(head))
        throw ciel::Error(input + ": is a Zarr folder of another program; the name of a CIEL dataset ends in .ciel");
    if (head.directory)
        throw ciel::Error(input +
                          ": is a directory but not an OpenFOAM case (it has no constant/polyMesh); name a file");
    for (const Format& format : table())
        if (std::find(format.extensions.begin(), format.extensions.end(), head.extension) != format.extensions.end())
            throw ciel::Error(input + ": has the extension of " + std::string(format.name) +
                              " files but the content of another format; correct the extension or copy the file again");
    throw ciel::Error(input + ": has an unknown format; the known formats are " + known_formats());
}

} // namespace server::importer
