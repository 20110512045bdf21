// One update of a scene's geometry: one function for each kind of layer. Only SceneGeometry uses LayerUpdate.
#pragma once

#include "annotations/camera.hpp"
#include "geometry/cut.hpp"
#include "geometry/volume_cut.hpp"
#include "scene/rules.hpp"

namespace server::geometry {

struct LayerUpdate {
    ciel::Extraction extraction;
    const std::shared_ptr<store::LoadedDataset>& loaded;
    std::shared_ptr<store::Dataset> dataset;
    const std::stop_token& stop;
    Geometry& out;
    std::map<std::pair<std::string, std::size_t>, Cut>& cuts;
    std::map<std::pair<std::string, std::size_t>, Boundary>& boundaries;
    std::map<std::string, VolumeCut>& volumes;
    const annotations::ViewCamera camera;
    const bool moving;
    const std::size_t most_bytes;
    std::size_t bytes;                            // size of all kept state
    std::vector<const scene::ClipLayer*> caps{};  // visible clip layers with caps
    scene::VolumeLayer::Direction slabs_across{}; // direction of the slabs of all volumes

    // Each function appends the layer's drawables to `out`, or a sentence about missing data. Returns false if `stop`
    // was requested. Throws limits::LimitReached when the kept state exceeds `most_bytes`.
    bool operator()(const scene::Layer& layer, const scene::IsoLayer& iso);
    bool operator()(const scene::Layer& layer, const scene::SliceLayer& slice);
    bool operator()(const scene::Layer& layer, const scene::SurfaceLayer& surface);
    bool operator()(const scene::Layer& layer, const scene::EdgesLayer& edges);
    bool operator()(const scene::Layer& layer, const scene::PointsLayer& points);
    bool operator()(const scene::Layer& layer, const scene::OutlineLayer& outline);
    bool operator()(const scene::Layer& layer, const scene::VolumeLayer& volume);
    bool operator()(const scene::Layer&, const scene::ClipLayer&) { return true; } // see Geometry::clip and `caps`

private:
    [[nodiscard]] const store::Step& step() const { return dataset->steps()[out.step]; }
    // Returns the field, changed so that its surfaces are relative to out.origin.
    [[nodiscard]] store::ScalarField drawn(store::ScalarField field) const;
    // Updates `bytes` after each surface, so that a scene that is too large is refused early. Throws LimitReached.
    void count(std::size_t before, std::size_t after);
    void lack(const scene::Layer& layer, const char* what, const store::NotWritten& missing) const;
    void leave_out(const scene::Layer& layer, const store::NotWritten& missing) const;

    void add(Painted& painted, const std::shared_ptr<const Shape>& shape, const scene::Coloring& coloring,
             const scene::Layer& layer, bool lit, const OfArray& of = {});
    // Returns more lines for a legend: range of the cell array from which the array was made, and number of cells left
    // out.
    [[nodiscard]] std::vector<std::string> legend_lines(const std::string& scalar) const;
    // Adds a remark, only once, with the number of cells that are left out because they have no number for the array.
    void tell_left_out(const std::string& scalar, bool is_cut) const;
    // Sets the color scale or the solid color. Adds to `out.lacking` if the scale has no color for any of the scalars.
    void color(Drawable& drawable, const scene::Coloring& coloring, const scene::Layer& layer) const;
    void add_edges(Outlined& outlined, const std::shared_ptr<const Shape>& shape,
                   const std::optional<scene::Edges>& edges, const scene::Layer& layer);
    Drawable& add_lines(const std::shared_ptr<const Shape>& shape, const scene::Color& color, float width,
                        const scene::Layer& layer, std::uint64_t identity, std::uint64_t revision);
    void add_contours(Contoured& contoured, const std::shared_ptr<const Shape>& shape,
                      const std::optional<scene::Contours>& contours, const scene::Layer& layer);

    // Sets the field of the cut to the distance from out.origin along the plane's normal. Returns the plane's distance,
    // nu. Therefore a plane that moves along its normal changes nu only, not the field.
    double use_plane(Cut& cut, const scene::Plane& plane);
    // Returns the clip layer whose caps coincide with the slice, or null. The slice is then cut by the plane of the
    // clip layer. Otherwise rounding would let parts of each surface cover the other surface.
    [[nodiscard]] const scene::ClipLayer* cap_at(const scene::SliceLayer& slice) const;
    // Cuts at `nu`. If the plane lies in a side of the mesh, takes the boundary faces of the side instead, so that the
    // slice coincides with these faces. Returns false if `stop` was requested.
    bool cut_along(Cut& cut, double nu) const;

    Boundary& boundary(const scene::Layer& layer, const std::string& key, std::size_t index = 0);
    [[nodiscard]] std::vector<std::uint8_t> cells_of(const scene::Threshold& threshold) const;
    // Returns null if the array of the threshold has no values at this step.
    Boundary* solid(const scene::Layer& layer, const std::vector<std::string>& groups,
                    const std::optional<scene::Threshold>& threshold, std::string key);
    bool add_caps(const scene::Layer& layer, const scene::SurfaceLayer& surface, const Boundary& solid);

    [[nodiscard]] VolumeDrawable drawable_of(const scene::Layer& layer, const scene::VolumeLayer& volume,
                                             const VolumeCut& kept, std::size_t stride) const;
    [[nodiscard]] double unit_length_of(const scene::VolumeLayer& volume) const;
    [[nodiscard]] double mean_edge() const; // geometric mean of the edges of the bounds
    [[nodiscard]] double diagonal() const;
};

[[nodiscard]] std::string bits_of(double number); // the bytes of the number, for a key; not readable
[[nodiscard]] std::string plane_name(const std::array<double, 3>& normal, const store::Step& step);

[[nodiscard]] std::array<double, 2> range_of(const store::Dataset& dataset, const std::string& scalar,
                                             std::size_t step);
// Returns "U:magnitude" for "U" if U is a vector. Returns other names unchanged.
[[nodiscard]] std::string full_name(const store::Dataset& dataset, const std::string& scalar);

} // namespace server::geometry
