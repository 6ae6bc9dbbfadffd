// Many steps at once, as when a key is held down or a program runs commands without waiting: what was overtaken costs
// neither work nor memory.
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/scarce_memory.h"
#include "tests/unit/web/rig.h"
#include "web/model/job_queue.h"

using namespace spineloft;
using namespace spineloft::test;

namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// A page with a picture of this size, most of it a bar, and a line along that.
struct LargeRig : Rig {
  explicit LargeRig(int threads) : Rig({1200, 700, 1}, threads) {}
  void openLarge() {
    constexpr int kSide = 800;
    image::Picture picture;
    picture.width = picture.height = kSide;
    picture.working = {kSide, kSide, std::vector<std::uint8_t>(std::size_t{4} * kSide * kSide, 250)};
    for (int y = 40; y < 760; ++y) {
      for (int x = 200; x < 600; ++x) picture.working.pixels[4 * (std::size_t{kSide} * y + x)] = 40;
    }
    app->addPicture(std::move(picture), "large.png");
    CHECK(settle());
    run("draw-spine", R"({"stroke":[[400,60],[401,400],[400,740]]})");
    CHECK(settle());
  }
};

/// Counts how many of it there are.
struct Counted {
  explicit Counted(std::uint64_t key) : key_(key) { most = std::max(most, ++there); }
  ~Counted() { --there; }
  std::uint64_t key() const { return key_; }
  bool step() { return ++steps_ < 3; }

  static inline int there = 0, most = 0;

 private:
  std::uint64_t key_;
  int steps_ = 0;
};

}  // namespace

TEST_CASE("of what is wanted only as much is in hand as there are workers, and what is wanted last is made" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    CAPTURE(threads);
    std::vector<std::uint64_t> made;
    bool due = false;
    WorkerPool pool(threads);
    app::JobQueue<Counted> queue(pool, [&](const Counted& one) { made.push_back(one.key()); }, [&] { due = true; });
    std::vector<app::JobQueue<Counted>::Wanted> wanted;
    const auto want = [&](std::uint64_t first) {
      wanted.clear();
      for (std::uint64_t key = first; key < first + 5; ++key)
        wanted.push_back({key, [key] { return std::make_shared<Counted>(key); }});
      queue.update(wanted);
    };
    Counted::most = 0;
    for (std::uint64_t round = 0; round < 100; ++round) want(10 * round);
    CHECK(Counted::most <= std::max(1, threads));
    made.clear();
    while (queue.busy()) {
      pool.pump();
      if (std::exchange(due, false) || !made.empty()) {
        std::erase_if(wanted, [&](const auto& one) { return std::ranges::count(made, one.key) > 0; });
        queue.update(wanted);
      }
      std::this_thread::yield();
    }
    CHECK(Counted::most <= std::max(1, threads));
    std::ranges::sort(made);
    CHECK(made == std::vector<std::uint64_t>{990, 991, 992, 993, 994});
    while (!pool.idle()) pool.pump();
    CHECK(Counted::there == 0);
  }
}

TEST_CASE("hundreds of steps, undos and redos without waiting need the memory of a few, and a new model gives it back" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    CAPTURE(threads);
    LargeRig rig(threads);
    const std::size_t empty = testing::liveBytes();
    rig.openLarge();
    const std::size_t begun = testing::liveBytes();
    testing::forgetMostLiveBytes();
    constexpr int kSteps = 361;
    for (int i = 1; i <= kSteps; ++i) {
      rig.host.clockMs += 2000;  // no burst that is one step
      const std::string turn = std::to_string(0.001 * i);
      CHECK(rig.run("set-along", R"({"kind":"twist","points":[[0,0],[1,)" + turn + "]]}").flag("ok") == true);
    }
    CHECK(rig.state().number("undo") >= kSteps);
    for (int i = 0; i < kSteps; ++i) CHECK(rig.run("undo").flag("ok") == true);
    for (int i = 0; i < kSteps; ++i) CHECK(rig.run("redo").flag("ok") == true);
    // What was made last is kept for undo, as far as the caches may (pipeline/cache.h).
    CHECK(testing::mostLiveBytes() <= begun + 64 * kMegabyte);
    REQUIRE(rig.settle());
    CHECK(testing::liveBytes() <= begun + 64 * kMegabyte);
    rig.app->restore("", "[]");
    REQUIRE(rig.settle());
    CHECK(testing::liveBytes() <= empty + 4 * kMegabyte);
  }
}
