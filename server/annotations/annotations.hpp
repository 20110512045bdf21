// Text, legends and axes drawn over a picture.
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
    std::string layers{};             // second line, distinguishes legends of the same name; usually empty
    bool missing = false;             // some colored places have no value: the legend also shows their color
    std::vector<std::string> lines{}; // more lines below `layers`
    bool both_ends = false; // a number at both ends even if the scale has no width; else one number stands for both
    // Pixels kept free at the lower end for controls of the page.
    double control_width = 0, control_height = 0;
};

// Text is arbitrary UTF-8. Characters missing in the font come from another font of the machine, else a box is drawn.
// Text that does not fit or would overlap something is shortened or left out, so pictures of any size can be drawn.
struct Annotations {
    std::string title;                 // centered at the top
    std::vector<std::string> captions; // lines at the upper left
    std::vector<Legend> legends;       // at the right, one below the other
    bool triad = false;                // arrows along x, y and z at the lower left
    bool axes = false;                 // ticks and numbers along the edges of the frame's bounds
    std::string length_units;          // units of the numbers on the axes
    double scale = 1;                  // factor on all sizes, in addition to size_of_picture()

    [[nodiscard]] bool empty() const { return title.empty() && captions.empty() && legends.empty() && !triad && !axes; }
};

// All inputs for the layout of a picture's annotations.
struct AnnotatedPicture : Viewpoint {
    std::array<float, 3> background_top{}, background_bottom{}; // RGB, 0 to 1
    Annotations annotations;
};

// Returns the scale factor of text: 1 for 1280 x 720 pixels. It is proportional to the height, or to the width in
// narrow pictures.
[[nodiscard]] double size_of_picture(int width, int height);

// Returns the Annotations::scale at which text has `pixels` pixels in a picture of this size.
[[nodiscard]] double scale_for_text(int width, int height, double pixels);

} // namespace ciel::annotations
