#include "web/tools/slide_slice.h"

#include "web/app/outline.h"
#include "web/app/slice_editing.h"

namespace spineloft::tools {
namespace {

constexpr double kDropReach = 44;  // CSS pixels from the bone of the selected part

PicturePoint toPicture(const ToolEnv& env, app::ClientPoint at) {
  return env.ui.pictureView.toPicture(at, env.ui.layout.picture);
}

}  // namespace

DropPlace dropPlace(const ToolEnv& env, app::ClientPoint at) {
  if (!env.ui.layout.picture.contains(at)) return {};
  const PicturePoint p = toPicture(env, at);
  PartId part = app::partAt(env.document, env.derived, env.ui.picture, p,
                            kDropReach / env.ui.pictureView.zoom);
  const document::Part* chosen = document::findPart(env.document, env.ui.selection);
  const pipeline::PartShape* shape = app::shapeOf(env.document, env.derived, env.ui.selection);
  if (chosen && shape && document::pictureOf(*chosen) == env.ui.picture &&
      app::nearestPlace(*shape, p).distance * env.ui.pictureView.zoom < kDropReach) {
    part = chosen->id;  // where parts overlap, the selected one is meant
  }
  shape = app::shapeOf(env.document, env.derived, part);
  if (shape == nullptr) return {};
  return {part, app::nearestPlace(*shape, p).at};
}

void SlideSlice::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  env.ui.slices.part = env.ui.selection;
  env.ui.slices.stop = stop_;
}

void SlideSlice::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  const pipeline::PartShape* shape = app::shapeOf(env.document, env.derived, env.ui.selection);
  if (!watch_.moved() || part == nullptr || shape == nullptr) return;
  const app::BonePlace place = app::nearestPlace(*shape, toPicture(env, event.at));
  at_ = place.at;
  off_ = place.distance * env.ui.pictureView.zoom > kPulledOff;
  loft::LoftParams params = document::loftIn(*part).loft;
  params.sections = off_ ? app::withoutStop(params.sections, stop_)
                         : app::withMovedStop(params.sections, stop_, at_);
  app::previewLoft(env.ui, *part, std::move(params));
  env.ui.slices.marked = off_ ? std::nullopt : std::optional(at_);
}

void SlideSlice::commit(const ToolEnv& env) {
  env.ui.slices.marked.reset();
  if (!watch_.moved()) return;
  env.ui.preview.reset();
  const auto stop = static_cast<double>(stop_);
  if (off_) {
    env.sink.run("remove-slice", app::Json::Object{{"slice", stop}});
  } else {
    env.sink.run("move-slice", app::Json::Object{{"slice", stop}, {"to", at_}});
  }
}

void SlideSlice::cancel(const ToolEnv& env) {
  env.ui.slices.marked.reset();
  env.ui.preview.reset();
}

void PlaceSlice::begin(const ToolEnv&, const ToolEvent& event) { at_ = event.at; }

void PlaceSlice::move(const ToolEnv& env, const ToolEvent& event) {
  at_ = event.at;
  const DropPlace place = dropPlace(env, at_);
  env.ui.slices.marked =
      place.part == env.ui.selection && place.part ? std::optional(place.at) : std::nullopt;
}

void PlaceSlice::commit(const ToolEnv& env) {
  env.ui.slices.marked.reset();
  const DropPlace place = dropPlace(env, at_);
  if (!place.part) {
    env.ui.slices.placing = false;
    return;
  }
  env.sink.run("add-slice", app::Json::Object{{"part", place.part.value}, {"at", place.at}});
}

void PlaceSlice::cancel(const ToolEnv& env) { env.ui.slices.marked.reset(); }

}  // namespace spineloft::tools
