// LossCheck: looks for lost mappings of a dataset only when there may be some.
#pragma once

#include "store/cache/mapped_file.hpp"

namespace server::store {

// A dataset calls its LossCheck after each read. After a loss, each call looks at all files, until the lost file is no
// longer mapped. Thread-safe.
class LossCheck {
public:
    explicit LossCheck(LossCount losses) : losses_(std::move(losses)) {}

    // Calls `look`, which throws Error if a file of the dataset is lost. Does not call it while the number of losses is
    // the same as at the last look that did not throw: these losses are of files that are no longer mapped.
    template <typename Look>
    void operator()(const Look& look) const {
        const std::uint32_t losses = *losses_;
        if (losses == let_go_) return;
        look();
        let_go_ = losses;
    }

private:
    LossCount losses_;
    mutable std::atomic<std::uint32_t> let_go_ = 0;
};

} // namespace server::store
