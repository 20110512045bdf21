// What is written over a picture, beside what it shows.
#pragma once

#include "annotations/camera.hpp"
#include "color/color_scale.hpp"

#include <array>
#include <string>
#include <vector>

namespace ciel::annotations {

struct Legend { // one color bar
    std::string name, units;
    color::ColorScale scale;
    std::string layers{};             // a second line, which tells it from another legend of that name; mostly empty
    bool missing = false;             // what is colored has places without a value: their color is shown, too
    std::vector<std::string> lines{}; // further ones below `layers`
};

// Text is UTF-8 and may hold anything: what the font lacks is taken from another one of the machine, and what none has
// is shown as a box. What does not fit into the picture, or would lie on something else, is shortened or left out, so
// that a picture of any size can be drawn.
struct Annotations {
    std::string title;                 // centred at the top
    std::vector<std::string> captions; // lines at the upper left
    std::vector<Legend> legends;       // at the right, one below the other
    bool triad = false;                // where x, y and z point, at the lower left
    bool axes = false;                 // ticks and numbers along the edges of the frame's bounds
    std::string length_units;          // of the numbers on the axes
    double scale = 1;                  // of all sizes, on top of the picture's own

    [[nodiscard]] bool empty() const { return title.empty() && captions.empty() && legends.empty() && !triad && !axes; }
};

// A picture before it is written on: what stands over it depends on no more than this.
struct AnnotatedPicture : Viewpoint {
    std::array<float, 3> background_top{}, background_bottom{}; // RGB, 0 to 1
    Annotations annotations;
};

// Where one of 1280 x 720 pixels has 1; text is so much larger. Of a narrow picture the width decides.
[[nodiscard]] double size_of_picture(int width, int height);

} // namespace ciel::annotations
