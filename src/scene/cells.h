// The two cells of a checker pattern.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

namespace rt {

/// Behaves like a constant array of two `T`, or of none; copies share it. Trees hold trees by name, and copying would double them.
template <typename T>
class Cells {
public:
    Cells() = default;
    Cells(T first, T second) : cells_(std::make_shared<const std::array<T, 2>>(std::array<T, 2>{std::move(first), std::move(second)})) {}

    std::size_t size() const { return cells_ ? 2 : 0; }
    const T* begin() const { return cells_ ? cells_->data() : nullptr; }
    const T* end() const { return begin() + size(); }
    const T& operator[](std::size_t i) const { return (*cells_)[i]; }
    const T& at(std::size_t i) const {
        if (i >= size()) throw std::out_of_range("a checker has two cells");
        return (*cells_)[i];
    }
    friend bool operator==(const Cells& a, const Cells& b) {
        return a.cells_ == b.cells_ || (a.cells_ && b.cells_ && *a.cells_ == *b.cells_);
    }

private:
    std::shared_ptr<const std::array<T, 2>> cells_;
};

}  // namespace rt
