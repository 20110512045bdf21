#include "import/values/seam_difference.hpp"

#include "import/values/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace server::importer {
namespace {

// Tolerance as a share of the field's range. Rounding in a file makes smaller differences.
constexpr double field_tolerance = 1e-4;

bool values_differ(ciel::ValuesView values, std::size_t width, const std::vector<Seam>& seams) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const double tolerance = field_tolerance * (high - low);
    for (const Seam& seam : seams)
        for (const auto& [a, b] : seam.points)
            for (std::size_t c = 0; c < width; ++c)
                if (std::abs(values[a * width + c] - values[b * width + c]) > tolerance) return true;
    return false;
}

bool positions_differ(const Seam& seam, const JoinedMesh::Member& member) {
    return std::any_of(seam.points.begin(), seam.points.end(), [&](const std::pair<ciel::Index, ciel::Index>& pair) {
        ciel::Vec3d a;
        ciel::Vec3d b;
        member.data->GetPoint(pair.first - member.first_point, a.data());
        member.data->GetPoint(pair.second - member.first_point, b.data());
        return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}) > 2 * seam.tolerance;
    });
}

} // namespace

std::string difference_across(const std::vector<Seam>& seams, const std::vector<JoinedMesh::Member>& members) {
    if (seams.empty()) return "";
    for (const Seam& seam : seams)
        if (positions_differ(seam, members[seam.member])) return "position";
    for (const FieldName& field : field_names(members))
        if (field.of == FieldOf::points &&
            values_differ(gather_field(members, field), static_cast<std::size_t>(field.components), seams))
            return field.name;
    return "";
}

} // namespace server::importer
