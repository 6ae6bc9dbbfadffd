#include "engine/base/worker_pool.h"

#include <algorithm>
#include <deque>

#ifdef SPINELOFT_THREADS
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace spineloft {
namespace {

enum class JobState { Queued, Running, Finished };

#ifdef SPINELOFT_THREADS
/// A thread of a page is a script that is fetched, which may fail. When none has begun for so long after the first job,
/// `pump` runs the jobs until one does.
constexpr std::chrono::seconds kThreadBegins{5};
#endif

struct Job {
  std::string label;
  std::function<void(const Progress&)> work;
  std::function<void()> done;
  Progress progress;
  JobState state = JobState::Queued;
};

#ifndef SPINELOFT_THREADS
struct NoMutex {
  void lock() {}
  void unlock() {}
};
template <class M>
struct NoLock {
  explicit NoLock(M&) {}
};
#endif

}  // namespace

struct WorkerPool::Shared {
#ifdef SPINELOFT_THREADS
  mutable std::mutex mutex;
  std::condition_variable wake;
  std::vector<std::thread> threads;
  bool hasBegun = false;  ///< one of the threads at least
  std::optional<std::chrono::steady_clock::time_point> firstJob;
  using Lock = std::unique_lock<std::mutex>;
#else
  mutable NoMutex mutex;
  using Lock = NoLock<NoMutex>;
#endif
  std::deque<std::shared_ptr<Job>> jobs;  // unfinished and finished ones until pumped, oldest first
  bool closing = false;

  /// Whether jobs are the caller's work.
  bool isCallers() const {
#ifdef SPINELOFT_THREADS
    return threads.empty() || (!hasBegun && firstJob && std::chrono::steady_clock::now() - *firstJob > kThreadBegins);
#else
    return true;
#endif
  }

  std::shared_ptr<Job> takeQueued() {
    for (const auto& job : jobs) {
      if (job->state == JobState::Queued) {
        job->state = JobState::Running;
        return job;
      }
    }
    return nullptr;
  }
};

WorkerPool::WorkerPool([[maybe_unused]] int threads) : shared_(std::make_unique<Shared>()) {
#ifdef SPINELOFT_THREADS
  Shared* shared = shared_.get();
  for (int i = 0; i < std::clamp(threads, 0, 16); ++i) {
    shared->threads.emplace_back([shared] {
      Shared::Lock lock(shared->mutex);
      shared->hasBegun = true;
      while (true) {
        std::shared_ptr<Job> job;
        shared->wake.wait(lock, [&] { return shared->closing || (job = shared->takeQueued()); });
        if (!job) return;
        lock.unlock();
        job->work(job->progress);
        lock.lock();
        job->state = JobState::Finished;
      }
    });
  }
#endif
}

WorkerPool::~WorkerPool() {
  cancelAll();
#ifdef SPINELOFT_THREADS
  {
    const Shared::Lock lock(shared_->mutex);
    shared_->closing = true;
  }
  shared_->wake.notify_all();
  for (std::thread& thread : shared_->threads) thread.join();
#endif
}

Progress WorkerPool::enqueue(std::string label, std::function<void(const Progress&)> work, std::function<void()> done) {
  auto job = std::make_shared<Job>();
  job->label = std::move(label);
  job->work = std::move(work);
  job->done = std::move(done);
  {
    const Shared::Lock lock(shared_->mutex);
    shared_->jobs.push_back(job);
#ifdef SPINELOFT_THREADS
    if (!shared_->firstJob) shared_->firstJob = std::chrono::steady_clock::now();
#endif
  }
#ifdef SPINELOFT_THREADS
  shared_->wake.notify_one();
#endif
  return job->progress;
}

int WorkerPool::pump() {
  std::shared_ptr<Job> ours;
  {
    const Shared::Lock lock(shared_->mutex);
    if (shared_->isCallers()) ours = shared_->takeQueued();
  }
  if (ours) ours->work(ours->progress);
  std::deque<std::shared_ptr<Job>> finished;
  {
    const Shared::Lock lock(shared_->mutex);
    if (ours) ours->state = JobState::Finished;
    auto& jobs = shared_->jobs;
    const auto first = std::stable_partition(jobs.begin(), jobs.end(),
                                             [](const auto& job) { return job->state != JobState::Finished; });
    finished.assign(first, jobs.end());
    jobs.erase(first, jobs.end());
  }
  for (const auto& job : finished) job->done();  // outside the lock: it may submit the next job
  return static_cast<int>(finished.size());
}

bool WorkerPool::idle() const {
  const Shared::Lock lock(shared_->mutex);
  return shared_->jobs.empty();
}

int WorkerPool::threads() const {
#ifdef SPINELOFT_THREADS
  return static_cast<int>(shared_->threads.size());
#else
  return 0;
#endif
}

std::optional<WorkerPool::Activity> WorkerPool::activity() const {
  const Shared::Lock lock(shared_->mutex);
  if (shared_->jobs.empty()) return std::nullopt;
  const auto told = std::ranges::find_if(shared_->jobs, [](const auto& job) { return !job->label.empty(); });
  const Job& job = told == shared_->jobs.end() ? *shared_->jobs.front() : **told;
  return Activity{job.label, job.progress};
}

void WorkerPool::cancelAll() {
  const Shared::Lock lock(shared_->mutex);
  for (const auto& job : shared_->jobs) job->progress.cancel();
}

}  // namespace spineloft
