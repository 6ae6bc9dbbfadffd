// Two bars on the page, and a solver of solids that answers when a test tells it to.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/unit/web/rig.h"

namespace spineloft::test {

/// Two bars side by side, and a solver that answers when it is told to.
struct TwoBars : Rig {
  TwoBars() {
    openBar();
    drawBar();
    run("draw-spine", R"({"stroke": [[110, 50], [112, 100], [110, 150]]})");
    settle();
  }

  /// How often the solver was asked, and what for last.
  std::size_t asked() const {
    std::size_t count = 0;
    for (const std::string& json : host.sent) count += json.find(R"("type":"solve")") != std::string::npos;
    return count;
  }
  app::Json lastAsked() const {
    for (std::size_t i = host.sent.size(); i > 0; --i) {
      if (host.sent[i - 1].find(R"("type":"solve")") != std::string::npos) return *app::Json::parse(host.sent[i - 1]);
    }
    FAIL("nothing was asked");
    return {};
  }
  app::Json step(std::size_t i = 0) { return (*state().find("steps")->array())[i]; }
  std::string status(std::size_t i = 0) { return *step(i).text("status"); }

  /// An answer to the request, with what else it says.
  static app::Json answerTo(const app::Json& request, app::Json::Object more) {
    more.emplace_back("id", *request.number("id"));
    return more;
  }
  static app::Json ofSolid(const app::Json& request, const char* what, app::Json value) {
    return answerTo(request, {{"step", 1},
                              {"key", *request.find("wanted")->array()->front().text()},
                              {"coarse", request.find("nodes")->array()->back().flag("coarse").value_or(false)},
                              {"ms", 3},
                              {what, std::move(value)}});
  }
  void say(const app::Json& answer, std::span<const std::uint8_t> bytes = {}) {
    app::JsonWriter json;
    json.value(answer);
    app->solved(json.json(), bytes);
  }
  /// A tetrahedron, whatever was asked for; half of it from each part, or all from the first.
  void answer(const app::Json& request, float size = 1, bool isOfOne = false, std::uint32_t apart = 1) {
    std::vector<float> positions;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < apart; ++i) {
      const float left = 3 * size * static_cast<float>(i);
      for (const float x : {left, 0.f, 0.f, left + size, 0.f, 0.f, left, size, 0.f, left, 0.f, size})
        positions.push_back(x);
      for (const std::uint32_t corner : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 0u, 3u, 2u})
        corners.push_back(4 * i + corner);
    }
    const std::vector<float> uv(2 * positions.size() / 3);
    std::vector<std::uint8_t> bytes;
    const auto add = [&](const auto& values) {
      const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
      bytes.insert(bytes.end(), first, first + values.size() * sizeof values[0]);
    };
    add(positions);
    add(uv);
    add(corners);
    const std::string count = std::to_string(4 * apart), half = std::to_string(2 * apart);
    const std::string runs = isOfOne ? R"({"part":1,"first":0,"count":)" + count + "}"
                                     : R"({"part":1,"first":0,"count":)" + half + R"(},{"part":2,"first":)" + half +
                                           R"(,"count":)" + half + "}";
    const app::Json mesh = *app::Json::parse(R"({"vertices":)" + count + R"(,"triangles":)" + count +
                                             R"(,"merges":0,"volume":0.1,"area":2,"genus":0,"runs":[)" + runs + "]}");
    say(ofSolid(request, "mesh", mesh), bytes);
    done(request);
  }
  void fail(const app::Json& request, app::Json failure) {
    say(ofSolid(request, "failure", std::move(failure)));
    done(request);
  }
  void done(const app::Json& request) { say(answerTo(request, {{"done", true}})); }
  void lost(bool loaded = true) { say(app::Json::Object{{"lost", true}, {"loaded", loaded}}); }

  void tick(int part, bool on = true) {
    run("pick", R"({"part": )" + std::to_string(part) + R"(, "on": )" + (on ? "true}" : "false}"));
    state();
  }
  void stick(const char* args = "{}") {
    CHECK(run("stick-together", args).flag("ok").value_or(false));
    state();
  }
  bool busy() { return *state().flag("busy"); }
};

/// The same, stuck together; nothing is answered yet.
struct Stuck : TwoBars {
  Stuck() { stick(R"({"parts": [1, 2]})"); }
};

}  // namespace spineloft::test
