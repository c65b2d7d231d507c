// A growable array for the hypothesis arena. Unlike std::vector it neither zeroes what it adds nor
// gives memory back, and writing past its size within the reserved room is part of the contract:
// the gate writes every candidate and only then decides whether to keep it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

namespace mda {

template <typename T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer() { std::free(data_); }

  [[nodiscard]] int size() const noexcept { return size_; }
  T& operator[](int i) noexcept { return data_[i]; }
  const T& operator[](int i) const noexcept { return data_[i]; }
  [[nodiscard]] const T* begin() const noexcept { return data_; }
  [[nodiscard]] const T* end() const noexcept { return data_ + size_; }

  /// Makes room for `extra` entries after the present ones. Throws std::bad_alloc.
  void make_room(int extra) {
    if (size_ + extra <= capacity_) return;
    const int wanted = (size_ + extra) + (size_ + extra) / 2 + 64;
    void* grown =
        std::realloc(static_cast<void*>(data_), static_cast<std::size_t>(wanted) * sizeof(T));
    if (grown == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(grown);
    capacity_ = wanted;
  }

  /// Sets the size, at most what there is room for; new entries hold what was written there.
  void set_size(int size) noexcept { size_ = size; }

  void push_back(const T& value) {
    make_room(1);
    data_[size_++] = value;
  }

  void swap(Buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  T* data_ = nullptr;
  int size_ = 0;
  int capacity_ = 0;
};

}  // namespace mda
