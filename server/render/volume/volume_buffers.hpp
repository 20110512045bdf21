// GL buffers of a volume's slices and boundary. They are kept from frame to frame.
#pragma once

#include "render/context/vertex_arrays.hpp"
#include "render/frame/volume.hpp"
#include "render/volume/boxed_ranges.hpp"
#include "render/volume/inner_polygons.hpp"

namespace server::render {

class VolumeBuffers {
public:
    struct Bounds { // box of the boundary's positions
        ciel::Vec3f low, high;
    };
    struct Slice {
        IndexRange outer, inner; // triangles (inner_polygons.hpp)
    };

    explicit VolumeBuffers(const Gl& gl);

    // Does nothing if identity, revision and stride have not changed, unless revision is 0. Throws Error if slices or
    // boundary are missing, if thickness or stride is not positive, or if an index is too large.
    void load(const Volume& volume);
    void bind_slices() const { gl_.BindVertexArray(slices_.array); }
    void bind_boundary() const { gl_.BindVertexArray(boundary_.array); }
    void draw(const IndexRange& range) const;

    // A drawn slab consists of Volume::stride slabs. It has a middle slice, and boundary triangles that intersect it.
    [[nodiscard]] const std::vector<Slice>& slices() const { return slice_of_slab_; }
    [[nodiscard]] const std::vector<IndexRange>& boundary_of_slabs() const { return boundary_of_slab_; }
    // Triangles of a slab's slice or boundary, split into consecutive ranges.
    [[nodiscard]] const std::vector<BoxedRange>& ranges_of_slice(std::size_t slab) const { return slice_ranges_[slab]; }
    [[nodiscard]] const std::vector<BoxedRange>& ranges_of_boundary(std::size_t slab) const {
        return boundary_ranges_[slab];
    }
    [[nodiscard]] const IndexRange& whole_boundary() const { return whole_boundary_; }
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }
    // Hash of the boundary's positions and triangles. It does not depend on the property.
    [[nodiscard]] std::uint64_t boundary_places() const { return boundary_places_; }

private:
    void upload_slices(const std::vector<SortedSlice>& slices);
    void upload_boundary(const color::SlabTriangles& mesh, const std::vector<std::vector<ciel::Index>>& lists);

    const Gl& gl_;
    VertexArrays slices_, boundary_;
    std::vector<Slice> slice_of_slab_;
    std::vector<IndexRange> boundary_of_slab_;
    std::vector<std::vector<BoxedRange>> slice_ranges_, boundary_ranges_;
    IndexRange whole_boundary_;
    Bounds bounds_{};
    std::uint64_t identity_ = 0, revision_ = 0;
    std::size_t stride_ = 0;
    std::uint64_t boundary_places_ = 0;
};

} // namespace server::render
