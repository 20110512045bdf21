#include "import/mesh/position_loss.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace ciel::importer {
namespace {

constexpr double changed_share = 0.01; // of a cell's volume; larger changes are reported
constexpr double flat = 1e-8; // of a cell's size cubed; smaller changes are ignored: a collapsed cell has no volume

std::string plural(std::uint64_t count, const char* one, const char* many) {
    return std::to_string(count) + (count == 1 ? one : many);
}

// The corners of one face relative to the mesh's origin: exact positions from the input, and stored ones as floats.
class Corners {
public:
    Corners(const JoinedMesh& mesh, const JoinedMesh::Member& part) : mesh_(mesh), part_(part) {}

    void read(std::span<const Index> loop) {
        exact_.resize(loop.size());
        stored_.resize(loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i) {
            part_.data->GetPoint(loop[i] - part_.first_point, exact_[i].data());
            for (std::size_t k = 0; k < 3; ++k) {
                exact_[i][k] -= mesh_.origin[k];
                stored_[i][k] = mesh_.positions[3 * std::size_t{loop[i]} + k];
            }
        }
    }
    [[nodiscard]] bool merge() const {
        for (std::size_t i = 0; i < exact_.size(); ++i) {
            const std::size_t next = i + 1 == exact_.size() ? 0 : i + 1;
            if (exact_[i] != exact_[next] && stored_[i] == stored_[next]) return true;
        }
        return false;
    }
    [[nodiscard]] const std::vector<Vec3d>& exact() const { return exact_; }
    [[nodiscard]] const std::vector<Vec3d>& stored() const { return stored_; }

private:
    const JoinedMesh& mesh_;
    const JoinedMesh::Member& part_;
    std::vector<Vec3d> exact_, stored_;
};

// Returns six times the signed volume of the cone from `apex` over the face `loop`. The sign follows the input's
// winding, which is the same for exact and stored positions.
double six_cones(const std::vector<Vec3d>& loop, const Vec3d& apex) {
    const auto arm = [&](std::size_t i) {
        return Vec3d{loop[i][0] - apex[0], loop[i][1] - apex[1], loop[i][2] - apex[2]};
    };
    double sum = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) {
        const Vec3d a = arm(0), b = arm(i - 1), c = arm(i);
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
}

double squared_distance(const Vec3d& a, const Vec3d& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

struct CellLoss {
    bool merges = false, changes = false;
};

CellLoss cell_loss(const JoinedMesh& mesh, Index cell, Corners& corners) {
    CellLoss loss;
    double exact = 0, stored = 0, reach = 0; // reach: squared distance of the farthest corner
    std::optional<std::pair<Vec3d, Vec3d>> apex;
    for (std::uint64_t f = mesh.cell_offset[cell]; f < mesh.cell_offset[cell + 1]; ++f) {
        const std::uint64_t begin = mesh.face_offset[f], end = mesh.face_offset[f + 1];
        if (begin == end) continue;
        corners.read(std::span(mesh.face_vertex).subspan(begin, end - begin));
        if (!apex) apex.emplace(corners.exact().front(), corners.stored().front());
        loss.merges = loss.merges || corners.merge();
        exact += six_cones(corners.exact(), apex->first);
        stored += six_cones(corners.stored(), apex->second);
        for (const Vec3d& p : corners.exact()) reach = std::max(reach, squared_distance(p, apex->first));
    }
    const double change = std::abs(stored - exact);
    loss.changes = change > changed_share * std::abs(exact) && change > flat * std::pow(reach, 1.5);
    return loss;
}

} // namespace

std::vector<std::string> position_loss(const JoinedMesh& mesh) {
    std::uint64_t merged = 0, changed = 0;
    for (const JoinedMesh::Member& part : mesh.parts) {
        Corners corners(mesh, part);
        for (Index cell = part.mesh_cell_begin; cell < part.mesh_cell_end; ++cell) {
            const CellLoss loss = cell_loss(mesh, cell, corners);
            merged += loss.merges ? 1 : 0;
            changed += loss.changes ? 1 : 0;
        }
    }
    std::vector<std::string> notes;
    if (merged > 0)
        notes.push_back(
            plural(merged, " cell has", " cells have") +
            " corners that differ in the input and coincide in the dataset, which stores positions as 32-bit floats.");
    if (changed > 0)
        notes.push_back("The volume of " + plural(changed, " cell", " cells") +
                        " changes by more than 1 %, because the dataset stores positions as 32-bit floats.");
    return notes;
}

} // namespace ciel::importer
