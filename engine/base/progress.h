// Progress and cancel of long work: one small object handed down by value.
#pragma once

#include <atomic>
#include <memory>

namespace spineloft {

/// Shared between the worker that does the work and the page that watches it. Copy freely.
class Progress {
 public:
  Progress() : shared_(std::make_shared<Shared>()) {}

  /// Worker: says how much is done (0…1, never goes back) and learns whether to go on. When it
  /// returns false the worker returns Error::Cancelled as soon as it can.
  bool advance(double done) const {
    double seen = shared_->done.load(std::memory_order_relaxed);
    if (done > seen) shared_->done.store(done < 1 ? done : 1, std::memory_order_relaxed);
    return !cancelled();
  }
  /// Watcher: how much is done, 0…1.
  double done() const { return shared_->done.load(std::memory_order_relaxed); }
  /// Watcher: asks the worker to stop. Can't be taken back.
  void cancel() const { shared_->cancelled.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return shared_->cancelled.load(std::memory_order_relaxed); }

 private:
  struct Shared {
    std::atomic<double> done{0};
    std::atomic<bool> cancelled{false};
  };
  std::shared_ptr<Shared> shared_;
};

}  // namespace spineloft
