#include "fields/cell_fits.hpp"

namespace ciel {

CellFits::CellFits(const Topology& topology, std::size_t most_bytes) : data_(std::make_unique<Data>(topology)) {
    data_->most_bytes = most_bytes;
    data_->blocks = topology.blocks().count();
    data_->of_block = std::make_unique<Data::OfBlock[]>(data_->blocks);
}

CellFits::~CellFits() = default;

std::size_t CellFits::memory_bytes() const {
    return data_->bytes.load(std::memory_order_relaxed) + data_->blocks * sizeof(Data::OfBlock);
}

void CellFits::forget() {
    data_->most_bytes.store(0, std::memory_order_relaxed);
    for (std::size_t b = 0; b < data_->blocks; ++b) {
        Data::OfBlock& of = data_->of_block[b];
        const Locked lock(of.mutex);
        of.fits = {};
        of.has_begun = false;
        data_->count(of);
    }
}

} // namespace ciel
