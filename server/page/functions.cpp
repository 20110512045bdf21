#include "page/functions.hpp"

#include "annotations/camera.hpp"
#include "annotations/color_ticks.hpp"
#include "annotations/layout.hpp"
#include "annotations/legend_names.hpp"
#include "annotations/ticks.hpp"
#include "color/background.hpp"
#include "color/color_tables.hpp"
#include "color/scale_range.hpp"
#include "color/scale_rules.hpp"

#include <algorithm>
#include <optional>

namespace server::page {
namespace {

using annotations::Box;
using annotations::Ink;

ciel::Vec3d vector(Reader& from) { return from.numbers<3>(); }

std::array<float, 3> color(Reader& from) {
    const auto rgb = from.numbers<3>();
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

annotations::ViewCamera camera(Reader& from) {
    annotations::ViewCamera camera;
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

void write(Writer& to, const annotations::Fill& fill) {
    write(to, fill.box);
    write(to, fill.top);
    write(to, fill.bottom);
}

void write(Writer& to, const annotations::Stroke& stroke) {
    to.numbers(std::array{stroke.from.x, stroke.from.y, stroke.to.x, stroke.to.y, stroke.width});
    write(to, stroke.ink);
}

void write(Writer& to, const annotations::Triangle& triangle) {
    for (const annotations::PicturePoint& corner : triangle.corners) to.numbers(std::array{corner.x, corner.y});
    write(to, triangle.ink);
}

void write(Writer& to, const annotations::Label& label) {
    to.text(label.text);
    to.numbers(std::array<double, 3>{double(label.pixels), double(label.x), double(label.y)});
    write(to, label.ink);
    write(to, label.box);
}

void write(Writer& to, const annotations::Handle& handle) {
    to.text(handle.id);
    write(to, handle.box);
}

void write(Writer& to, const color::Rgb8& color) {
    for (const std::uint8_t channel : color) to.number(channel);
}

void write(Writer& to, const std::string& text) { to.text(text); }

template <class Item>
void write_list(Writer& to, const std::vector<Item>& items) {
    to.number(static_cast<double>(items.size()));
    for (const Item& item : items) write(to, item);
}

void write(Writer& to, const annotations::Overlay& overlay) {
    write_list(to, overlay.plates);
    write_list(to, overlay.fills);
    write_list(to, overlay.strokes);
    write_list(to, overlay.triangles);
    write_list(to, overlay.labels);
    write_list(to, overlay.handles);
    write(to, overlay.halo);
}

color::ColorScale scale_of_values(Reader& from) {
    color::ColorScale scale;
    scale.range = from.numbers<2>();
    scale.log = from.flag();
    scale.steps = from.integer();
    return scale;
}

color::Rgb8 bytes(Reader& from) {
    color::Rgb8 rgb{};
    for (std::uint8_t& channel : rgb) channel = static_cast<std::uint8_t>(from.integer());
    return rgb;
}

std::optional<color::Rgb8> bytes_if_any(Reader& from) {
    return from.flag() ? std::optional(bytes(from)) : std::nullopt;
}

template <class Read>
auto list(Reader& from, const Read& read) {
    std::vector<decltype(read(from))> items;
    for (int count = from.integer(); count > 0; --count) items.push_back(read(from));
    return items;
}

std::string text(Reader& from) { return from.text(); }

color::ColorScale color_scale(Reader& from) {
    color::ColorScale scale = scale_of_values(from);
    scale.map = from.text();
    scale.points = list(from, [](Reader& each) {
        const double at = each.number();
        return color::ColorPoint{at, bytes(each)};
    });
    scale.reverse = from.flag();
    scale.nan = bytes(from);
    scale.below = bytes_if_any(from);
    scale.above = bytes_if_any(from);
    return scale;
}

color::RangeChoice range_choice(Reader& from) {
    color::RangeChoice choice;
    if (from.flag()) choice.given = from.numbers<2>();
    choice.symmetric = from.flag();
    choice.log = from.flag();
    return choice;
}

annotations::Legend legend(Reader& from) {
    annotations::Legend legend;
    legend.name = from.text();
    legend.units = from.text();
    legend.scale = color_scale(from);
    legend.layers = from.text();
    legend.missing = from.flag();
    legend.both_ends = from.flag();
    legend.lines = list(from, text);
    legend.control_width = from.number();
    legend.control_height = from.number();
    return legend;
}

} // namespace

void lay_texts(Reader& arguments, annotations::TextMeasure& measure, Writer& results) {
    annotations::AnnotatedPicture shown;
    shown.width = arguments.integer();
    shown.height = arguments.integer();
    shown.annotations.scale = annotations::scale_for_text(shown.width, shown.height, arguments.number());
    shown.background_top = color(arguments);
    shown.background_bottom = color(arguments);
    shown.annotations.title = arguments.text();
    shown.annotations.captions = list(arguments, text);
    shown.annotations.legends = list(arguments, legend);
    if (shown.width <= 0 || shown.height <= 0) {
        write(results, annotations::Overlay{});
        return write_list(results, std::vector<Box>{});
    }
    annotations::Layout layout(shown, measure);
    annotations::lay_title(layout, shown.annotations);
    annotations::lay_captions(layout, shown.annotations);
    annotations::lay_legends(layout, shown.annotations);
    write(results, layout.overlay);
    write_list(results, layout.taken());
}

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

void default_camera(Reader& arguments, Writer& results) {
    const ciel::Vec3d low = vector(arguments), high = vector(arguments);
    const double aspect = arguments.number();
    const annotations::ViewCamera camera = annotations::default_camera(low, high, aspect, arguments.number());
    results.numbers(camera.position);
    results.numbers(camera.target);
    results.numbers(camera.up);
    results.number(camera.parallel_height);
}

void label_on(Reader& arguments, Writer& results) {
    const color::ColorScale scale = scale_of_values(arguments);
    results.text(annotations::label_on(scale, arguments.number()));
}

void number_alone(Reader& arguments, Writer& results) {
    const double value = arguments.number();
    results.text(annotations::number_label(value, arguments.integer()));
}

void pretty_units(Reader& arguments, Writer& results) { results.text(annotations::pretty_units(arguments.text())); }

void has_width(Reader& arguments, Writer& results) {
    results.number(color::has_width(scale_of_values(arguments)) ? 1 : 0);
}

void place_of(Reader& arguments, Writer& results) {
    const color::ColorScale scale = scale_of_values(arguments);
    results.number(color::place_of(scale, arguments.number()));
}

void value_at(Reader& arguments, Writer& results) {
    const color::ColorScale scale = scale_of_values(arguments);
    results.number(color::value_at(scale, arguments.number()));
}

void color_of(Reader& arguments, Writer& results) {
    const color::ColorScale scale = color_scale(arguments);
    write(results, color::color_of(scale, arguments.number()));
}

void colors_along(Reader& arguments, Writer& results) {
    const color::ColorScale scale = color_scale(arguments);
    write_list(results, color::colors_along(scale, arguments.integer()));
}

void color_row(Reader& arguments, Writer& results) {
    const color::ColorScale scale = color_scale(arguments);
    write_list(results, color::color_row(scale, arguments.integer()));
}

void scale_rules(Reader& arguments, Writer& results) {
    const color::ScaleRules rules = color::scale_rules(color_scale(arguments));
    results.number(rules.origin);
    for (const auto& texel : rules.texels)
        for (const float channel : texel) results.number(channel);
}

void named_background(Reader& arguments, Writer& results) {
    const color::Background background = arguments.text() == "light" ? color::light_background : color::dark_background;
    for (const auto& end : {background.top, background.bottom})
        for (const float channel : end) results.number(channel);
}

void is_bright(Reader& arguments, Writer& results) {
    const auto top = color(arguments);
    const auto bottom = color(arguments);
    results.number(color::is_bright({top, bottom}));
}

void range_of(Reader& arguments, Writer& results) {
    const color::RangeChoice choice = range_choice(arguments);
    results.numbers(color::range_of(choice, arguments.numbers<2>()));
}

void range_above_zero(Reader& arguments, Writer& results) {
    results.numbers(color::range_above_zero(arguments.numbers<2>()));
}

void is_shown_by(Reader& arguments, Writer& results) {
    const color::RangeChoice choice = range_choice(arguments);
    results.number(color::is_shown_by(choice, arguments.numbers<2>()) ? 1 : 0);
}

void color_maps(Reader& /*arguments*/, Writer& results) {
    results.number(static_cast<double>(color::color_tables().size()));
    for (const color::NamedColors& map : color::color_tables()) {
        results.text(map.name);
        results.text(map.kind);
    }
}

void legend_title(Reader& arguments, Writer& results) {
    const color::ColorScale scale = scale_of_values(arguments);
    const std::string array = arguments.text();
    results.text(annotations::legend_title(array, arguments.text(), scale));
}

void legend_name_of(Reader& arguments, Writer& results) {
    annotations::NamedLayer layer;
    layer.type = arguments.text();
    layer.contours = arguments.flag();
    layer.array = arguments.text();
    layer.origin = vector(arguments);
    layer.normal = vector(arguments);
    layer.groups = list(arguments, text);
    results.text(annotations::legend_name_of(layer));
}

void legend_names(Reader& arguments, Writer& results) {
    const auto legends = list(arguments, [](Reader& each) {
        annotations::NamedLegend legend;
        legend.array = each.text();
        legend.names = list(each, text);
        return legend;
    });
    write_list(results, annotations::legend_names(legends));
}

} // namespace server::page
