// The exports and imports of the WebAssembly module. The page writes arguments to `room(doubles)` and calls a function.
// The function returns the number of doubles to read from `results()`. The page must read them before its next call.
#include "page/functions.hpp"

// Functions that the page provides. Sizes are CSS pixels per em; results are CSS pixels.
[[clang::import_module("page"), clang::import_name("text_width")]] double
page_text_width(const char* utf8, std::size_t bytes, int pixels);
[[clang::import_module("page"), clang::import_name("ascent")]] int page_ascent(int pixels);
[[clang::import_module("page"), clang::import_name("descent")]] int page_descent(int pixels);
[[clang::import_module("page"), clang::import_name("digit_height")]] int page_digit_height(int pixels);

namespace {

using server::annotations::FontMetrics;

class PageText final : public server::annotations::TextMeasure {
public:
    FontMetrics metrics(int pixels) override {
        return {page_ascent(pixels), page_descent(pixels), page_digit_height(pixels)};
    }
    int width(std::string_view utf8, int pixels) override {
        return static_cast<int>(page_text_width(utf8.data(), utf8.size(), pixels) + 0.5);
    }
};

std::vector<double> arguments;
server::page::Writer written;

template <class Function>
std::size_t call(Function function) {
    server::page::Reader reader(arguments);
    written.clear();
    function(reader, written);
    return written.message().size();
}

} // namespace

[[clang::export_name("room")]] double* room(std::size_t doubles) {
    arguments.resize(doubles);
    return arguments.data();
}
[[clang::export_name("results")]] const double* results() { return written.message().data(); }

[[clang::export_name("lay_out")]] std::size_t lay_out() {
    PageText measure;
    return call([&](auto& in, auto& out) { server::page::lay_out(in, measure, out); });
}
[[clang::export_name("lay_texts")]] std::size_t lay_texts() {
    PageText measure;
    return call([&](auto& in, auto& out) { server::page::lay_texts(in, measure, out); });
}
[[clang::export_name("default_camera")]] std::size_t default_camera() { return call(server::page::default_camera); }
[[clang::export_name("label_on")]] std::size_t label_on() { return call(server::page::label_on); }
[[clang::export_name("number_alone")]] std::size_t number_alone() { return call(server::page::number_alone); }
[[clang::export_name("pretty_units")]] std::size_t pretty_units() { return call(server::page::pretty_units); }
[[clang::export_name("has_width")]] std::size_t has_width() { return call(server::page::has_width); }
[[clang::export_name("place_of")]] std::size_t place_of() { return call(server::page::place_of); }
[[clang::export_name("value_at")]] std::size_t value_at() { return call(server::page::value_at); }
[[clang::export_name("color_of")]] std::size_t color_of() { return call(server::page::color_of); }
[[clang::export_name("colors_along")]] std::size_t colors_along() { return call(server::page::colors_along); }
[[clang::export_name("color_row")]] std::size_t color_row() { return call(server::page::color_row); }
[[clang::export_name("scale_rules")]] std::size_t scale_rules() { return call(server::page::scale_rules); }
[[clang::export_name("named_background")]] std::size_t named_background() {
    return call(server::page::named_background);
}
[[clang::export_name("is_bright")]] std::size_t is_bright() { return call(server::page::is_bright); }
[[clang::export_name("range_of")]] std::size_t range_of() { return call(server::page::range_of); }
[[clang::export_name("range_above_zero")]] std::size_t range_above_zero() {
    return call(server::page::range_above_zero);
}
[[clang::export_name("is_shown_by")]] std::size_t is_shown_by() { return call(server::page::is_shown_by); }
[[clang::export_name("color_maps")]] std::size_t color_maps() { return call(server::page::color_maps); }
[[clang::export_name("legend_title")]] std::size_t legend_title() { return call(server::page::legend_title); }
[[clang::export_name("legend_name_of")]] std::size_t legend_name_of() { return call(server::page::legend_name_of); }
[[clang::export_name("legend_names")]] std::size_t legend_names() { return call(server::page::legend_names); }
