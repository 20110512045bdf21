#include "store/cache/mapped_mesh.hpp"

#include "ciel/parallel.hpp"
#include "store/cache/paged_array.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace ciel::store {
namespace {

ElementType type_of(const std::string& name) {
    if (name == "cell_types") return ElementType::u1;
    if (std::ranges::find(layout::optional_arrays, name) != std::end(layout::optional_arrays)) return ElementType::i8;
    return name.ends_with("face_offset") ? ElementType::u8 : ElementType::u4;
}

bool is_cell_type(std::uint8_t type) {
    switch (static_cast<CellType>(type)) {
    case CellType::tetrahedron:
    case CellType::hexahedron:
    case CellType::wedge:
    case CellType::pyramid:
    case CellType::polyhedron:
        return true;
    }
    return false;
}

// Has no branches, so that a pass over tens of millions of indices takes hardly longer than reading them.
Index highest(std::span<const Index> ids) {
    Index result = 0;
    for (const Index id : ids) result = std::max(result, id);
    return result;
}

void check_below(const MappedFile& file, std::uint64_t limit, const char* of_what) {
    const auto ids = file.as<Index>();
    if (!ids.empty() && highest(ids) >= limit)
        refuse_damage(file.path(), "holds index " + std::to_string(highest(ids)) + ", but there are only " +
                                       std::to_string(limit) + " " + of_what);
}

void check_offsets(const MappedFile& file, std::uint64_t corners) {
    const auto offsets = file.as<std::uint64_t>();
    if (offsets.front() != 0 || offsets.back() != corners)
        refuse_damage(file.path(), "does not span the " + std::to_string(corners) + " corners of face_vertex");
    bool short_loop = false;
    for (std::size_t i = 1; i < offsets.size(); ++i)
        short_loop |= offsets[i] < offsets[i - 1] || offsets[i] - offsets[i - 1] < 3;
    if (short_loop) refuse_damage(file.path(), "has a face with fewer than three corners");
}

void check_owners(const MappedFile& file, std::uint64_t cells) {
    check_below(file, cells, "cells");
    const auto owner = file.as<Index>();
    if (!std::is_sorted(owner.begin(), owner.end())) refuse_damage(file.path(), "is not sorted");
}

void check_neighbours(const MappedFile& owner, const MappedFile& neighbour, std::uint64_t cells) {
    const auto own = owner.as<Index>();
    const auto other = neighbour.as<Index>();
    bool wrong = false;
    for (std::size_t i = 0; i < other.size(); ++i)
        wrong |= other[i] != none && (other[i] >= cells || other[i] <= own[i]);
    if (wrong) refuse_damage(neighbour.path(), "names a cell that does not exist or comes before its face's owner");
}

void check_ascending(const MappedFile& file) {
    const auto ids = file.as<Index>();
    if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) != ids.end())
        refuse_damage(file.path(), "is not sorted or holds an id twice");
}

void check_group(const Group& group, const MappedFile& file, std::uint64_t limit) {
    check_ascending(file);
    check_below(file, limit, group.of == Group::Of::faces ? "faces" : "cells");
}

} // namespace

