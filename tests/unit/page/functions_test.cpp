#include "page/functions.hpp"

#include "annotations/camera.hpp"
#include "annotations/overlay.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <map>

namespace server::page {
namespace {

using testing::ElementsAre;

class Digits final : public annotations::TextMeasure { // every character is half an em wide
public:
    annotations::FontMetrics metrics(int pixels) override { return {pixels, pixels / 4, 3 * pixels / 4}; }
    int width(std::string_view utf8, int pixels) override { return static_cast<int>(utf8.size()) * pixels / 2; }
};

struct Label {
    std::string text;
    annotations::Box box;
};

struct Overlay {
    std::size_t plates = 0, fills = 0, strokes = 0, triangles = 0;
    std::vector<Label> labels;
    std::vector<annotations::Handle> handles;
};

annotations::Box read_box(Reader& from) {
    const auto box = from.numbers<4>();
    return {box[0], box[1], box[2], box[3]};
}

Overlay read_overlay(Reader& from) {
    Overlay overlay;
    const auto skip = [&](int numbers) {
        const int count = from.integer();
        for (int i = 0; i < count * numbers; ++i) (void)from.number();
        return static_cast<std::size_t>(count);
    };
    overlay.plates = skip(4 + 1 + 4);
    overlay.fills = skip(4 + 4 + 4);
    overlay.strokes = skip(2 + 2 + 1 + 4);
    overlay.triangles = skip(6 + 4);
    for (int labels = from.integer(); labels > 0; --labels) {
        Label label{from.text(), {}};
        for (int i = 0; i < 3 + 4; ++i) (void)from.number();
        label.box = read_box(from);
        overlay.labels.push_back(label);
    }
    for (int handles = from.integer(); handles > 0; --handles) {
        std::string id = from.text();
        overlay.handles.push_back({std::move(id), read_box(from)});
    }
    (void)from.numbers<4>(); // skips the color of the halo
    return overlay;
}

struct View {
    bool triad = true, axes = true;
    double field_of_view = 30;
    std::vector<annotations::Box> taken{};

