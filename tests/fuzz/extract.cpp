// Fuzzes extract with a small mesh, two fields and a sequence of a viewer's calls. Every algorithm and a new query give
// the same bits, and functions on surfaces keep their contracts.
#include "ciel/extract.hpp"
#include "fuzz/extract_promises.hpp"
#include "fuzz/extract_steps.hpp"
#include "support/kept.hpp"
#include "support/views.hpp"
#include "support/volume_property.hpp"

#include <optional>

namespace {

using namespace ciel;
using namespace server;
using namespace ciel::test;

constexpr std::array algorithms{Algorithm::signatures, Algorithm::propagation, Algorithm::naive};

class Viewer {
public:
    Viewer(const Topology& topology, const FaceMeshView& mesh, Bytes& bytes)
        : topology_(topology), mesh_(kept(mesh)), bytes_(bytes) {
        for (auto& values : values_) values = field_from(bytes, mesh.vertex_count());
        for (std::size_t i = 0; i < values_.size(); ++i) field_[i].emplace(topology, values_[i], kept_by_test);
        for (const Algorithm algorithm : algorithms) {
            query_.emplace_back(topology, mesh_, algorithm);
            query_.back().set_field(*field_[0]);
        }
    }

    void run() {
        check_fields();
        for (int steps = bytes_.next() % 16 + 1; steps > 0; --steps) step();
        sweep_values();
        select();
    }

private:
    void check_fields() {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const auto minima = field_[i]->sorted_minima();
            for (std::size_t k = 1; k < minima.size(); ++k)
                require(std::pair(values_[i][minima[k - 1]], minima[k - 1]) <
                            std::pair(values_[i][minima[k]], minima[k]),
                        "minima are sorted");
            (void)count_ambiguous_faces(topology_, mesh_, values_[i]);
            gradient_[i] = vertex_gradients(topology_, mesh_, values_[i]);
            require(gradient_[i].size() == values_[i].size(), "as many gradients as vertices");
        }
    }

    void step() {
        const std::uint8_t what = bytes_.next();
        switch (what % 8) {
        case 0:
            current_ = what / 8 % 2;
            for (Query& query : query_) query.set_field(*field_[current_]);
            break;
        case 1:
            decider_ = what / 8 % 2 == 0 ? Decider::isolate_high : Decider::asymptotic;
            for (Query& query : query_) query.set_decider(decider_);
            break;
        case 2:
            normals_ = what / 8 % 2 == 0 ? Normals::gradient : Normals::polygons;
            for (Query& query : query_) query.set_normals(normals_);
            break;
        case 3:
            move(what / 8);
            break;
        default:
            extract(number(bytes_.next()), what >= 16);
            break;
        }
    }

    void move(std::size_t by) {
        // Keeps earlier positions, to which views still refer.
        moved_.push_back({mesh_.positions.begin(), mesh_.positions.end()});
        for (std::size_t i = by; i < moved_.back().size(); i += 7) moved_.back()[i] += number(bytes_.next() % 64);
        mesh_.positions = moved_.back();
        for (auto& field : field_) field->vertices_moved();
        for (Query& query : query_) query.set_mesh(mesh_);
    }

    void extract(double nu, bool with_normals) {
        Surface surface, other;
        require(query_[0].extract(nu, with_normals, surface), "nothing asked extract to stop");
        for (std::size_t i = 1; i < query_.size(); ++i) {
            require(query_[i].extract(nu, with_normals, other), "nothing asked extract to stop");
            same_surface(surface, other, "the algorithms differ");
        }
        const Field field(topology_, values_[current_], kept_by_test);
        Query fresh(topology_, mesh_, {Algorithm::signatures, decider_});
        fresh.set_normals(normals_);
        fresh.set_field(field);
        require(fresh.extract(nu, with_normals, other), "nothing asked extract to stop");
        same_surface(surface, other, "the history shows");
        if (with_normals) require(surface.normals.size() == surface.points.size(), "normals were asked for");
        check_cut(surface, mesh_, values_[current_], nu);
        check_closed(surface, mesh_, values_[current_]);
        draw(surface);
        asked_.push_back(nu);
    }

    // Calls the functions that drawing and exporting a surface need.
    void draw(const Surface& surface) {
        check_edges(surface);
        std::vector<float> at(surface.points.size());
        interpolate(surface.points, values_[1 - current_], 1, at);
        const double levels[]{number(bytes_.next()), number(bytes_.next())};
        const std::vector<Vec3f> lines = contour_lines(surface, at, levels);
        require(lines.size() == 2 * expected_lines(surface, at, levels), "as many contour lines as high runs");
        const auto coordinate = [&] { return (bytes_.next() - 128) / 64.0; };
        std::vector<HalfSpace> planes(bytes_.next() % 3);
        for (HalfSpace& plane : planes) plane = {{coordinate(), coordinate(), coordinate()}, coordinate()};
        const double slack = bytes_.next() / 1e6;
        check_clipped(clip_surface(surface, at, planes, slack), surface.points.size(), planes, slack,
                      mesh_.cell_count());
    }

