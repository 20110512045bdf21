#include "app/import_view.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace ciel::app {
namespace {

constexpr int width = 30;
std::atomic<bool> cancelled{false};
static_assert(std::atomic<bool>::is_always_lock_free); // set in a signal handler

void on_signal(int) { cancelled = true; }

} // namespace

ImportView::ImportView(std::FILE* out) : out_(out), terminal_(::isatty(STDERR_FILENO) != 0) {}

void ImportView::progress(double share, const std::string& phase) {
    const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
    if (terminal_) {
        const std::string done(static_cast<std::size_t>(percent) * width / 100, '#');
        std::fprintf(stderr, "\r[%-*s] %3d %% %-40.40s", width, done.c_str(), percent, phase.c_str());
    } else if (percent / 10 != shown_tenth_) {
        shown_tenth_ = percent / 10;
        std::fprintf(out_, "%d %% %s\n", percent, phase.c_str());
        std::fflush(out_);
    }
}

void ImportView::line(const std::string& line) const {
    clear();
    std::fprintf(out_, "%s\n", line.c_str());
}

void ImportView::clear() const {
    if (terminal_) std::fprintf(stderr, "\r%*s\r", width + 52, "");
}

store::ImportListener ImportView::listener() {
    return {[this](double share, const std::string& phase) { progress(share, phase); },
            [this](const std::string& text) { line(text); }};
}

const std::atomic<bool>& cancelled_by_signal() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return cancelled;
}

} // namespace ciel::app
