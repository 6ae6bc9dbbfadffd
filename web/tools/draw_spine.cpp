#include "web/tools/draw_spine.h"

#include "web/app/outline.h"
#include "web/app/preview.h"

namespace spineloft::tools {
namespace {

constexpr double kPointSpacing = 1.5;  // CSS pixels between the points of a stroke
constexpr double kClickReach = 8;      // CSS pixels round a spine that still select it

PicturePoint toPicture(const ToolEnv& env, app::ClientPoint at) {
  return env.ui.pictureView.toPicture(at, env.ui.layout.picture);
}

app::Json strokeJson(const std::vector<PicturePoint>& stroke) {
  app::Json::Array list;
  list.reserve(stroke.size());
  for (const PicturePoint p : stroke) list.push_back(app::Json::Array{p.x, p.y});
  return list;
}

}  // namespace

void DrawSpine::begin(const ToolEnv&, const ToolEvent& event) { watch_.begin(event); }

void DrawSpine::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  if (!env.ui.preview) start(env);
  std::vector<PicturePoint>& stroke = env.ui.preview->recipe.stroke;
  const PicturePoint p = toPicture(env, event.at);
  if (distance(p, stroke.back()) * env.ui.pictureView.zoom < kPointSpacing) return;
  stroke.push_back(p);
  env.ui.preview->fresh = false;
}

void DrawSpine::start(const ToolEnv& env) {
  const document::Part* part = document::findPart(env.document, env.ui.redraw);
  app::Preview& preview = part ? app::previewPart(env.ui, *part) : app::previewNewPart(env.ui);
  preview.recipe.picture = env.ui.picture;
  preview.recipe.stroke = {toPicture(env, watch_.start())};
}

void DrawSpine::commit(const ToolEnv& env) {
  if (!env.ui.preview) {
    const PicturePoint p = toPicture(env, watch_.start());
    const PartId part = app::partAt(env.document, env.derived, env.ui.picture, p,
                                    kClickReach / env.ui.pictureView.zoom);
    env.sink.run("select-part", app::Json::Object{{"id", part.value}});
    return;
  }
  app::Json::Object args{{"stroke", strokeJson(env.ui.preview->recipe.stroke)}};
  const PartId redraw = env.ui.redraw;
  env.ui.preview.reset();
  if (redraw) args.emplace_back("part", redraw.value);
  env.sink.run(redraw ? "redraw-spine" : "draw-spine", std::move(args));
}

void DrawSpine::cancel(const ToolEnv& env) { env.ui.preview.reset(); }

}  // namespace spineloft::tools
