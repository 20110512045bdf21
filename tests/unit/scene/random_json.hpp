// Random JSON documents. They have no nulls, which a merge patch cannot produce, and few names, so that documents
// overlap.
#pragma once

#include <nlohmann/json.hpp>
#include <random>

namespace ciel::test {

class RandomJson {
public:
    explicit RandomJson(unsigned seed) : random_(seed) {}

    nlohmann::json object(int depth) {
        nlohmann::json made = nlohmann::json::object();
        for (const char* name : {"a", "b", "c", "d/e", "~"})
            if (pick(3) != 0) made[name] = value(depth - 1);
        return made;
    }

    nlohmann::json value(int depth) {
        switch (pick(depth > 0 ? 7 : 4)) {
        case 0:
            return pick(3);
        case 1:
            return pick(2) == 0;
        case 2:
            return pick(2) == 0 ? "x" : "y";
        case 3:
            return 0.5 * pick(3);
        case 4: {
            nlohmann::json list = nlohmann::json::array();
            for (int i = pick(3); i > 0; --i) list.push_back(value(depth - 1));
            return list;
        }
        default:
            return object(depth);
        }
    }

    int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

private:
    std::mt19937 random_;
};

} // namespace ciel::test
