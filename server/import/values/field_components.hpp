// Chooses the components of each array. If steps differ, the components that most steps have are chosen, not those of
// the first step, which may be the faulty one.
#pragma once

#include <map>
#include <string>

namespace ciel::importer {

using ComponentsOf = std::map<std::string, std::string>; // name in the dataset -> components_text (fields.hpp)

class FieldComponents {
public:
    // `chosen`: the result of an earlier pass over all steps, or empty.
    explicit FieldComponents(ComponentsOf chosen = {}) : chosen_(std::move(chosen)) {}

    // Returns whether the array's components at this step are the chosen ones. Without an earlier pass, the first step
    // with the array chooses.
    [[nodiscard]] bool accept(const std::string& array, const std::string& components) {
        ++steps_[array][components];
        return chosen_.try_emplace(array, components).first->second == components;
    }
    [[nodiscard]] const std::string& chosen(const std::string& array) const { return chosen_.at(array); }

    // Returns the components that most steps have, per array. In a tie, the chosen ones are kept.
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
    std::map<std::string, std::map<std::string, std::size_t>> steps_; // array -> components -> number of steps
};

} // namespace ciel::importer
