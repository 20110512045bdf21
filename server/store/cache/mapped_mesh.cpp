#include "store/cache/mapped_mesh.hpp"

#include "ciel/parallel.hpp"
#include "store/cache/stored_array.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace server::store {
namespace {

ElementType type_of(const std::string& name) {
    if (name == "cell_types") return ElementType::u1;
    if (std::ranges::find(layout::optional_arrays, name) != std::end(layout::optional_arrays)) return ElementType::i8;
    return name.ends_with("face_offset") ? ElementType::u8 : ElementType::u4;
}

bool is_cell_type(std::uint8_t type) {
    switch (static_cast<ciel::CellType>(type)) {
    case ciel::CellType::tetrahedron:
    case ciel::CellType::hexahedron:
    case ciel::CellType::wedge:
    case ciel::CellType::pyramid:
    case ciel::CellType::polyhedron:
        return true;
    }
    return false;
}

// A loop without branches, which is about as fast as reading the indices.
ciel::Index highest(std::span<const ciel::Index> ids) {
    ciel::Index result = 0;
    for (const ciel::Index id : ids) result = std::max(result, id);
    return result;
}

void check_below(const MappedFile& file, std::uint64_t limit, const char* of_what) {
    const auto ids = file.as<ciel::Index>();
    if (!ids.empty() && highest(ids) >= limit)
        refuse_damage(file.path(), "holds index " + std::to_string(highest(ids)) + ", but there are only " +
                                       std::to_string(limit) + " " + of_what);
}

void check_offsets(const MappedFile& file, std::uint64_t corners) {
    const auto offsets = file.as<std::uint64_t>();
    if (offsets.front() != 0 || offsets.back() != corners)
        refuse_damage(file.path(), "must begin with 0 and end with " + std::to_string(corners) +
                                       ", the number of corners in face_vertex");
    bool short_loop = false;
    for (std::size_t i = 1; i < offsets.size(); ++i)
        short_loop |= offsets[i] < offsets[i - 1] || offsets[i] - offsets[i - 1] < 3;
    if (short_loop) refuse_damage(file.path(), "has a face with fewer than three corners");
}

bool is_sorted(const MappedFile& file, std::size_t begin, std::size_t end) {
    const auto ids = file.as<ciel::Index>().subspan(begin, end - begin);
    return std::is_sorted(ids.begin(), ids.end());
}

void check_neighbours(const MappedFile& owner, const MappedFile& neighbour, std::uint64_t cells) {
    const auto own = owner.as<ciel::Index>();
    const auto other = neighbour.as<ciel::Index>();
    bool wrong = false;
    for (std::size_t i = 0; i < other.size(); ++i)
        wrong |= other[i] != ciel::none && (other[i] >= cells || other[i] <= own[i]);
    if (wrong)
        refuse_damage(neighbour.path(), "has a cell that does not exist or is not greater than the owner of its face");
}

void check_ascending(const MappedFile& file) {
    const auto ids = file.as<ciel::Index>();
    if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) != ids.end())
        refuse_damage(file.path(), "is not sorted or contains an id twice");
}

void check_group(const Group& group, const MappedFile& file, std::uint64_t limit) {
    check_ascending(file);
    check_below(file, limit, group.of == Group::Of::faces ? "faces" : "cells");
}

} // namespace

MappedMesh::MappedMesh(std::filesystem::path directory, const std::string& dataset_id, LossCount losses,
                       FileAccess access)
    : directory_(std::move(directory)), dataset_id_(dataset_id), losses_(std::move(losses)) {
    const auto attributes = directory_ / layout::attributes_document;
    attributes_ = parse_mesh_attributes(read_text(attributes, layout::document_bytes), attributes);
    for (const char* name : layout::whole_arrays) map(name, type_of(name));
    for (const char* name : layout::optional_arrays)
        if (attributes_.checksums.contains(name)) map(name, type_of(name));
    if (attributes_.checksums.contains(std::string(layout::faces_group) + "/owner"))
        face_folder_ = std::string(layout::faces_group) + "/";
    for (const char* name : layout::face_arrays) map(face_array(name), type_of(name));
    for (std::size_t i = 0; i < attributes_.groups.size(); ++i) map("groups/" + std::to_string(i), ElementType::u4);

    for (const char* group : {"faces", "types", "groups", "numbers"}) verified_[group];
    for (const char* name : layout::id_arrays) stretches_[name];
    vertex_count_ = array("original_vertex").as<ciel::Index>().size();
    if (vertex_count_ == 0 || cell_count() == 0 || (!has_numbers() && stored_faces() == 0))
        refuse_damage(directory_, "is an empty mesh");
    if (vertex_count_ >= ciel::none || cell_count() >= ciel::none || stored_faces() >= ciel::none)
        refuse(directory_,
               "has more than 4,294,967,294 vertices, faces or cells, the limit for a mesh; import a smaller mesh");
    check_sizes();
    for (std::size_t i = 0; i < attributes_.groups.size(); ++i) map_group(i);
    std::error_code error;
    if (std::filesystem::exists(layout::block_index(directory_).parent_path(), error))
        blocks_ = std::make_shared<const StoredBlocks>(directory_, dataset_id, losses_, access);
    else if (has_numbers())
        refuse_damage(layout::block_index(directory_).parent_path(), "is missing");
}

