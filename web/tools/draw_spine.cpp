#include "web/tools/draw_spine.h"

#include "web/app/outline.h"

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

void DrawSpine::begin(const ToolEnv& env, app::ClientPoint at) { watch_.begin(at, env.ui.touch); }

void DrawSpine::move(const ToolEnv& env, app::ClientPoint at) {
  watch_.move(at);
  if (!watch_.moved()) return;
  if (!env.ui.preview) {
    env.ui.preview.emplace();
    env.ui.preview->stroke.push_back(toPicture(env, watch_.start()));
  }
  app::Preview& preview = *env.ui.preview;
  const PicturePoint p = toPicture(env, at);
  if (distance(p, preview.stroke.back()) * env.ui.pictureView.zoom < kPointSpacing) return;
  preview.stroke.push_back(p);
  preview.fresh = false;
}

void DrawSpine::commit(const ToolEnv& env) {
  if (!env.ui.preview) {
    const PicturePoint p = toPicture(env, watch_.start());
    const PartId part = app::partAt(env.document, env.derived, env.ui.picture, p,
                                    kClickReach / env.ui.pictureView.zoom);
    env.sink.run("select-part", app::Json::Object{{"id", part.value}});
    return;
  }
  app::Json::Object args{{"stroke", strokeJson(env.ui.preview->stroke)}};
  const PartId redraw = env.ui.redraw;
  env.ui.preview.reset();
  if (redraw) args.emplace_back("part", redraw.value);
  env.sink.run(redraw ? "redraw-spine" : "draw-spine", std::move(args));
}

void DrawSpine::cancel(const ToolEnv& env) { env.ui.preview.reset(); }

}  // namespace spineloft::tools
