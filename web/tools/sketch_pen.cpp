#include "web/tools/sketch_pen.h"

#include <algorithm>

#include "web/commands/intents.h"

namespace spineloft::tools {
namespace {

constexpr double kPointSpacing = 1.5;  // CSS pixels between the points of a stroke

}  // namespace

void SketchPen::begin(const ToolEnv& env, const ToolEvent& event) {
  app::Sketching& sketching = env.ui.sketching;
  sketching.menu = app::PenMenu::None;
  image::SketchStroke& stroke = sketching.stroke.emplace();
  stroke.erase = erase_;
  stroke.colour = sketching.colour;
  stroke.radius = erase_ ? app::kEraserRadii[sketching.eraserSize] : app::kPenRadii[sketching.penSize];
  add(env, event);
}

void SketchPen::move(const ToolEnv& env, const ToolEvent& event) {
  if (!env.ui.sketching.stroke) return;
  const image::SketchStroke& stroke = *env.ui.sketching.stroke;
  const PicturePoint p = env.ui.pictureView.toPicture(event.at, env.ui.layout.picture);
  if (distance(p, stroke.points.back()) * env.ui.pictureView.zoom < kPointSpacing) return;
  add(env, event);
}

void SketchPen::add(const ToolEnv& env, const ToolEvent& event) {
  image::SketchStroke& stroke = *env.ui.sketching.stroke;
  if (stroke.points.size() >= image::kMostSketchPoints) return;
  stroke.points.push_back(env.ui.pictureView.toPicture(event.at, env.ui.layout.picture));
  // Fingers and mice know no pressure: all of a line is as wide as the pen.
  if (event.device != platform::Device::Pen || erase_) return;
  stroke.pressure.push_back(static_cast<float>(std::clamp(event.pressure, 0.0, 1.0)));
}

void SketchPen::commit(const ToolEnv& env) {
  if (!env.ui.sketching.stroke) return;
  image::SketchStroke stroke = std::move(*env.ui.sketching.stroke);
  env.ui.sketching.stroke.reset();
  // A pen that leaves the glass weighs nothing any more: that is not how the line was meant to end.
  if (stroke.pressure.size() > 1) stroke.pressure.back() = stroke.pressure[stroke.pressure.size() - 2];
  env.sink.run(app::drawOnSketch, stroke);
}

void SketchPen::cancel(const ToolEnv& env) { env.ui.sketching.stroke.reset(); }

}  // namespace spineloft::tools
