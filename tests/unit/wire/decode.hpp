// Joins messages sent in pieces, and decodes pictures with libpng and libjpeg.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace server::wire {

// Returns the joined payload of messages in pieces (protocol/frame.md). A missing or misplaced piece fails the test.
[[nodiscard]] std::vector<std::uint8_t> joined(std::span<const std::vector<std::uint8_t>> messages);

// Returns RGB rows from the top. A damaged file, bytes after its end or another size fails the test.
[[nodiscard]] std::vector<std::uint8_t> decoded_png(const std::vector<std::uint8_t>& file, int width, int height);
[[nodiscard]] std::vector<std::uint8_t> decoded_jpeg(const std::vector<std::uint8_t>& file, int width, int height);

} // namespace server::wire
