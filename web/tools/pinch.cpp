#include "web/tools/pinch.h"

#include <algorithm>

#include "web/tools/pan_picture.h"

namespace spineloft::tools {
namespace {

constexpr double kLeastSpread = 12;  // CSS pixels; nearer fingers only shift

double growth(const FingerPair& from, const FingerPair& to) {
  if (std::min(from.spread(), to.spread()) < kLeastSpread) return 1;
  return to.spread() / from.spread();
}

}  // namespace

void pinchPicture(const ToolEnv& env, const FingerPair& from, const FingerPair& to) {
  const app::Rect& at = env.ui.layout.picture;
  app::panPicture(env.ui.pictureView, shownPicture(env), at, to.middle() - from.middle());
  app::zoomPicture(env.ui.pictureView, at, to.middle(), growth(from, to));
}

void pinchSolid(const ToolEnv& env, const FingerPair& from, const FingerPair& to) {
  const app::Rect& at = env.ui.layout.solid;
  env.ui.flight.reset();
  env.ui.cameraTouched = true;
  app::panCamera(env.ui.camera, at, to.middle() - from.middle());
  app::zoomCamera(env.ui.camera, at, to.middle(), growth(from, to));
}

}  // namespace spineloft::tools