void MappedMesh::check_sizes() const {
    const std::uint64_t faces = stored_faces();
    if (attributes_.info.vertices != vertex_count_ || attributes_.info.cells != cell_count() ||
        (!has_numbers() && attributes_.info.faces != faces))
        refuse_damage(directory_ / layout::attributes_document,
                      "declares other numbers of vertices, faces or cells than the arrays have");
    const auto expect = [&](const std::string& name, std::uint64_t want) {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return;
        const std::uint64_t have = found->second.bytes().size() / element_bytes(type_of(name));
        if (have != want)
            refuse_damage(found->second.path(), "has " + std::to_string(have) + " entries, but must have " +
                                                    std::to_string(want) + " entries");
    };
    expect("original_cell", cell_count());
    expect(face_array("neighbour"), faces);
    expect(face_array("face_offset"), faces + 1);
    expect("solver_vertex", vertex_count_);
    expect("solver_cell", cell_count());
    if (faces < attributes_.info.boundary_faces) check_boundary_count(faces);
}

// Arrays on boundary faces are read with the size that the attributes declare, so the declared number must be right.
void MappedMesh::check_boundary_count(std::uint64_t count) const {
    if (count != attributes_.info.boundary_faces)
        refuse_damage(directory_ / layout::attributes_document,
                      "declares " + std::to_string(attributes_.info.boundary_faces) +
                          " boundary faces, but there are " + std::to_string(count));
}

void MappedMesh::map(const std::string& name, ElementType type) {
    const auto path = directory_ / name;
    const auto document = path / layout::array_document;
    const ZarrArray zarr = parse_zarr_array(read_text(document, layout::document_bytes), document);
    if (zarr.type != type || zarr.shape.size() != 1 || (zarr.shape != zarr.chunks && zarr.shape[0] != 0))
        refuse_damage(document,
                      std::string("declares a wrong type, number of dimensions or number of chunks for the array '") +
                          name + "'");
    arrays_.emplace(name, MappedFile(layout::chunk(path, 0, 1), zarr.chunk_bytes(document), losses_));
    keepers_.emplace(std::piecewise_construct, std::forward_as_tuple(name), std::forward_as_tuple(*this, name));
    verified_[name];
}

void MappedMesh::map_group(std::size_t index) {
    const auto& [of, name, facts] = attributes_.groups[index];
    const MappedFile& file = array("groups/" + std::to_string(index));
    const std::uint64_t limit = of == Group::Of::faces ? stored_faces() : cell_count();
    groups_.push_back(
        {of,
         name,
         {file.as<ciel::Index>(), static_cast<ciel::Index>(limit), keeper("groups/" + std::to_string(index))},
         facts});
}

CheckedStretches& MappedMesh::stretches_of(const std::string& ids) const {
    std::unique_ptr<CheckedStretches>& stretches = stretches_.at(ids);
    verified_.at(ids).once([&] {
        const std::string& sum = checksum_of(ids);
        const MappedFile& file = array(ids);
        const ArrayLayout layout{directory_ / ids, 1, 1, file.bytes().size(), false};
        std::optional<ValueRanges> ranges; // nullopt if the file was replaced; the array is then one stretch
        if (file.is_current()) ranges = read_ranges(layout, 0, sum, 0, 0, dataset_id_);
        stretches =
            std::make_unique<CheckedStretches>(layout.chunk_bytes, checks_of_stretches(layout, sum, std::move(ranges)));
    });
    return *stretches;
}

