// Room on the stack for objects that are made when they are needed.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace rt {

/// At most `size` objects, each made in its place by `emplace`. Nothing is written before: an array of std::optional clears all its bytes,
/// which for packets of rays was a fiftieth of a picture's time.
template <typename T, std::size_t size>
class Slots {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    template <typename... Arguments>
    T& emplace(std::size_t i, Arguments&&... arguments) {
        return *new (memory_ + i * sizeof(T)) T(std::forward<Arguments>(arguments)...);
    }

private:
    alignas(T) std::byte memory_[size * sizeof(T)];
};

}  // namespace rt
