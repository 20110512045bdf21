// The Cutter of Algorithm 2 (paper): cuts the cells that Propagation (propagation.hpp) finds to be active at nu.
#include "ciel/of_this_thread.hpp"
#include "ciel/parallel.hpp"
#include "extraction/classify_vertices.hpp"
#include "extraction/cutter.hpp"
#include "extraction/propagation.hpp"
#include "fields/field_data.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

class PropagationCutter : public Cutter {
public:
    using Cutter::Cutter;

    void set_field(const Field& field) override {
        field_ = &field.data();
        propagation_.begin(topology_, field);
        cut_.forget();
    }
    bool update(double nu, const StopToken& stop) override;
    [[nodiscard]] std::size_t memory_bytes() const override {
        return Cutter::memory_bytes() + propagation_.memory_bytes();
    }

private:
    void update_block(Index b, double nu);

    const Field::Data* field_ = nullptr;
    Propagation propagation_;
};

void PropagationCutter::update_block(Index b, double nu) {
    ActiveBlock& cut = cut_[b];
    if (propagation_.settle(b)) cut.known = false;
    if (cut.known || propagation_.cells(b).empty()) return;
    const ValuesView values = field_->of_block(b);
    CutScratch& scratch = of_this_thread<CutScratch>();
    const double threshold = propagation_.threshold();
    (void)classify(values, threshold, scratch, cut);
    cut_cells(topology_.blocks().cells(b), {values, field_->has_gaps(b), threshold, nu, decider_, {}},
              propagation_.cells(b), scratch, cut);
    cut.known = !cut.decided;
}

bool PropagationCutter::update(double nu, const StopToken& stop) {
    active_.clear();
    if (!propagation_.reach(nu, stop)) {
        cut_.forget();
        return false;
    }
    propagation_.list_blocks(active_);
    std::erase_if(active_, [this](Index b) { return !has(b); });
    cut_.keep(active_);
    parallel_for(active_.size(), 2, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) update_block(active_[i], nu);
    });
    std::erase_if(active_, [this](Index b) { return propagation_.cells(b).empty(); });
    return !stop.stop_requested();
}

} // namespace

std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology) {
    return std::make_unique<PropagationCutter>(topology);
}

} // namespace ciel::detail
