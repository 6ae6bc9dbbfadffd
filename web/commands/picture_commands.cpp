// Commands about the board, its files and the views.
#include "web/commands/command_actions.h"
#include "web/model/messages.h"
#include "web/ui/sizing.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kZoomStep = 1.25;
constexpr double kNudge = 40;          ///< CSS pixels that an arrow key drags
constexpr double kNarrowShare = 0.34;  ///< what a view keeps when the other has the focus on a phone

/// What the camera has to see: all parts, and what stands beside them as seen from `camera`.
publish::WorldBounds boundsFor(Env env, const Camera* camera) {
  auto bounds = publish::worldBounds(env.studio.document(), env.studio.derived());
  if (!bounds) return {{-0.4, -0.4, -0.25}, {0.4, 0.4, 0.25}};
  if (camera == nullptr || !env.ui.beside) return *bounds;
  const Thing& thing = things()[*env.ui.beside];
  const ThingPlace place = placeBeside(thing, *bounds, env.studio.document().height.value, *camera);
  for (const double x : {-thing.width / 2, thing.width / 2}) {
    pipeline::include(bounds, place.at({x, 0}));
    pipeline::include(bounds, place.at({x, 1}));
  }
  return *bounds;
}

Camera cameraFor(Env env, const publish::WorldBounds& bounds, bool home) {
  const UiState& ui = env.ui;
  return home ? homeCamera(bounds, ui.layout.solid) : framed(ui.camera, bounds, ui.layout.solid);
}

Outcome zoomBy(Env env, double factor) {
  UiState& ui = env.ui;
  if (ui.focus == Focus::Picture) {
    zoomPicture(ui.pictureView, ui.layout.picture, ui.layout.picture.centre(), factor);
  } else {
    ui.flight.reset();
    ui.cameraTouched = true;
    zoomCamera(ui.camera, ui.layout.solid, ui.layout.solid.centre(), factor);
  }
  return {};
}

/// Turns the solid as if dragged that way, or shifts the picture.
Outcome nudge(Env env, ClientPoint by) {
  UiState& ui = env.ui;
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), ui.picture);
  if (ui.focus == Focus::Solid) {
    ui.flight.reset();
    ui.cameraTouched = true;
    orbit(ui.camera, ui.layout.solid, by);
  } else if (entry != nullptr) {
    panPicture(ui.pictureView, entry->size, ui.layout.picture, by);
  }
  return {};
}

}  // namespace

void flyTo(const CommandEnv& env, bool home) {
  Camera to = cameraFor(env, boundsFor(env, nullptr), home);
  if (env.ui.beside) to = cameraFor(env, boundsFor(env, &to), home);
  fly(env, to);
}

void fly(const CommandEnv& env, const Camera& to) {
  UiState& ui = env.ui;
  if (env.host.reducedMotion() || ui.layout.solid.width < 1) {
    ui.camera = to;
    ui.flight.reset();
  } else if (!(to == ui.camera)) {
    ui.flight = CameraFlight{ui.camera, to, env.host.nowMs()};
  }
}

Outcome saveAs(const CommandEnv& env, publish::Format format) { return outcomeOf(env.studio.save(format)); }

namespace rows {

Outcome openPicture(Env env, const Json&) {
  sendPickPicture(env.host);
  return {};
}

Outcome clearBoard(Env env, const Json&) {
  env.studio.cancelWork();
  env.studio.clear();
  env.ui.selection = {};
  env.ui.redraw = {};
  env.ui.preview.reset();
  env.ui.cameraTouched = false;
  resetNextPart(env.ui);
  return {};
}

Outcome saveGlb(Env env, const Json&) { return saveAs(env, publish::Format::Glb); }
Outcome saveStl(Env env, const Json&) { return saveAs(env, publish::Format::Stl); }

Outcome homeView(Env env, const Json&) {
  env.ui.cameraTouched = false;
  flyTo(env, true);
  return {};
}

Outcome fitView(Env env, const Json&) {
  if (env.ui.focus == Focus::Picture) {
    env.ui.pictureView.fitted = true;
  } else {
    flyTo(env, false);
  }
  return {};
}

Outcome zoomIn(Env env, const Json&) { return zoomBy(env, kZoomStep); }
Outcome zoomOut(Env env, const Json&) { return zoomBy(env, 1 / kZoomStep); }

Outcome turnLeft(Env env, const Json&) { return nudge(env, {-kNudge, 0}); }
Outcome turnRight(Env env, const Json&) { return nudge(env, {kNudge, 0}); }
Outcome turnUp(Env env, const Json&) { return nudge(env, {0, -kNudge}); }
Outcome turnDown(Env env, const Json&) { return nudge(env, {0, kNudge}); }

Outcome focusPicture(Env env, const Json&) {
  env.ui.focus = Focus::Picture;
  if (env.ui.layout.stacked) env.ui.share = 1 - kNarrowShare;
  return {};
}

Outcome focusSolid(Env env, const Json&) {
  env.ui.focus = Focus::Solid;
  if (env.ui.layout.stacked) env.ui.share = kNarrowShare;
  return {};
}

}  // namespace rows
}  // namespace spineloft::app
