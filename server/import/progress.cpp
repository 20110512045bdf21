#include "import/progress.hpp"

#include <csignal>
#include <cstdio>

namespace ciel::importer {

namespace {

volatile std::sig_atomic_t cancelled = 0;

void on_signal(int) { cancelled = 1; }

} // namespace

void install_cancel_handlers() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
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

} // namespace ciel::importer
