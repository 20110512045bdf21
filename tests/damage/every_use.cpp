#include "damage/every_use.hpp"

#include "frames/frame_of.hpp"
#include "geometry/default_scene.hpp"
#include "probe/probe.hpp"
#include "store/writer.hpp"
#include "unit/methods/service.hpp"

namespace ciel::test {
using namespace server;
namespace {

Vec3d place_inside(const store::MeshInfo& mesh) {
    Vec3d middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        middle[axis] = 0.3 * mesh.bounds[2 * axis] + 0.7 * mesh.bounds[2 * axis + 1];
    return middle;
}

json layers_of(const store::Dataset& dataset, const std::string& cells) {
    const store::MeshInfo& mesh = dataset.info().meshes[0];
    const Vec3d middle = place_inside(mesh);
    const auto& range = dataset.steps()[0].arrays.at("p").range;
    const double low = range[0], value = 0.6 * range[0] + 0.4 * range[1];
    std::string patch;
    for (const store::Group& group : dataset.groups(0))
        if (group.of == store::Group::Of::faces) patch = group.name;
    const json by_u{{"array", "U:magnitude"}};
    const json threshold{{"array", "p"}, {"range", {low, value}}};
    json layers{
        {"outline", {{"type", "outline"}}},
        {"surface", {{"type", "surface"}, {"color", {{"array", "p"}}}, {"edges", {{"width", 1}}}}},
        {"patch", {{"type", "surface"}, {"groups", {patch}}, {"color", by_u}}},
        {"kept", {{"type", "surface"}, {"threshold", threshold}}},
        {"kept cells", {{"type", "surface"}, {"threshold", {{"array", cells}, {"range", {0, 100}}}}}},
        {"edges", {{"type", "edges"}}},
        {"bends", {{"type", "edges"}, {"angle", 30}, {"threshold", threshold}}},
        {"points", {{"type", "points"}, {"color", {{"array", "p"}}}}},
        {"all points", {{"type", "points"}, {"of", "all"}, {"threshold", threshold}}},
        {"iso", {{"type", "iso"}, {"array", "p"}, {"values", {value, (value + low) / 2}}, {"color", by_u}}},
        {"slice",
         {{"type", "slice"}, {"axis", "x"}, {"value", middle[0]}, {"contours", {{"array", "p"}, {"values", {value}}}}}},
        {"oblique", {{"type", "slice"}, {"origin", middle}, {"normal", {0.5, 0.3, 0.8}}, {"color", {{"array", "p"}}}}},
        {"side", {{"type", "slice"}, {"axis", "x"}, {"value", mesh.bounds[0]}}},
        {"volume", {{"type", "volume"}, {"array", "p"}}},
        {"clip", {{"type", "clip"}, {"origin", middle}, {"normal", {1, 0, 0}}, {"caps", true}}},
    };
    if (dataset.steps()[0].arrays.contains("patch:p"))
        layers["faces"] = {{"type", "surface"}, {"groups", {patch}}, {"color", {{"array", "patch:p"}}}};
    return layers;
}

} // namespace

EveryUse::EveryUse(engine::Server& server, std::string dataset, std::string cells, Extraction extraction)
    : server_(server), name_(std::move(dataset)), cells_(std::move(cells)), extraction_(extraction) {}

void EveryUse::open() { dataset_ = server_.catalog().open(name_)->dataset(); }

void EveryUse::attempt(const std::string& use, const std::function<void()>& body) {
    try {
        body();
    } catch (const Error& error) {
        told_.push_back({use, error.what()});
    }
}

void EveryUse::show_layers() {
    const auto loaded = std::make_shared<store::LoadedDataset>(dataset_, std::size_t{1} << 30);
    json all;
    attempt("scene", [&] { all = layers_of(*dataset_, cells_); });
    geometry::SceneGeometry geometry(extraction_);
    for (const auto& [id, layer] : all.items())
        attempt(id, [&, id = id] {
            json layers{{id, all[id]}};
            if (id == "clip") layers["capped"] = {{"type", "surface"}, {"color", {{"array", "p"}}}};
            const auto shown = geometry.update({scene::parse({{"dataset", name_}, {"layers", layers}}), loaded});
            (void)frames::frame_of(*shown, {scene::parse({{"dataset", name_}}), loaded}, 64, 64, 1);
        });
    attempt("default scene", [&] { (void)geometry::default_scene(*loaded, name_); });
    attempt("probe",
            [&] { (void)probe::probe(*dataset_, 0, *loaded->locator(0), place_inside(dataset_->info().meshes[0])); });
}

// Calls the server's methods. They use the dataset as the server has opened it, not the one of this test.
void EveryUse::ask_methods() {
    Client client(server_, false);
    const auto ask = [&](const std::string& method, const json& params) {
        const json answer = client.request(method, params);
        if (!answer.contains("error")) return;
        if (answer["error"]["code"] == -32603) throw std::runtime_error(method + ": " + answer.dump());
        told_.push_back({method, answer["error"]["data"]["reason"].get<std::string>()});
    };
    ask("dataset.describe", {{"dataset", name_}});
    ask("dataset.histogram", {{"dataset", name_}, {"array", "p"}, {"bins", 16}});
    // This one reads the values; the one before has been computed at the import.
    ask("dataset.histogram", {{"dataset", name_}, {"array", "p"}, {"bins", 16}, {"range", {0.25, 0.75}}});
    const json surface{{"dataset", name_}, {"layers", {{"a", {{"type", "surface"}, {"color", {{"array", "p"}}}}}}}};
    ask("surface.export", {{"scene", surface}, {"layer", "a"}, {"format", "vtp"}});
    ask("probe.point", {{"scene", surface}, {"position", place_inside(dataset_->info().meshes[0])}});
    ask("session.open", {{"scene", surface}});
}

void EveryUse::append_a_step() {
    attempt("append", [&] {
        std::vector<float> p(dataset_->info().meshes[0].vertices, 1);
        store::Writer writer = store::Writer::append(server_.options().data[0]);
        const std::vector<store::ArrayValues> arrays{{{"p", store::Association::point, 1, "", ""}, p}};
        writer.add_step(++last_time_, 0, 0, arrays);
        writer.finish();
    });
    attempt("refresh", [&] {
        if (const auto newer = dataset_->refreshed()) dataset_ = newer;
    });
}

std::vector<Told> EveryUse::run() {
    told_.clear();
    show_layers();
    ask_methods();
    append_a_step();
    return told_;
}

} // namespace ciel::test
