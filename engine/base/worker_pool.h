// Work off the caller's thread, through one interface that also serves the single-thread build.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/progress.h"

namespace spineloft {

/// A few threads that take jobs in order. Every call comes from the owner's thread; only the `work`
/// functions run elsewhere. With 0 threads (or in a build without threads) `pump` runs the jobs
/// itself, one a call, so that everything works the same, only less smoothly.
class WorkerPool {
 public:
  /// `threads` 0…16; ignored in a build without threads.
  explicit WorkerPool(int threads);
  /// Cancels what is queued or running, waits for the running jobs to notice, drops their results.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Queues a job. `work(progress)` returns a value; it may run on another thread and must not throw.
  /// `done(value)` runs later inside `pump` on the owner's thread, also when the job was cancelled
  /// (the value then says so, as Results do). `label` says what is being done, for the page;
  /// empty: nothing that anybody needs to know of.
  template <class Work, class Finish>
  Progress submit(std::string label, Work work, Finish done) {
    using Value = decltype(work(std::declval<const Progress&>()));
    auto slot = std::make_shared<std::optional<Value>>();
    return enqueue(
        std::move(label), [slot, work = std::move(work)](const Progress& progress) { slot->emplace(work(progress)); },
        [slot, done = std::move(done)]() mutable { done(std::move(**slot)); });
  }

  /// Runs `done` of every finished job; with 0 threads first runs the oldest queued job. Returns how
  /// many jobs were finished.
  int pump();
  /// Nothing queued, running or waiting for `pump`.
  bool idle() const;
  int threads() const;

  /// The oldest unfinished job, for a progress bar; one with a label, if there is any.
  struct Activity {
    std::string label;
    Progress progress;
  };
  std::optional<Activity> activity() const;
  /// Asks every unfinished job to stop.
  void cancelAll();

 private:
  Progress enqueue(std::string label, std::function<void(const Progress&)> work, std::function<void()> done);
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace spineloft
