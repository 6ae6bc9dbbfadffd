// The page's canvas: its size, its letters, and how many pixels a frame has.
#include <imgui.h>

#include <algorithm>
#include <array>

#include "web/page/app.h"

namespace spineloft::app {
namespace {

/// A hand that has not moved for so long rests.
constexpr double kRestMs = 150;
/// So many pixels a processor draws for every move of a hand.
constexpr double kMovingPixels = 0.4e6;
/// Of the pixels of a frame at rest, along a side: with odd shares the panels would jump by a pixel.
constexpr std::array kShares{1.0, 2.0 / 3, 0.5, 1.0 / 3, 0.25};

}  // namespace

void App::resize(const platform::CanvasSize& size) {
  ui_.canvasWidth = std::max(1.0, size.width);
  ui_.canvasHeight = std::max(1.0, size.height);
  ui_.dpr = std::clamp(size.dpr, 0.5, 4.0);
  if (fontDpr_ != ui_.dpr) fontDpr_ = 0;
  // What is under the pointer is another place now.
  if (gestures_.active()) gestures_.cancel(toolEnv());
  layout();
  touch(2);
  // Before the browser shows the last frame at another size; where a processor draws, it does so until the next one is
  // there.
  if (!host_.drawsSlowly()) frame();
}

/// The letters of the canvas for its pixels and the language.
void App::makeFonts() {
  if (fontDpr_ == ui_.dpr) return;
  fontDpr_ = ui_.dpr;
  fonts_ = buildFonts(fontFiles_, ui_.dpr);
  renderer_->fontsChanged();
}

/// The start page lies over the canvas: letters, panels and frames of every kind, a piece at a time.
void App::warmUp() {
  if (lost_ || !studio_.document().pictures.empty()) return;
  if (fontDpr_ != ui_.dpr) return makeFonts();
  if (frames_ == 0) return drawFrame();
  if (!shown_ || rehearsal_.done()) return;
  layOutPanels();
  rehearsal_.drawNext(*renderer_);
}

/// Of the frame that begins: where a processor draws, it comes sooner with fewer pixels while something moves.
void App::chooseDensity() {
  const bool dragsControl = ImGui::IsAnyItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  const bool flies = moving() && !studio_.works() && !ui_.preview, inHand = gestures_.active() || dragsControl;
  const bool handWaits = host_.drawsSlowly() && inHand && handMoves_ && !handRests();
  scene_.hurried = handWaits;
  platform::CanvasSize size{ui_.canvasWidth, ui_.canvasHeight, ui_.dpr};
  if (handWaits || (host_.drawsSlowly() && flies)) {
    const auto pixels = [&](double dpr) { return size.width * size.height * dpr * dpr; };
    const auto share = std::ranges::find_if(kShares, [&](double s) { return pixels(ui_.dpr * s) <= kMovingPixels; });
    size.dpr *= share == std::end(kShares) ? kShares.back() : *share;
  }
  // All of a view is drawn anew where the view moves, and where what stays is first drawn with fewer pixels.
  const bool anew = viewMoves() || (changesPart() && size != pixels_);
  scene_.held = inHand && !(gestures_.active() && anew);
  pixels_ = size;
  seenFrom_ = ui_.camera;
  pictureSeen_ = ui_.pictureView;
}

/// A hand changes parts that there are.
bool App::changesPart() const { return !ui_.placing.empty() || (ui_.preview && ui_.preview->part); }

/// Solids or picture are seen from elsewhere than in the last frame.
bool App::viewMoves() const { return ui_.camera != seenFrom_ || ui_.pictureView != pictureSeen_; }

/// The last frame comes onto the canvas as soon as all of it has been drawn; false: it has not.
bool App::showFrame() {
  if (shown_ || lost_) return true;
  if (!renderer_->finished()) return false;
  host_.setPixels(pixels_);
  renderer_->show();
  shown_ = true;
  return true;
}

/// The hand has not moved for a while, or frames are so quick that they need not wait for that: then one may take
/// longer and look better.
bool App::handRests() const { return !host_.drawsSlowly() || host_.nowMs() - handMovedMs_ >= kRestMs; }

/// A frame for a hand that will rest.
void App::awaitRest() {
  if (restPending_ || handRests()) return;
  restPending_ = true;
  host_.wakeAfter(kRestMs);
}

}  // namespace spineloft::app
