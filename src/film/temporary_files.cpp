#include "film/temporary_files.h"

#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

namespace rt {

namespace {

/// `used` is set after the path is complete, so that a handler in the same thread never sees half a name.
struct Slot {
    std::atomic<bool> used{false};
    std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

std::array<Slot, 8> slots;

}  // namespace

HoldSignals::HoldSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
}

HoldSignals::~HoldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void remember_temporary(const std::string& path) {
    if (path.size() >= PATH_MAX) return;
    for (Slot& slot : slots) {
        if (slot.used) continue;
        std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
        slot.used = true;
        return;
    }
}

void forget_temporary(const std::string& path) {
    for (Slot& slot : slots) {
        if (!slot.used || path != slot.path.data()) continue;
        slot.used = false;
        return;
    }
}

void remove_temporary_files() {
    for (const Slot& slot : slots)
        if (slot.used) unlink(slot.path.data());
}

}  // namespace rt
