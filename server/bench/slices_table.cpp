// Measures the paper's table 4: makes 100 slices, and interpolates the scalar of the case at their points.
#include "bench/case.hpp"
#include "ciel/sweep_sinks.hpp"

#include <cmath>

namespace server::bench {

namespace {

constexpr std::size_t slice_count = 100;

class Slices {
public:
    Slices(const Case& data, ciel::Algorithm algorithm)
        : values_(converted(data.values, false)), query_(*data.topology, data.mesh, algorithm) {}

    std::uint64_t draw(const ciel::Field& distance) {
        query_.set_field(distance);
        const auto [low, high] = distance.range();
        std::uint64_t triangles = 0;
        for (const double nu : values_between(low, high, slice_count)) {
            (void)query_.extract(nu, false, surface_);
            property_.resize(surface_.points.size());
            ciel::interpolate(surface_.points, values_.floats(), 1, property_);
            triangles += triangles_of(surface_);
        }
        return triangles;
    }

private:
    store::Values values_; // as floats
    ciel::Query query_;
    ciel::Surface surface_;
    std::vector<float> property_;
};

class OnePass {
public:
    explicit OnePass(const Case& data) : data_(data), values_(converted(data.values, false)) {}

    std::uint64_t draw(const ciel::Field& distance) {
        const auto [low, high] = distance.range();
        ciel::sweep(*data_.topology, data_.mesh, distance, values_between(low, high, slice_count),
                    ciel::SliceSink{values_.floats()}, buffers_, slices_);
        std::uint64_t triangles = 0;
        for (const ciel::SliceSink::Out& slice : slices_) triangles += slice.triangles.size() / 3;
        return triangles;
    }

private:
    const Case& data_;
    store::Values values_; // as floats
    ciel::SweepBuffers<ciel::SliceSink> buffers_;
    std::vector<ciel::SliceSink::Out> slices_;
};

// Returns the field whose level sets are the slices. Screen-aligned slices need a new field after each camera turn.
ciel::Field distance_along(const Case& data, ciel::Vec3d normal) {
    return field_of(data, store::Values(ciel::plane_distance(data.mesh, data.mesh.surface_origin, normal)));
}

} // namespace

Table slices_table(const Case& data) {
    Table table{"slices", {}, {}};
    const double part = 1 / std::sqrt(3.0);
    const ciel::Vec3d box{1, 0, 0}, screen{part, part, part};
    const ciel::Field kept = distance_along(data, box);
    for (const auto& [algorithm, name] : {std::pair{ciel::Algorithm::naive, "naive"},
                                          {ciel::Algorithm::propagation, "propagation"},
                                          {ciel::Algorithm::signatures, "signatures"}}) {
        Slices slices(data, algorithm);
        table.rows.push_back(measure(std::string("100 box-aligned, ") + name, [&] { return slices.draw(kept); }));
        table.rows.push_back(measure(std::string("100 screen-aligned, ") + name, [&] {
            const ciel::Field distance = distance_along(data, screen);
            return slices.draw(distance);
        }));
    }
    OnePass pass(data);
    table.rows.push_back(measure("100 box-aligned, one pass", [&] { return pass.draw(kept); }));
    table.rows.push_back(
        measure("100 screen-aligned, one pass", [&] { return pass.draw(distance_along(data, screen)); }));
    return table;
}

} // namespace server::bench