const std::string& MappedMesh::checksum_of(const std::string& name) const {
    const auto sum = attributes_.checksums.find(name);
    if (sum == attributes_.checksums.end())
        refuse_damage(directory_ / layout::attributes_document, "lacks the checksum of '" + name + "'");
    return sum->second;
}

void MappedMesh::verify_checksums(const std::vector<std::string>& names) const {
    ciel::parallel_for(names.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const MappedFile& file = array(names[i]);
            if (checksum(file.bytes()) != checksum_of(names[i]))
                refuse_damage(file.path(), "does not match its checksum");
        }
    });
}

bool MappedMesh::has_its_checksum(const std::string& name, const MappedFile& file) const {
    const auto sum = attributes_.checksums.find(name);
    return sum != attributes_.checksums.end() && checksum(file.bytes()) == sum->second;
}

void MappedMesh::verify_faces() const {
    std::vector<std::string> names;
    for (const char* name : layout::face_arrays) names.push_back(face_array(name));
    verify_checksums(names);
    const MappedFile &vertices = array(face_array("face_vertex")), &owner = array(face_array("owner"));
    const std::vector<std::function<void()>> checks{
        [&] { check_below(vertices, vertex_count_, "vertices"); },
        [&] { check_offsets(array(face_array("face_offset")), vertices.as<ciel::Index>().size()); },
        [&] { check_below(owner, cell_count(), "cells"); },
        [&] {
            check_neighbours(owner, array(face_array("neighbour")), cell_count());
            check_order();
        }};
    ciel::parallel_for(checks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) checks[i]();
    });
}

void MappedMesh::verify_types() const {
    verify_checksums({"cell_types"});
    if (!std::all_of(cell_types().begin(), cell_types().end(), is_cell_type))
        refuse_damage(array("cell_types").path(), "contains a cell type that does not exist");
}

// Numbered faces are in two ranges, each sorted by owner: the boundary faces, then the faces inside the mesh.
void MappedMesh::check_order() const {
    const auto& owner = array(face_array("owner"));
    const auto neighbour = array(face_array("neighbour")).as<ciel::Index>();
    const std::size_t boundary = attributes_.info.boundary_faces, first_inner = has_numbers() ? boundary : 0;
    check_boundary_count(static_cast<std::uint64_t>(std::ranges::count(neighbour, ciel::none)));
    if (!is_sorted(owner, 0, first_inner) || !is_sorted(owner, first_inner, neighbour.size()))
        refuse_damage(owner.path(), "is not sorted in ascending order");
    if (std::ranges::any_of(neighbour.first(first_inner), [](ciel::Index cell) { return cell != ciel::none; }))
        refuse_damage(array(face_array("neighbour")).path(), "has a face inside the mesh among the boundary faces");
}

void MappedMesh::verify_groups() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < groups_.size(); ++i) names.push_back("groups/" + std::to_string(i));
    verify_checksums(names);
    for (std::size_t i = 0; i < groups_.size(); ++i)
        check_group(groups_[i], array(names[i]), groups_[i].of == Group::Of::faces ? stored_faces() : cell_count());
}

const std::vector<Group>& MappedMesh::groups() const {
    verified_.at("groups").once([this] { verify_groups(); });
    const bool has_faces = std::ranges::any_of(
        groups_, [](const Group& group) { return group.of == Group::Of::faces && !group.ids.empty(); });
    if (!has_numbers() && has_faces) number_faces();
    return groups_;
}

void MappedMesh::verify() const {
    verified_.at("faces").once([this] { verify_faces(); });
    verified_.at("types").once([this] { verify_types(); });
    (void)groups();
    (void)original_vertex();
    (void)original_cell();
    (void)solver_vertex();
    (void)solver_cell();
    if (!blocks_) return;
    const ciel::TopologyCounts counts = stored_topology().counts();
    const MeshInfo& info = attributes_.info;
    if (counts.vertices != info.vertices || counts.cells != info.cells || counts.faces != info.faces ||
        counts.boundary_faces != info.boundary_faces)
        refuse_damage(directory_ / layout::attributes_document,
                      "declares other numbers of vertices, faces or cells than the blocks have");
    for (const ciel::RecordKind kind : record_kinds)
        ciel::parallel_for(blocks_->block_count(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) (void)blocks_->read(static_cast<ciel::Index>(b), kind);
        });
}

