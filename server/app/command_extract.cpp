// ciel extract NAME.ciel --iso ARRAY=VALUE -o FILE: iso-surfaces and slices as one file.
#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "store/files.hpp"
#include "wire/joined_surface.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace ciel::app {
namespace {

struct ExtractCommand {
    SceneOptions scene;
    std::vector<std::string> colors;
    bool triangles = false;
    std::string output;
};

std::vector<wire::NamedValues> values_of(const Surface& surface, const std::vector<std::string>& scalars,
                                         store::LoadedDataset& loaded, std::size_t step) {
    std::vector<wire::NamedValues> all;
    for (const std::string& scalar : scalars) {
        wire::NamedValues values{scalar, std::vector<float>(surface.points.size())};
        interpolate(surface.points, *loaded.scalar_values(scalar, step), 1, values.values);
        all.push_back(std::move(values));
    }
    return all;
}

int run_command(const ExtractCommand& extract) {
    const auto format = wire::surface_format(std::filesystem::path(extract.output).extension());
    if (!extract.scene.has_layers()) throw Error("nothing to extract; give --iso, --slice or --plane");
    const auto loaded = load_dataset(extract.scene.dataset);
    const auto geometry = make_geometry(parse_scene(extract.scene.document(*loaded->dataset())), loaded);
    wire::JoinedSurface joined;
    for (const session::Drawable& drawable : geometry->drawables) {
        const Surface& surface = drawable.shape->surface;
        joined.add(surface, values_of(surface, extract.colors, *loaded, geometry->step));
    }
    std::ostringstream bytes;
    const wire::ExportedCounts written =
        wire::write_surface(format, {joined.surface(), geometry->origin, joined.values(), extract.triangles}, bytes);
    const std::string text = std::move(bytes).str();
    store::replace_file(std::filesystem::absolute(extract.output), store::bytes_of(text));
    if (written.polygons == 0)
        std::cerr << "ciel: there is no surface; `ciel info` shows the arrays' ranges and the bounds\n";
    std::printf("wrote %s: %zu polygons, %zu vertices\n", extract.output.c_str(), written.polygons, written.vertices);
    return 0;
}

} // namespace

void add_extract(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand("extract", "Write iso-surfaces and slices to a PLY, STL or VTP file.");
    auto extract = std::make_shared<ExtractCommand>();
    extract->scene.add_to(*command);
    command->add_option("--color", extract->colors, "Point scalars to interpolate onto the surface.")
        ->type_name("ARRAY");
    command->add_flag("--triangles", extract->triangles, "Triangles instead of polygons (STL always has them).");
    command->add_option("-o,--output", extract->output, "The file, .ply, .stl or .vtp.")->required()->type_name("FILE");
    command->callback([&run, extract] { run = [extract] { return run_command(*extract); }; });
}

} // namespace ciel::app
