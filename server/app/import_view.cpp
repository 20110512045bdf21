#include "app/import_view.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace server::app {
namespace {

constexpr int width = 30;
std::atomic<bool> cancelled_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free); // a signal handler sets the flag

void on_signal(int) { cancelled_flag = true; }

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

importing::ImportListener ImportView::listener() {
    return {[this](double share, const std::string& phase) { progress(share, phase); },
            [this](const std::string& text) { line(text); }};
}

CancelOnSignal::CancelOnSignal() {
    cancelled_flag = false;
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, &interrupt_);
    ::sigaction(SIGTERM, &action, &terminate_);
}

const std::atomic<bool>& CancelOnSignal::cancelled() const { return cancelled_flag; }

void CancelOnSignal::restore() {
    if (!std::exchange(installed_, false)) return;
    ::sigaction(SIGINT, &interrupt_, nullptr);
    ::sigaction(SIGTERM, &terminate_, nullptr);
}

// Restores the handlers before reading the flag, so that no signal is lost: a signal after restore() ends the program.
void CancelOnSignal::end() {
    restore();
    if (cancelled_flag) throw ciel::Error("a signal stopped the import; no dataset was served");
}

} // namespace server::app
