#include "polygons/ear_clipping.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::detail {

namespace {

using Point = std::array<double, 2>;

double twice_area(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// A regular grid with about one corner in each grid cell.
class Grid {
public:
    Grid(std::span<const Point> corners, std::span<const Index> members) {
        side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(members.size()))) + 1;
        low_ = high_ = corners[0];
        for (const Point& p : corners)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                low_[axis] = std::min(low_[axis], p[axis]);
                high_[axis] = std::max(high_[axis], p[axis]);
            }
        begin_.assign(side_ * side_ + 1, 0);
        for (const Index i : members) ++begin_[place(corners[i]) + 1];
        for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
        member_.resize(members.size());
        std::vector<std::size_t> cursor(begin_.begin(), begin_.end() - 1);
        for (const Index i : members) member_[cursor[place(corners[i])]++] = i;
    }

    // Returns whether wanted(corner) is true for any corner in the grid cells that touch the rectangle. Each visited
    // grid cell and corner takes one of `steps`. Returns false when `steps` becomes negative.
    template <class Wanted>
    [[nodiscard]] bool any(const Point& low, const Point& high, std::int64_t& steps, Wanted&& wanted) const {
        for (std::size_t row = index(low, 1); row <= index(high, 1); ++row)
            for (std::size_t column = index(low, 0); column <= index(high, 0); ++column) {
                const std::size_t at = row * side_ + column;
                steps -= static_cast<std::int64_t>(1 + begin_[at + 1] - begin_[at]);
                if (steps < 0) return false;
                for (std::size_t k = begin_[at]; k < begin_[at + 1]; ++k)
                    if (wanted(member_[k])) return true;
            }
        return false;
    }

private:
    [[nodiscard]] std::size_t index(const Point& p, std::size_t axis) const {
        const double share = (p[axis] - low_[axis]) / (high_[axis] - low_[axis]);
        // Also 0 for NaN, which means that the polygon has no extent along the axis.
        if (!(share > 0)) return 0;
        return std::min(side_ - 1, static_cast<std::size_t>(std::min(share, 1.0) * static_cast<double>(side_)));
    }
    [[nodiscard]] std::size_t place(const Point& p) const { return index(p, 1) * side_ + index(p, 0); }

    std::size_t side_ = 1;
    Point low_{}, high_{};
    std::vector<std::size_t> begin_;
    std::vector<Index> member_;
};

class EarClipper {
public:
    EarClipper(std::span<const Point> corners, std::vector<Index>& out)
        : corners_(corners), out_(out), steps_(512 * static_cast<std::int64_t>(corners.size())),
          before_(corners.size()), after_(corners.size()), convex_(corners.size()), is_left_(corners.size(), 1),
          left_(corners.size()), waits_(corners.size(), 0) {
        const auto n = static_cast<Index>(corners.size());
        for (Index i = 0; i < n; ++i) {
            before_[i] = i == 0 ? n - 1 : i - 1;
            after_[i] = i + 1 == n ? 0 : i + 1;
        }
        for (Index i = 0; i < n; ++i) convex_[i] = area_at(i) > 0 ? 1 : 0;
    }

    // Cuts off ears in rounds, so that the triangles are compact. After the first round, a round tests only the
    // neighbors of corners that the round before cut off, because only these can become ears.
    void run() {
        const Grid grid = grid_of_the_rest();
        for (Index i = 0; i < corners_.size(); ++i) next_.push_back(i);
        while (left_ > 3) {
            if (next_.empty()) cut_off(some_left_); // no ear is left, so the polygon crosses itself
            ++round_;
            now_.swap(next_);
            next_.clear();
            for (const Index i : now_)
                if (left_ > 3 && is_left_[i] != 0 && waits_[i] != round_ && (--steps_ < 0 || is_ear(grid, i)))
                    cut_off(i);
        }
        out_.insert(out_.end(), {before_[some_left_], some_left_, after_[some_left_]});
    }

private:
    // Has only non-convex corners: a triangle that contains any other corner also contains a corner that is not convex.
    [[nodiscard]] Grid grid_of_the_rest() const {
        std::vector<Index> members;
        for (Index i = 0; i < corners_.size(); ++i)
            if (convex_[i] == 0) members.push_back(i);
        return {corners_, members};
    }
    [[nodiscard]] double area_at(Index i) const {
        return twice_area(corners_[before_[i]], corners_[i], corners_[after_[i]]);
    }

    [[nodiscard]] bool is_ear(const Grid& grid, Index i) {
        if (convex_[i] == 0) return false;
        const Point &a = corners_[before_[i]], &b = corners_[i], &c = corners_[after_[i]];
        const Point low{std::min({a[0], b[0], c[0]}), std::min({a[1], b[1], c[1]})};
        const Point high{std::max({a[0], b[0], c[0]}), std::max({a[1], b[1], c[1]})};
        return !grid.any(low, high, steps_, [&](Index other) {
            const Point& p = corners_[other];
            return convex_[other] == 0 && p != a && p != b && p != c && twice_area(a, b, p) >= 0 &&
                   twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
        });
    }

    void cut_off(Index i) {
        const Index a = before_[i], c = after_[i];
        out_.insert(out_.end(), {a, i, c});
        after_[a] = c;
        before_[c] = a;
        is_left_[i] = 0;
        convex_[i] = 1; // so that is_ear ignores the corner from now on
        --left_;
        some_left_ = a;
        for (const Index k : {a, c}) {
            convex_[k] = area_at(k) > 0 ? 1 : 0;
            if (waits_[k] != round_) next_.push_back(k);
            waits_[k] = round_;
        }
    }

    std::span<const Point> corners_;
    std::vector<Index>& out_;
    std::int64_t steps_; // number of steps left (clip_ears)
    std::vector<Index> before_, after_;
    std::vector<std::uint8_t> convex_, is_left_;
    std::size_t left_;
    Index some_left_ = 0;
    std::vector<Index> now_, next_; // corners to test in this round and in the next round
    std::vector<Index> waits_;      // by corner: the round in which the corner is skipped
    Index round_ = 0;
};

} // namespace

void clip_ears(std::span<const Point> corners, std::vector<Index>& out) { EarClipper(corners, out).run(); }

} // namespace ciel::detail
