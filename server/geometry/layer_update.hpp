// One update of a scene's geometry: what each kind of layer does, and the kept state that it uses. Of SceneGeometry
// alone.
#pragma once

#include "annotations/camera.hpp"
#include "geometry/cut.hpp"
#include "geometry/volume_cut.hpp"

namespace ciel::geometry {

struct LayerUpdate {
    Extraction extraction;
    const std::shared_ptr<store::LoadedDataset>& loaded;
    std::shared_ptr<store::Dataset> dataset;
    const std::stop_token& stop;
    Geometry& out;
    std::map<std::pair<std::string, std::size_t>, Cut>& cuts;
    std::map<std::pair<std::string, std::size_t>, Boundary>& boundaries;
    std::map<std::string, VolumeCut>& volumes;
    const annotations::Camera camera;
    const bool moving;
    const std::size_t most_bytes;
    std::size_t bytes;                            // of all that is kept
    std::vector<const scene::ClipLayer*> caps{};  // that surfaces get
    scene::VolumeLayer::Direction slabs_across{}; // of all volumes

    // Each appends what the layer shows to `out`, or a sentence about what it lacks. False when stopped. Throws
    // LimitReached.
    bool operator()(const scene::Layer& layer, const scene::IsoLayer& iso);
    bool operator()(const scene::Layer& layer, const scene::SliceLayer& slice);
    bool operator()(const scene::Layer& layer, const scene::SurfaceLayer& surface);
    bool operator()(const scene::Layer& layer, const scene::EdgesLayer& edges);
    bool operator()(const scene::Layer& layer, const scene::PointsLayer& points);
    bool operator()(const scene::Layer& layer, const scene::OutlineLayer& outline);
    bool operator()(const scene::Layer& layer, const scene::VolumeLayer& volume);
    bool operator()(const scene::Layer&, const scene::ClipLayer&) { return true; } // Geometry::clip and caps

private:
    [[nodiscard]] const store::Step& step() const { return dataset->steps()[out.step]; }
    // Looked at after each surface, so that a scene which is too large is never made.
    void count(std::size_t before, std::size_t after);
    void lack(const scene::Layer& layer, const char* what, const store::NotWritten& missing) const;
    void leave_out(const scene::Layer& layer, const store::NotWritten& missing) const;

    void add(Painted& painted, const std::shared_ptr<const Shape>& shape, const scene::Coloring& coloring,
             const scene::Layer& layer, bool lit, const OfArray& of = {});
    // The extremes of the cells that it was made from, and how many of them blew up.
    [[nodiscard]] std::vector<std::string> legend_lines(const std::string& scalar) const;
    // How many cells blew up, once for each array that is shown.
    void tell_left_out(const std::string& scalar, bool is_cut) const;
    // By its scalars, or in the solid color; and says where a scale has no place for them.
    void color(Drawable& drawable, const scene::Coloring& coloring, const scene::Layer& layer) const;
    void add_edges(Outlined& outlined, const std::shared_ptr<const Shape>& shape,
                   const std::optional<scene::LineStyle>& style, const scene::Layer& layer);
    Drawable& add_lines(const std::shared_ptr<const Shape>& shape, const scene::LineStyle& style,
                        const scene::Layer& layer, std::uint64_t identity, std::uint64_t revision);
    void add_contours(Contoured& contoured, const std::shared_ptr<const Shape>& shape,
                      const std::optional<scene::Contours>& contours, const scene::Layer& layer);

    // The field is measured from the mesh's origin, whatever the plane's, so that a plane that moves along its normal
    // is only another nu of the same field. Returns nu.
    double use_plane(Cut& cut, const std::array<double, 3>& origin, const std::array<double, 3>& normal);
    // Whose caps lie where the slice does, or null. It is cut just as they are: between vertices rounded in another
    // way, or the other way round, the one would show through the other here and there.
    [[nodiscard]] const scene::ClipLayer* cap_at(const scene::SliceLayer& slice) const;
    // In a side of the mesh for the same reason the very faces that surface layers have there. False when stopped.
    bool cut_along(Cut& cut, double nu) const;

    Boundary& boundary(const scene::Layer& layer, const std::string& key, std::size_t index = 0);
    [[nodiscard]] std::vector<std::uint8_t> cells_of(const scene::Threshold& threshold) const;
    // The state of what a layer shows of the mesh's cells; null where its threshold has no values.
    Boundary* solid(const scene::Layer& layer, const std::vector<std::string>& groups,
                    const std::optional<scene::Threshold>& threshold, std::string key);
    bool add_caps(const scene::Layer& layer, const scene::SurfaceLayer& surface, const Boundary& solid);

    [[nodiscard]] VolumeDrawable drawable_of(const scene::Layer& layer, const scene::VolumeLayer& volume,
                                             const VolumeCut& kept, std::size_t stride) const;
    [[nodiscard]] double unit_length_of(const scene::VolumeLayer& volume) const;
    [[nodiscard]] double mean_edge() const; // of the bounds
    [[nodiscard]] double diagonal() const;
};

// Keys of kept state.
[[nodiscard]] std::string bits_of(double number); // all its bits: a key, not a text
[[nodiscard]] std::string plane_name(const std::array<double, 3>& normal, const store::Step& step);

[[nodiscard]] std::array<float, 2> range_of(const store::Dataset& dataset, const std::string& scalar, std::size_t step);
// A vector's bare name with what it stands for, "U:magnitude"; other names as they are.
[[nodiscard]] std::string full_name(const store::Dataset& dataset, const std::string& scalar);

} // namespace ciel::geometry
