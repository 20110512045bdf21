// Chooses the components (number and names) of each array in the dataset. If the steps differ, the components of most
// steps are chosen. The first step does not decide, because it may be the faulty step.
#pragma once

#include <map>
#include <string>

namespace server::importer {

using ComponentsOf = std::map<std::string, std::string>; // name in the dataset -> components_text (fields.hpp)

class FieldComponents {
public:
    // `chosen`: result of of_most_steps() after an earlier pass over all steps; empty in the first pass.
    explicit FieldComponents(ComponentsOf chosen = {}) : chosen_(std::move(chosen)) {}

    // Counts a step of the array. Returns whether it has the chosen components. In the first pass, the first step that
    // has the array determines the chosen components.
    [[nodiscard]] bool accept(const std::string& array, const std::string& components) {
        ++steps_[array][components];
        return chosen_.try_emplace(array, components).first->second == components;
    }
    [[nodiscard]] const std::string& chosen(const std::string& array) const { return chosen_.at(array); }

    // Returns, by array, the components that most steps have. If several are equally frequent, keeps the chosen
    // components.
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

} // namespace server::importer
