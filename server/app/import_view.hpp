// An import as a person at a terminal sees it, for `ciel import` and for `ciel serve FILE`.
#pragma once

#include "importing/importer.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>

namespace ciel::app {

// A bar on a terminal; elsewhere a line for every tenth. Lines go to `out`.
class ImportView {
public:
    explicit ImportView(std::FILE* out);
    void progress(double share, const std::string& phase);
    void line(const std::string& line) const;
    void clear() const;                                 // takes the bar away
    [[nodiscard]] importing::ImportListener listener(); // borrows this view

private:
    std::FILE* out_;
    bool terminal_;
    int shown_tenth_ = -1;
};

// While it lives, SIGINT and SIGTERM cancel the import instead of ending the program; then they do again what they did
// before. One at a time.
class CancelOnSignal {
public:
    CancelOnSignal();
    ~CancelOnSignal() { restore(); }
    CancelOnSignal(const CancelOnSignal&) = delete;
    CancelOnSignal& operator=(const CancelOnSignal&) = delete;

    [[nodiscard]] const std::atomic<bool>& cancelled() const;
    // Throws Error when a signal came that the import did not see any more.
    void end();

private:
    void restore();

    struct sigaction interrupt_ {};
    struct sigaction terminate_ {};
    bool installed_ = true;
};

} // namespace ciel::app
