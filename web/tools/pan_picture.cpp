#include "web/tools/pan_picture.h"

#include "web/edit/outline.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

image::Size shownPicture(const ToolEnv& env) {
  const document::PictureEntry* entry = document::findPicture(env.document, env.ui.picture);
  return entry ? entry->size : image::Size{};
}

void PanPicture::begin(const ToolEnv&, const ToolEvent& event) {
  watch_.begin(event);
  adds_ = (event.modifiers & platform::kShift) != 0;
}

void PanPicture::move(const ToolEnv& env, const ToolEvent& event) {
  const app::ClientPoint by = watch_.move(event);
  if (!watch_.moved()) return;
  app::panPicture(env.ui.pictureView, shownPicture(env), env.ui.layout.picture, by);
}

void PanPicture::commit(const ToolEnv& env) {
  if (watch_.moved()) return;
  const PicturePoint p = env.ui.pictureView.toPicture(watch_.start(), env.ui.layout.picture);
  const PartId part = app::partAt(env.document, env.derived, env.ui.picture, p, 0);
  selectTapped(env, part, adds_);
}

}  // namespace spineloft::tools
