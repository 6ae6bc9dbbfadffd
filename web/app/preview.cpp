#include "web/app/preview.h"

namespace spineloft::app {

Preview& previewPart(UiState& ui, const document::Part& part) {
  if (ui.preview && ui.preview->part == part.id) return *ui.preview;
  Preview& preview = ui.preview.emplace();
  preview.part = part.id;
  preview.recipe = part.recipe;
  preview.look = part.look;
  return preview;
}

Preview& previewNewPart(UiState& ui) {
  Preview& preview = ui.preview.emplace();
  preview.loft().picture = ui.picture;
  preview.loft().loft.sections.front().shape = ui.section;
  preview.loft().loft.startCap = ui.startCap;
  preview.loft().loft.endCap = ui.endCap;
  preview.look = ui.look;
  return preview;
}

const Preview* previewOf(const UiState& ui, PartId part) {
  return part && ui.preview && ui.preview->part == part && ui.preview->shape ? &*ui.preview
                                                                              : nullptr;
}

}  // namespace spineloft::app
