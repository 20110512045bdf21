#include "import/progress.hpp"

#include <csignal>
#include <cstdio>

namespace server::importer {

namespace {

volatile std::sig_atomic_t cancelled = 0;

void on_signal(int) { cancelled = 1; }

void handle_both(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

} // namespace

void install_cancel_handlers() { handle_both(on_signal); }

void ignore_cancelling() {
    handle_both(SIG_IGN);
    cancelled = 0;
}

void progress(double share, const std::string& phase) {
    if (cancelled != 0) throw Cancelled{};
    static int shown = -1;
    static std::string shown_phase;
    const int percent = static_cast<int>(share * 100);
    if (percent <= shown && phase == shown_phase) return;
    shown = percent;
    shown_phase = phase;
    std::printf("progress %.2f %s\n", share, phase.c_str());
    std::fflush(stdout);
}

} // namespace server::importer
