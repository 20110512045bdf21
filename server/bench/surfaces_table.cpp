#include "bench/case.hpp"

#include <algorithm>
#include <array>

namespace server::bench {

namespace {

class Surfaces {
public:
    Surfaces(const Case& data, ciel::Algorithm algorithm, const char* name)
        : data_(data), name_(name), field_(field_of(data, data.values)), query_(*data.topology, data.mesh, algorithm) {
        query_.set_field(field_);
        low_ = field_.range()[0];
        high_ = field_.range()[1];
    }

    std::uint64_t extract(double nu, bool normals = true) {
        (void)query_.extract(nu, normals, surface_);
        return triangles_of(surface_);
    }

    void add_rows(Table& table) {
        for (const std::size_t count : {std::size_t{1}, std::size_t{50}, std::size_t{100}})
            for (const bool normals : {false, true}) add_series(table, count, normals);
        add_step(table);
        add_jumps(table);
        add_changed_field(table);
        add_moved_mesh(table);
    }

private:
    [[nodiscard]] double at(double share) const {
        return low_ + share * (static_cast<double>(high_) - static_cast<double>(low_));
    }
    [[nodiscard]] std::string named(const std::string& what) const { return what + ", " + name_; }

    void add_series(Table& table, std::size_t count, bool normals) {
        const std::vector<double> values = values_between(low_, high_, count);
        // Extracts another value before each run, because the query still holds the last surface of the previous run.
        const auto away = [&] { (void)extract(at(0.3), false); };
        table.rows.push_back(measure(
            named(std::to_string(count) + (count == 1 ? " surface" : " surfaces") + (normals ? ", normals" : "")),
            [&] {
                std::uint64_t triangles = 0;
                for (const double nu : values) triangles += extract(nu, normals);
                return triangles;
            },
            away));
    }

    // Returns a step of at least 1e-7 of the range that activates or deactivates at most 1 % of the active edges.
    double small_step(double nu) {
        (void)extract(nu, false);
        const auto edges = static_cast<double>(surface_.points.size());
        const double span = static_cast<double>(high_) - static_cast<double>(low_);
        double step = span / 100;
        while (step > span * 1e-7) {
            const auto passed =
                std::ranges::count_if(data_.values, [&](double value) { return value >= nu && value < nu + step; });
            // If the value of a vertex lies within the step, the vertex's edges, about 12, become active or inactive.
            if (12 * static_cast<double>(passed) <= edges / 100) return step;
            step /= 2;
        }
        return span * 1e-7;
    }

    // Measures a small step and a jump. Both end at nearly the same surface, so that their costs can be compared.
    void add_step(Table& table) {
        const double middle = at(0.5), step = small_step(middle);
        double nu = middle;
        Row row = measure(named("one small step, normals"), [&] { return extract(nu += step); });
        row.note = "of " + std::to_string(step);
        table.rows.push_back(row);
        // Extracts other values before each run, so that no block can reuse its cut at the middle value.
        const auto away = [&] {
            for (const double share : {0.45, 0.55, 0.8}) (void)extract(at(share));
        };
        table.rows.push_back(measure(
            named("one jump to there, normals"), [&] { return extract(middle); }, away));
    }

    void add_jumps(Table& table) {
        constexpr std::array shares{0.31, 0.77, 0.12, 0.55, 0.9, 0.24, 0.66, 0.43};
        table.rows.push_back(measure(named("eight jumps, normals"), [&] {
            std::uint64_t triangles = 0;
            for (const double share : shares) triangles += extract(at(share));
            return triangles;
        }));
    }

    void add_changed_field(Table& table) {
        const double nu = at(0.5);
        bool other = false;
        table.rows.push_back(measure(named("a changed field, one surface, normals"), [&] {
            other = !other;
            ciel::Field changed = field_of(data_, other ? data_.changed : data_.values);
            query_.set_field(changed);
            field_ = std::move(changed);
            return extract(nu);
        }));
        query_.set_field(field_ = field_of(data_, data_.values));
    }

    void add_moved_mesh(Table& table) {
        data_.mesh.positions.with([&]<class Number>(std::span<const Number> all) {
            add_moved_mesh<Number>({all.begin(), all.end()}, table);
        });
    }

    template <class Number>
    void add_moved_mesh(std::vector<Number> positions, Table& table) {
        const double nu = at(0.5);
        ciel::FaceMeshView moved = data_.mesh;
        moved.positions = positions;
        Number shift = 1e-3F;
        table.rows.push_back(measure(
            named("a moved mesh, one surface, normals"),
            [&] {
                query_.set_mesh(moved);
                field_.vertices_moved();
                return extract(nu);
            },
            [&] {
                for (std::size_t i = 0; i < positions.size(); i += 3) positions[i] += shift;
                shift = -shift;
            }));
        query_.set_mesh(data_.mesh);
        field_.vertices_moved();
    }

    const Case& data_;
    const char* name_;
    ciel::Field field_;
    ciel::Query query_;
    ciel::Surface surface_;
    float low_ = 0, high_ = 0;
};

} // namespace

Table surfaces_table(const Case& data) {
    Table table{"surfaces", {}, {}};
    Surfaces(data, ciel::Algorithm::naive, "naive").add_rows(table);
    Surfaces(data, ciel::Algorithm::propagation, "propagation").add_rows(table);
    Surfaces(data, ciel::Algorithm::signatures, "signatures").add_rows(table);
    return table;
}

} // namespace server::bench
