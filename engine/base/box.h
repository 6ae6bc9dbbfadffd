// An immutable value that copies share: equal by content, cheap to copy, edited by replacing it. The
// history keeps many documents that differ in one part; boxes are what they have in common.
#pragma once

#include <memory>
#include <utility>

namespace spineloft {

/// Never empty, except after it was moved from. Reads like a `const T&`.
template <class T>
class Box {
 public:
  Box() : value_(std::make_shared<const T>()) {}
  Box(T value) : value_(std::make_shared<const T>(std::move(value))) {}

  const T& get() const { return *value_; }
  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  operator const T&() const { return *value_; }

  /// Whether both are one value in memory; then they are equal as well.
  bool shares(const Box& other) const { return value_ == other.value_; }
  friend bool operator==(const Box& a, const Box& b) { return a.shares(b) || *a == *b; }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace spineloft
