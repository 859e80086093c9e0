// A value that is cheap to copy: copies share one immutable object until one of them is edited.
#pragma once

#include <memory>
#include <utility>

namespace rt {

/// Behaves like a `T` (copyable, comparable by content) but copies cost a pointer. Never null.
template <typename T>
class Shared {
public:
    Shared() : value_(std::make_shared<T>()) {}
    Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}  // NOLINT: implicit, it is a T

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    /// Address of the shared object: equal addresses mean equal values (the reverse need not hold).
    const T* identity() const { return value_.get(); }
    /// The value for editing; detaches from other copies first.
    T& edit() {
        if (value_.use_count() != 1) value_ = std::make_shared<T>(*value_);
        return *value_;
    }
    friend bool operator==(const Shared& a, const Shared& b) { return a.value_ == b.value_ || *a.value_ == *b.value_; }

private:
    std::shared_ptr<T> value_;
};

}  // namespace rt
