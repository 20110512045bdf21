#include "methods/raw_ids.hpp"

#include <nlohmann/json.hpp>

namespace server::methods {
namespace {

using nlohmann::json;

class IdReader final : public json::json_sax_t {
public:
    [[nodiscard]] std::vector<std::string> take() { return std::move(ids_); }

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool string(string_t&) override { return value(); }
    bool binary(binary_t&) override { return value(); }
    // The parser calls number_integer for integers with a minus sign. Only -0 would lose the sign.
    bool number_integer(number_integer_t number) override { return value(number == 0 ? "-0" : std::to_string(number)); }
    bool number_unsigned(number_unsigned_t number) override { return value(std::to_string(number)); }
    // The parser calls number_float also for integers beyond 64 bits.
    bool number_float(number_float_t, const string_t& token) override { return value(token); }

    bool start_object(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override {
        if (depth_ == 0)
            request_depth_ = 1; // a batch
        else
            (void)value();
        ++depth_;
        return true;
    }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        is_id_ = depth_ == request_depth_ + 1 && name == "id";
        return true;
    }
    bool parse_error(std::size_t end, const std::string& token, const json::exception& error) override {
        if (is_id_ && dynamic_cast<const json::out_of_range*>(&error) != nullptr) large_ = {end, token};
        return false;
    }

    // An id that a double cannot hold: the offset of its end in the text, and the id as written (empty if none).
    [[nodiscard]] const std::pair<std::size_t, std::string>& large() const { return large_; }
    [[nodiscard]] std::size_t request() const { return ids_.size() - 1; }

private:
    bool value(const std::string& number = {}) {
        if (depth_ == request_depth_) ids_.emplace_back(); // a request, or an invalid element of a batch
        if (is_id_) ids_.back() = number;
        is_id_ = false;
        return true;
    }
    bool open() {
        (void)value();
        ++depth_;
        return true;
    }
    bool close() {
        --depth_;
        return true;
    }

    std::vector<std::string> ids_;
    std::pair<std::size_t, std::string> large_;
    std::size_t depth_ = 0, request_depth_ = 0;
    bool is_id_ = false;
};

} // namespace

std::vector<std::string> raw_ids(std::string_view text) {
    IdReader reader;
    (void)json::sax_parse(text.begin(), text.end(), &reader);
    return reader.take();
}

std::optional<IdsInRange> ids_in_range(std::string_view text, std::size_t most) {
    IdsInRange result{std::string(text), {}};
    for (std::size_t i = 0; i <= most; ++i) {
        IdReader reader;
        if (json::sax_parse(result.text.begin(), result.text.end(), &reader)) return result;
        const auto& [end, token] = reader.large();
        if (token.empty() || end > result.text.size() || end < token.size()) break;
        std::string small = "0.5"; // shorter than any number beyond the range of a double
        small.resize(token.size(), ' ');
        result.text.replace(end - token.size(), token.size(), small);
        result.large[reader.request()] = token;
    }
    return std::nullopt;
}

} // namespace server::methods
