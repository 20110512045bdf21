// Console output of an import, for `ciel import` and `ciel serve FILE`.
#pragma once

#include "importing/importer.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>

namespace server::app {

// Shows a progress bar if stderr is a terminal. Otherwise prints a line to `out` at each tenth.
class ImportView {
public:
    explicit ImportView(std::FILE* out);
    void progress(double share, const std::string& phase);
    void line(const std::string& line) const;
    void clear() const;                                 // removes the bar
    [[nodiscard]] importing::ImportListener listener(); // must not outlive this view

private:
    std::FILE* out_;
    bool terminal_;
    int shown_tenth_ = -1;
};

// While an object exists, SIGINT and SIGTERM set cancelled() instead of ending the program. At most one object may
// exist.
class CancelOnSignal {
public:
    CancelOnSignal();
    ~CancelOnSignal() { restore(); }
    CancelOnSignal(const CancelOnSignal&) = delete;
    CancelOnSignal& operator=(const CancelOnSignal&) = delete;

    [[nodiscard]] const std::atomic<bool>& cancelled() const;
    // Restores the previous handlers. Throws Error if a signal arrived since construction.
    void end();

private:
    void restore();

    struct sigaction interrupt_ {};
    struct sigaction terminate_ {};
    bool installed_ = true;
};

} // namespace server::app
