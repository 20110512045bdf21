// Interface by which the layout measures text. The code that draws text implements it.
#pragma once

#include <string_view>

namespace server::annotations {

struct FontMetrics { // pixels, all positive
    int ascent = 0, descent = 0;
    int digit = 0; // height of a digit above the base line
};

// Use a TextMeasure on one thread only. `pixels`: font size per em. Every function may throw Error without a font.
class TextMeasure {
public:
    virtual ~TextMeasure() = default;
    [[nodiscard]] virtual FontMetrics metrics(int pixels) = 0;
    [[nodiscard]] virtual int width(std::string_view utf8, int pixels) = 0; // pixels
};

} // namespace server::annotations
