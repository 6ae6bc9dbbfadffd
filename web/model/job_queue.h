// What takes longer than a frame, step by step: done by the workers, or between frames.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "engine/base/worker_pool.h"

namespace spineloft::app {

/// Works on what is wanted now and on nothing else: as many are made at a time as there are workers, without any a step
/// of one at a time, and no other is begun, however often another thing is wanted. What a worker has in hand when it is
/// wanted no more is dropped at its next step. `Making` has a key(), and a step() that says whether there is another;
/// it runs on one thread at a time.
template <class Making>
class JobQueue {
 public:
  /// Is handed what is made.
  using Take = std::function<void(const Making&)>;
  /// Something wanted, and how to begin with it; null where that can't be.
  struct Wanted {
    decltype(std::declval<const Making&>().key()) key{};
    std::function<std::shared_ptr<Making>()> begin;
  };
  /// The pool must not outlive it. `goOn` is called when a worker is free for what was not begun: `update` is due.
  JobQueue(WorkerPool& pool, Take take, std::function<void()> goOn)
      : pool_(pool), take_(std::move(take)), goOn_(std::move(goOn)) {}

  /// Lets go of what is not wanted any more, and begins with what is, each key once, as far as workers are free.
  void update(const std::vector<Wanted>& wanted) {
    std::erase_if(jobs_, [&](const std::shared_ptr<Job>& job) {
      const auto isIt = [&](const Wanted& one) { return one.key == job->making->key(); };
      job->dropped = std::ranges::none_of(wanted, isIt);
      return job->dropped.load();
    });
    waiting_ = false;
    const int most = std::max(1, pool_.threads());
    for (const Wanted& one : wanted) {
      const auto isIt = [&](const auto& job) { return job->making->key() == one.key; };
      if (std::ranges::any_of(jobs_, isIt)) continue;
      if (inHand_ >= most) {
        waiting_ = true;
        return;
      }
      auto making = one.begin();
      if (!making) continue;
      jobs_.push_back(std::make_shared<Job>());
      jobs_.back()->making = std::move(making);
      run(jobs_.back());
    }
  }

  /// Makes all that are wanted, now and here.
  void finish(const std::vector<Wanted>& wanted) {
    // What a worker has in hand is made anew: its steps are that worker's.
    update({});
    for (const Wanted& one : wanted) {
      const auto making = one.begin();
      if (!making) continue;
      while (making->step()) {
      }
      take_(*making);
    }
  }

  bool busy() const { return waiting_ || !jobs_.empty(); }

 private:
  struct Job {
    std::shared_ptr<Making> making;
    std::atomic<bool> dropped = false;  ///< nobody waits for it any more
  };

  void run(const std::shared_ptr<Job>& job) {
    const bool inOneGo = pool_.threads() > 0;
    ++inHand_;
    // No label: nobody who draws needs to know of it.
    pool_.submit(
        "",
        [job, inOneGo](const Progress& progress) {
          bool more = true;
          while (more && !job->dropped && !progress.cancelled()) {
            more = job->making->step();
            if (!inOneGo) break;
          }
          return more;
        },
        [this, job](bool more) {
          --inHand_;
          if (more && !job->dropped) {
            run(job);
            return;
          }
          if (!job->dropped) {
            std::erase(jobs_, job);
            take_(*job->making);
          }
          if (waiting_) goOn_();
        });
  }

  WorkerPool& pool_;
  Take take_;
  std::function<void()> goOn_;
  std::vector<std::shared_ptr<Job>> jobs_;  ///< begun and wanted
  int inHand_ = 0;                          ///< by the pool, dropped ones too
  bool waiting_ = false;                    ///< something wanted is not begun
};

}  // namespace spineloft::app
