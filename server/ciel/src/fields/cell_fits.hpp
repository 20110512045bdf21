// The layout behind CellFits, for the kernel's own files. Not in the paper.
#pragma once

#include "ciel/cell_fits.hpp"
#include "ciel/threads.hpp"
#include "fields/block_fits.hpp"

#include <atomic>

namespace ciel {

struct CellFits::Data {
    struct OfBlock {
        Mutex mutex;
        bool has_begun = false;
        detail::BlockFits<std::uint16_t> fits;
        std::size_t counted = 0; // bytes of `fits` that are included in `bytes`
    };

    explicit Data(const Topology& of) : topology(of) {}

    const Topology topology;
    std::atomic<const void*> positions = nullptr; // address of the positions with which the fits were first used
    std::atomic<std::size_t> most_bytes = 0;
    std::size_t blocks = 0;
    std::unique_ptr<OfBlock[]> of_block;
    std::atomic<std::size_t> bytes = 0; // memory of the fits of all blocks

    // Returns whether the fits belong to the positions at the address `other`. The first call decides to which
    // positions they belong.
    [[nodiscard]] bool belong_to(const void* other) {
        const void* first = nullptr;
        return positions.compare_exchange_strong(first, other) || first == other;
    }
    void count(OfBlock& of) { // call with of.mutex locked
        bytes.fetch_add(of.fits.memory_bytes() - of.counted, std::memory_order_relaxed);
        of.counted = of.fits.memory_bytes();
    }
};

} // namespace ciel

namespace ciel::detail {

// Calls f(fitted). fitted(index of a cell in the section) returns a FittedPolyhedron, which is valid until the next
// call of `fitted`. `shared` keeps the fits, and is locked for this block while f runs. If `shared` is null, no fits
// are kept.
template <class Local, class Sampler, class F>
void with_fits(CellFits::Data* shared, Index b, const Block& block, const PolyhedralSection<Local>& section,
               const Sampler& sample, PolyhedronFitter& fitter, F&& f) {
    bool has_begun = false;
    const auto fit = [&](Index cell) {
        if (!has_begun) fitter.begin(block, section);
        has_begun = true;
        return fitter.fit(section, cell, sample);
    };
    if constexpr (std::is_same_v<Local, std::uint16_t>)
        if (shared != nullptr) {
            CellFits::Data::OfBlock& own = shared->of_block[b];
            const Locked lock(own.mutex);
            if (own.has_begun ||
                shared->bytes.load(std::memory_order_relaxed) < shared->most_bytes.load(std::memory_order_relaxed)) {
                if (!own.has_begun) own.fits.begin(section.count());
                own.has_begun = true;
                f([&](Index cell) { return own.fits.of(cell, [&] { return fit(cell); }); });
                shared->count(own);
                return;
            }
        }
    f(fit);
}

} // namespace ciel::detail
