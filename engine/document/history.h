// Generic undo and redo: a stack of values (the idea of arximboldi/lager, in a few lines of our own),
// unlimited within a budget of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "engine/base/result.h"

namespace spineloft::document {

/// Bytes that all steps of a history may hold beyond the present: many thousands of small steps, or a
/// few removed photos.
inline constexpr std::size_t kHistoryBytes = std::size_t{64} << 20;

/// Which gesture a commit belongs to: commits in a row with the same one become one step (a slider that
/// is dragged). 0: a step of its own.
using Gesture = std::uint64_t;

/// What a commit did.
enum class Committed : std::uint8_t {
  Nothing,  ///< the value equals the present
  Step,     ///< one more step of undo
  Amended,  ///< the present was replaced, as part of the step before
};

/// Past, present and future of a value type with ==. One commit is one step of undo. Where there is a
/// function `bytesBeyond(base, next)` for T, it says what a value holds that its neighbour does not;
/// else a value costs its size.
template <class T>
class History {
 public:
  explicit History(T present = {}, std::size_t budget = kHistoryBytes)
      : present_(std::move(present)), budget_(budget) {}

  const T& present() const { return present_; }
  std::size_t undoSteps() const { return past_.size(); }
  std::size_t redoSteps() const { return future_.size(); }
  /// Bytes that the steps of undo and redo hold beyond the present, and how many they may.
  std::size_t bytes() const { return bytes_; }
  std::size_t budget() const { return budget_; }

  /// The value after `steps` steps from the oldest one that is kept; undoSteps() is the present,
  /// undoSteps() + redoSteps() the last.
  const T& at(std::size_t steps) const {
    if (steps < past_.size()) return past_[steps].value;
    if (steps == past_.size()) return present_;
    return future_[past_.size() + future_.size() - steps].value;
  }

  /// Makes `next` the present and forgets the future; nothing happens when it equals the present. With
  /// the gesture of the commit just before, that step takes `next` in (`amend`). Over budget the oldest
  /// steps are forgotten, but never the last one.
  Committed commit(T next, Gesture gesture = 0) {
    if (next == present_) return Committed::Nothing;
    if (gesture != 0 && gesture == gesture_) {
      amend(std::move(next));
      return Committed::Amended;
    }
    forget(future_);
    push(past_, std::move(present_), next);
    present_ = std::move(next);
    gesture_ = gesture;
    keepBudget();
    return Committed::Step;
  }
  /// Replaces the present without a step of its own and forgets the future. A step that thereby comes
  /// back to where it began is no step any more.
  void amend(T next) {
    forget(future_);
    present_ = std::move(next);
    if (past_.empty()) return;
    Entry last = pop(past_);
    if (last.value == present_) {
      present_ = std::move(last.value);
      gesture_ = 0;
    } else {
      push(past_, std::move(last.value), present_);
    }
  }
  /// Error: NothingToUndo.
  Status undo() { return step(past_, future_, Error::NothingToUndo); }
  /// Error: NothingToRedo.
  Status redo() { return step(future_, past_, Error::NothingToRedo); }

 private:
  struct Entry {
    T value;
    std::size_t bytes = 0;  ///< beyond the neighbour on the side of the present
  };
  using Entries = std::deque<Entry>;  ///< the one next to the present last

  static std::size_t costOf(const T& value, const T& neighbour) {
    if constexpr (requires { bytesBeyond(neighbour, value); }) {
      return bytesBeyond(neighbour, value);
    } else {
      return sizeof(T);
    }
  }
  void push(Entries& entries, T value, const T& neighbour) {
    const std::size_t bytes = costOf(value, neighbour);
    bytes_ += bytes;
    entries.push_back({std::move(value), bytes});
  }
  Entry pop(Entries& entries) {
    Entry last = std::move(entries.back());
    entries.pop_back();
    bytes_ -= last.bytes;
    return last;
  }
  void forget(Entries& entries) {
    while (!entries.empty()) pop(entries);
  }
  void keepBudget() {
    while (bytes_ > budget_ && past_.size() > 1) {
      bytes_ -= past_.front().bytes;
      past_.pop_front();
    }
  }
  Status step(Entries& from, Entries& to, Error nothing) {
    if (from.empty()) return nothing;
    Entry next = pop(from);
    push(to, std::move(present_), next.value);
    present_ = std::move(next.value);
    gesture_ = 0;
    return Done{};
  }

  Entries past_, future_;
  T present_;
  Gesture gesture_ = 0;
  std::size_t budget_ = kHistoryBytes, bytes_ = 0;
};

}  // namespace spineloft::document
