// Describes the text, legends and axes that are drawn over a picture.
#pragma once

#include "annotations/camera.hpp"
#include "color/color_scale.hpp"

#include <array>
#include <string>
#include <vector>

namespace server::annotations {

struct Legend {
    std::string name, units;
    color::ColorScale scale;
    std::string layers{}; // second line of text, which distinguishes legends with the same name; usually empty
    bool missing = false; // some colored points have no value, so the legend also shows the color of missing values
    std::vector<std::string> lines{}; // further lines of text, below `layers`
    // For a scale without width (both ends are equal): true writes the number at both ends, false writes it once.
    bool both_ends = false;
    // Size in pixels of the area at the legend's lower end that stays free for controls of the page. Height 0: no area.
    double control_width = 0, control_height = 0;
};

// All texts are UTF-8. Text that does not fit into the picture, or would overlap something, is shortened or left out. A
// character that the font lacks is drawn with another font of the machine, or as a box.
struct Annotations {
    std::string title;                 // centered at the top
    std::vector<std::string> captions; // lines at the upper left
    std::vector<Legend> legends;       // at the right, one below the other
    bool triad = false;                // arrows along x, y and z at the lower left
    bool axes = false;        // ticks and numbers along edges of the bounding box (Viewpoint::bounds_min, bounds_max)
    std::string length_units; // units of the numbers on the axes
    double scale = 1;         // all sizes are multiplied by `scale` and by size_of_picture()

    [[nodiscard]] bool empty() const { return title.empty() && captions.empty() && legends.empty() && !triad && !axes; }
};

struct AnnotatedPicture : Viewpoint {
    std::array<float, 3> background_top{}, background_bottom{}; // RGB, 0 to 1
    Annotations annotations;
};

// Returns the factor by which the sizes of annotations scale with the picture: min(height, 0.75 * width) / 720, which
// is 1 for 1280 x 720 pixels.
[[nodiscard]] double size_of_picture(int width, int height);

// Returns the Annotations::scale at which the font size is `pixels` pixels in a picture of this size.
[[nodiscard]] double scale_for_text(int width, int height, double pixels);

} // namespace server::annotations
