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

namespace ciel::app {
namespace {

constexpr int samples = 4;

struct RenderCommand {
    SceneOptions scene;
    std::string scene_file, color, map = "viridis", range, background = "dark", size = "1280x720", gl = "auto", output;
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
        throw Error(path + " is not JSON: " + error.what());
    }
}

std::vector<double> parse_range(const std::string& text) {
    auto range = parse_numbers("--range", text);
    if (range.size() != 2) throw UsageError("--range " + text + " is not of the form MIN,MAX");
    return range;
}

nlohmann::json document_of_options(const RenderCommand& render, const store::Dataset& dataset) {
    nlohmann::json document = render.scene.document(dataset);
    for (auto& layer : document["layers"]) {
        nlohmann::json color{{"map", render.map}};
        if (!render.color.empty())
            color["array"] = render.color;
        else if (layer["type"] == "iso")
            color["array"] = layer["array"];
        if (!render.range.empty()) color["range"] = parse_range(render.range);
        layer["color"] = std::move(color);
    }
    document["layers"]["outline"] = {{"type", "outline"}, {"color", {{"solid", "#808890"}}}};
    document["background"] = render.background;
    return document;
}

nlohmann::json document_of(const RenderCommand& render, store::LoadedDataset& loaded) {
    if (!render.scene_file.empty()) {
        if (render.scene.has_layers())
            throw UsageError("--scene says what to show; leave out --iso, --slice and --plane");
        nlohmann::json document = read_scene_file(render.scene_file);
        if (render.scene.time && document.is_object()) document["time"] = *render.scene.time;
        return document;
    }
    const auto dataset = loaded.dataset();
    if (render.scene.has_layers()) return document_of_options(render, *dataset);
    nlohmann::json document = session::default_scene(loaded, dataset->info().name);
    if (render.scene.time) document["time"] = *render.scene.time;
    return document;
}

int run_command(const RenderCommand& render) {
    const Size size = parse_size(render.size);
    const render::Backend backend = render::backend_named(render.gl);
    if (std::filesystem::path(render.output).extension() != ".png")
        throw Error(render.output + " cannot be written: pictures are .png files");
    const auto loaded = load_dataset(render.scene.dataset);
    const scene::Scene scene = parse_scene(document_of(render, *loaded));
    const auto geometry = make_geometry(scene, loaded);
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
        ->add_option("--scene", render->scene_file,
                     "A scene document; without it and without layers, the default view.")
        ->type_name("FILE.json");
    command->add_option("--color", render->color, "Point scalar that colours the layers.")->type_name("ARRAY");
    command->add_option("--map", render->map, "Colour map.")->type_name("NAME")->capture_default_str();
    command->add_option("--range", render->range, "Values of the map's two ends; the array's range by default.")
        ->type_name("MIN,MAX");
    command->add_option("--background", render->background, "dark, light or #rrggbb.")->capture_default_str();
    command->add_option("--size", render->size, "Of the picture in pixels.")->type_name("WxH")->capture_default_str();
    command->add_option("--gl", render->gl, "What draws.")
        ->check(CLI::IsMember({"auto", "egl-device", "egl-surfaceless", "osmesa"}))
        ->capture_default_str();
    command->add_option("-o,--output", render->output, "The picture.")->required()->type_name("FILE.png");
    command->callback([&run, render] { run = [render] { return run_command(*render); }; });
}

} // namespace ciel::app
