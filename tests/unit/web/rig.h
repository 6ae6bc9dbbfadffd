// The whole page without a browser: a host that remembers, a renderer that draws nothing, and a
// hand that draws.
#pragma once

#include <doctest/doctest.h>
#include <imgui.h>

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/io/share_text.h"
#include "engine/vision/cut_out_numbers.h"
#include "web/gl/null_renderer.h"
#include "web/model/json.h"
#include "web/page/app.h"

namespace spineloft::test {

class FakeHost final : public platform::Host {
 public:
  double nowMs() const override { return clockMs; }
  void requestFrame() override { frameAsked = true; }
  void wakeAfter(double) override { ++wakesAsked; }
  void send(std::string_view json) override { sent.emplace_back(json); }
  void solve(std::string_view json, std::span<const platform::SolverMesh> meshes) override {
    sent.emplace_back(json);
    given.assign(meshes.begin(), meshes.end());
  }
  void cutOut(const platform::CutRequest& request) override {
    search = Search{request.id, request.picture, vision::hintsFrom(request.hints), {}};
    pictureKeys.emplace_back(request.pictureKey);
  }
  /// A round of the search that is asked for, as the program of the page does it, and what it says.
  void cutOnce(platform::Page& page) {
    using enum platform::CutAnswer::Kind;
    if (!search) return;
    Search& now = *search;
    REQUIRE(now.hints);
    if (!now.rounds) now.rounds.emplace(vision::CutOutSearch::begin(now.picture, *now.hints));
    Result<vision::CutOutSearch>& rounds = *now.rounds;
    if (rounds && rounds.value().step()) {
      page.cutOutAnswered({now.id, Progress, rounds.value().done(), {}});
      return;
    }
    const auto found =
        vision::numbersOf(rounds ? rounds.value().outlines() : Result<vision::CutContours>(rounds.failure()));
    const std::uint32_t id = now.id;
    search.reset();
    page.cutOutAnswered({id, Found, 1, found});
  }
  void sendFile(std::string_view name, std::string_view, std::span<const std::uint8_t> b) override {
    files.emplace_back(std::string(name), b.size());
  }
  bool drawsSlowly() const override { return slow; }
  void setPixels(const platform::CanvasSize& size) override { canvas = size; }
  bool reducedMotion() const override { return reduced; }
  bool said(std::string_view part) const {
    for (const std::string& json : sent) {
      if (json.find(part) != std::string::npos) return true;
    }
    return false;
  }

  double clockMs = 1000;
  bool frameAsked = false, reduced = false, slow = false;
  platform::CanvasSize canvas;
  int wakesAsked = 0;
  std::vector<std::string> sent;
  std::vector<platform::SolverMesh> given;  ///< to the solver, last
  std::vector<std::pair<std::string, std::size_t>> files;
  /// For a cut-out that is asked for.
  struct Search {
    std::uint32_t id = 0;
    image::Picture picture;
    std::optional<vision::CutHints> hints;
    std::optional<Result<vision::CutOutSearch>> rounds;
  };
  std::optional<Search> search;
  std::vector<std::string> pictureKeys;  ///< of all cut-outs that were asked for
};

/// A dark vertical bar on white paper; its middle line runs from (100, 40) to (100, 160).
inline image::Picture barPicture(int width = 200, int height = 200) {
  image::Picture picture;
  picture.width = width;
  picture.height = height;
  picture.working = {width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool inside = x >= 80 && x < 121 && y >= 30 && y < 171;
      const std::uint8_t v = inside ? 40 : 250;
      picture.working.pixels.insert(picture.working.pixels.end(), {v, v, v, 255});
    }
  }
  return picture;
}

