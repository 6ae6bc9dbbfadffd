#include "web/tools/slide_section.h"

#include "web/commands/intents.h"
#include "web/edit/drop_place.h"
#include "web/edit/outline.h"
#include "web/edit/section_editing.h"

namespace spineloft::tools {
namespace {

PicturePoint toPicture(const ToolEnv& env, app::ClientPoint at) {
  return env.ui.pictureView.toPicture(at, env.ui.layout.picture);
}

}  // namespace

void SlideSection::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  env.ui.sections.part = env.ui.selection;
  env.ui.sections.key = key_;
}

void SlideSection::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  const pipeline::PartShape* shape = app::shapeOf(env.document, env.derived, env.ui.selection);
  if (!watch_.moved() || part == nullptr || shape == nullptr) return;
  const app::SpinePlace place = app::nearestPlace(*shape, toPicture(env, event.at));
  at_ = place.at;
  off_ = place.distance * env.ui.pictureView.zoom > kPulledOff;
  loft::LoftParams params = document::loftIn(*part).loft;
  params.sections =
      off_ ? app::withoutSectionKey(params.sections, key_) : app::withMovedSectionKey(params.sections, key_, at_);
  app::previewLoft(env.ui, *part, std::move(params));
  env.ui.sections.marked = off_ ? std::nullopt : std::optional(at_);
}

void SlideSection::commit(const ToolEnv& env) {
  env.ui.sections.marked.reset();
  if (!watch_.moved()) return;
  env.ui.preview.reset();
  if (off_) {
    env.sink.run(app::removeSection, env.ui.selection, key_);
  } else {
    env.sink.run(app::moveSection, env.ui.selection, key_, at_);
  }
}

void SlideSection::cancel(const ToolEnv& env) {
  env.ui.sections.marked.reset();
  env.ui.preview.reset();
}

void PlaceSection::begin(const ToolEnv&, const ToolEvent& event) { at_ = event.at; }

void PlaceSection::move(const ToolEnv& env, const ToolEvent& event) {
  at_ = event.at;
  const app::DropPlace place = app::dropPlace(env.document, env.derived, env.ui, at_);
  env.ui.sections.marked = place.part == env.ui.selection && place.part ? std::optional(place.at) : std::nullopt;
}

void PlaceSection::commit(const ToolEnv& env) {
  env.ui.sections.marked.reset();
  const app::DropPlace place = app::dropPlace(env.document, env.derived, env.ui, at_);
  if (!place.part) {
    env.ui.sections.placing = false;
    return;
  }
  env.sink.run(app::addSection, place.part, place.at, std::nullopt);
}

void PlaceSection::cancel(const ToolEnv& env) { env.ui.sections.marked.reset(); }

}  // namespace spineloft::tools
