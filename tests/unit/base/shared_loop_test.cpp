#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "engine/base/shared_loop.h"
#include "engine/base/worker_pool.h"

using namespace spineloft;

namespace {

/// What a loop over `count` rounds did.
struct Rounds {
  explicit Rounds(int count) : times(static_cast<std::size_t>(count)) {}
  std::vector<std::atomic<int>> times;  ///< of every round
  std::array<std::atomic<int>, 2> running{};
  std::atomic<int> together{0};  ///< shares that ran beside another one of the same `who`

  void operator()(LoopShare share) {
    std::atomic<int>& own = running.at(static_cast<std::size_t>(share.who));
    if (own++ > 0) ++together;
    for (int i = share.first; i < share.end; ++i) ++times.at(static_cast<std::size_t>(i));
    --own;
  }
  bool eachOnce() const {
    return together == 0 && std::ranges::all_of(times, [](const std::atomic<int>& one) { return one == 1; });
  }
};

bool runsEachOnce(int count) {
  Rounds rounds(count);
  sharedLoop(count, [&](LoopShare share) { rounds(share); });
  return rounds.eachOnce();
}

}  // namespace

TEST_CASE("a shared loop runs every round once before it returns, however many there are" *
          doctest::test_suite("threads")) {
  for (int again = 0; again < 200; ++again) {
    for (const int count : {0, 1, 2, 3, 15, 16, 17, 33, 240, 1000}) REQUIRE(runsEachOnce(count));
  }
}

TEST_CASE("a second thread takes shares, if and only if the program has threads and the machine two processors" *
          doctest::test_suite("threads")) {
  const bool two = WorkerPool(1).threads() > 0 && std::thread::hardware_concurrency() > 1;
  std::atomic<int> helped{0};
  const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  do {
    sharedLoop(1000, [&](LoopShare share) {
      std::atomic<int> work{0};
      for (int i = share.first; i < share.end; ++i) {
        for (int k = 0; k < 100; ++k) ++work;
      }
      if (share.who == 1) helped += work;
    });
  } while (two && helped == 0 && std::chrono::steady_clock::now() < until);
  CHECK((helped > 0) == two);
}

TEST_CASE("loops of several threads at once, and loops within a share, run every round once" *
          doctest::test_suite("threads")) {
  WorkerPool pool(2);
  int good = 0;
  for (int job = 0; job < 40; ++job) {
    pool.submit(
        "", [](const Progress&) { return runsEachOnce(100) && runsEachOnce(7); }, [&](bool ok) { good += ok ? 1 : 0; });
  }
  std::atomic<int> nested{0};
  constexpr int kRounds = 40;
  sharedLoop(kRounds, [&](LoopShare share) {
    for (int i = share.first; i < share.end; ++i) nested += runsEachOnce(50) ? 1 : 0;
  });
  while (!pool.idle()) pool.pump();
  CHECK(good == 40);
  CHECK(nested == kRounds);
}
