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
  void answer(const app::Json& request, float size = 1, bool isOfOne = false) {
    const std::array<float, 12> positions{0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size};
    const std::array<float, 8> uv{};
    const std::array<std::uint32_t, 12> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    std::vector<std::uint8_t> bytes(sizeof positions + sizeof uv + sizeof corners);
    std::memcpy(bytes.data(), positions.data(), sizeof positions);
    std::memcpy(bytes.data() + sizeof positions, uv.data(), sizeof uv);
    std::memcpy(bytes.data() + sizeof positions + sizeof uv, corners.data(), sizeof corners);
    const std::string runs = isOfOne ? R"({"part":1,"first":0,"count":4})"
                                     : R"({"part":1,"first":0,"count":2},{"part":2,"first":2,"count":2})";
    const app::Json mesh =
        *app::Json::parse(R"({"vertices":4,"triangles":4,"merges":0,"volume":0.1,"area":2,"genus":0,)"
                          R"("runs":[)" +
                          runs + "]}");
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