MappedMesh::MappedMesh(std::filesystem::path directory, const std::string& dataset_id, AnyLost any_lost,
                       FileAccess access)
    : directory_(std::move(directory)), dataset_id_(dataset_id), any_lost_(std::move(any_lost)) {
    const auto attributes = directory_ / layout::attributes_document;
    attributes_ = parse_mesh_attributes(read_text(attributes, layout::document_bytes), attributes);
    for (const char* name : layout::whole_arrays) map(name, type_of(name));
    for (const char* name : layout::optional_arrays)
        if (attributes_.checksums.contains(name)) map(name, type_of(name));
    for (const char* name : layout::boundary_arrays)
        if (attributes_.checksums.contains(layout::boundary_arrays[0])) map(name, type_of(name));
    for (std::size_t i = 0; i < attributes_.groups.size(); ++i) map("groups/" + std::to_string(i), ElementType::u4);

    for (const char* group : {"faces", "groups", layout::boundary_group}) verified_[group];
    for (const char* name : layout::id_arrays) pages_[name];
    vertex_count_ = array("original_vertex").as<Index>().size();
    const std::uint64_t faces = array("owner").as<Index>().size();
    if (vertex_count_ == 0 || cell_count() == 0 || faces == 0) refuse_damage(directory_, "is an empty mesh");
    if (vertex_count_ >= none || cell_count() >= none || faces >= none)
        refuse(directory_, "has more than 4,294,967,294 vertices, faces or cells, the most that a mesh can have");
    check_sizes(faces);
    for (std::size_t i = 0; i < attributes_.groups.size(); ++i) map_group(i, faces);
    std::error_code error;
    if (std::filesystem::exists(layout::block_index(directory_).parent_path(), error))
        blocks_ = std::make_shared<const StoredBlocks>(directory_, dataset_id, any_lost_, access);
}

void MappedMesh::check_sizes(std::uint64_t faces) const {
    if (attributes_.info.vertices != vertex_count_ || attributes_.info.cells != cell_count() ||
        attributes_.info.faces != faces)
        refuse_damage(directory_ / layout::attributes_document,
                      "declares other numbers of vertices, faces or cells than the arrays hold");
    const auto expect = [&](const char* name, std::uint64_t want) {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return;
        const std::uint64_t have = found->second.bytes().size() / element_bytes(type_of(name));
        if (have != want)
            refuse_damage(found->second.path(),
                          "has " + std::to_string(have) + " entries where " + std::to_string(want) + " are needed");
    };
    expect("original_cell", cell_count());
    expect("neighbour", faces);
    expect("face_offset", faces + 1);
    expect("solver_vertex", vertex_count_);
    expect("solver_cell", cell_count());
    if (!has_boundary()) return;
    const std::uint64_t boundary = array("boundary/face").as<Index>().size();
    check_boundary_count(boundary);
    expect("boundary/face_offset", boundary + 1);
    expect("boundary/owner", boundary);
}

// The number in the attributes is the size of arrays on boundary faces.
void MappedMesh::check_boundary_count(std::uint64_t count) const {
    if (count != attributes_.info.boundary_faces)
        refuse_damage(directory_ / layout::attributes_document,
                      "counts " + std::to_string(attributes_.info.boundary_faces) + " boundary faces, but there are " +
                          std::to_string(count));
}

void MappedMesh::map(const std::string& name, ElementType type) {
    const auto path = directory_ / name;
    const auto document = path / layout::array_document;
    const ZarrArray zarr = parse_zarr_array(read_text(document, layout::document_bytes), document);
    if (zarr.type != type || zarr.shape.size() != 1 || (zarr.shape != zarr.chunks && zarr.shape[0] != 0))
        refuse_damage(document, std::string("is not the one-chunk array that '") + name + "' must be");
    arrays_.emplace(name, MappedFile(layout::chunk(path, 0, 1), zarr.chunk_bytes(document), any_lost_));
    keepers_.emplace(std::piecewise_construct, std::forward_as_tuple(name), std::forward_as_tuple(*this, name));
    verified_[name];
}

void MappedMesh::map_group(std::size_t index, std::uint64_t faces) {
    const auto& [of, name, facts] = attributes_.groups[index];
    const MappedFile& file = array("groups/" + std::to_string(index));
    const std::uint64_t limit = of == Group::Of::faces ? faces : cell_count();
    groups_.push_back(
        {of, name, {file.as<Index>(), static_cast<Index>(limit), keeper("groups/" + std::to_string(index))}, facts});
}

