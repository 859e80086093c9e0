#include "grading/child_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include "grading/descriptor.h"

namespace rt {

pid_t start_child(const std::function<int()>& work) {
    const pid_t child = fork();
    if (child < 0) throw_errno("starting a process");
    if (child > 0) return child;
    int status = 127;
    try {
        status = work();
    } catch (...) {  // nobody is there to be told
    }
    _exit(status);
}

bool holds_in_child(const std::function<bool()>& work) {
    const pid_t child = start_child([&] { return work() ? 0 : 1; });
    int status = 1;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return false;
    }
    return status == 0;
}

}  // namespace rt
