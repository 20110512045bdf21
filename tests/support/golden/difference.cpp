#include "support/golden/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace ciel::test {
namespace {

constexpr int tile = 16;

struct Lab {
    float l = 0, a = 0, b = 0;
};

double distance(const Lab& p, const Lab& q) {
    return std::hypot(static_cast<double>(p.l - q.l), static_cast<double>(p.a - q.a), static_cast<double>(p.b - q.b));
}

// Linear light of each sRGB byte (IEC 61966-2-1).
const std::array<double, 256>& linear() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> out{};
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double value = static_cast<double>(i) / 255;
            out[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        }
        return out;
    }();
    return table;
}

// CIE 15: cube root, with a linear piece for dark values.
double lightness_curve(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }

Lab lab_of(const std::uint8_t* rgb) {
    const double r = linear()[rgb[0]];
    const double g = linear()[rgb[1]];
    const double b = linear()[rgb[2]];
    const double x = lightness_curve((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = lightness_curve(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = lightness_curve((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {static_cast<float>(116 * y - 16), static_cast<float>(500 * (x - y)), static_cast<float>(200 * (y - z))};
}

struct LabPicture {
    int width, height;
    std::vector<Lab> pixels;

    explicit LabPicture(const Picture& picture)
        : width(picture.width), height(picture.height), pixels(picture.pixels()) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const std::uint8_t* rgb = &picture.rgb[3 * i];
            const bool is_as_before = i > 0 && std::equal(rgb, rgb + 3, rgb - 3);
            pixels[i] = is_as_before ? pixels[i - 1] : lab_of(rgb);
        }
    }
    [[nodiscard]] const Lab& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] Lab mean(int left, int top) const { // mean of the tile at (left, top)
        const int right = std::min(left + tile, width);
        const int bottom = std::min(top + tile, height);
        double l = 0, a = 0, b = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                l += at(x, y).l;
                a += at(x, y).a;
                b += at(x, y).b;
            }
        const double count = static_cast<double>(right - left) * (bottom - top);
        return {static_cast<float>(l / count), static_cast<float>(a / count), static_cast<float>(b / count)};
    }
};

void find_shift(const LabPicture& a, const LabPicture& b, Difference& found) {
    for (int top = 0; top < a.height; top += tile)
        for (int left = 0; left < a.width; left += tile) {
            const double shift = distance(a.mean(left, top), b.mean(left, top));
            if (shift <= found.shift) continue;
            found.shift = shift;
            found.shift_x = left;
            found.shift_y = top;
        }
}

bool is_found_near(const Lab& color, const LabPicture& picture, int x, int y) {
    for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u)
            if (distance(color, picture.at(u, v)) <= Tolerance::color) return true;
    return false;
}

double share_off(const LabPicture& a, const LabPicture& b) {
    std::size_t off = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            if (!is_found_near(a.at(x, y), b, x, y) || !is_found_near(b.at(x, y), a, x, y)) ++off;
    return static_cast<double>(off) / static_cast<double>(a.pixels.size());
}

void check(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size() || a.rgb.size() != 3 * a.pixels())
        throw std::invalid_argument("pictures of different sizes are not compared");
}

} // namespace

Difference difference(const Picture& a, const Picture& b) {
    check(a, b);
    Difference found;
    if (a.rgb == b.rgb) return found;
    const LabPicture first(a);
    const LabPicture second(b);
    find_shift(first, second, found);
    found.share = share_off(first, second);
    return found;
}

bool is_within(const Difference& difference, const Tolerance& tolerance) {
    return difference.shift <= tolerance.shift && difference.share <= tolerance.share;
}

Picture difference_picture(const Picture& a, const Picture& b) {
    check(a, b);
    const LabPicture first(a);
    const LabPicture second(b);
    Picture out{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
        const auto grey = static_cast<std::uint8_t>(64 + first.pixels[i].l / 2);
        const auto off = static_cast<int>(std::min(255.0, 25 * distance(first.pixels[i], second.pixels[i])));
        out.rgb[3 * i] = static_cast<std::uint8_t>(std::max<int>(grey, off));
        out.rgb[3 * i + 1] = out.rgb[3 * i + 2] = static_cast<std::uint8_t>(std::max(0, grey - off));
    }
    return out;
}

std::string words(const Difference& difference, const Tolerance& tolerance) {
    std::ostringstream out;
    out << "the tile at " << difference.shift_x << ", " << difference.shift_y << " changed its mean color by "
        << difference.shift << " (" << tolerance.shift << " may be), " << 100 * difference.share
        << " % of the pixels moved (" << 100 * tolerance.share << " % may)";
    return out.str();
}

} // namespace ciel::test
