#include "render/volume/volume_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace server::render {
namespace {

constexpr double rounding = 1e-6; // tolerance for comparisons, as a share of a slab's thickness

struct Piece {
    SlabOfVolume of;
    double middle = 0;     // coordinate along the slabs' normal
    bool is_odd = false;   // alternates along the normal; true reverses the order of coincident pieces
    bool is_below = false; // its coordinate is smaller than the coordinate of the eye
};

void take_turns(std::vector<Piece>& sorted, std::span<const SlabRow> rows) {
    for (auto begin = sorted.begin(); begin != sorted.end();) {
        const double middle = begin->middle, near = rounding * rows[begin->of.volume].thickness;
        const auto end = std::find_if(begin, sorted.end(),
                                      [&](const Piece& piece) { return std::abs(piece.middle - middle) > near; });
        std::sort(begin, end, [](const Piece& a, const Piece& b) { return a.of.volume < b.of.volume; });
        if (begin->is_odd) std::reverse(begin, end);
        begin = end;
    }
}

void append(std::vector<SlabOfVolume>& order, const std::vector<Piece>& pieces) {
    for (const Piece& piece : pieces) {
        const SlabOfVolume& next = piece.of;
        if (!order.empty() && order.back().volume == next.volume && order.back().slab == next.slab)
            order.back().share += next.share;
        else
            order.push_back(next);
    }
}

double middle_of(const SlabRow& row, std::size_t slab) {
    return row.first + (static_cast<double>(slab) + 0.5) * row.thickness;
}

std::vector<Piece> whole_slabs(std::span<const SlabRow> rows, double eye) {
    std::vector<Piece> pieces;
    for (std::size_t volume = 0; volume < rows.size(); ++volume) {
        const auto& [first, thickness, count] = rows[volume];
        const double place = std::clamp(std::floor((eye - first) / thickness), 0.0, static_cast<double>(count));
        for (std::size_t slab = 0; slab < count; ++slab)
            pieces.push_back(
                {{volume, slab}, middle_of(rows[volume], slab), slab % 2 == 1, slab < static_cast<std::size_t>(place)});
    }
    return pieces;
}

std::vector<double> borders(std::span<const SlabRow> rows, double eye) {
    std::vector<double> all;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const auto& [first, thickness, count] : rows) {
        for (std::size_t i = 0; i <= count; ++i) all.push_back(first + static_cast<double>(i) * thickness);
        thinnest = std::min(thinnest, thickness);
    }
    if (std::isfinite(eye)) all.push_back(eye);
    std::ranges::sort(all);
    const auto is_same = [&](double a, double b) { return b - a < rounding * thinnest; };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    return all;
}

// Returns the ends of the interval that the slice of a slab draws. If the eye is in the volume and less than one slab
// from the slice, this interval extends to the eye. Otherwise it is the slab.
std::array<double, 2> seen(const SlabRow& row, std::size_t slab, double eye) {
    const double middle = middle_of(row, slab), half = row.thickness / 2;
    const double last = row.first + static_cast<double>(row.count) * row.thickness;
    if (std::abs(middle - eye) >= row.thickness || eye <= row.first || eye >= last)
        return {middle - half, middle + half};
    return middle >= eye ? std::array{eye, middle + half} : std::array{middle - half, eye};
}

// Returns the slab that draws the light at `place`, or nullopt outside the volume. This is the slab that contains
// `place`, or the next slab if the middle of that slab and `place` are on different sides of the eye.
std::optional<std::size_t> slab_at(const SlabRow& row, double place, double eye) {
    double slab = std::floor((place - row.first) / row.thickness);
    if (slab < 0 || slab >= static_cast<double>(row.count)) return {};
    const double slice = row.first + (slab + 0.5) * row.thickness;
    if (place > eye && slice < eye) ++slab;
    if (place < eye && slice >= eye) --slab;
    if (slab < 0 || slab >= static_cast<double>(row.count)) return {};
    return static_cast<std::size_t>(slab);
}

std::vector<Piece> divided_slabs(std::span<const SlabRow> rows, double eye, const SlabPieces& wanted) {
    std::vector<Piece> pieces;
    const std::vector<double> places = borders(rows, eye);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double length = places[i + 1] - places[i], middle = places[i] + length / 2;
        const double count = std::clamp(std::ceil(length * wanted.per_length), 1.0, static_cast<double>(wanted.most));
        for (std::size_t volume = 0; volume < rows.size(); ++volume) {
            const std::optional<std::size_t> slab = slab_at(rows[volume], middle, eye);
            if (!slab) continue;
            const auto [from, to] = seen(rows[volume], *slab, eye);
            for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
                pieces.push_back({{volume, *slab, length / count / (to - from)},
                                  places[i] + (static_cast<double>(k) + 0.5) * length / count,
                                  (i + k) % 2 == 1,
                                  middle < eye});
        }
    }
    return pieces;
}

} // namespace

std::vector<SlabOfVolume> back_to_front(std::span<const SlabRow> rows, double eye, SlabPieces wanted) {
    double thickest = 0;
    for (const SlabRow& row : rows) thickest = std::max(thickest, row.thickness);
    const bool whole = rows.size() < 2 || wanted.most < 2 || thickest * wanted.per_length <= 1;
    std::vector<Piece> below = whole ? whole_slabs(rows, eye) : divided_slabs(rows, eye, wanted);
    const auto middle =
        std::stable_partition(below.begin(), below.end(), [](const Piece& piece) { return piece.is_below; });
    std::vector<Piece> above(middle, below.end());
    below.erase(middle, below.end());
    std::ranges::stable_sort(below, {}, &Piece::middle);
    std::ranges::stable_sort(above, std::ranges::greater(), &Piece::middle);
    take_turns(below, rows);
    take_turns(above, rows);
    std::vector<SlabOfVolume> order;
    append(order, below);
    append(order, above);
    return order;
}

} // namespace server::render
