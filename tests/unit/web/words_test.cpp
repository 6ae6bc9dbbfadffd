// What lies above the views: words are clear of each other and of everything that can be pressed.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "tests/unit/web/rig.h"
#include "tests/unit/web/shown.h"
#include "web/panels/widgets.h"

using namespace spineloft;
using app::Json;
using app::Rect;
using spineloft::test::inSight;
using spineloft::test::Rig;
using spineloft::test::Shown;

namespace {

/// The words above the views are on the canvas and clear of all else; all of them.
std::set<std::string> clearWords(Rig& rig, const platform::CanvasSize& size) {
  std::set<std::string> words;
  const std::vector<Shown> all = inSight(rig);
  for (const Shown& one : all) {
    if (one.kind != "words") continue;
    words.insert(one.words);
    CAPTURE(size.width);
    CAPTURE(one.words);
    CHECK(one.at.x >= 0);
    CHECK(one.at.right() <= size.width);
    CHECK(one.at.y >= 0);
    CHECK(one.at.bottom() <= size.height);
    for (const Shown& other : all) {
      CAPTURE(other.words);
      if (&other != &one) CHECK_FALSE(one.at.meets(other.at));
    }
  }
  return words;
}

/// Windows of 1440 × 900, 1024 × 768, 390 × 844 and 320 × 568 below the bar of the page, the last two for fingers.
const platform::CanvasSize kCanvases[] = {{1440, 844, 1}, {1024, 712, 1}, {390, 780, 2}, {320, 504, 2}};

}  // namespace

TEST_CASE("words that make room are clear of everything, and moved no farther than that takes") {
  Rng rng(11);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Rect> taken;
    for (std::uint32_t i = rng.below(6) + 1; i > 0; --i) {
      taken.push_back({rng.uniform(0, 300), rng.uniform(0, 300), rng.uniform(1, 120), rng.uniform(1, 80)});
    }
    const Rect words{rng.uniform(0, 300), rng.uniform(0, 300), rng.uniform(1, 150), rng.uniform(1, 40)};
    const double gap = rng.uniform(1, 8);
    for (const app::Toward way : {app::Toward::Head, app::Toward::Foot}) {
      const Rect at = app::clearOf(words, taken, gap, way);
      CHECK(at == Rect{words.x, at.y, words.width, words.height});
      const double moved = way == app::Toward::Head ? words.y - at.y : at.y - words.y;
      CHECK(moved >= 0);
      const auto isClear = [&](double y) {
        return std::ranges::none_of(taken, [&](const Rect& one) {
          const double slack = gap - 1e-4;
          return Rect{words.x, y, words.width, words.height}.meets(
              {one.x - slack, one.y - slack, one.width + 2 * slack, one.height + 2 * slack});
        });
      };
      CHECK(isClear(at.y));
      for (int k = 0; k < 20 && moved > 1e-3; ++k) {
        const double nearer = rng.uniform(0, moved - 1e-3);
        CHECK_FALSE(isClear(way == app::Toward::Head ? words.y - nearer : words.y + nearer));
      }
    }
  }
}

TEST_CASE(
    "what is to be done with a cut-out covers neither the legend of the ribs nor a button, in windows of every size") {
  for (const platform::CanvasSize& size : kCanvases) {
    Rig rig(size);
    rig.openBar();
    const platform::Device device = size.width < 500 ? platform::Device::Touch : platform::Device::Mouse;
    rig.drawBar(device);
    clearWords(rig, size);
    for (const char* tool : {"puff", "ribs", "bone", "sheet"}) {
      rig.run(tool);
      rig.settle();
      clearWords(rig, size);
    }
    rig.run("puff");
    rig.run("cut-start", R"({"at": [100, 100]})");
    rig.settle();
    for (const char* brush : {"cut-add", "cut-remove"}) {
      rig.run(brush);
      rig.settle();
      const std::set<std::string> words = clearWords(rig, size);
      const bool adds = std::string_view(brush) == "cut-add";
      // In the lowest view there is no room for it; the status line says it, too.
      const bool told = words.contains(adds ? "Draw over what is missing" : "Draw over what is too much");
      CHECK((told || size.height < 600));
    }
    rig.run("cut-use");
    rig.settle();
    clearWords(rig, size);
    rig.run("select-part", R"({"id": 1})");
    rig.run("redraw");
    rig.settle();
    clearWords(rig, size);
  }
}

TEST_CASE("words that fit when they are a little smaller are not shortened, and none is smaller than 11 CSS pixels") {
  Rig rig;
  rig.openBar();
  ImFont* font = ImGui::GetIO().FontDefault;
  const std::string_view words = "Half round";
  const float wide = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.data(), words.data() + words.size()).x;
  for (float share = 0.4f; share < 1.2f; share += 0.013f) {
    CAPTURE(share);
    const panels::Fitted fit = panels::fitted(font, panels::asIs(words), share * wide);
    CHECK((fit.text == words) == (share >= 11 / app::kTextEm));
    CHECK(fit.share * app::kTextEm > 10.999f);
  }
}
