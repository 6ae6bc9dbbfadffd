#include "web/app/preview.h"

#include <algorithm>

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

document::Region regionOfLine(PictureId picture, std::vector<PicturePoint> line,
                              image::Size size) {
  constexpr double kOpen = 0.3;     // the gap's share of the way: an open line
  constexpr double kRibbon = 0.03;  // of the picture's longer side
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  const double gap = line.empty() ? 0 : distance(line.front(), line.back());
  document::Region region{picture, {}, 0};
  if (gap > kOpen * length) {
    region.ribbon = std::clamp(kRibbon * std::max(size.width, size.height), document::kLeastRibbon,
                               document::kMostRibbon);
  }
  region.contours.push_back(std::move(line));
  return region;
}

const Preview* previewOf(const UiState& ui, PartId part) {
  return part && ui.preview && ui.preview->part == part && ui.preview->shape ? &*ui.preview
                                                                              : nullptr;
}

}  // namespace spineloft::app
