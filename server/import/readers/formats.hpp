// The table of input formats. For each format it has a function that recognizes a file and a function that opens it.
#pragma once

#include "import/source/source.hpp"

#include <filesystem>
#include <span>
#include <string_view>

namespace server::importer {

using Inputs = std::vector<std::string>;

struct Head {
    std::filesystem::path path;
    std::string extension; // lower case, with the dot
    bool directory = false;
    std::uint64_t size = 0;
    std::string bytes; // the first 4 KiB of a file; empty for a directory
};

struct Format {
    std::string_view name;
    std::vector<std::string_view> extensions;
    bool (*probe)(const Head& head);
    bool several_inputs; // true: `open` takes all inputs; false: each input is opened alone, as a part of one mesh
    std::unique_ptr<Source> (*open)(const Inputs& inputs, const SourceOptions& options);
};

[[nodiscard]] std::span<const Format> formats();

// Throws Error if the input does not exist, is empty, or has an unknown format.
[[nodiscard]] const Format& find_format(const std::string& input);

std::unique_ptr<Source> open_index(const Inputs& inputs, const SourceOptions& options);      // index_source.cpp
std::unique_ptr<Source> open_vtk_xml(const Inputs& inputs, const SourceOptions& options);    // vtk_xml.cpp
std::unique_ptr<Source> open_legacy_vtk(const Inputs& inputs, const SourceOptions& options); // legacy_vtk.cpp
std::unique_ptr<Source> open_openfoam(const Inputs& inputs, const SourceOptions& options);   // openfoam.cpp
std::unique_ptr<Source> open_plot3d(const Inputs& inputs, const SourceOptions& options);     // plot3d.cpp
std::unique_ptr<Source> open_ensight(const Inputs& inputs, const SourceOptions& options);    // ensight.cpp
std::unique_ptr<Source> open_exodus(const Inputs& inputs, const SourceOptions& options);     // exodus.cpp
std::unique_ptr<Source> open_lsdyna(const Inputs& inputs, const SourceOptions& options);     // lsdyna.cpp
std::unique_ptr<Source> open_cgns(const Inputs& inputs, const SourceOptions& options);       // cgns.cpp
std::unique_ptr<Source> open_fluent(const Inputs& inputs, const SourceOptions& options);     // fluent.cpp
std::unique_ptr<Source> open_fluent_cff(const Inputs& inputs, const SourceOptions& options); // fluent.cpp

// Returns the file. If the file is an index of pieces or blocks, also returns the files that the index names.
std::vector<std::filesystem::path> files_of_vtk_xml(const std::filesystem::path& file); // vtk_xml.cpp

bool is_fluent(const Head& head);
bool is_fluent_cff(const Head& head);
bool is_openfoam(const Head& head);
bool is_plot3d(const Head& head);

} // namespace server::importer
