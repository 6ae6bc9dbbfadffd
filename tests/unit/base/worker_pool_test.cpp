#include <doctest/doctest.h>

#include <atomic>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/worker_pool.h"

using namespace spineloft;

namespace {

void pumpUntilIdle(WorkerPool& pool) {
  while (!pool.idle()) pool.pump();
}

}  // namespace

TEST_CASE("every job of a pool is worked once and finished on the owner's call of pump" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 1, 3}) {
    WorkerPool pool(threads);
    std::atomic<int> worked{0};
    std::vector<int> results;
    for (int i = 0; i < 50; ++i) {
      pool.submit(
          "count", [i, &worked](const Progress&) { return ++worked, i * i; },
          [&results](int value) { results.push_back(value); });
    }
    CHECK(results.empty());
    pumpUntilIdle(pool);
    CHECK(worked == 50);
    REQUIRE(results.size() == 50);
    int sum = 0;
    for (const int value : results) sum += value;
    CHECK(sum == 40425);
  }
}

TEST_CASE("a cancelled job still reports, as cancelled" * doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    WorkerPool pool(threads);
    std::vector<Result<int>> results;
    const Progress progress = pool.submit(
        "wait for cancel",
        [](const Progress& p) -> Result<int> {
          for (int i = 0; p.advance(i * 1e-9); ++i) {
          }
          return Error::Cancelled;
        },
        [&](Result<int> r) { results.push_back(std::move(r)); });
    REQUIRE(pool.activity().has_value());
    CHECK(pool.activity()->label == "wait for cancel");
    progress.cancel();
    pumpUntilIdle(pool);
    REQUIRE(results.size() == 1);
    CHECK(results[0].error() == Error::Cancelled);
    CHECK_FALSE(pool.activity().has_value());
  }
}

TEST_CASE("a finished job may submit the next one, and a pool may die with work in hand" *
          doctest::test_suite("threads")) {
  int finished = 0;
  {
    WorkerPool pool(1);
    pool.submit(
        "first", [](const Progress&) { return 1; },
        [&](int) {
          ++finished;
          pool.submit("second", [](const Progress&) { return 2; }, [&](int) { ++finished; });
        });
    pumpUntilIdle(pool);
    CHECK(finished == 2);
    pool.submit(
        "never ends by itself",
        [](const Progress& p) {
          while (p.advance(0)) {
          }
          return 3;
        },
        [&](int) { ++finished; });
  }
  CHECK(finished == 2);
}
