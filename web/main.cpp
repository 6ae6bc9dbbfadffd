// The page's beginning: renderer and App are made here, once the shell calls spl_start; from then
// on everything happens in callbacks.
#include <imgui.h>

#include "engine/base/shared_loop.h"
#include "engine/pipeline/warm_up.h"
#include "web/gl/webgl_renderer.h"
#include "web/page/app.h"
#include "web/platform/page.h"
#include "web/platform/warm_up.h"

/// In place of Dear ImGui's own, whose built-in font is ten kilobytes that do not compress: the page is given its
/// fonts.
ImFont* ImFontAtlas::AddFontDefault(const ImFontConfig*) { return nullptr; }

namespace spineloft::platform {
namespace {

constexpr int kThreads = 2;  // none in a program that was linked without threads

}  // namespace

std::unique_ptr<Page> makePage(Host& host, FontFiles fonts, const CanvasSize& size) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  std::unique_ptr<gl::Renderer> renderer = gl::makeWebGlRenderer();
  if (renderer == nullptr) return nullptr;
  sharedLoop(0, [](LoopShare) {});  // its thread begins with the others, not under the first stroke
  app::App::Parts parts{host, std::move(renderer), std::move(fonts), kThreads};
  return std::make_unique<app::App>(std::move(parts), size);
}

bool warmUp() { return pipeline::warmUp(1).ok(); }

}  // namespace spineloft::platform

int main() { return 0; }
