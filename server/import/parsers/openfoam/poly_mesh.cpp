#include "import/parsers/openfoam/poly_mesh.hpp"

#include "import/parsers/openfoam/reader.hpp"

#include <algorithm>

namespace server::importer {

namespace {

void append_face(FoamReader& reader, FoamFaces& faces) {
    const std::size_t corners = reader.items(reader.bytes_left());
    reader.expect('(');
    for (std::size_t i = 0; i < corners; ++i) faces.points.push_back(reader.label());
    reader.expect(')');
    faces.offset.push_back(faces.points.size());
}

FoamFaces compact_faces(FoamReader& reader) {
    FoamFaces faces;
    const std::vector<std::int64_t> offsets = reader.labels(reader.bytes_left());
    faces.points = reader.labels(reader.bytes_left());
    faces.offset.clear();
    std::int64_t previous = 0;
    for (const std::int64_t offset : offsets) {
        if (offset < previous) reader.fail("has face offsets that decrease");
        faces.offset.push_back(static_cast<std::size_t>(offset));
        previous = offset;
    }
    if (faces.offset.empty() || faces.offset.front() != 0 || faces.offset.back() != faces.points.size())
        reader.fail("has face offsets that do not match its number of points");
    return faces;
}

void read_patch_entry(FoamReader& reader, std::string_view key, FoamPatch& patch) {
    bool is_quoted = false;
    if (key == "type") {
        patch.type = reader.name(is_quoted);
    } else if (key == "startFace") {
        patch.first_face = reader.label();
    } else if (key == "nFaces") {
        patch.face_count = reader.label();
    } else if (key == "neighbProcNo") {
        patch.neighbour = reader.label();
    } else if (key == "inGroups") {
        if (reader.peek() == 'L') static_cast<void>(reader.word()); // skips "List<word>"
        if (reader.peek() != '(') static_cast<void>(reader.label());
        reader.expect('(');
        while (!reader.accept(')')) patch.groups.emplace_back(reader.name(is_quoted));
    }
    reader.skip_entry();
}

// Reads "N ( NAME { entries } ... )". Some files leave out the count N.
template <typename Item, typename ReadEntry>
std::vector<Item> read_dictionaries(FoamReader& reader, const ReadEntry& read_entry) {
    std::vector<Item> items;
    if (reader.peek() != '(') static_cast<void>(reader.items(reader.bytes_left()));
    if (reader.at_end()) return items;
    reader.expect('(');
    while (!reader.accept(')')) {
        bool is_quoted = false;
        Item item;
        item.name = reader.name(is_quoted);
        reader.expect('{');
        while (!reader.accept('}')) read_entry(reader.word(), item);
        items.push_back(std::move(item));
    }
    return items;
}

} // namespace

std::vector<double> parse_foam_points(std::string_view bytes, const std::string& file) {
    FoamReader reader(bytes, file);
    return reader.numbers(3, reader.bytes_left());
}

FoamFaces parse_foam_faces(std::string_view bytes, const std::string& file) {
    FoamReader reader(bytes, file);
    if (reader.format().class_name == "faceCompactList") return compact_faces(reader);
    FoamFaces faces;
    const std::size_t count = reader.items(reader.bytes_left());
    if (count == 0) return faces;
    if (reader.format().is_binary)
        reader.fail("has binary faces of the class faceList, which no OpenFOAM since 2.0 writes,");
    faces.offset.reserve(count + 1);
    reader.expect('(');
    for (std::size_t i = 0; i < count; ++i) append_face(reader, faces);
    reader.expect(')');
    return faces;
}

std::vector<std::int64_t> parse_foam_labels(std::string_view bytes, const std::string& file, std::size_t most) {
    FoamReader reader(bytes, file);
    return reader.labels(most);
}

std::vector<FoamPatch> parse_foam_boundary(std::string_view bytes, const std::string& file) {
    FoamReader reader(bytes, file);
    return read_dictionaries<FoamPatch>(
        reader, [&](std::string_view key, FoamPatch& patch) { read_patch_entry(reader, key, patch); });
}

std::vector<FoamZone> parse_foam_zones(std::string_view bytes, const std::string& file) {
    FoamReader reader(bytes, file);
    return read_dictionaries<FoamZone>(reader, [&](std::string_view key, FoamZone& zone) {
        if (key == "cellLabels" || key == "faceLabels") zone.labels = reader.labels(reader.bytes_left());
        reader.skip_entry();
    });
}

} // namespace server::importer
