// Pictures back from their files, by the libraries that everybody reads them with.
#pragma once

#include <cstdint>
#include <vector>

namespace ciel::wire {

// RGB rows from the top. A file that is damaged, goes on behind its end or has another size fails the test.
[[nodiscard]] std::vector<std::uint8_t> decoded_png(const std::vector<std::uint8_t>& file, int width, int height);
[[nodiscard]] std::vector<std::uint8_t> decoded_jpeg(const std::vector<std::uint8_t>& file, int width, int height);

} // namespace ciel::wire
