#include "import/readers/openfoam/openfoam_piece.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <cmath>

namespace server::importer {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t most_labels = ciel::none - std::size_t{1};

class PieceReader {
public:
    PieceReader(const FoamRoot& root, const std::string& region, double time)
        : root_(root), region_(region), time_(time) {}

    FoamPieceFiles run() {
        piece_.points = parse_foam_points(read("points"), name_);
        const std::size_t point_count = piece_.points.size() / 3;
        piece_.faces = parse_foam_faces(read("faces"), name_);
        const std::size_t faces = piece_.faces.offset.size() - 1;
        if (faces > most_labels || point_count > most_labels)
            fail("has more than 4,294,967,294 faces or points, the most that a dataset can hold");
        for (const std::int64_t point : piece_.faces.points)
            if (!is_below(point, point_count))
                fail("has a face with point " + std::to_string(point) + ", but there are only " +
                     std::to_string(point_count) + " points");
        piece_.owner = parse_foam_labels(read("owner"), name_, faces);
        if (piece_.owner.size() != faces)
            fail("has " + std::to_string(piece_.owner.size()) + " owners for " + std::to_string(faces) + " faces");
        count_cells(piece_.owner);
        read_neighbours(faces);
        read_patches(faces);
        read_optional();
        return std::move(piece_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw ciel::Error(name_ + ": " + what); }
    static bool is_below(std::int64_t label, std::size_t count) {
        return label >= 0 && static_cast<std::uint64_t>(label) < count;
    }

    // Returns the content of a mesh file. Sets name_ to the path of the file, for error texts.
    std::string read(const std::string& name) {
        const fs::path file = root_.mesh_file(region_, name, time_);
        name_ = (root_.directory / "constant" / region_ / "polyMesh" / name).string();
        if (file.empty()) throw ciel::Error(name_ + ": is missing");
        name_ = file.string();
        return read_foam_file(file);
    }

    void count_cells(const std::vector<std::int64_t>& cells) {
        for (const std::int64_t cell : cells) {
            if (!is_below(cell, most_labels))
                fail("contains cell " + std::to_string(cell) + ", which is negative or too large");
            piece_.cell_count = std::max(piece_.cell_count, static_cast<std::size_t>(cell) + 1);
        }
        // A closed cell has at least four faces, and at most two cells share a face, so faces outnumber cells.
        if (piece_.cell_count > piece_.owner.size())
            fail("contains more cells than the mesh has faces; the file is damaged");
    }

    // In old files, `neighbour` also has an entry -1 for each boundary face.
    void read_neighbours(std::size_t faces) {
        piece_.neighbour = parse_foam_labels(read("neighbour"), name_, faces);
        while (!piece_.neighbour.empty() && piece_.neighbour.back() == -1) piece_.neighbour.pop_back();
        count_cells(piece_.neighbour);
    }

    void read_patches(std::size_t faces) {
        piece_.patches = parse_foam_boundary(read("boundary"), name_);
        for (const FoamPatch& patch : piece_.patches) {
            const auto inner = static_cast<std::int64_t>(piece_.neighbour.size());
            const auto all = static_cast<std::int64_t>(faces);
            if (patch.face_count < 0 || patch.face_count > all || patch.first_face < 0 ||
                patch.first_face > all - patch.face_count || (patch.face_count > 0 && patch.first_face < inner))
                fail("patch " + patch.name + " has faces that are not on the boundary");
        }
    }

    void read_optional() {
        for (const auto& [name, zones, most] : {std::tuple{"cellZones", &piece_.cell_zones, piece_.cell_count},
                                                std::tuple{"faceZones", &piece_.face_zones, piece_.face_count()}}) {
            if (root_.mesh_file(region_, name, time_).empty()) continue;
            *zones = parse_foam_zones(read(name), name_);
            for (const FoamZone& zone : *zones)
                for (const std::int64_t label : zone.labels)
                    if (!is_below(label, most))
                        fail("zone " + zone.name + " contains " + std::to_string(label) +
                             ", but the mesh has no such id");
        }
        if (root_.mesh_file(region_, "cellProcAddressing", time_).empty()) return;
        try {
            read_addressing();
        } catch (const ciel::Error& error) {
            piece_.cell_addressing.clear();
            piece_.lost.push_back("The solver's ids of the cells of " + root_.name +
                                  " could not be read: " + error.what());
        }
    }

    void read_addressing() {
        piece_.cell_addressing = parse_foam_labels(read("cellProcAddressing"), name_, piece_.cell_count);
        if (piece_.cell_addressing.size() != piece_.cell_count)
            fail("has " + std::to_string(piece_.cell_addressing.size()) + " labels for " +
                 std::to_string(piece_.cell_count) + " cells");
    }

    const FoamRoot& root_;
    const std::string& region_;
    double time_;
    std::string name_;
    FoamPieceFiles piece_;
};

} // namespace

FoamPieceFiles read_foam_piece(const FoamRoot& root, const std::string& region, double time) {
    return PieceReader(root, region, time).run();
}

} // namespace server::importer
