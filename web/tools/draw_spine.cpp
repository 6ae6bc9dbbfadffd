#include "web/tools/draw_spine.h"

#include "engine/pipeline/outline_ink.h"
#include "web/commands/intents.h"
#include "web/edit/outline.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

constexpr double kClickReach = 8;  // CSS pixels round a spine that still select it

}  // namespace

void DrawSpine::begin(const ToolEnv&, const ToolEvent& event) {
  watch_.begin(event);
  adds_ = (event.modifiers & platform::kShift) != 0;
}

void DrawSpine::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  if (!env.ui.preview) start(env, event);
  document::LoftRecipe& recipe = env.ui.preview->asLoft();
  if (!extend(env, recipe.stroke, event.at)) return;
  if (!env.ui.preview->part)
    recipe.ignored = pipeline::inkOfOthers(env.document, env.derived, recipe.picture, recipe.stroke);
  // A pen that leaves the glass weighs nothing: that is not how the line was meant to end.
  std::vector<double>& pressure = env.ui.preview->pressure;
  pressure.push_back(event.pressure > 0 ? event.pressure : pressure.back());
  env.ui.preview->fresh = false;
  if (usesPressure(env, event)) app::depthOfPressure(recipe.stroke, pressure, recipe.pose.depth);
}

bool DrawSpine::usesPressure(const ToolEnv& env, const ToolEvent& event) {
  return env.ui.edit.depthByPressure && event.device == platform::Device::Pen && !env.ui.preview->part;
}

void DrawSpine::start(const ToolEnv& env, const ToolEvent& event) {
  const document::Part* part = document::findPart(env.document, env.ui.redraw);
  app::Preview& preview = part ? app::previewPart(env.ui, *part) : app::previewNewPart(env.ui);
  preview.asLoft().picture = env.ui.picture;
  preview.asLoft().stroke = {toPicture(env, watch_.start())};
  preview.pressure = {event.pressure};
}

void DrawSpine::commit(const ToolEnv& env) {
  if (!env.ui.preview) {
    const PicturePoint p = toPicture(env, watch_.start());
    const PartId part =
        app::partAt(env.document, env.derived, env.ui.picture, p, kClickReach / env.ui.pictureView.zoom);
    selectTapped(env, part, adds_);
    return;
  }
  const document::LoftRecipe& recipe = env.ui.preview->loft();
  const PartId redraw = env.ui.redraw;
  if (redraw) {
    env.sink.run(app::redrawSpine, redraw, recipe.stroke);
  } else {
    env.sink.run(app::drawSpine,
                 app::DrawSpineIntent{.stroke = recipe.stroke, .depth = recipe.pose.depth, .cut = true, .lie = true});
  }
  env.ui.preview.reset();
}

void DrawSpine::cancel(const ToolEnv& env) { env.ui.preview.reset(); }

}  // namespace spineloft::tools
