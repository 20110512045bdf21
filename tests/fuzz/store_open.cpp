// Fuzzes one file of a dataset. The first byte selects the file, the second whether its checksum is corrected, the rest
// is the content. If the dataset opens, its topology, field, surface and slice are computed.
#include "support/store_box/box.hpp"
#include "support/store_box/format_1.hpp"

#include "ciel/extract.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/loaded.hpp"
#include "store/mesh_arrays.hpp"

#include <string_view>

namespace {

namespace fs = std::filesystem;
using namespace ciel;
using namespace server;

constexpr const char* files[] = {
    ".zattrs", "steps.json", "meshes/0/.zattrs", "meshes/0/arrays/p/.zarray", "meshes/0/arrays/p/.zattrs",
    "meshes/0/faces/owner/.zarray", "meshes/0/cell_types/0", "meshes/0/faces/face_offset/0",
    "meshes/0/faces/face_vertex/0", "meshes/0/faces/owner/0", "meshes/0/faces/neighbour/0", "meshes/0/groups/0/0",
    "meshes/0/positions/0.0.0", "meshes/0/arrays/p/0.0", "meshes/0/arrays/U/0.0.0",
    // of the same dataset in format 1:
    "meshes/0/face_offset/0", "meshes/0/face_vertex/0", "meshes/0/owner/0", "meshes/0/neighbour/0"};
constexpr std::size_t first_of_format_1 = 15;

void mend_checksums(const fs::path& dataset, const std::string& before, const std::string& after) {
    const std::string old = store::checksum(store::bytes_of(before)), now = store::checksum(store::bytes_of(after));
    for (const char* document : {"meshes/0/.zattrs", "steps.json"}) {
        std::string text = test::read_file(dataset / document);
        for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size()))
            text.replace(at, old.size(), now);
        test::overwrite_file(dataset / document, text);
    }
}

void use(const fs::path& directory) {
    store::LoadedDataset loaded(store::Dataset::open(directory), 1 << 20);
    const auto dataset = loaded.dataset();
    const FaceMeshView faces = dataset->mesh_arrays().numbered_faces(0, 0);
    for (Index face = 0; face < faces.face_count(); ++face) (void)faces.loop(face).front();
    for (const store::Group& group : dataset->groups(0))
        if (group.of == store::Group::Of::faces)
            for (const Index face : group.ids) (void)faces.owner[face];
    (void)dataset->mesh_arrays().all_faces(0, 0);
    for (std::size_t step = 0; step < dataset->steps().size(); ++step)
        for (const store::ScalarField& scalar :
             {loaded.scalar("p", step), loaded.scalar("U:magnitude", step), loaded.plane(step, {1, 1, 1}, {0, 0, 1})})
            for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
                Query query = scalar.query(algorithm);
                Surface surface;
                for (const double nu : {3.5, 0.0, 13.0}) query.extract(nu, true, surface);
            }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const test::Folder scratch;
    static const fs::path now = scratch / "box.ciel", format_1 = scratch / "old.ciel";
    if (!fs::exists(now)) {
        test::write_box(now, test::box(2, 2, 2));
        test::write_box(format_1, test::box(2, 2, 2));
        test::make_format_1(format_1, test::box(2, 2, 2));
    }
    if (size < 2) return 0;
    const std::size_t which = data[0] % std::size(files);
    const fs::path& directory = which < first_of_format_1 ? now : format_1;
    const fs::path file = directory / files[which];
    const std::string content(reinterpret_cast<const char*>(data + 2), size - 2), before = test::read_file(file);
    // These two documents hold checksums and are restored afterwards.
    const std::string mesh = test::read_file(directory / "meshes/0/.zattrs"),
                      steps = test::read_file(directory / "steps.json");
    test::overwrite_file(file, content);
    if (data[1] % 2 == 1) mend_checksums(directory, before, content);
    try {
        use(directory);
    } catch (const Error&) { // only Error is a valid refusal
    }
    test::overwrite_file(file, before);
    test::overwrite_file(directory / "meshes/0/.zattrs", mesh);
    test::overwrite_file(directory / "steps.json", steps);
    return 0;
}
