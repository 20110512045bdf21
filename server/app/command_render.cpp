// ciel render NAME.ciel -o FILE.png: a still picture, made as the server makes it.
#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "session/default_scene.hpp"
#include "session/errors.hpp"
#include "session/picture.hpp"
#include "store/files.hpp"
#include "wire/png.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace ciel::app {
namespace {

constexpr int samples = 4;

struct RenderCommand {
    SceneOptions scene;
    std::string scene_file, size = "1280x720", gl = "auto", output;
    std::optional<std::string> color, map, range, background;

    [[nodiscard]] bool colors() const { return color || map || range; }
};

struct Size {
    std::int64_t width = 0, height = 0;
};

Size parse_size(const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto [cross, first] = std::from_chars(text.data(), end, size.width);
    const bool has_cross = first == std::errc{} && cross != end && *cross == 'x';
    const auto [stop, second] = std::from_chars(has_cross ? cross + 1 : end, end, size.height);
    if (second != std::errc{} || stop != end || size.width < 1 || size.height < 1)
        throw UsageError("--size " + text + " is not of the form WIDTHxHEIGHT");
    try {
        session::check_picture_size({}, size.width, size.height);
    } catch (const session::LimitReached& error) {
        throw UsageError("--size " + text + " is too large: " + error.what());
    }
    return size;
}

nlohmann::json read_scene_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(path + " cannot be read");
    try {
        return nlohmann::json::parse(file);
    } catch (const nlohmann::json::exception& error) {
        const std::string reason = error.what(); // "[json.exception...] parse error at line 2...": the part for people
        throw Error(path + " is not JSON: " + reason.substr(std::min(reason.size(), reason.find("] ") + 2)));
    }
}

std::vector<double> parse_range(const std::string& text) {
    auto range = parse_numbers("--range", text);
    if (range.size() != 2) throw UsageError("--range " + text + " is not of the form MIN,MAX");
    return range;
}

// What was asked for, on everything that can have the colours of an array.
void color_layers(const RenderCommand& render, nlohmann::json& layers) {
    bool any = false;
    for (auto& layer : layers) {
        if (layer["type"] == "volume") {
            any = any || render.map || render.range;
            if (render.map) layer["color"]["map"] = *render.map;
            if (render.range) layer["color"]["range"] = parse_range(*render.range);
        }
        if (layer["type"] != "iso" && layer["type"] != "slice") continue;
        any = true;
        nlohmann::json color = layer.value("color", nlohmann::json::object());
        if (render.color) color["array"] = *render.color;
        if (render.map) color["map"] = *render.map;
        if (render.range) color["range"] = parse_range(*render.range);
        if (!color.contains("array") && layer["type"] == "iso") color["array"] = layer["array"];
        layer["color"] = std::move(color);
    }
    if (!any && render.colors())
        throw UsageError("nothing has colours of an array; give --iso, --slice, --plane or --volume");
}

nlohmann::json document_of_options(const RenderCommand& render, const store::Dataset& dataset) {
    nlohmann::json document = render.scene.document(dataset);
    document["layers"]["outline"] = {{"type", "outline"}, {"color", {{"solid", "#808890"}}}};
    return document;
}

nlohmann::json default_document(const RenderCommand& render, store::LoadedDataset& loaded) {
    nlohmann::json document = session::default_scene(loaded, loaded.dataset()->info().name);
    if (render.scene.time) document["time"] = time_of_step(*loaded.dataset(), *render.scene.time);
    return document;
}

nlohmann::json document_of_file(const RenderCommand& render, const std::string& dataset) {
    if (render.scene.has_layers() || render.colors() || render.background)
        throw UsageError(
            "--scene says what to show and how; leave out --iso, --slice, --plane, --volume, --color, --map, --range "
            "and --background");
    nlohmann::json document = read_scene_file(render.scene_file);
    if (!document.is_object()) return document; // refused with the place by who checks it
    if (!document.contains("dataset")) document["dataset"] = dataset;
    if (document["dataset"] != dataset)
        throw Error(render.scene_file + " is a scene of the dataset " + document["dataset"].dump() + ", not of \"" +
                    dataset + "\"; name that one, or change the scene");
    if (render.scene.time) document["time"] = *render.scene.time;
    return document;
}

nlohmann::json document_of(const RenderCommand& render, store::LoadedDataset& loaded) {
    if (!render.scene_file.empty()) return document_of_file(render, loaded.dataset()->info().name);
    nlohmann::json document =
        render.scene.has_layers() ? document_of_options(render, *loaded.dataset()) : default_document(render, loaded);
    color_layers(render, document["layers"]);
    document["background"] = render.background.value_or("dark");
    return document;
}

int run_command(const RenderCommand& render) {
    const Size size = parse_size(render.size);
    const render::Backend backend = render::backend_named(render.gl);
    if (lower_case_extension(render.output) != ".png")
        throw UsageError("-o " + render.output + ": pictures are .png files");
    const auto loaded = load_dataset(render.scene.dataset);
    const scene::Scene scene = parse_scene(document_of(render, *loaded));
    const auto geometry = make_geometry(scene, loaded, decider_named(render.scene.decider));
    render::Image image;
    render::Renderer renderer(backend);
    renderer.draw(
        session::frame_of(*geometry, scene, static_cast<int>(size.width), static_cast<int>(size.height), samples),
        image);
    std::vector<std::uint8_t> png;
    wire::encode_png(image.width, image.height, image.rgb, wire::PngEffort::still, png);
    store::replace_file(std::filesystem::absolute(render.output), std::as_bytes(std::span(png)));
    std::printf("wrote %s: %zu triangles by %s (%s)\n", render.output.c_str(), geometry->triangles,
                renderer.gl_renderer().c_str(), renderer.selection().c_str());
    return 0;
}

} // namespace

void add_render(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand("render", "Draw a still picture of a dataset.");
    auto render = std::make_shared<RenderCommand>();
    render->scene.add_to(*command);
    command
        ->add_option("--volume", render->scene.volumes,
                     "Volume of a point scalar, and how opaque a ray gets per tenth of the diagonal from the lowest "
                     "value (position 0) to the highest (1); may be repeated.")
        ->type_name("ARRAY[=POSITION:OPACITY,...]");
    command
        ->add_option("--scene", render->scene_file,
                     "A scene document; without it and without layers, the default view.")
        ->type_name("FILE.json");
    command->add_option("--color", render->color, "Point scalar that colours the layers.")->type_name("ARRAY");
    command->add_option("--map", render->map, "Colour map.")->type_name("NAME")->default_str("viridis");
    command->add_option("--range", render->range, "Values of the map's two ends; the array's range by default.")
        ->type_name("MIN,MAX");
    command->add_option("--background", render->background, "dark, light or #rrggbb.")
        ->type_name("COLOR")
        ->default_str("dark");
    command->add_option("--size", render->size, "Of the picture in pixels.")->type_name("WxH")->capture_default_str();
    command->add_option("--gl", render->gl, "What draws.")
        ->check(CLI::IsMember({"auto", "egl-device", "egl-surfaceless", "osmesa"}))
        ->capture_default_str();
    command->add_option("-o,--output", render->output, "The picture.")->required()->type_name("FILE.png");
    command->callback([&run, render] { run = [render] { return run_command(*render); }; });
}

} // namespace ciel::app
