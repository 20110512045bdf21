// A Cutter that keeps the cut of a block while the same vertices are high, unless a decider uses nu.
#include "ciel/of_this_thread.hpp"
#include "extraction/classify_vertices.hpp"
#include "extraction/cutter.hpp"
#include "fields/field_data.hpp"
#include "parallel/grain.hpp"

namespace ciel::detail {

namespace {

class SignatureCutter : public Cutter {
public:
    using Cutter::Cutter;

    void set_field(const Field& field) override { field_ = &field.data(); }
    bool update(double nu, const StopToken& stop) override;

private:
    void update_block(Index b, double threshold, double nu);
    const Field::Data* field_ = nullptr;
};

bool SignatureCutter::update(double nu, const StopToken& stop) {
    const double threshold = field_->threshold(nu);
    active_.clear();
    for (Index b = 0; b < cut_.size(); ++b)
        if (has(b) && field_->crosses(b, threshold)) active_.push_back(b);
    cut_.keep(active_);
    parallel_for(active_.size(), fair_grain(active_.size(), 2), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) update_block(active_[i], threshold, nu);
    });
    return !stop.stop_requested();
}

void SignatureCutter::update_block(Index b, double threshold, double nu) {
    const Block& block = topology_.blocks().cells(b);
    ActiveBlock& cut = cut_[b];
    CutScratch& scratch = of_this_thread<CutScratch>();
    const ValuesView values = field_->of_block(b);
    const bool gaps = field_->has_gaps(b);
    if (classify(values, threshold, scratch, cut) && !gaps) return;
    cut.known = false; // so that it is false if cut_block throws
    cut_block(block, {values, gaps, threshold, nu, decider_, field_->ranges.of(block, b, values)}, scratch, cut);
    cut.known = !gaps && !cut.decided;
}

} // namespace

std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology) {
    return std::make_unique<SignatureCutter>(topology);
}

} // namespace ciel::detail
