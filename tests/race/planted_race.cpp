// Two threads that add to one number without agreeing on it: the thread sanitizer must say so, or its silence elsewhere means nothing.
#include <cstdio>
#include <thread>

int main() {
    int number = 0;
    const auto add = [&] {
        for (int i = 0; i < 10000; ++i) ++number;
    };
    { const std::jthread first(add), second(add); }
    std::printf("%d\n", number);
    return 0;
}
