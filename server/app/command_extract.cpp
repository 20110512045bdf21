// ciel extract NAME.ciel --iso ARRAY=VALUE -o FILE: writes iso-surfaces and slices to one file.
#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "geometry/places.hpp"
#include "geometry/sound_shape.hpp"
#include "geometry/surface_values.hpp"
#include "store/files/files.hpp"
#include "wire/files/joined_surface.hpp"
#include "wire/files/surface_files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

namespace server::app {
namespace {

struct ExtractCommand {
    SceneOptions scene;
    std::vector<std::string> colors;
    bool triangles = false, from_origin = false;
    std::string output;
};

bool is_of_cells(store::LoadedDataset& loaded, const std::string& scalar) {
    const auto dataset = loaded.dataset();
    return dataset->find(store::parse_scalar(*dataset, scalar).array)->association == store::Association::cell;
}

// If one of the arrays is a cell array, the polygons share no vertices, so that each has the value of its cell.
std::shared_ptr<const geometry::Shape> shape_for(const geometry::Drawable& drawable,
                                                 const std::vector<std::string>& scalars, std::size_t step,
                                                 store::LoadedDataset& loaded) {
    const auto sound = geometry::sound_shape(drawable.shape, scalars, step, loaded);
    const bool flat =
        std::ranges::any_of(scalars, [&](const std::string& scalar) { return is_of_cells(loaded, scalar); });
    return flat ? geometry::separated(*sound) : sound;
}

std::vector<wire::NamedValues> values_of(const ciel::Surface& surface, const std::vector<std::string>& scalars,
                                         store::LoadedDataset& loaded, std::size_t step) {
    std::vector<wire::NamedValues> all;
    for (const std::string& scalar : scalars) {
        // A vector without a component means its magnitude, which the file calls ARRAY:magnitude.
        const store::ScalarName name = store::parse_scalar(*loaded.dataset(), scalar);
        const store::Values values =
            is_of_cells(loaded, scalar)
                ? geometry::flat_values(
                      surface, loaded.stored_scalar(scalar, step, store::Association::cell)->of(surface.polygon_cell))
                : loaded.stored_scalar(scalar, step)->at(surface.points);
        all.push_back(wire::NamedValues::copy_of(name.magnitude ? name.array + ":magnitude" : scalar, values));
    }
    return all;
}

std::string range_of(const std::string& scalar, store::LoadedDataset& loaded, std::size_t step) {
    const store::Histogram all = loaded.histogram(scalar, step, 1);
    if (all.counts[0] == 0) return scalar + " has no finite value";
    std::ostringstream text;
    text << scalar << " lies between " << all.range[0] << " and " << all.range[1];
    return text.str();
}

std::string why_empty(const scene::CheckedScene& checked, const geometry::Geometry& geometry) {
    std::ostringstream text;
    text << "the surface is empty: at time " << geometry.time;
    std::set<std::string> scalars;
    bool slices = false;
    for (const scene::Layer& layer : checked.scene().layers) {
        if (const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind)) scalars.insert(iso->array);
        slices = slices || std::holds_alternative<scene::SliceLayer>(layer.kind);
    }
    const char* separator = " ";
    for (const std::string& scalar : scalars)
        text << std::exchange(separator, ", ") << range_of(scalar, *checked.loaded(), geometry.step);
    if (slices)
        for (std::size_t axis = 0; axis < 3; ++axis)
            text << std::exchange(separator, ", ") << "xyz"[axis] << " lies between " << geometry.bounds_min[axis]
                 << " and " << geometry.bounds_max[axis];
    return text.str();
}

void tell_left_out(const scene::CheckedScene& checked, const std::vector<std::string>& colors, std::size_t step) {
    store::LoadedDataset& loaded = *checked.loaded();
    std::set<std::string> sentences;
    for (const std::string& color : colors) sentences.insert(geometry::left_out_text(color, false, step, loaded));
    for (const scene::Layer& layer : checked.scene().layers)
        if (const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind))
            sentences.insert(geometry::left_out_text(iso->array, true, step, loaded));
    for (const std::string& sentence : sentences)
        if (!sentence.empty()) std::cerr << "ciel: " << sentence << '\n';
}

wire::SurfaceFormat format_of(const std::string& output) {
    try {
        return wire::surface_format(lower_case_extension(output));
    } catch (const ciel::Error& error) {
        throw UsageError("-o " + output + ": " + error.what());
    }
}

int run_command(const ExtractCommand& extract) {
    const auto format = format_of(extract.output);
    if (!extract.scene.has_layers()) throw UsageError("nothing to extract; give --iso, --slice or --plane");
    const auto loaded = load_dataset(extract.scene.dataset);
    const scene::Scene scene = parse_scene(extract.scene.document(*loaded->dataset()));
    if (!extract.colors.empty()) read_late_step(scene, *loaded);
    const auto [checked, geometry] = make_geometry(scene, loaded, extract.scene.extraction.chosen());
    geometry::require_complete(*geometry);
    wire::JoinedSurface joined;
    for (const geometry::Drawable& drawable : geometry->drawables) {
        if (!drawable.polygons()) continue;
        const auto shape = shape_for(drawable, extract.colors, geometry->step, *loaded);
        const ciel::Surface& surface = shape->surface;
        joined.add(surface, values_of(surface, extract.colors, *loaded, geometry->step),
                   geometry::places_of(surface, *geometry, *loaded->dataset()));
    }
    std::ostringstream bytes;
    const bool is_moved = extract.from_origin || wire::has_floats(format);
    const ciel::Vec3d origin = is_moved ? wire::file_origin(geometry->first_mesh_bounds) : ciel::Vec3d{};
    const wire::ExportedCounts written = wire::write_surface(
        format, {joined.surface(), geometry->origin, joined.values(), extract.triangles, origin, joined.places()},
        bytes);
    const std::string text = std::move(bytes).str();
    store::replace_file(std::filesystem::absolute(extract.output), store::bytes_of(text));
    tell_left_out(checked, extract.colors, geometry->step);
    if (written.polygons == 0) std::cerr << "ciel: " << why_empty(checked, *geometry) << '\n';
    std::printf("wrote %s: %zu polygons, %zu vertices\n", extract.output.c_str(), written.polygons, written.vertices);
    if (origin != ciel::Vec3d{} || extract.from_origin)
        std::printf("the coordinates are relative to the origin %s\n", wire::origin_text(origin).c_str());
    return 0;
}

} // namespace

void add_extract(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand("extract", "Write iso-surfaces and slices to a PLY, STL or VTP file.");
    command->footer("An iso-value outside the range of the array gives an empty surface. A sentence on stderr names "
                    "the range,\nand the exit code is 0.");
    auto extract = std::make_shared<ExtractCommand>();
    extract->scene.add_to(*command);
    command
        ->add_option(
            "--color", extract->colors,
            "Arrays on the surface: a point array is interpolated, a cell array (cell:NAME) is constant per polygon.")
        ->type_name("ARRAY");
    command->add_flag("--triangles", extract->triangles,
                      "Write triangles instead of polygons (STL always has triangles).");
    command->add_flag("--origin", extract->from_origin,
                      "Write coordinates relative to an origin that is the same for all surfaces of the dataset. STL "
                      "files have relative coordinates even without --origin if 32-bit floats would lose digits.");
    command->add_option("-o,--output", extract->output, "The output file, .ply, .stl or .vtp.")
        ->required()
        ->type_name("FILE");
    command->callback([&run, extract] { run = [extract] { return run_command(*extract); }; });
}

} // namespace server::app
