#include "page/functions.hpp"

#include "annotations/color_ticks.hpp"
#include "annotations/layout.hpp"
#include "annotations/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::page {
namespace {

using annotations::Box;
using annotations::Ink;

Vec3d vector(Reader& from) { return from.numbers<3>(); }

std::array<float, 3> color(Reader& from) {
    const auto rgb = from.numbers<3>();
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

annotations::Camera camera(Reader& from) {
    annotations::Camera camera;
    camera.position = vector(from);
    camera.target = vector(from);
    camera.up = vector(from);
    camera.fov_degrees = from.number();
    camera.parallel = from.flag();
    camera.parallel_height = from.number();
    return camera;
}

annotations::AnnotatedPicture picture(Reader& from) {
    annotations::AnnotatedPicture picture;
    picture.width = from.integer();
    picture.height = from.integer();
    const double text = from.number();
    picture.camera = camera(from);
    picture.bounds_min = vector(from);
    picture.bounds_max = vector(from);
    picture.background_top = color(from);
    picture.background_bottom = color(from);
    picture.annotations.triad = from.flag();
    picture.annotations.axes = from.flag();
    picture.annotations.length_units = from.text();
    picture.annotations.scale = annotations::scale_for_text(picture.width, picture.height, text);
    return picture;
}

Box box(Reader& from) {
    const auto sides = from.numbers<4>();
    return {sides[0], sides[1], sides[2], sides[3]};
}

void write(Writer& to, const Ink& ink) {
    for (const float channel : ink) to.number(channel);
}

void write(Writer& to, const Box& box) { to.numbers(std::array{box.left, box.top, box.right, box.bottom}); }

void write(Writer& to, const annotations::Plate& plate) {
    Ink middle{};
    for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = (plate.top[i] + plate.bottom[i]) / 2;
    write(to, plate.box);
    to.number(plate.edge);
    write(to, middle);
}

void write(Writer& to, const annotations::Stroke& stroke) {
    to.numbers(std::array{stroke.from.x, stroke.from.y, stroke.to.x, stroke.to.y, stroke.width});
    write(to, stroke.ink);
}

void write(Writer& to, const annotations::Triangle& triangle) {
    for (const annotations::Place& corner : triangle.corners) to.numbers(std::array{corner.x, corner.y});
    write(to, triangle.ink);
}

void write(Writer& to, const annotations::Label& label) {
    to.text(label.text);
    to.numbers(std::array<double, 3>{double(label.pixels), double(label.x), double(label.y)});
    write(to, label.ink);
    write(to, label.box);
}

template <class Item>
void write_list(Writer& to, const std::vector<Item>& items) {
    to.number(static_cast<double>(items.size()));
    for (const Item& item : items) write(to, item);
}

void write(Writer& to, const annotations::Overlay& overlay) {
    write_list(to, overlay.plates);
    write_list(to, overlay.strokes);
    write_list(to, overlay.triangles);
    write_list(to, overlay.labels);
    write(to, overlay.halo);
}

color::ColorScale color_scale(Reader& from) {
    color::ColorScale scale;
    scale.range = from.numbers<2>();
    scale.log = from.flag();
    scale.steps = from.integer();
    return scale;
}

} // namespace

void lay_out(Reader& arguments, annotations::TextMeasure& measure, Writer& results) {
    const annotations::AnnotatedPicture shown = picture(arguments);
    annotations::Overlay triad, axes;
    if (shown.width > 0 && shown.height > 0 && annotations::is_usable(shown.camera)) {
        annotations::Layout layout(shown, measure);
        triad.halo = axes.halo = layout.overlay.halo;
        for (int boxes = arguments.integer(); boxes > 0; --boxes) layout.take(box(arguments));
        if (shown.annotations.triad) annotations::lay_triad(layout, shown);
        std::swap(layout.overlay, triad);
        if (shown.annotations.axes) annotations::lay_axes(layout, shown);
        axes = std::move(layout.overlay);
    }
    write(results, triad);
    write(results, axes);
}

void color_ticks(Reader& arguments, Writer& results) {
    const color::ColorScale scale = color_scale(arguments);
    const int most = arguments.integer(), most_marks = arguments.integer();
    const auto ticks = annotations::color_ticks(scale, most, most_marks);
    results.number(static_cast<double>(ticks.size()));
    for (const annotations::ColorTick& tick : ticks) {
        results.number(tick.value);
        results.number(tick.at);
        results.text(tick.label);
    }
}

void label_on(Reader& arguments, Writer& results) {
    const color::ColorScale scale = color_scale(arguments);
    results.text(annotations::label_on(scale, arguments.number()));
}

void number_alone(Reader& arguments, Writer& results) {
    const double value = arguments.number();
    results.text(annotations::number_label(value, arguments.integer()));
}

void exponent_of(Reader& arguments, Writer& results) {
    results.number(annotations::exponent_of(color_scale(arguments)));
}

void times_power_of_ten(Reader& arguments, Writer& results) {
    results.text(annotations::times_power_of_ten(arguments.integer()));
}

void pretty_units(Reader& arguments, Writer& results) { results.text(annotations::pretty_units(arguments.text())); }

} // namespace ciel::page
