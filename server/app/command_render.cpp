// ciel render NAME.ciel -o FILE.png: draws a still picture with the server's code.
#include "app/camera_options.hpp"
#include "app/color_options.hpp"
#include "app/commands.hpp"
#include "app/layer_options.hpp"
#include "app/lighting_options.hpp"
#include "app/scene_options.hpp"
#include "ciel/printable.hpp"
#include "frames/picture.hpp"
#include "geometry/default_scene.hpp"
#include "limits/errors.hpp"
#include "probe/shown_bounds.hpp"
#include "scene/read_json.hpp"
#include "store/files/files.hpp"
#include "wire/pictures/png.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace server::app {
namespace {

constexpr std::array annotation_names{"legend", "triad", "axes", "time", "dataset"};

struct RenderCommand {
    SceneOptions scene;
    LayerOptions layers;
    std::string scene_file, size = "1280x720", gl = "auto", output;
    CameraOptions camera;
    std::optional<std::string> background, title;
    std::vector<std::string> annotations;
    std::optional<double> text_scale;
    ColorOptions colors;
    LightingOptions lighting;
};

geometry::ViewSize parse_size(const std::string& text) {
    std::int64_t width = 0, height = 0;
    const char* const end = text.data() + text.size();
    const auto [cross, first] = std::from_chars(text.data(), end, width);
    const bool has_cross = first == std::errc{} && cross != end && *cross == 'x';
    const auto [stop, second] = std::from_chars(has_cross ? cross + 1 : end, end, height);
    if (second != std::errc{} || stop != end || width < 1 || height < 1)
        throw UsageError("--size " + text + " is not of the form WIDTHxHEIGHT");
    try {
        frames::check_picture_size({}, width, height);
    } catch (const limits::LimitReached& error) {
        throw UsageError("--size " + text + " is too large: " + error.what());
    }
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

nlohmann::json read_scene_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw ciel::Error(path + " cannot be read; name a readable scene file with --scene");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
        return scene::read_json(text);
    } catch (const scene::TwiceNamed& error) {
        throw ciel::Error(path + ": " + error.what());
    } catch (const nlohmann::json::exception& error) {
        const std::string reason = error.what(); // "[json.exception...] parse error at line 2..."
        throw ciel::Error(path + " is not JSON: " + reason.substr(std::min(reason.size(), reason.find("] ") + 2)));
    }
}

void color_layers(const RenderCommand& render, nlohmann::json& layers) {
    bool any = false;
    for (auto& layer : layers) {
        if (layer["type"] == "outline" || layer["type"] == "clip") continue;
        if (layer["type"] == "volume") {
            if (render.colors.any()) {
                any = true;
                render.colors.apply_to(layer["color"]);
                layer["color"].erase("array"); // a volume is colored by its own array
            }
            continue;
        }
        nlohmann::json color = layer.value("color", nlohmann::json::object());
        render.colors.apply_to(color);
        if (!color.contains("array") && layer["type"] == "iso") color["array"] = layer["array"];
        any = any || color.contains("array");
        layer["color"] = std::move(color);
    }
    if (any || !render.colors.any()) return;
    if (render.colors.array)
        throw UsageError("--color has no layer to color; give --iso, --slice, --plane, --surface or --volume");
    throw UsageError("--range, --map and the other options of colors need an array; give --color");
}

nlohmann::json document_of_options(const RenderCommand& render, const store::Dataset& dataset) {
    nlohmann::json document = render.scene.document(dataset);
    document["layers"]["outline"] = {{"type", "outline"}, {"color", {{"solid", "#808890"}}}};
    return document;
}

geometry::DefaultScene default_document(const RenderCommand& render, store::LoadedDataset& loaded) {
    geometry::DefaultScene shown = geometry::default_scene(loaded, loaded.dataset()->info().name);
    shown.document.erase("camera"); // it fits the web client; stand_back() adds a camera that fits the picture
    if (render.scene.time) shown.document["time"] = time_of_step(*loaded.dataset(), *render.scene.time);
    return shown;
}

nlohmann::json document_of_file(const RenderCommand& render, const std::string& dataset) {
    if (render.scene.has_layers() || render.layers.any() || render.colors.any() || render.background)
        throw UsageError("--scene already sets layers, colors and background; leave out --iso, --slice, --plane, "
                         "--volume, --background, and the options of layers and colors");
    nlohmann::json document = read_scene_file(render.scene_file);
    if (!document.is_object()) return document;                        // parse_scene() throws Error
    document = scene::merge_patch(nlohmann::json::object(), document); // drops null members
    if (!document.contains("dataset")) document["dataset"] = dataset;
    if (document["dataset"] != dataset)
        throw ciel::Error(render.scene_file + " is a scene of the dataset " + document["dataset"].dump() +
                          ", not of \"" + dataset + "\"; render the dataset of the scene, or change the scene");
    if (render.scene.time) document["time"] = *render.scene.time;
    return document;
}

