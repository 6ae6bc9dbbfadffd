#include "web/gl/kept_items.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "engine/base/rng.h"

using namespace spineloft;

namespace {

bool holds(const std::vector<int>& all, const std::vector<int>& some) {
  return std::ranges::all_of(some, [&](int item) { return std::ranges::count(all, item) == 1; });
}

/// Frames of a row of things of which some change from time to time, seen from places that change now and then.
struct Frames {
  explicit Frames(std::uint64_t seed) : rng(seed) {
    for (int i = 0; i < 8; ++i) items.push_back(next++);
  }
  void step() {
    alike = rng.below(10) != 0;
    if (rng.below(6) == 0) moved = rng.below(static_cast<std::uint32_t>(items.size()));
    if (rng.below(4) != 0) items[moved] = next++;
    if (rng.below(30) == 0 && items.size() > 2) items.pop_back();
    if (rng.below(30) == 0) items.push_back(next++);
    moved = std::min<std::size_t>(moved, items.size() - 1);
  }
  Rng rng;
  std::vector<int> items;
  std::size_t moved = 0;
  int next = 0;
  bool alike = false;
};

}  // namespace

TEST_CASE("every thing of a frame is in the picture or drawn besides, and the picture is the one that was drawn last") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Frames frames(seed);
    gl::KeptItems<int> kept;
    std::vector<int> drawn;
    bool usable = false;  // seen from the place that it was drawn for
    for (int frame = 0; frame < 200; ++frame) {
      frames.step();
      kept.follow(frames.items, frames.alike);
      usable = usable && frames.alike;
      if (frames.rng.below(12) == 0) {  // another number of pixels
        kept.dropPicture();
        usable = false;
      }
      if (frames.rng.below(5) == 0) continue;  // a frame that is drawn in another way
      if (kept.share()) {
        drawn = kept.picture();
        usable = true;
      }
      if (!kept.picture().empty()) {
        CHECK(usable);
        CHECK(kept.picture() == drawn);
      }
      CHECK(holds(frames.items, kept.picture()));
      std::vector<int> all = kept.picture();
      all.insert(all.end(), kept.others().begin(), kept.others().end());
      CHECK(std::ranges::is_permutation(all, frames.items));
    }
  }
}

TEST_CASE("while one of eight things moves, its picture is drawn once") {
  std::vector<int> items{1, 2, 3, 4, 5, 6, 7, 8};
  gl::KeptItems<int> kept;
  int drawn = 0;
  for (int frame = 0; frame < 50; ++frame) {
    if (frame % 7 != 3) items[2] = 100 + frame;
    kept.follow(items, true);
    if (kept.share()) ++drawn;
    if (frame > 0) CHECK(kept.picture().size() == 7);
    if (frame > 0) CHECK(kept.others() == std::vector{items[2]});
  }
  CHECK(drawn == 1);
}

TEST_CASE("from another place nothing is taken from the picture") {
  const std::vector<int> items{1, 2, 3};
  gl::KeptItems<int> kept;
  kept.follow(items, true);
  kept.share();
  kept.follow(items, true);
  CHECK(kept.share());
  CHECK(kept.picture() == items);
  kept.follow(items, false);
  CHECK_FALSE(kept.share());
  CHECK(kept.picture().empty());
  CHECK(kept.others() == items);
}

TEST_CASE("a picture of another size is drawn in the frame that asks for it, of what stays") {
  std::vector<int> items{1, 2, 3, 4};
  gl::KeptItems<int> kept;
  for (int frame = 0; frame < 3; ++frame) {
    items[0] = 10 + frame;
    kept.follow(items, true);
    kept.share();
  }
  items[0] = 20;
  kept.follow(items, true);
  kept.dropPicture();
  CHECK(kept.share());
  CHECK(kept.picture() == std::vector{2, 3, 4});
  CHECK(kept.others() == std::vector{20});
}
