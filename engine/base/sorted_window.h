// Some values in order, of which one after the other comes and goes: quantiles of a window that moves along a row
// without sorting it anew at every place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spineloft {

/// In memory of the caller, which it empties first. Values are numbers, not NaN.
class SortedWindow {
 public:
  explicit SortedWindow(std::vector<float>& memory) : values_(memory) { values_.clear(); }

  void add(float value) {
    values_.push_back(value);
    std::size_t i = values_.size() - 1;
    for (; i > 0 && values_[i - 1] > value; --i) values_[i] = values_[i - 1];
    values_[i] = value;
  }
  /// `value` was added.
  void remove(float value) {
    auto at = std::lower_bound(values_.begin(), values_.end(), value);
    for (; at + 1 != values_.end(); ++at) *at = *(at + 1);
    values_.pop_back();
  }
  std::size_t size() const { return values_.size(); }
  /// The value of which `rank` others are less or come before it, rank < size().
  float at(std::size_t rank) const { return values_[rank]; }

 private:
  std::vector<float>& values_;
};

}  // namespace spineloft
