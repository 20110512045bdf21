#include "scene/read_json.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace server::scene {
namespace {

using nlohmann::json;

// Finds duplicate names. With a callback, json::parse would search the enclosing list at each object's end: time n^2.
class NameReader final : public json::json_sax_t {
public:
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }

    bool start_object(std::size_t) override {
        names_.emplace_back();
        return true;
    }
    bool end_object() override {
        names_.pop_back();
        return true;
    }
    bool key(string_t& name) override {
        if (!names_.back().insert(name).second)
            throw TwiceNamed(json(name).dump() + " occurs twice in the same object; remove one of the two members");
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

private:
    std::vector<std::set<std::string>> names_; // member names read so far, per object that is not yet closed
};

} // namespace

json read_json(std::string_view text) {
    json read = json::parse(text.begin(), text.end());
    NameReader names;
    json::sax_parse(text.begin(), text.end(), &names);
    return read;
}

} // namespace server::scene