class Rig {
 public:
  explicit Rig(platform::CanvasSize size = {1200, 700, 1}, int threads = 0) : threads_(threads) {
    ImGui::CreateContext();
    auto renderer = std::make_unique<gl::NullRenderer>();
    gl = renderer.get();
    app = std::make_unique<app::App>(app::App::Parts{host, std::move(renderer), {}, threads}, size);
    settle();
  }
  ~Rig() {
    app.reset();
    ImGui::DestroyContext();
  }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  /// Gives the page frames and wakes until it asks for no more. False when it does not rest within `most` turns of
  /// 16 ms of its own time, as while a solid waits for a solver; with workers within two minutes, because how many
  /// frames it draws until they are done is up to the machine.
  bool settle(int most = 300) {
    const auto start = std::chrono::steady_clock::now();
    for (int turns = 0; threads_ > 0 || turns < most; ++turns) {
      host.clockMs += 16;
      host.cutOnce(*app);
      if (std::exchange(host.wakesAsked, 0) > 0) app->wake();
      const bool drawn = std::exchange(host.frameAsked, false);
      if (drawn) app->frame();
      if (!drawn && app->idle() && host.wakesAsked == 0) return true;
      if (threads_ == 0 || (drawn && turns < most)) continue;
      if (std::chrono::steady_clock::now() - start > std::chrono::minutes(2)) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // a worker has it
    }
    return false;
  }
  void openBar() {
    app->addPicture(barPicture(), "bar.png");
    settle();
  }
  app::Json state() { return *app::Json::parse(app->state()); }
  app::Json run(std::string_view id, std::string_view args = {}) { return *app::Json::parse(app->run(id, args)); }
  /// Whether a command did what it was asked, with all that followed.
  bool works(std::string_view id, std::string_view args = {}) {
    const bool ok = run(id, args).flag("ok") == true;
    settle();
    return ok;
  }
  /// The name of what was wrong with a command; empty: nothing.
  std::string fault(std::string_view id, std::string_view args) {
    const app::Json answer = run(id, args);
    settle();
    return answer.text("error") ? *answer.text("error") : std::string();
  }
  double undoSteps() { return *state().number("undo"); }
  /// The document, as the text of a link holds it.
  document::Document shared() {
    const app::Json answer = *app::Json::parse(app->shareText("{}"));
    REQUIRE(answer.text("text") != nullptr);
    const auto read = io::readShareText(*answer.text("text"));
    REQUIRE(read.ok());
    return read.value();
  }
  std::size_t parts() { return state().find("parts")->array()->size(); }

  void pointer(platform::PointerKind kind, double x, double y, platform::Device device = {}, int id = 1,
               int button = 0) {
    using platform::PointerKind;
    const bool down = kind == PointerKind::Down || kind == PointerKind::Move;
    app->pointer({kind, id, device, button, down ? 1 : 0, x, y, 0.5, host.clockMs, 0});
  }
  Vec2<platform::CanvasSpace> at(double x, double y) { return app->imageToCanvas(x, y); }
  /// Presses at the first of the picture points and moves through the others; does not lift.
  void press(double x0, double y0, double x1, double y1, platform::Device device = {}, int id = 1) {
    auto p = at(x0, y0);
    pointer(platform::PointerKind::Down, p.x, p.y, device, id);
    for (int i = 1; i <= 20; ++i) {
      p = at(x0 + (x1 - x0) * i / 20, y0 + (y1 - y0) * i / 20);
      pointer(platform::PointerKind::Move, p.x, p.y, device, id);
    }
    lastX = p.x;
    lastY = p.y;
  }
  void lift(platform::Device device = {}, int id = 1) { pointer(platform::PointerKind::Up, lastX, lastY, device, id); }
  void drawBar(platform::Device device = {}) {
    press(100, 40, 100, 160, device);
    lift(device);
    settle();
  }
  void click(double x, double y) {
    pointer(platform::PointerKind::Down, x, y);
    pointer(platform::PointerKind::Up, x, y);
    settle();
  }
  bool key(std::string_view code, std::string_view name, int modifiers = 0) {
    const bool used = app->key({code, name, true, modifiers});
    settle();
    return used;
  }

  FakeHost host;
  gl::NullRenderer* gl = nullptr;
  std::unique_ptr<app::App> app;
  double lastX = 0, lastY = 0;

 private:
  int threads_;
};

}  // namespace spineloft::test
