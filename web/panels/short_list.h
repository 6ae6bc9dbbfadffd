// What a bar puts together anew in every frame: a few values, without asking for memory.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace spineloft::panels {

/// Up to kMost values, in order; what is beyond is left off.
template <class T, std::size_t kMost = 16>
class ShortList {
 public:
  void push_back(const T& value) {
    assert(size_ < kMost);
    if (size_ < kMost) values_[size_++] = value;
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size_; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size_; }
  T& operator[](std::size_t at) { return values_[at]; }
  const T& operator[](std::size_t at) const { return values_[at]; }
  T& back() { return values_[size_ - 1]; }
  const T& back() const { return values_[size_ - 1]; }

 private:
  std::array<T, kMost> values_{};
  std::size_t size_ = 0;
};

}  // namespace spineloft::panels
