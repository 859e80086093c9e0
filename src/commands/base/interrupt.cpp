#include "commands/base/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>

#include "film/temporary_files.h"

namespace rt {

namespace {

std::atomic<bool> stop_asked{false};
std::atomic<bool> render_listens{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

pthread_t main_thread;

/// The end of the program is left to the main thread: it makes the temporary files and holds signals while their list changes.
void on_signal(int signal) {
    if (render_listens.load() && !stop_asked.exchange(true)) return;
    if (pthread_equal(pthread_self(), main_thread) == 0) {
        pthread_kill(main_thread, signal);
        return;
    }
    remove_temporary_files();
    constexpr char text[] = "\nraytrace: interrupted\n";
    const auto written = write(STDERR_FILENO, text, sizeof text - 1);
    static_cast<void>(written);
    _exit(exit_interrupted);
}

}  // namespace

StopOnSignal::StopOnSignal() {
    stop_asked = false;
    render_listens = true;
}

StopOnSignal::~StopOnSignal() { render_listens = false; }

const std::atomic<bool>& StopOnSignal::stop() const { return stop_asked; }

void install_signal_handlers() {
    main_thread = pthread_self();
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction inherited {};
        sigaction(signal, nullptr, &inherited);
        if (inherited.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is told as what cannot be written
}

}  // namespace rt
