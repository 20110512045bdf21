#include "ciel/gradient.hpp"

#include "ciel/extract.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ciel {

void CellGradient::clear() {
    samples_.clear();
    corners_.clear();
    loops_.clear();
}

Index CellGradient::add_vertex(const float* position, float value) {
    samples_.push_back({position[0], position[1], position[2], value});
    return static_cast<Index>(samples_.size() - 1);
}

void CellGradient::end_loop(bool reversed) { loops_.push_back({corners_.size(), reversed}); }

// Samples are relative to their mean by now. Each face is a fan of cones to the mean.
double CellGradient::volume() const {
    double six_volumes = 0;
    std::size_t begin = 0;
    for (const Loop& loop : loops_) {
        double x = 0, y = 0, z = 0; // twice the area vector of the loop about the mean
        const Sample* a = &samples_[corners_[loop.end - 1]];
        for (std::size_t i = begin; i < loop.end; ++i) {
            const Sample* b = &samples_[corners_[i]];
            x += a->y * b->z - a->z * b->y;
            y += a->z * b->x - a->x * b->z;
            z += a->x * b->y - a->y * b->x;
            a = b;
        }
        const Sample& apex = samples_[corners_[begin]];
        const double cones = apex.x * x + apex.y * y + apex.z * z;
        six_volumes += loop.reversed ? -cones : cones;
        begin = loop.end;
    }
    return std::abs(six_volumes) / 6;
}

CellGradient::Result CellGradient::solve() {
    Sample mean{0, 0, 0, 0};
    for (const Sample& s : samples_) {
        mean.x += s.x;
        mean.y += s.y;
        mean.z += s.z;
        mean.value += s.value;
    }
    if (samples_.size() < 4 || !std::isfinite(mean.value)) return {};
    const double share = 1.0 / static_cast<double>(samples_.size());
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, xv = 0, yv = 0, zv = 0;
    for (Sample& s : samples_) {
        s.x -= mean.x * share;
        s.y -= mean.y * share;
        s.z -= mean.z * share;
        s.value -= mean.value * share;
        xx += s.x * s.x;
        xy += s.x * s.y;
        xz += s.x * s.z;
        yy += s.y * s.y;
        yz += s.y * s.z;
        zz += s.z * s.z;
        xv += s.x * s.value;
        yv += s.y * s.value;
        zv += s.z * s.value;
    }
    const double cx = yy * zz - yz * yz, cy = xz * yz - xy * zz, cz = xy * yz - xz * yy;
    const double determinant = xx * cx + xy * cy + xz * cz;
    const double size = (xx + yy + zz) / 3;
    if (!(determinant > 1e-15 * size * size * size)) return {}; // flat, a line, a point
    const double dx = xx * zz - xz * xz, dy = xy * xz - xx * yz, dz = xx * yy - xy * xy;
    return {{static_cast<float>((cx * xv + cy * yv + cz * zv) / determinant),
             static_cast<float>((cy * xv + dx * yv + dy * zv) / determinant),
             static_cast<float>((cz * xv + dy * yv + dz * zv) / determinant)},
            static_cast<float>(volume())};
}

namespace {

template <class Local>
class BlockSampler {
public:
    BlockSampler(const FaceMeshView& mesh, const Block& block, const BlockArrays<Local>& arrays,
                 std::span<const float> values)
        : mesh_(mesh), block_(block), arrays_(arrays), values_(values), sample_of_(block.vertex.size(), none) {}

    CellGradient::Result operator()(Index cell) {
        gradient_.clear();
        touched_.clear();
        for (Index i = block_.cell_face_begin[cell]; i < block_.cell_face_begin[cell + 1]; ++i) {
            const Index face = arrays_.cell_face[i] / 2;
            for (Index k = block_.face_begin[face]; k < block_.face_begin[face + 1]; ++k)
                gradient_.add_corner(sample(arrays_.vertex[k]));
            gradient_.end_loop(arrays_.cell_face[i] % 2 != 0);
        }
        for (const Index v : touched_) sample_of_[v] = none;
        return gradient_.solve();
    }

private:
    Index sample(Index local) {
        if (sample_of_[local] == none) {
            sample_of_[local] =
                gradient_.add_vertex(&mesh_.positions[3 * std::size_t{block_.vertex[local]}], values_[local]);
            touched_.push_back(local);
        }
        return sample_of_[local];
    }

