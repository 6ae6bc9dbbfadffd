// A value that comes and goes, whose memory stays.
#pragma once

namespace spineloft::app {

/// A T, or none, as std::optional; but the memory of one that is gone serves the next.
template <class T>
class Reusable {
 public:
  explicit operator bool() const { return there_; }
  T& operator*() { return value_; }
  const T& operator*() const { return value_; }
  T* operator->() { return &value_; }
  const T* operator->() const { return &value_; }

  void reset() { there_ = false; }
  /// What was there last, to be overwritten; it is not there by that.
  T& room() { return value_; }
  /// The same; from now on it is there.
  T& renew() {
    there_ = true;
    return value_;
  }

 private:
  T value_{};
  bool there_ = false;
};

}  // namespace spineloft::app
