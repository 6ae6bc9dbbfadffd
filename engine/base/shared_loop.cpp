#include "engine/base/shared_loop.h"

#ifdef SPINELOFT_THREADS
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#endif

namespace spineloft {

#ifdef SPINELOFT_THREADS
namespace {

/// The thread that takes shares, for as long as the program runs. It is asleep where none was offered for a while: the
/// caller goes on alone while it wakes up.
class Helper {
 public:
  Helper() {
    if (std::thread::hardware_concurrency() < 2) return;
    // Signals are for the threads that know of them.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      std::thread([this] { live(); }).detach();
      isThere_ = true;
    } catch (...) {  // there is none
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  /// False where it is another caller's, or there is none. Else all is done.
  bool run(int count, LoopWork call, const void* work) {
    if (!isThere_ || isTaken_.exchange(true)) return false;
    call_ = call;
    work_ = work;
    count_ = count;
    next_ = 0;
    state_ = State::Offered;
    if (isAsleep_) {
      const std::lock_guard lock(mutex_);
      isWanted_ = true;
      wake_.notify_one();
    }
    takeShares(0);
    State offered = State::Offered;
    if (!state_.compare_exchange_strong(offered, State::Idle)) {
      for (int looks = 0; state_ != State::Done; ++looks) {
        if (looks > kLooks) std::this_thread::yield();  // that thread may have lost its processor
      }
      state_ = State::Idle;
    }
    isTaken_ = false;
    return true;
  }

 private:
  enum class State { Idle, Offered, Running, Done };

  /// Of so many shares a slow processor takes few, and the last one is soon done.
  static constexpr int kShares = 16;
  /// Between two loops of one calculation it stays awake.
  static constexpr std::chrono::milliseconds kAwake{1};
  /// The last share mostly ends a few microseconds after the others.
  static constexpr int kLooks = 2000;

  void takeShares(int who) {
    const int size = std::max(1, (count_ + kShares - 1) / kShares);
    for (int first = next_.fetch_add(size); first < count_; first = next_.fetch_add(size)) {
      call_(work_, {first, std::min(first + size, count_), who});
    }
  }

  void live() {
    while (true) {
      for (auto last = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - last < kAwake;) {
        if (joinLoop()) last = std::chrono::steady_clock::now();
        std::this_thread::yield();
      }
      std::unique_lock lock(mutex_);
      isAsleep_ = true;
      wake_.wait(lock, [this] { return isWanted_ || state_ == State::Offered; });
      isAsleep_ = isWanted_ = false;
    }
  }

  bool joinLoop() {
    State offered = State::Offered;
    if (!state_.compare_exchange_strong(offered, State::Running)) return false;
    takeShares(1);
    state_ = State::Done;
    return true;
  }

  std::atomic<State> state_{State::Idle};
  std::atomic<bool> isTaken_{false}, isAsleep_{false};
  std::atomic<int> next_{0};
  LoopWork call_ = nullptr;
  const void* work_ = nullptr;
  int count_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool isWanted_ = false;  ///< a loop came while it was asleep
  bool isThere_ = false;
};

/// Null while another thread makes it: nobody waits for that.
Helper* helper() {
  static std::atomic<bool> isBegun{false};
  static std::atomic<Helper*> made{nullptr};
  if (Helper* there = made) return there;
  if (!isBegun.exchange(true)) made = new (std::nothrow) Helper;
  return made;
}

}  // namespace
#endif

void runShares(int count, LoopWork call, const void* work) {
#ifdef SPINELOFT_THREADS
  Helper* other = helper();
  if (other != nullptr && other->run(count, call, work)) return;
#endif
  if (count > 0) call(work, {0, count, 0});
}

}  // namespace spineloft