ciel::FaceMeshView MappedMesh::view_points(ciel::ValuesView positions) const {
    return ciel::face_mesh_view(attributes_.origin, positions, cell_types(), {}, {}, {}, {});
}

ciel::FaceMeshView MappedMesh::with_stored_faces(ciel::FaceMeshView points) const {
    verified_.at("faces").once([this] { verify_faces(); });
    const auto vertices = array(face_array("face_vertex")).as<ciel::Index>();
    const ciel::Index cells = points.cell_count();
    points.face_offset = {array(face_array("face_offset")).as<std::uint64_t>(), vertices.size() + 1,
                          keeper(face_array("face_offset"))};
    points.face_vertex = {vertices, points.vertex_count(), keeper(face_array("face_vertex"))};
    points.owner = {array(face_array("owner")).as<ciel::Index>(), cells, keeper(face_array("owner"))};
    points.neighbour = {array(face_array("neighbour")).as<ciel::Index>(), cells, keeper(face_array("neighbour"))};
    return points;
}

void MappedMesh::number_faces() const {
    verified_.at("groups").once([this] { verify_groups(); });
    verified_.at("numbers").once([this] {
        std::vector<std::vector<ciel::Index>> ids(groups_.size());
        for (std::size_t i = 0; i < groups_.size(); ++i)
            if (groups_[i].of == Group::Of::faces) ids[i].assign(groups_[i].ids.begin(), groups_[i].ids.end());
        // Sets the limit of the ids in face_vertex, because view_points({}) has no positions and so no vertices.
        ciel::FaceMeshView mesh = with_stored_faces(view_points({}));
        mesh.face_vertex = {mesh.face_vertex.unchecked(), static_cast<ciel::Index>(vertex_count_),
                            keeper("face_vertex")};
        NumberedGroups numbered = number_groups(mesh, ids);
        // Checks the files again: one may have changed since the first check, and a wrong `numbered` would be kept.
        for (const auto& [name, file] : arrays_)
            if (!has_its_checksum(name, file)) file.refuse();
        check_boundary_count(static_cast<std::uint64_t>(std::ranges::count(numbered.faces.neighbour, ciel::none)));
        numbered_ = std::move(numbered);
        for (std::size_t i = 0; i < groups_.size(); ++i)
            if (groups_[i].of == Group::Of::faces)
                groups_[i].ids = {numbered_.ids[i], static_cast<ciel::Index>(numbered_.faces.owner.size())};
    });
}

ciel::FaceMeshView MappedMesh::numbered_faces(ciel::FaceMeshView points) const {
    if (has_numbers()) return with_stored_faces(std::move(points));
    number_faces();
    return ciel::with_faces(std::move(points), {shared_from_this(), &numbered_.faces});
}

ciel::FaceMeshView MappedMesh::first_faces(ciel::FaceMeshView faces) const {
    const std::size_t count = attributes_.info.boundary_faces;
    faces.face_offset = faces.face_offset.part(0, count + 1);
    faces.owner = faces.owner.part(0, count);
    faces.neighbour = faces.neighbour.part(0, count);
    return faces;
}

ciel::FaceMeshView MappedMesh::boundary(ciel::FaceMeshView points) const {
    return first_faces(numbered_faces(std::move(points)));
}

ciel::FaceMeshView MappedMesh::all_faces(ciel::FaceMeshView points) const {
    verified_.at("types").once([this] { verify_types(); });
    if (!has_numbers()) return with_stored_faces(std::move(points));
    const std::lock_guard lock(making_faces_);
    auto faces = all_faces_.lock();
    if (!faces) {
        faces = std::make_shared<const ciel::FaceLists>(ciel::all_faces(stored_topology(), boundary(points)));
        check_intact();
        all_faces_ = faces;
    }
    return ciel::with_faces(std::move(points), std::move(faces));
}

// Throws Error that names the changed array. A wrong index in `suspected` can also mean that another array has changed.
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
        // was_touched is called before the checksum is computed, so that its next call detects a write in between.
        if (!file.was_touched()) continue;
        const bool is_whole = has_its_checksum(name, file);
        file.check_intact(); // throws if the file was truncated: the zeros in the mapping may match the checksum
        if (!is_whole) file.refuse();
    }
    if (blocks_) blocks_->check_unchanged();
}

void MappedMesh::check_intact() const {
    for (const auto& [name, file] : arrays_) file.check_intact();
    if (blocks_) blocks_->check_intact();
}

} // namespace server::store
