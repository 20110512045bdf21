// Whole messages from their pieces; pictures back from their files, by the libraries that everybody reads them with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

// The payload that messages carry in pieces (protocol/frame.md). A piece that is missing or out of order fails the
// test.
[[nodiscard]] std::vector<std::uint8_t> joined(std::span<const std::vector<std::uint8_t>> messages);

// RGB rows from the top. A file that is damaged, goes on behind its end or has another size fails the test.
[[nodiscard]] std::vector<std::uint8_t> decoded_png(const std::vector<std::uint8_t>& file, int width, int height);
[[nodiscard]] std::vector<std::uint8_t> decoded_jpeg(const std::vector<std::uint8_t>& file, int width, int height);

} // namespace ciel::wire
