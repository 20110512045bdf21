// An import as a person at a terminal sees it, for `ciel import` and for `ciel serve FILE`.
#pragma once

#include "store/importer.hpp"

#include <cstdio>

namespace ciel::app {

// A bar on a terminal; elsewhere a line for every tenth. Lines go to `out`.
class ImportView {
public:
    explicit ImportView(std::FILE* out);
    void progress(double share, const std::string& phase);
    void line(const std::string& line) const;
    void clear() const;                             // takes the bar away
    [[nodiscard]] store::ImportListener listener(); // borrows this view

private:
    std::FILE* out_;
    bool terminal_;
    int shown_tenth_ = -1;
};

// From the first call on, SIGINT and SIGTERM set it instead of ending the program.
[[nodiscard]] const std::atomic<bool>& cancelled_by_signal();

} // namespace ciel::app
