// Which components each array has at each step. Where steps differ, what most steps have is the array's, whichever
// comes first: the first step may be the bad one.
#pragma once

#include <map>
#include <string>

namespace ciel::importer {

using ComponentsOf = std::map<std::string, std::string>; // name in the dataset -> components_text (fields.hpp)

class FieldComponents {
public:
    // `chosen`: what an earlier look at all steps has come to, or nothing.
    explicit FieldComponents(ComponentsOf chosen = {}) : chosen_(std::move(chosen)) {}

    // Whether the array is taken at this step: it has what was chosen, or what the first step with it has.
    [[nodiscard]] bool accept(const std::string& array, const std::string& components) {
        ++steps_[array][components];
        return chosen_.try_emplace(array, components).first->second == components;
    }
    [[nodiscard]] const std::string& chosen(const std::string& array) const { return chosen_.at(array); }

    // What most steps have; of as many what was chosen.
    [[nodiscard]] ComponentsOf of_most_steps() const {
        ComponentsOf most = chosen_;
        for (const auto& [array, steps] : steps_)
            for (const auto& [components, count] : steps) {
                const auto best = steps.find(most[array]);
                if (best == steps.end() || count > best->second) most[array] = components;
            }
        return most;
    }
    [[nodiscard]] bool is_of_most_steps() const { return of_most_steps() == chosen_; }

private:
    ComponentsOf chosen_;
    std::map<std::string, std::map<std::string, std::size_t>> steps_; // array -> components -> at how many steps
};

} // namespace ciel::importer