PageStates& MappedMesh::pages_of(const std::string& ids) const {
    std::unique_ptr<PageStates>& pages = pages_.at(ids);
    verified_.at(ids).once([&] {
        const std::string& sum = checksum_of(ids);
        const MappedFile& file = array(ids);
        const ArrayLayout layout{directory_ / ids, 1, 1, file.bytes().size(), false};
        std::optional<ValueRanges> ranges; // of a dataset that has been replaced: none, so that all is one page
        if (file.is_current()) ranges = read_ranges(layout, 0, sum, 0, 0, dataset_id_);
        pages = std::make_unique<PageStates>(layout.chunk_bytes, page_checks(layout, sum, std::move(ranges)));
    });
    return *pages;
}

const std::string& MappedMesh::checksum_of(const std::string& name) const {
    const auto sum = attributes_.checksums.find(name);
    if (sum == attributes_.checksums.end())
        refuse_damage(directory_ / layout::attributes_document, "lacks the checksum of '" + name + "'");
    return sum->second;
}

void MappedMesh::verify_checksums(const std::vector<std::string>& names) const {
    parallel_for(names.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const MappedFile& file = array(names[i]);
            if (checksum(file.bytes()) != checksum_of(names[i]))
                refuse_damage(file.path(), "does not match its checksum");
        }
    });
}

bool MappedMesh::has_its_checksum(const std::string& name, const MappedFile& file) const {
    return checksum(file.bytes()) == attributes_.checksums.at(name);
}

void MappedMesh::verify_faces() const {
    verify_checksums({"cell_types", "face_offset", "face_vertex", "owner", "neighbour"});
    const std::vector<std::function<void()>> checks{
        [&] { check_below(array("face_vertex"), vertex_count_, "vertices"); },
        [&] { check_offsets(array("face_offset"), array("face_vertex").as<Index>().size()); },
        [&] { check_owners(array("owner"), cell_count()); },
        [&] {
            check_neighbours(array("owner"), array("neighbour"), cell_count());
            check_boundary_count(static_cast<std::uint64_t>(std::ranges::count(array("neighbour").as<Index>(), none)));
        },
        [&] {
            if (!std::all_of(cell_types().begin(), cell_types().end(), is_cell_type))
                refuse_damage(array("cell_types").path(), "names a cell type that does not exist");
        }};
    parallel_for(checks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) checks[i]();
    });
}

bool MappedMesh::has_boundary() const { return arrays_.contains(layout::boundary_arrays[0]); }

void MappedMesh::verify_boundary() const {
    verify_checksums({std::begin(layout::boundary_arrays), std::end(layout::boundary_arrays)});
    const MappedFile& vertices = array("boundary/face_vertex");
    check_below(vertices, vertex_count_, "vertices");
    check_offsets(array("boundary/face_offset"), vertices.as<Index>().size());
    check_owners(array("boundary/owner"), cell_count());
    check_ascending(array("boundary/face"));
    check_below(array("boundary/face"), attributes_.info.faces, "faces");
}

// Compares the boundary with the list of all faces.
void MappedMesh::compare_boundary() const {
    verify_boundary();
    FaceMeshView all = view({});
    all.face_vertex = {array("face_vertex").as<Index>(), static_cast<Index>(vertex_count_), keeper("face_vertex")};
    const BoundaryFaceLists expected = boundary_face_lists(all);
    const auto compare = [&](const char* name, const auto& wanted) {
        if (!std::ranges::equal(array(name).as<std::ranges::range_value_t<decltype(wanted)>>(), wanted))
            refuse_damage(array(name).path(), "differs from the faces of the mesh");
    };
    compare("boundary/face_offset", expected.face_offset);
    compare("boundary/face_vertex", expected.face_vertex);
    compare("boundary/owner", expected.owner);
    compare("boundary/face", expected.face);
}

void MappedMesh::verify_groups() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < groups_.size(); ++i) names.push_back("groups/" + std::to_string(i));
    verify_checksums(names);
    const std::uint64_t faces = array("owner").as<Index>().size();
    for (std::size_t i = 0; i < groups_.size(); ++i)
        check_group(groups_[i], array(names[i]), groups_[i].of == Group::Of::faces ? faces : cell_count());
}

