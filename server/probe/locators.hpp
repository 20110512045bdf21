// The cell locators of datasets that are probed, kept from one probe to the next.
#pragma once

#include "ciel/cell_locator.hpp"
#include "store/dataset.hpp"

#include <memory>
#include <mutex>
#include <vector>

namespace ciel::probe {

// Keeps the last four locators. Thread-safe.
class Locators {
public:
    // Returns the locator of the step's mesh and positions, made on first use. The result keeps the dataset.
    // Throws Error when the dataset's files were changed meanwhile.
    [[nodiscard]] std::shared_ptr<const CellLocator> get(const std::shared_ptr<store::Dataset>& dataset,
                                                         std::size_t step);
    void forget();      // releases all datasets
    void forget_lost(); // releases the datasets whose files were truncated or rewritten

private:
    struct Held;
    struct Kept {
        const void* positions; // identify mesh and coordinates: mapped once, also after a refresh
        std::shared_ptr<const Held> held;
    };
    std::mutex mutex_;
    std::vector<Kept> kept_; // newest last
};

} // namespace ciel::probe
