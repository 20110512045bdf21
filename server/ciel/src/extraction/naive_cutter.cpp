// The paper's baseline: a Cutter that has no list of active edges, and visits every cell of the mesh for every value.
#include "ciel/of_this_thread.hpp"
#include "ciel/parallel.hpp"
#include "extraction/classify_vertices.hpp"
#include "extraction/cutter.hpp"
#include "fields/field_data.hpp"

namespace ciel::detail {

namespace {

class NaiveCutter : public Cutter {
public:
    using Cutter::Cutter;

    void set_field(const Field& field) override { field_ = &field.data(); }
    bool update(double nu, const StopToken& stop) override {
        const double threshold = field_->threshold(nu);
        active_.clear();
        for (Index b = 0; b < cut_.size(); ++b)
            if (has(b)) active_.push_back(b);
        cut_.keep(active_);
        parallel_for(active_.size(), 2, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) {
                const Index b = active_[i];
                const ValuesView values = field_->of_block(b);
                CutScratch& scratch = of_this_thread<CutScratch>();
                (void)classify(values, threshold, scratch, cut_[b]);
                cut_block(topology_.blocks().cells(b), {values, field_->has_gaps(b), threshold, nu, decider_, {}, true},
                          scratch, cut_[b]);
            }
        });
        std::erase_if(active_, [this](Index b) { return cut_[b].ends.empty(); });
        return !stop.stop_requested();
    }

private:
    const Field::Data* field_ = nullptr;
};

} // namespace

std::unique_ptr<Cutter> make_naive_cutter(const Topology& topology) { return std::make_unique<NaiveCutter>(topology); }

} // namespace ciel::detail
