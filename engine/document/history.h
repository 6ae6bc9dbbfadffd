// Generic undo and redo: a stack of values (the idea of arximboldi/lager, in a few lines of our own).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace spineloft::document {

/// Past, present and future of a value type with ==. One commit is one step of undo.
template <class T>
class History {
 public:
  explicit History(T present = {}) : present_(std::move(present)) {}

  const T& present() const { return present_; }
  std::size_t undoSteps() const { return past_.size(); }
  std::size_t redoSteps() const { return future_.size(); }

  /// Makes `next` the present and forgets the future; nothing happens when it equals the present.
  void commit(T next) {
    if (next == present_) return;
    past_.push_back(std::move(present_));
    present_ = std::move(next);
    future_.clear();
  }
  /// Error: NothingToUndo.
  Status undo() { return step(past_, future_, Error::NothingToUndo); }
  /// Error: NothingToRedo.
  Status redo() { return step(future_, past_, Error::NothingToRedo); }

 private:
  Status step(std::vector<T>& from, std::vector<T>& to, Error nothing) {
    if (from.empty()) return nothing;
    to.push_back(std::move(present_));
    present_ = std::move(from.back());
    from.pop_back();
    return Done{};
  }
  std::vector<T> past_, future_;
  T present_;
};

}  // namespace spineloft::document
