#include "web/edit/drop_place.h"

#include "web/edit/outline.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {

DropPlace dropPlace(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                    ClientPoint at) {
  constexpr double kReach = 44;  // CSS pixels from the spine of the selected part
  if (!ui.layout.picture.contains(at)) return {};
  const PicturePoint p = ui.pictureView.toPicture(at, ui.layout.picture);
  const double zoom = ui.pictureView.zoom;
  PartId part = partAt(document, derived, ui.picture, p, kReach / zoom);
  const document::Part* chosen = document::findPart(document, ui.selection);
  const pipeline::PartShape* shape = shapeOf(document, derived, ui.selection);
  if (chosen && shape && document::pictureOf(*chosen) == ui.picture &&
      nearestPlace(*shape, p).distance * zoom < kReach) {
    part = chosen->id;  // where parts overlap, the selected one is meant
  }
  shape = shapeOf(document, derived, part);
  if (shape == nullptr) return {};
  return {part, nearestPlace(*shape, p).at};
}

}  // namespace spineloft::app