const std::vector<Group>& MappedMesh::groups() const {
    verified_.at("groups").once([this] { verify_groups(); });
    return groups_;
}

void MappedMesh::verify() const {
    verified_.at("faces").once([this] { verify_faces(); });
    if (has_boundary()) compare_boundary();
    (void)groups();
    (void)original_vertex();
    (void)original_cell();
    (void)solver_vertex();
    (void)solver_cell();
    if (!blocks_) return;
    for (const RecordKind kind : record_kinds)
        parallel_for(blocks_->block_count(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) (void)blocks_->read(static_cast<Index>(b), kind);
        });
}

FaceMeshView MappedMesh::view_points(ValuesView positions) const {
    return face_mesh_view(attributes_.origin, positions, cell_types(), {}, {}, {}, {});
}

FaceMeshView MappedMesh::view(ValuesView positions) const {
    verified_.at("faces").once([this] { verify_faces(); });
    return face_mesh_view(attributes_.origin, positions, cell_types(), array("face_offset").as<std::uint64_t>(),
                          array("face_vertex").as<Index>(), array("owner").as<Index>(), array("neighbour").as<Index>(),
                          {keeper("face_offset"), keeper("face_vertex"), keeper("owner"), keeper("neighbour")});
}

BoundaryFaces MappedMesh::boundary(FaceMeshView points) const {
    verified_.at(layout::boundary_group).once([&] {
        if (has_boundary())
            verify_boundary();
        else
            boundary_ = boundary_face_lists(view(points.positions));
        no_neighbour_.assign(attributes_.info.boundary_faces, none);
    });
    const auto cells = static_cast<Index>(cell_count()), faces = static_cast<Index>(attributes_.info.faces);
    const auto set = [&](std::span<const std::uint64_t> offset, std::span<const Index> vertex,
                         std::span<const Index> owner, std::span<const Index> face, const auto& keeper_of) {
        points.face_offset = {offset, vertex.size() + 1, keeper_of("boundary/face_offset")};
        points.face_vertex = {vertex, points.vertex_count(), keeper_of("boundary/face_vertex")};
        points.owner = {owner, cells, keeper_of("boundary/owner")};
        points.neighbour = {no_neighbour_, cells};
        return BoundaryFaces{points, {face, faces, keeper_of("boundary/face")}};
    };
    if (!has_boundary())
        return set(boundary_.face_offset, boundary_.face_vertex, boundary_.owner, boundary_.face,
                   [](const char*) -> const ArrayKeeper* { return nullptr; });
    return set(array("boundary/face_offset").as<std::uint64_t>(), array("boundary/face_vertex").as<Index>(),
               array("boundary/owner").as<Index>(), array("boundary/face").as<Index>(),
               [this](const char* name) { return keeper(name); });
}

// Throws Error that names the array whose checksum no longer matches. A contradiction between two arrays is found in
// one of them, `suspected`, but the other one may have changed.
void MappedMesh::refuse_changed(const std::string& suspected) const {
    check_intact(); // throws if another thread has found the changed array already
    if (!has_its_checksum(suspected, array(suspected))) array(suspected).refuse();
    for (const auto& [name, file] : arrays_)
        if (!has_its_checksum(name, file)) file.refuse();
    array(suspected).refuse(); // all checksums match: the change was undone meanwhile
}

void MappedMesh::check_unchanged() {
    const std::lock_guard lock(checking_);
    for (auto& [name, file] : arrays_) {
        file.check_size();
        if (!file.was_touched()) continue; // before the checksum, so that a write during it is found by the next call
        const bool is_whole = has_its_checksum(name, file);
        file.check_intact(); // a truncated file reads as zeros, which may have the checksum
        if (!is_whole) file.refuse();
    }
    if (blocks_) blocks_->check_unchanged();
}

void MappedMesh::check_intact() const {
    for (const auto& [name, file] : arrays_) file.check_intact();
    if (blocks_) blocks_->check_intact();
}

} // namespace ciel::store
