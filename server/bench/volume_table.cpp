// Measures pictures of a volume with 100 slices and 1024 x 1024 pixels, while the camera turns around the volume.
#include "bench/volume_pictures.hpp"
#include "geometry/volume_cut.hpp"

#include <algorithm>

namespace server::bench {

namespace {

constexpr double turn_degrees = 3;

const char* style(bool shaded) { return shaded ? "shaded" : "unshaded"; }

// The caller must set the camera first, because measuring turns it by an angle that depends on the number of runs.
void add_figures(Table& table, VolumePictures& pictures, const std::string& of, std::size_t stride = 1) {
    (void)pictures.draw(false, stride);
    const double share = pictures.covered_share(), samples = pictures.samples();
    constexpr double pixels = double{VolumePictures::side} * VolumePictures::side;
    table.figures.push_back({of + ": picture covered", 100 * share, "%"});
    table.figures.push_back({of + ": samples", samples, ""});
    const double resolution = pictures.volume().coarseness;
    table.figures.push_back(
        {of + ": samples a covered pixel", samples * resolution * resolution / std::max(1.0, share * pixels), ""});
}

} // namespace

Table volume_table(const Case& data) {
    Table table{"volume", {}, {}};
    VolumePictures pictures(data);
    const ciel::Vec3d box{0, 1, 0};
    table.rows.push_back(measure("cut box-aligned", [&] { return pictures.cut(box); }));
    const render::Volume& volume = pictures.volume();
    const double loss = geometry::largest_loss(volume.opacity_points, volume.unit_length,
                                               volume.thickness * static_cast<double>(volume.slices.size()));
    const std::size_t preview_stride = geometry::moving_stride(VolumePictures::slice_count, data.values.size(), loss);
    for (const bool shaded : {true, false}) {
        pictures.turn_back();
        table.rows.push_back(measure(
            std::string("box-aligned, ") + style(shaded) + ", draw", [&] { return pictures.draw(shaded); },
            [&] { pictures.turn(turn_degrees); }));
    }
    pictures.turn_back();
    add_figures(table, pictures, "box-aligned");
    pictures.add_up_in_bytes(true);
    table.rows.push_back(measure(
        "box-aligned, unshaded, in bytes, draw", [&] { return pictures.draw(false); },
        [&] { pictures.turn(turn_degrees); }));
    pictures.add_up_in_bytes(false);
    for (const bool shaded : {true, false}) {
        pictures.turn_back();
        table.rows.push_back(measure(
            std::string("preview, ") + style(shaded) + ", draw", [&] { return pictures.draw(shaded, preview_stride); },
            [&] { pictures.turn(turn_degrees); }));
    }
    pictures.turn_back();
    add_figures(table, pictures, "preview", preview_stride);
    table.rows.push_back(measure(
        "cut screen-aligned", [&] { return pictures.cut_across_view(); }, [&] { pictures.turn(turn_degrees); }));
    for (const bool shaded : {true, false}) {
        pictures.turn_back();
        table.rows.push_back(measure(
            std::string("screen-aligned, ") + style(shaded) + ", draw", [&] { return pictures.draw(shaded); },
            [&] {
                pictures.turn(turn_degrees);
                (void)pictures.cut_across_view();
            }));
    }
    pictures.turn_back();
    (void)pictures.cut_across_view();
    add_figures(table, pictures, "screen-aligned");
    return table;
}

} // namespace server::bench