    const FaceMeshView& mesh_;
    const Block& block_;
    const BlockArrays<Local>& arrays_;
    std::span<const float> values_;
    CellGradient gradient_;
    std::vector<Index> sample_of_, touched_;
};

} // namespace

void GradientCache::make_cells(const FaceMeshView& mesh, const Field::Blocks& field) {
    const std::vector<Block>& blocks = field.topology->blocks().block;
    parallel_for(blocks.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            const Block& block = blocks[b];
            const std::span<std::uint8_t> state = std::span(cell_state_).subspan(block.cell_begin, block.cell_count);
            if (std::ranges::find(state, 1) == state.end()) continue;
            block.with([&](const auto& arrays) {
                BlockSampler sampler(mesh, block, arrays, field.of_block(static_cast<Index>(b)));
                for (Index cell = 0; cell < block.cell_count; ++cell) {
                    if (state[cell] != 1) continue;
                    cell_[block.cell_begin + cell] = sampler(cell);
                    state[cell] = 2;
                }
            });
        }
    });
}

// Cells come in ascending order, so the sum has the same bits whatever the blocks and threads.
void GradientCache::average(std::span<const Index> vertices, std::span<const Index> cells,
                            std::span<const Index> cell_end) {
    Index begin = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        double sum[3] = {0, 0, 0}, volume = 0;
        for (Index c = begin; c < cell_end[i]; ++c) {
            const CellGradient::Result& cell = cell_[cells[c]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += static_cast<double>(cell.volume) * cell.gradient[axis];
            volume += cell.volume;
        }
        Vec3f& out = gradient_[vertices[i]];
        for (std::size_t axis = 0; axis < 3; ++axis)
            out[axis] = volume > 0 ? static_cast<float>(sum[axis] / volume) : 0.0F;
        begin = cell_end[i];
    }
}

std::span<const Vec3f> GradientCache::at(const FaceMeshView& mesh, const Field::Blocks& field,
                                         std::span<const EdgePoint> points) {
    const Locked lock(mutex_);
    const Topology::Blocks& blocks = field.topology->blocks();
    gradient_.resize(blocks.counts.vertices);
    vertex_known_.resize(blocks.counts.vertices);
    cell_.resize(blocks.counts.cells);
    cell_state_.resize(blocks.counts.cells);
    std::vector<Index> wanted;
    for (const EdgePoint& point : points)
        for (const Index v : {point.a, point.b})
            if (!vertex_known_[v]) {
                vertex_known_[v] = 1;
                wanted.push_back(v);
            }
    if (wanted.empty()) return gradient_;

    constexpr std::size_t chunk = 1024;
    struct Around {
        std::vector<Index> cells, end;
    };
    std::vector<Around> around((wanted.size() + chunk - 1) / chunk);
    const auto for_chunks = [&](auto&& body) {
        parallel_for(around.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                body(std::span(wanted).subspan(i * chunk, std::min(chunk, wanted.size() - i * chunk)), around[i]);
        });
    };
    for_chunks([&](std::span<const Index> vertices, Around& out) {
        std::vector<Index> cells;
        for (const Index v : vertices) {
            blocks.cells_around(v, cells);
            for (const Index c : cells) {
                std::atomic_ref state(cell_state_[c]);
                if (state.load(std::memory_order_relaxed) == 0) state.store(1, std::memory_order_relaxed);
            }
            out.cells.insert(out.cells.end(), cells.begin(), cells.end());
            out.end.push_back(static_cast<Index>(out.cells.size()));
        }
    });
    make_cells(mesh, field);
    for_chunks([&](std::span<const Index> vertices, const Around& in) { average(vertices, in.cells, in.end); });
    return gradient_;
}

std::size_t GradientCache::memory_bytes() const {
    const Locked lock(mutex_);
    return gradient_.capacity() * sizeof(Vec3f) + vertex_known_.capacity() + cell_.capacity() * sizeof(cell_[0]) +
           cell_state_.capacity();
}

std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, std::span<const float> values) {
    return vertex_gradients(Topology(mesh), mesh, values);
}

std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh, std::span<const float> values) {
    const Field field(topology, values, nullptr);
    std::vector<EdgePoint> all;
    for (Index v = 0; v < mesh.vertex_count(); ++v) all.push_back({v, v, 0});
    const auto gradients = field.blocks().gradients.at(mesh, field.blocks(), all);
    return {gradients.begin(), gradients.end()};
}

} // namespace ciel
