#include "tests/bench/accuracy/redrawn_strokes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace spineloft;
using namespace spineloft::accuracy;

namespace {

constexpr double kWidth = 40;

/// A straight thing 400 px long along x, 40 px wide on y = 100; its middle line is drawn right to left.
io::BenchCase bar(const std::string& id) {
  io::BenchCase one;
  one.id = id;
  for (int x = 450; x >= 50; x -= 2) one.axis.push_back({static_cast<double>(x), 100, kWidth});
  for (const char* name : {"careful", "sloppy", "mine", "offcentre"})
    one.strokes.push_back({name, {{70, 100}, {430, 100}}});
  return one;
}

}  // namespace

TEST_CASE("strokes drawn anew stay near the middle line, between the careful one's ends, and are the seed's alone") {
  bool left = false, right = false, forwards = false, backwards = false;
  for (int seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    io::BenchCase one = bar("bar"), same = bar("bar"), other = bar("another");
    redrawStrokes(one, static_cast<std::uint64_t>(seed));
    redrawStrokes(same, static_cast<std::uint64_t>(seed));
    redrawStrokes(other, static_cast<std::uint64_t>(seed));
    CHECK(one.strokes == same.strokes);
    CHECK(one.strokes != other.strokes);
    CHECK(one.strokes[2] == bar("bar").strokes[2]);
    double furthest = 0;
    for (const auto& [name, line] : one.strokes) {
      CAPTURE(name);
      if (name == "mine") continue;
      REQUIRE(line.size() == 80);
      const double ends = std::min(std::abs(line.front().x - line.back().x), 360.);
      CHECK(ends >= 360 - 2 * 0.25 * kWidth - 1e-9);
      double aside = 0;
      for (const PicturePoint p : line) {
        const double off = (p.y - 100) / kWidth;
        CHECK(p.x >= 70 - 1e-9);
        CHECK(p.x <= 430 + 1e-9);
        CHECK(std::abs(off) <= (name == "careful" ? 0.03 : name == "sloppy" ? 0.13 : 0.27) + 1e-9);
        if (name == "offcentre") CHECK(std::abs(off) >= 0.17 - 1e-9);
        aside += off;
        furthest = std::max(furthest, std::abs(off));
      }
      if (name == "offcentre") (aside < 0 ? left : right) = true;
      (line.front().x < line.back().x ? forwards : backwards) = true;
    }
    CHECK(furthest > 0.17);
  }
  CHECK((left && right && forwards && backwards));
}

TEST_CASE("a case without a careful stroke, or without a middle line, keeps its strokes") {
  io::BenchCase one = bar("bar");
  one.strokes.erase(one.strokes.begin());
  const auto before = one.strokes;
  redrawStrokes(one, 1);
  CHECK(one.strokes == before);
  io::BenchCase bare = bar("bar");
  bare.axis.clear();
  redrawStrokes(bare, 1);
  CHECK(bare.strokes == bar("bar").strokes);
}
