#include "web/edit/spinning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/polyline.h"
#include "web/edit/preview.h"

namespace spineloft::app {
namespace {

constexpr double kFromEdge = 0.06;    // of the picture, from its edge to the ends of an axis
constexpr double kStraighten = 2;     // degrees
constexpr double kShortest = 8;       // picture pixels: an axis of less has no direction that a hand means
constexpr double kClosed = 0.08;      // the gap's share of the way: a closed line
constexpr double kTolerance = 0.001;  // of the picture's longer side, by which a profile may be simplified

}  // namespace

std::optional<ShownAxis> shownAxis(const document::Document& document, const UiState& ui) {
  if (ui.tool != ToolKind::Spin) return std::nullopt;
  const document::PictureEntry* entry = document::findPicture(document, ui.picture);
  if (entry == nullptr) return std::nullopt;
  const document::Part* part = document::findPart(document, ui.selection);
  const auto* spun = part ? document::latheOf(*part) : nullptr;
  if (spun != nullptr && spun->region.picture == ui.picture) {
    const bool moves = ui.preview && ui.preview->part == part->id;
    const auto* moved = moves ? std::get_if<document::LatheRecipe>(&ui.preview->recipe) : nullptr;
    const lathe::LatheParams& params = moved ? moved->lathe : spun->lathe;
    return ShownAxis{part->id, params.axisFrom, params.axisTo};
  }
  if (ui.axisOf == ui.picture) return ShownAxis{{}, ui.lathe.axisFrom, ui.lathe.axisTo};
  const double middle = (entry->size.width - 1) / 2.0, high = entry->size.height;
  return ShownAxis{{}, {middle, kFromEdge * high}, {middle, (1 - kFromEdge) * high}};
}

std::optional<ShownAxis> axisInHand(const document::Document& document, const UiState& ui) {
  const std::optional<ShownAxis> axis = shownAxis(document, ui);
  return axis && axis->part && !ui.redraw ? axis : std::nullopt;
}

ShownAxis axisThrough(const ShownAxis& axis, PicturePoint p) {
  const PicturePoint along = normalized(axis.to - axis.from), away = p - axis.from;
  const PicturePoint aside = away - along * dot(away, along);
  return {axis.part, axis.from + aside, axis.to + aside};
}

int axisEndAt(const ShownAxis& axis, PicturePoint p, double reach) {
  const double first = distance(p, axis.from), second = distance(p, axis.to);
  if (std::min(first, second) > reach) return -1;
  return first <= second ? 0 : 1;
}

ShownAxis withMovedEnd(const ShownAxis& axis, int end, PicturePoint to) {
  ShownAxis moved = axis;
  PicturePoint& own = end == 0 ? moved.from : moved.to;
  const PicturePoint other = end == 0 ? moved.to : moved.from;
  const PicturePoint along = to - other;
  const double slack = std::tan(kStraighten * std::numbers::pi / 180);
  own = to;
  if (std::abs(along.x) < slack * std::abs(along.y)) own.x = other.x;
  if (std::abs(along.y) < slack * std::abs(along.x)) own.y = other.y;
  return distance(own, other) < kShortest ? axis : moved;
}

lathe::LatheParams nextLathe(const document::Document& document, const UiState& ui) {
  lathe::LatheParams params = ui.lathe;
  if (const std::optional<ShownAxis> axis = shownAxis(document, ui)) {
    params.axisFrom = axis->from;
    params.axisTo = axis->to;
  }
  return params;
}

document::Region profileOfLine(PictureId picture, const std::vector<PicturePoint>& line, image::Size size) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  const double gap = line.empty() ? 0 : distance(line.front(), line.back());
  const double tolerance = kTolerance * std::max(size.width, size.height);
  document::Region region{picture, {geometry::simplifiedLine(std::span<const PicturePoint>(line), tolerance)}, 0};
  region.open = gap > kClosed * length;
  return region;
}

}  // namespace spineloft::app
