// The browser as the page sees it.
#pragma once

#include <memory>

#include "web/platform/host.h"
#include "web/platform/page.h"

namespace spineloft::platform {

/// Frames and wakes go to `page` once it is set.
class BrowserHost final : public Host {
 public:
  double nowMs() const override;
  void requestFrame() override;
  void wakeAfter(double milliseconds) override;
  void send(std::string_view json) override;
  void solve(std::string_view json, std::span<const SolverMesh> meshes) override;
  void cutOut(const CutRequest& request) override;
  void sendFile(std::string_view name, std::string_view mediaType, std::span<const std::uint8_t> bytes) override;
  bool drawsSlowly() const override;
  void setPixels(const CanvasSize& size) override;
  bool reducedMotion() const override;

  Page* page = nullptr;

 private:
  static void onFrame(void* host);
  bool framePending_ = false;
};

/// The shell's catalogue (web/shell/words).
class BrowserWords final : public words::Source {
 public:
  std::string translated(std::string_view english, std::string_view args) override;
  std::string drawn(std::string_view text) override;
};

/// Creates GLFW's window and its WebGL2 context on Module.canvas, and takes GLFW's listeners off
/// the page: all input comes through the exported functions. False without WebGL2.
bool openWindow(const CanvasSize& size);
/// Sets the canvas' backing store. Its size on the page is the style sheet's business.
void resizeCanvas(const CanvasSize& size);
/// The density to draw with: at most 2, and less on large canvases where the processor draws.
double usableDpr(const CanvasSize& wanted);

}  // namespace spineloft::platform
