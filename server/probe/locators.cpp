#include "probe/locators.hpp"

#include <algorithm>

namespace ciel::probe {
namespace {

constexpr std::size_t most_kept = 4;

} // namespace

struct Locators::Held {
    std::shared_ptr<const store::Dataset> dataset; // owns the arrays that the locator reads
    CellLocator locator;
};

std::shared_ptr<const CellLocator> Locators::get(const std::shared_ptr<store::Dataset>& dataset, std::size_t step) {
    const store::Step& shown = dataset->steps().at(step);
    const auto mesh = dataset->mesh(shown.mesh, shown.coordinates);
    const void* positions = mesh.positions.data();
    const auto locator_of = [](const std::shared_ptr<const Held>& held) {
        return std::shared_ptr<const CellLocator>(held, &held->locator);
    };
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(kept_, positions, &Kept::positions);
    if (found != kept_.end()) return locator_of(found->held);
    auto held = std::make_shared<const Held>(Held{dataset, CellLocator(mesh)});
    dataset->check_unchanged();
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    kept_.push_back({positions, held});
    return locator_of(held);
}

void Locators::forget() {
    const std::scoped_lock lock(mutex_);
    kept_.clear();
}

void Locators::forget_lost() {
    const std::scoped_lock lock(mutex_);
    std::erase_if(kept_, [](const Kept& kept) { return !kept.held->dataset->is_intact(); });
}

} // namespace ciel::probe