    [[nodiscard]] std::array<Overlay, 2> laid_out() const {
        Writer arguments;
        arguments.numbers(std::array<double, 3>{800, 600, 12});
        arguments.numbers(std::array<double, 9>{4, -8, 4, 0, 0, 0, 0, 0, 1});
        arguments.numbers(std::array<double, 3>{field_of_view, 0, 1});
        arguments.numbers(std::array<double, 6>{-1, -1, -1, 1, 1, 1});
        arguments.numbers(std::array<double, 6>{});
        arguments.number(triad ? 1 : 0);
        arguments.number(axes ? 1 : 0);
        arguments.text("m^2");
        arguments.number(static_cast<double>(taken.size()));
        for (const auto& box : taken) arguments.numbers(std::array{box.left, box.top, box.right, box.bottom});
        Reader reader(arguments.message());
        Writer results;
        Digits measure;
        lay_out(reader, measure, results);
        Reader found(results.message());
        return {read_overlay(found), read_overlay(found)};
    }
};

std::vector<std::string> texts(const Overlay& overlay) {
    std::vector<std::string> all;
    for (const Label& label : overlay.labels) all.push_back(label.text);
    return all;
}

TEST(PageFunctions, LayOutTheTriadAndTheAxes) {
    const auto [triad, axes] = View().laid_out();
    EXPECT_THAT(texts(triad), testing::UnorderedElementsAre("x", "y", "z"));
    EXPECT_EQ(triad.triangles, 3U);
    EXPECT_THAT(texts(axes), testing::IsSupersetOf({"−1", "0", "1", "x [m²]", "y [m²]", "z [m²]"}));
    EXPECT_EQ(axes.plates, axes.labels.size());
}

TEST(PageFunctions, LayOutOnlyWhatIsAskedFor) {
    const auto [triad, axes] = View{.triad = false, .axes = false}.laid_out();
    EXPECT_TRUE(triad.labels.empty());
    EXPECT_EQ(axes.strokes, 0U);
}

TEST(PageFunctions, KeepOffTakenBoxes) {
    const annotations::Box left_half{0, 0, 400, 600};
    const auto [triad, axes] = View{.taken = {left_half}}.laid_out();
    EXPECT_TRUE(triad.labels.empty()) << "the triad stands at the lower left";
    EXPECT_FALSE(axes.labels.empty());
    for (const Label& label : axes.labels) EXPECT_FALSE(label.box.overlaps(left_half)) << label.text;
}

TEST(PageFunctions, DrawNothingForAnUnusableCamera) {
    const auto [triad, axes] = View{.field_of_view = 0}.laid_out();
    EXPECT_TRUE(triad.labels.empty());
    EXPECT_TRUE(axes.labels.empty());
}

struct Color {
    double red, green, blue;
};

// Arguments of lay_texts: a title, a caption, and a legend that has color points, all colors and a line.
std::vector<double> texts_of(bool missing, double control_height) {
    Writer arguments;
    const auto put = [&](const Color& color) { arguments.numbers(std::array{color.red, color.green, color.blue}); };
    arguments.numbers(std::array<double, 9>{800, 600, 12});
    arguments.text("Title");
    arguments.number(1);
    arguments.text("caption");
    arguments.number(1);
    arguments.text("U");
    arguments.text("m/s");
    arguments.numbers(std::array<double, 4>{0, 10, 0, 2});
    arguments.text("viridis");
    arguments.number(2);
    for (const double at : {0.0, 1.0}) {
        arguments.number(at);
        put({255 * at, 0, 0});
    }
    arguments.number(0);
    put({1, 2, 3});
    for (int outside = 0; outside < 2; ++outside) {
        arguments.number(1);
        put({4, 5, 6});
    }
    arguments.text("Boundary");
    arguments.numbers(std::array<double, 3>{missing ? 1.0 : 0.0, 0, 1});
    arguments.text("cells: 0 to 11");
    arguments.numbers(std::array<double, 2>{200, control_height});
    return {arguments.message().begin(), arguments.message().end()};
}

struct Texts {
    Overlay overlay;
    std::vector<annotations::Box> taken;
};

Texts laid_texts(const std::vector<double>& arguments) {
    Reader reader(arguments);
    Writer results;
    Digits measure;
    lay_texts(reader, measure, results);
    Reader found(results.message());
    Texts texts{read_overlay(found), {}};
    for (int boxes = found.integer(); boxes > 0; --boxes) texts.taken.push_back(read_box(found));
    return texts;
}

TEST(PageFunctions, LayOutTitleCaptionsAndLegends) {
    const Texts found = laid_texts(texts_of(true, 30));
    EXPECT_THAT(texts(found.overlay), testing::IsSupersetOf({"Title", "caption", "U [m/s]", "Boundary",
                                                             "cells: 0 to 11", "0", "5", "10", "no value"}));
    // Three borders, two colors outside the range, two steps, and the missing values with their border.
    EXPECT_EQ(found.overlay.fills, 3U + 2 + 2 + 2);
    std::vector<std::string> ids;
    for (const annotations::Handle& handle : found.overlay.handles) ids.push_back(handle.id);
    EXPECT_THAT(ids, testing::UnorderedElementsAre("legend 0", "legend 0 low", "legend 0 high", "legend 0 controls"));
    for (const Label& label : found.overlay.labels)
        EXPECT_THAT(found.taken, testing::Contains(
                                     testing::Truly([&](const annotations::Box& box) { return box.holds(label.box); })))
            << label.text;
}

TEST(PageFunctions, KeepNoRoomForControlsThatAreNotThere) {
    const auto height = [](const Texts& texts) {
        for (const annotations::Handle& handle : texts.overlay.handles)
            if (handle.id == "legend 0") return handle.box.height();
        return 0.0;
    };
    EXPECT_NEAR(height(laid_texts(texts_of(false, 30))) - height(laid_texts(texts_of(false, 0))), 30 + 0.35 * 12, 0.01);
}

TEST(PageFunctions, LayOutNoTextsInAPictureWithoutPixels) {
    std::vector<double> arguments = texts_of(false, 0);
    arguments[0] = 0;
    const Texts found = laid_texts(arguments);
    EXPECT_TRUE(found.overlay.labels.empty());
    EXPECT_TRUE(found.taken.empty());
}

template <class Function>
Reader results_of(Function function, Writer& results, const std::vector<double>& arguments) {
    Reader reader(arguments);
    results.clear();
    function(reader, results);
    return Reader(results.message());
}

TEST(PageFunctions, GiveTheDefaultCamera) {
    Writer results;
    Reader found = results_of(default_camera, results, {1, 2, 3, 4, 6, 9, 1.5, 40});
    const annotations::ViewCamera camera = annotations::default_camera({1, 2, 3}, {4, 6, 9}, 1.5, 40);
    EXPECT_EQ(found.numbers<3>(), camera.position);
    EXPECT_EQ(found.numbers<3>(), (ciel::Vec3d{2.5, 4, 6}));
    EXPECT_EQ(found.numbers<3>(), camera.up);
    EXPECT_EQ(found.number(), camera.parallel_height);
}

TEST(PageFunctions, MakeTexts) {
    Writer results;
    EXPECT_EQ(results_of(label_on, results, {0, 10, 0, 0, -2.5}).text(), "−2.5");
    EXPECT_EQ(results_of(number_alone, results, {1e9, 6}).text(), "10⁹");
}

TEST(PageFunctions, GiveValuesTheirPlaces) {
    Writer results;
    EXPECT_EQ(results_of(has_width, results, {0, 10, 0, 0}).number(), 1);
    EXPECT_EQ(results_of(has_width, results, {5, 5, 0, 0}).number(), 0);
    EXPECT_EQ(results_of(place_of, results, {0, 10, 0, 0, 2.5}).number(), 0.25);
    EXPECT_DOUBLE_EQ(results_of(value_at, results, {1, 100, 1, 0, 0.5}).number(), 10);
}

// Arguments: a color scale from 0 to 10 with two color points, reversed if asked for, then `last`.
std::vector<double> scale_with_points(bool reverse, int steps, double last) {
    Writer arguments;
    arguments.numbers(std::array<double, 4>{0, 10, 0, static_cast<double>(steps)});
    arguments.text("viridis");
    arguments.numbers(std::array<double, 9>{2, 0, 0, 0, 0, 1, 200, 100, 50});
    arguments.numbers(std::array<double, 4>{reverse ? 1.0 : 0.0, 1, 2, 3});
    arguments.numbers(std::array<double, 6>{1, 7, 8, 9, 0, last});
    return {arguments.message().begin(), arguments.message().end()};
}

using Color3 = std::array<double, 3>;

std::vector<Color3> colors_of(Reader results) {
    std::vector<Color3> colors;
    for (int count = results.integer(); count > 0; --count) colors.push_back(results.numbers<3>());
    return colors;
}

TEST(PageFunctions, GiveValuesTheirColors) {
    Writer results;
    const Color3 black{0, 0, 0}, middle{100, 50, 25}, last{200, 100, 50};
    EXPECT_EQ(results_of(color_of, results, scale_with_points(false, 0, 5)).numbers<3>(), middle);
    EXPECT_EQ(results_of(color_of, results, scale_with_points(true, 0, 10)).numbers<3>(), black);
    EXPECT_EQ(results_of(color_of, results, scale_with_points(false, 0, -1)).numbers<3>(), (Color3{7, 8, 9}));
    EXPECT_EQ(results_of(color_of, results, scale_with_points(false, 0, NAN)).numbers<3>(), (Color3{1, 2, 3}));
    EXPECT_THAT(colors_of(results_of(colors_along, results, scale_with_points(false, 0, 3))),
                ElementsAre(black, middle, last));
    EXPECT_THAT(colors_of(results_of(colors_along, results, scale_with_points(false, 2, 3))),
                ElementsAre(black, last, last));
    EXPECT_THAT(colors_of(results_of(color_row, results, scale_with_points(true, 2, 9))), ElementsAre(last, black));
}

TEST(PageFunctions, MakeTexelsForShaders) {
    Writer results;
    Reader found = results_of(scale_rules, results, scale_with_points(false, 4, 0));
    EXPECT_EQ(found.number(), 0);
    EXPECT_THAT(found.numbers<4>(), ElementsAre(0, 0.1F, 4, 0));
    EXPECT_EQ(results.message().size(), 1U + 5 * 4);
}

TEST(PageFunctions, TellOfBackgrounds) {
    Writer results, light;
    light.text("light");
    Reader found = results_of(named_background, results, {light.message().begin(), light.message().end()});
    EXPECT_THAT(found.numbers<3>(), ElementsAre(1, 1, 1));
    EXPECT_THAT(found.numbers<3>(), ElementsAre(0.90F, 0.92F, 0.95F));
    EXPECT_EQ(results_of(is_bright, results, {1, 1, 1, 0, 0, 0}).number(), 1);
    EXPECT_EQ(results_of(is_bright, results, {0, 0, 0, 0.9, 0.9, 0.9}).number(), 0);
}

TEST(PageFunctions, ChooseRanges) {
    Writer results;
    const auto ends = [&](void (*function)(Reader&, Writer&), const std::vector<double>& arguments) {
        return results_of(function, results, arguments).numbers<2>();
    };
    EXPECT_THAT(ends(range_of, {0, 0, 0, -3, 8}), ElementsAre(-3, 8));
    EXPECT_THAT(ends(range_of, {1, -5, 2, 1, 0, -3, 8}), ElementsAre(-5, 5));
    EXPECT_THAT(ends(range_of, {0, 0, 1, -3, 8}), ElementsAre(8e-6, 8));
    EXPECT_THAT(ends(range_above_zero, {0, 2000}), ElementsAre(0.002, 2000));
    EXPECT_EQ(results_of(is_shown_by, results, {0, 0, 1, -3, 0}).number(), 0);
    EXPECT_EQ(results_of(is_shown_by, results, {1, 1, 2, 0, 1, -3, 0}).number(), 1);
}

TEST(PageFunctions, TellTheColorMaps) {
    Writer results;
    Reader found = results_of(color_maps, results, {});
    std::map<std::string, std::string> kinds;
    const int count = found.integer();
    for (int i = 0; i < count; ++i) {
        std::string name = found.text();
        kinds[std::move(name)] = found.text();
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(count));
    EXPECT_THAT(kinds, testing::IsSupersetOf({std::pair<const std::string, std::string>("viridis", "sequential"),
                                              {"vik", "diverging"},
                                              {"twilight", "cyclic"}}));
}

TEST(PageFunctions, NameLegends) {
    Writer arguments, results;
    arguments.numbers(std::array<double, 4>{0, 1e9, 0, 0});
    arguments.text("p");
    arguments.text("Pa");
    const auto message = [&] { return std::vector<double>(arguments.message().begin(), arguments.message().end()); };
    EXPECT_EQ(results_of(legend_title, results, message()).text(), "p [Pa] ×10⁹");
    arguments.clear();
    arguments.text("slice");
    arguments.number(1);
    arguments.text("");
    arguments.numbers(std::array<double, 7>{1, 2, 3, 0, 1, 0, 0});
    EXPECT_EQ(results_of(legend_name_of, results, message()).text(), "Lines on slice at y = 2");
    arguments.clear();
    arguments.text("surface");
    arguments.number(0);
    arguments.text("");
    arguments.numbers(std::array<double, 7>{0, 0, 0, 0, 0, 0, 1});
    arguments.text("inlet");
    EXPECT_EQ(results_of(legend_name_of, results, message()).text(), "Boundary: inlet");
    arguments.clear();
    arguments.number(2);
    for (const char* name : {"Edges", "Points"}) {
        arguments.text("p");
        arguments.number(1);
        arguments.text(name);
    }
    Reader found = results_of(legend_names, results, message());
    EXPECT_EQ(found.integer(), 2);
    EXPECT_EQ(found.text(), "Edges");
    EXPECT_EQ(found.text(), "Points");
}

TEST(PageMessage, ATextBeyondTheEndIsEmpty) {
    for (const double bytes : {1e18, -1.0, 17.0}) {
        const std::vector<double> message{bytes, 0};
        Reader reader(message);
        EXPECT_EQ(reader.text(), "") << bytes;
    }
    Reader nothing({});
    EXPECT_EQ(nothing.number(), 0);
    EXPECT_EQ(nothing.text(), "");
}

TEST(PageMessage, TextsOfAnyLengthComeBack) {
    for (std::size_t length = 0; length < 20; ++length) {
        Writer writer;
        const std::string text(length, 'a');
        writer.text(text);
        writer.number(7);
        Reader reader(writer.message());
        EXPECT_EQ(reader.text(), text);
        EXPECT_EQ(reader.number(), 7);
    }
}

} // namespace
} // namespace server::page
