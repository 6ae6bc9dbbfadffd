// Work on solids that is stopped by hand, again and again, at any moment: what was good last stays.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/web/two_bars.h"

using namespace spineloft;
using app::Json;
using test::Stuck;
using test::TwoBars;

namespace {

/// Where the corners of everything that is drawn are, mesh after mesh.
std::vector<std::array<float, 3>> shown(test::Rig& rig) {
  rig.host.clockMs += 16;
  rig.app->frame();
  std::vector<std::array<float, 3>> corners;
  for (const gl::SceneMesh& mesh : rig.gl->last.meshes) {
    for (const auto& triangle : mesh.mesh->triangles) {
      for (const auto v : triangle) {
        const auto& p = mesh.mesh->positions[v];
        corners.push_back({p[0], p[1], p[2]});
      }
    }
  }
  return corners;
}

/// What a request asks for, without where its arrays happen to lie.
std::string meaning(const Json& request) {
  app::JsonWriter json;
  json.value(*request.find("nodes"));
  json.value(*request.find("wanted"));
  return json.json();
}

/// The request that the page makes of a model's file by itself.
std::string askedAfresh(std::span<const std::uint8_t> file) {
  ImGuiContext* const ours = ImGui::GetCurrentContext();
  ImGui::SetCurrentContext(nullptr);
  std::string asked;
  {
    TwoBars other;
    REQUIRE(Json::parse(other.app->openProject(file, "{}"))->flag("ok") == true);
    other.settle();
    other.state();
    asked = meaning(other.lastAsked());
  }
  ImGui::SetCurrentContext(ours);
  return asked;
}

/// An edit that makes a solid that was never there before, in one of several ways.
void editAnew(TwoBars& rig, Rng& random, int round) {
  const std::string part = std::to_string(1 + random.below(2));
  constexpr std::array kSections{"square", "star", "circle", "hexagon"};
  if (random.below(3) == 0) {
    rig.run("set-section", R"({"part": )" + part + R"(, "section": ")" + kSections[random.below(4)] + R"("})");
  }
  rig.run("move-parts", R"({"parts": [)" + part + R"(], "mm": [)" + std::to_string(0.3 + 0.01 * round) + ", 0, 0]}");
}

/// The solver gets on with it for a while; frames are drawn meanwhile.
void workAWhile(TwoBars& rig, Rng& random, const Json& request) {
  for (std::uint32_t i = random.below(5); i > 0; --i) {
    rig.say(TwoBars::answerTo(request, {{"progress", random.uniform()}}));
    rig.host.clockMs += 16;
    rig.app->frame();
  }
}

}  // namespace

TEST_CASE(
    "edits that are stopped at any moment leave the last good solid, and the one after them is as if they "
    "had not been") {
  Rng random(404);
  Stuck rig;
  rig.answer(rig.lastAsked());
  REQUIRE(rig.settle());
  auto good = shown(rig);
  REQUIRE(good.size() == 12);
  std::optional<Json> stopped;
  int cancels = 0, solids = 0;
  for (int round = 0; cancels < testing::rounds(40); ++round) {
    CAPTURE(round);
    const std::size_t before = rig.asked();
    editAnew(rig, random, round);
    // Else it is stopped before anybody looks at it.
    const bool looks = random.below(4) != 0;
    if (looks) rig.state();
    const std::size_t asked = rig.asked();
    REQUIRE(asked > before);
    const Json request = rig.lastAsked();
    // What was stopped is done nonetheless, too late.
    if (stopped && random.below(3) == 0) rig.answer(*stopped, 50);
    if (looks) {
      workAWhile(rig, random, request);
      REQUIRE(rig.status() == "waiting");
      REQUIRE(shown(rig) == good);
    }
    if (random.below(5) == 0) {
      rig.answer(request, 1 + 0.1f * static_cast<float>(++solids));
      REQUIRE(rig.settle());
      REQUIRE(rig.status() == "ready");
      REQUIRE(shown(rig) != good);
      good = shown(rig);
      stopped.reset();
      continue;
    }
    rig.app->cancelWork();
    ++cancels;
    REQUIRE(rig.settle());
    REQUIRE(*rig.step().text("failure") == "Cancelled");
    REQUIRE(rig.step().number("triangles") == 4);
    REQUIRE_FALSE(rig.busy());
    REQUIRE(shown(rig) == good);
    REQUIRE(rig.asked() == asked);
    stopped = request;
  }
  CHECK(10 * solids > cancels);
  CHECK(std::ranges::count(rig.host.sent, R"({"type":"stopSolving"})") == cancels);

  rig.run("solve-again");
  rig.state();
  const Json last = rig.lastAsked();
  const auto file = rig.app->exportModel("spineloft");
  CHECK(meaning(last) == askedAfresh(std::vector<std::uint8_t>(file.begin(), file.end())));
  rig.answer(last, 9);
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
  CHECK(shown(rig) != good);
}