    void sweep_values() {
        const Field& field = *field_[current_];
        std::vector<SoupSink::Out> soup;
        std::vector<OutlineSink::Out> outline;
        std::vector<SliceSink::Out> slices;
        std::vector<geometry::SlabSink::Out> slabs;
        const std::vector<float>& property = values_[1 - current_];
        const auto filled = geometry::filled_cells(*field_[1 - current_]);
        const geometry::SlabProperty of_slab{topology_, property, gradient_[1 - current_], filled};
        // Buffers left from a sweep through the other field must not affect the result.
        SweepBuffers<SoupSink> kept;
        SweepBuffers<SliceSink> kept_slices;
        require(sweep(topology_, mesh_, *field_[1 - current_], asked_, SoupSink{}, kept, soup) &&
                    sweep(topology_, mesh_, *field_[1 - current_], asked_, SliceSink{property}, kept_slices, slices),
                "nothing asked sweep to stop");
        require(sweep(topology_, mesh_, field, asked_, SoupSink{}, kept, soup) &&
                    sweep(topology_, mesh_, field, asked_, OutlineSink{}, outline) &&
                    sweep(topology_, mesh_, field, asked_, SliceSink{property}, kept_slices, slices) &&
                    sweep(topology_, mesh_, field, asked_, geometry::SlabSink{of_slab}, slabs),
                "nothing asked sweep to stop");
        for (Query& query : query_) query.set_decider(Decider::isolate_high);
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            Surface surface;
            require(query_[0].extract(asked_[i], false, surface), "nothing asked extract to stop");
            compare_with(surface, soup[i], outline[i], slices[i]);
            check_slab(slabs[i]);
        }
        check_slab(VolumeProperty(topology_, mesh_, property).boundary(mesh_));
    }

    static void compare_with(const Surface& surface, const std::vector<Vec3f>& soup, const std::vector<Vec3f>& outline,
                             const SliceSink::Out& slice) {
        std::vector<Vec3f> fans, sides, of_slice;
        for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
            const auto loop = corners(surface, i);
            for (std::size_t k = 2; k < loop.size(); ++k)
                for (const Index p : {loop[0], loop[k - 1], loop[k]}) fans.push_back(surface.positions[p]);
            for (std::size_t k = 0; k < loop.size(); ++k)
                for (const Index p : {loop[(k + loop.size() - 1) % loop.size()], loop[k]})
                    sides.push_back(surface.positions[p]);
        }
        require(same_bits(fans, soup), "a soup is the surface's polygons as fans");
        require(same_bits(sides, outline), "an outline is the surface's sides");
        require(slice.property.size() == slice.positions.size(), "a slice's property");
        for (const Index p : slice.triangles) of_slice.push_back(slice.positions.at(p));
        require(same_bits(fans, of_slice), "a slice is the surface's polygons as fans");
    }

    void select() {
        const double one = number(bytes_.next()), two = number(bytes_.next());
        const std::array range{std::min(one, two), std::max(one, two)};
        Surface cut;
        require(query_[1].extract(asked_.empty() ? one : asked_.back(), true, cut), "nothing asked extract to stop");
        for (const InRange vertices : {InRange::all, InRange::any}) {
            const auto kept = cells_in_range(mesh_, values_[1 - current_], range, vertices);
            require(kept.size() == mesh_.cell_count(), "a flag per cell");
            const Surface around = threshold_surface(mesh_, kept), part = polygons_of_cells(cut, kept);
            check_polygons(around, mesh_.cell_count());
            check_polygons(part, mesh_.cell_count());
            check_edges(around);
            for (const Index cell : around.polygon_cell) require(kept[cell] != 0, "a face of a cell that is not kept");
            for (const Index cell : part.polygon_cell) require(kept[cell] != 0, "a polygon of a cell that is not kept");
        }
    }

    const Topology& topology_;
    FaceMeshView mesh_;
    Bytes& bytes_;
    std::array<std::vector<float>, 2> values_;
    std::array<std::vector<Vec3f>, 2> gradient_;
    std::array<std::optional<Field>, 2> field_;
    std::vector<Query> query_; // one query per algorithm
    std::vector<std::vector<float>> moved_;
    std::size_t current_ = 0;
    Decider decider_ = Decider::isolate_high;
    Normals normals_ = Normals::gradient;
    std::vector<double> asked_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const Index cells_per_block = bytes.next() % 16U + 1;
    Polyhedra mesh = lattice_from(bytes);
    spoil(mesh, bytes);
    std::optional<Assembled> assembled;
    try {
        assembled.emplace(assemble(view(mesh)));
    } catch (const Error&) {
        return 0;
    }
    const FaceMeshView faces = assembled->mesh.view();
    const Topology topology(faces, {cells_per_block});
    Viewer(topology, faces, bytes).run();
    return 0;
}
