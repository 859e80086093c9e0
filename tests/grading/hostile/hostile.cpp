// A program that does what no program should: hostile DEED [ARGUMENT]. Deeds with an answer print it.
#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>

namespace {

int answer(bool done) {
    std::printf("%s\n", done ? "done" : std::strerror(errno));
    return done ? 0 : 1;
}

/// Twice forked, in a session of its own, deaf to signals that can be ignored.
void leave_daemon(bool wait_for_it) {
    for (int number : {SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGPIPE}) signal(number, SIG_IGN);
    if (fork() != 0) {
        while (wait_for_it) pause();
        usleep(50'000);
        return;
    }
    setsid();
    if (fork() != 0) _exit(0);
    for (;;) pause();
}

/// Children of children until no more can be had; how many this one process got.
int bomb() {
    int started = 0;
    for (int failures = 0; failures < 1000;) {
        const pid_t child = fork();
        if (child == 0) {
            for (;;) pause();
        }
        if (child > 0)
            ++started;
        else
            ++failures;
    }
    std::printf("%d\n", started);
    return 0;
}

/// Each process lives only until it has started the next.
int chain() {
    for (;;) {
        if (fork() > 0) _exit(0);
        setsid();
    }
}

int allocate(double gigabytes) {
    const std::size_t step = 1 << 20;
    for (double done = 0.0; done < gigabytes * 1024.0; ++done) {
        void* memory = std::malloc(step);
        if (memory == nullptr) throw std::bad_alloc();
        std::memset(memory, 1, step);
    }
    return answer(true);
}

int reach(int port) {
    const int stream = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return answer(connect(stream, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
}

int list_descriptors() {
    DIR* folder = opendir("/proc/self/fd");
    while (const dirent* entry = readdir(folder)) {
        if (entry->d_name[0] != '.' && std::atoi(entry->d_name) != dirfd(folder)) std::printf("%s ", entry->d_name);
    }
    return 0;
}

int write_without_end(const std::string& path) {
    const int file = open(path.c_str(), O_CREAT | O_WRONLY, 0644);
    static char block[65536];
    while (write(file, block, sizeof block) > 0) {
    }
    return answer(false);
}

int fill(const std::string& folder) {
    for (int i = 0;; ++i) std::ofstream(folder + "/" + std::to_string(i)) << std::string(100'000, 'x');
}

}  // namespace

int main(int count, char** words) {
    const std::string deed = count > 1 ? words[1] : "", argument = count > 2 ? words[2] : "";
    const std::map<std::string, std::function<int()>> deeds = {
        {"exit", [&] { return std::atoi(argument.c_str()); }},
        {"signal", [&] { return raise(std::atoi(argument.c_str())); }},
        {"crash", [] { return *static_cast<volatile int*>(nullptr); }},
        {"busy",
         [] {
             for (volatile bool on = true; on;) {
             }
             return 0;
         }},
        {"sleep", [] { return pause(); }},
        {"deaf", [] { return leave_daemon(true), 0; }},
        {"daemon", [] { return leave_daemon(false), 0; }},
        {"bomb", bomb},
        {"chain", chain},
        {"flood",
         [] {
             while (std::puts("All work and no play makes Jack a dull boy.") >= 0) {
             }
             return 0;
         }},
        {"allocate", [&] { return allocate(std::atof(argument.c_str())); }},
        {"write", [&] { return answer(open(argument.c_str(), O_CREAT | O_WRONLY, 0644) >= 0); }},
        {"read", [&] { return answer(open(argument.c_str(), O_RDONLY) >= 0); }},
        {"size",
         [&] {
             struct stat s;
             return answer(stat(argument.c_str(), &s) == 0 && (s.st_size > 0 || (errno = ENODATA) == 0));
         }},
        {"reach", [&] { return reach(std::atoi(argument.c_str())); }},
        {"descriptors", list_descriptors},
        {"endless-file", [&] { return write_without_end(argument); }},
        {"fill", [&] { return fill(argument); }},
    };
    const auto found = deeds.find(deed);
    return found == deeds.end() ? 99 : found->second();
}
