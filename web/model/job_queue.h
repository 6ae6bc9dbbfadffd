// What takes longer than a frame, step by step: done by the workers, or between frames.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "engine/base/worker_pool.h"

namespace spineloft::app {

/// `Making` has a key(), and a step() that says whether there is another; it runs on one thread at a time.
template <class Making>
class JobQueue {
 public:
  /// Is handed what is made.
  using Take = std::function<void(const Making&)>;
  /// Something wanted, and how to begin with it; null where that can't be.
  struct Wanted {
    std::uint64_t key = 0;
    std::function<std::shared_ptr<Making>()> begin;
  };
  /// The pool must not outlive it.
  JobQueue(WorkerPool& pool, Take take) : pool_(pool), take_(std::move(take)) {}

  /// Begins with what is wanted now, each key once, and lets go of what is not any more. As many are made at a time
  /// as there are workers; without any, a step of one a job.
  void update(const std::vector<Wanted>& wanted) {
    std::vector<std::shared_ptr<Job>> jobs;
    for (const Wanted& one : wanted) {
      const auto isIt = [&](const auto& job) { return job->making->key() == one.key; };
      if (std::ranges::any_of(jobs, isIt)) continue;
      const auto known = std::ranges::find_if(jobs_, isIt);
      if (known != jobs_.end()) {
        jobs.push_back(*known);
      } else if (auto making = one.begin()) {
        jobs.push_back(std::make_shared<Job>());
        jobs.back()->making = std::move(making);
      }
    }
    for (const auto& job : jobs_) {
      if (!std::ranges::count(jobs, job)) job->dropped = true;
    }
    jobs_ = std::move(jobs);
    start();
  }

  /// Makes all that are wanted, now and here.
  void finish(const std::vector<Wanted>& wanted) {
    // What a worker has in hand is made anew: its steps are that worker's.
    for (const auto& job : jobs_) job->dropped = true;
    jobs_.clear();
    for (const Wanted& one : wanted) {
      const auto making = one.begin();
      if (!making) continue;
      while (making->step()) {
      }
      take_(*making);
    }
  }

  bool busy() const { return !jobs_.empty(); }

 private:
  struct Job {
    std::shared_ptr<Making> making;
    bool started = false;
    std::atomic<bool> dropped = false;  ///< nobody waits for it any more
  };

  void start() {
    const auto most = static_cast<std::size_t>(std::max(1, pool_.threads()));
    for (std::size_t i = 0; i < std::min(most, jobs_.size()); ++i) {
      if (!std::exchange(jobs_[i]->started, true)) run(jobs_[i]);
    }
  }

  void run(const std::shared_ptr<Job>& job) {
    const bool inOneGo = pool_.threads() > 0;
    // No label: nobody who draws needs to know of it.
    pool_.submit(
        "",
        [job, inOneGo](const Progress& progress) {
          bool more = true;
          do {
            more = job->making->step();
          } while (more && inOneGo && !job->dropped && !progress.cancelled());
          return more;
        },
        [this, job](bool more) {
          if (job->dropped) return;
          if (more) {
            run(job);
            return;
          }
          std::erase(jobs_, job);
          start();
          take_(*job->making);
        });
  }

  WorkerPool& pool_;
  Take take_;
  std::vector<std::shared_ptr<Job>> jobs_;  ///< in the order of the parts
};

}  // namespace spineloft::app