struct Wanted { // NOLINT(bugprone-exception-escape): moving a json does not throw
    nlohmann::json document;
    std::optional<geometry::BoundingBox> box; // shown by the default camera; nullopt: probe::shown_bounds()
};

Wanted wanted_by(const RenderCommand& render, store::LoadedDataset& loaded) {
    if (!render.scene_file.empty()) return {document_of_file(render, loaded.dataset()->info().name), {}};
    Wanted wanted;
    if (render.scene.has_layers() || render.layers.has_layers()) {
        wanted.document = document_of_options(render, *loaded.dataset());
    } else {
        geometry::DefaultScene shown = default_document(render, loaded);
        wanted = {std::move(shown.document), shown.box};
    }
    render.layers.apply(wanted.document["layers"]);
    color_layers(render, wanted.document["layers"]);
    wanted.document["background"] = render.background.value_or("dark");
    return wanted;
}

// If --annotations is given, exactly the annotations that it names are on.
void annotate(const RenderCommand& render, nlohmann::json& document) {
    nlohmann::json annotations = nlohmann::json::object();
    for (const std::string& wanted : render.annotations) {
        if (wanted != "none" && wanted != "all") continue;
        if (render.annotations.size() > 1)
            throw UsageError("--annotations " + wanted +
                             " cannot be combined with other names; leave the other names out");
    }
    const auto is_wanted = [&](const char* name) {
        const auto& names = render.annotations;
        return names.front() == "all" || std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!render.annotations.empty())
        for (const char* name : annotation_names) annotations[name] = is_wanted(name);
    if (render.title) annotations["title"] = *render.title;
    if (render.text_scale) annotations["scale"] = *render.text_scale;
    if (annotations.empty() || !document.is_object()) return;
    document = scene::merge_patch(std::move(document), {{"annotations", std::move(annotations)}});
}

int run_command(const RenderCommand& render) {
    const geometry::ViewSize size = parse_size(render.size);
    const render::Backend backend = render::backend_named(render.gl);
    if (lower_case_extension(render.output) != ".png")
        throw UsageError("-o " + render.output + ": the name of a picture must end in .png");
    render.scene.check_time();
    const auto loaded = load_dataset(render.scene.dataset);
    auto [document, box] = wanted_by(render, *loaded);
    annotate(render, document);
    render.camera.apply(document);
    if (const auto patch = render.lighting.patch(); !patch.empty() && document.is_object())
        document = scene::merge_patch(std::move(document), patch);
    scene::Scene scene = parse_scene(document);
    render.camera.project(scene.camera);
    const auto [checked, geometry] = make_geometry(scene, loaded, render.scene.extraction.chosen());
    const scene::CheckedScene shown =
        render.camera.stand_back(checked, *geometry, size, box.value_or(probe::shown_bounds(*geometry, checked)));
    render::Image image;
    render::Renderer renderer(backend);
    renderer.draw(frames::picture_of(*geometry, shown, size), image);
    for (const std::string& remark : frames::remarks_on(*geometry, renderer))
        std::cerr << "ciel: " << ciel::printable(remark) << '\n';
    std::vector<std::uint8_t> png;
    wire::encode_png(image.width, image.height, image.rgb, png);
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
    render->layers.add_to(*command);
    command
        ->add_option(
            "--volume", render->scene.volumes,
            "Volume of a point scalar with an opacity curve. POSITION is 0 at the lowest value and 1 at the highest. "
            "OPACITY is the opacity of a ray after a tenth of the diagonal (or --volume-unit-length). May be repeated.")
        ->type_name("ARRAY[=POSITION:OPACITY,...]");
    command
        ->add_option("--scene", render->scene_file,
                     "Scene document. Without --scene and without layers, the default view is drawn.")
        ->type_name("FILE.json");
    render->camera.add_to(*command);
    render->colors.add_to(*command);
    render->lighting.add_to(*command);
    command->add_option("--background", render->background, "Background: dark, light or #rrggbb.")
        ->type_name("COLOR")
        ->default_str("dark");
    command
        ->add_option("--annotations", render->annotations,
                     "Annotations over the picture: all, none, or some of legend,triad,axes,time,dataset; by default "
                     "legend and triad.")
        ->type_name("NAME[,NAME...]")
        ->delimiter(',')
        ->check(CLI::IsMember({"all", "none", "legend", "triad", "axes", "time", "dataset"}));
    command->add_option("--title", render->title, "Title above the picture.")->type_name("TEXT");
    command->add_option("--text-scale", render->text_scale, "Factor on the size of the text.")->type_name("FACTOR");
    command->add_option("--size", render->size, "Size of the picture in pixels.")
        ->type_name("WxH")
        ->capture_default_str();
    command->add_option("--gl", render->gl, "OpenGL back end.")
        ->check(CLI::IsMember({"auto", "egl-device", "egl-surfaceless", "osmesa"}))
        ->capture_default_str();
    command->add_option("-o,--output", render->output, "The picture to write.")->required()->type_name("FILE.png");
    command->callback([&run, render] { run = [render] { return run_command(*render); }; });
}

} // namespace server::app
