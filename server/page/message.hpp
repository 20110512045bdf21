// Messages between the page and this module. A message is an array of doubles. A text is stored as its number of bytes,
// then its UTF-8 bytes, padded with zeros to whole doubles. webclient/src/wasm/message.ts writes and reads the same
// format.
#pragma once

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace server::page {

// Reads a message. Beyond the end of the message, numbers are 0 and texts are empty.
class Reader {
public:
    explicit Reader(std::span<const double> message) : message_(message) {}

    double number() { return at_ < message_.size() ? message_[at_++] : 0; }
    bool flag() { return number() != 0; }
    int integer() { return static_cast<int>(number()); }
    template <std::size_t n>
    std::array<double, n> numbers() {
        std::array<double, n> all{};
        for (double& each : all) each = number();
        return all;
    }
    std::string text() {
        const double bytes = number();
        const auto left = static_cast<double>(sizeof(double) * (message_.size() - at_));
        if (!(bytes >= 0 && bytes <= left)) return {};
        std::string out(static_cast<std::size_t>(bytes), '\0');
        if (!out.empty()) std::memcpy(out.data(), message_.data() + at_, out.size());
        at_ += (out.size() + sizeof(double) - 1) / sizeof(double);
        return out;
    }

private:
    std::span<const double> message_;
    std::size_t at_ = 0;
};

class Writer {
public:
    void number(double value) { message_.push_back(value); }
    void numbers(std::span<const double> values) { message_.insert(message_.end(), values.begin(), values.end()); }
    void text(std::string_view text) {
        number(static_cast<double>(text.size()));
        const std::size_t begin = message_.size();
        message_.resize(begin + (text.size() + sizeof(double) - 1) / sizeof(double));
        if (!text.empty()) std::memcpy(message_.data() + begin, text.data(), text.size());
    }
    [[nodiscard]] std::span<const double> message() const { return message_; }
    void clear() { message_.clear(); }

private:
    std::vector<double> message_;
};

} // namespace server::page
