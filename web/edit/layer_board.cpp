#include "web/edit/layer_board.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/geometry/polyline.h"
#include "web/edit/layer_joints.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {
namespace {

using document::StackRecipe;

constexpr double kRoom = 1.25;  // of the board to what is changed on it
constexpr double kLevel = 0.8;  // cosine up to which right and front are those of the model

/// Middle and half the larger side of what curves enclose.
struct Square {
  SectionPoint middle;
  double half = 1;
};
Square squareRound(const std::vector<stack::Curve>& curves) {
  std::vector<SectionPoint> all;
  for (const stack::Curve& curve : curves) {
    const std::vector<SectionPoint> outline = stack::outlineOf(curve);
    all.insert(all.end(), outline.begin(), outline.end());
  }
  const auto [left, right] = std::ranges::minmax(all, {}, &SectionPoint::x);
  const auto [back, front] = std::ranges::minmax(all, {}, &SectionPoint::y);
  const double half = std::max(right.x - left.x, front.y - back.y) / 2;
  return {{(left.x + right.x) / 2, (back.y + front.y) / 2}, half > 0 ? half : 1};
}

SectionPoint toBoard(const BoardOnSheet& place, SectionPoint p) { return (p - place.middle) / place.unit; }

sections::DrawnCurve drawnOf(const BoardOnSheet& place, const stack::Curve& curve) {
  sections::DrawnCurve drawn;
  for (const SectionPoint p : curve.through) drawn.points.push_back({toBoard(place, p), curve.corners.all});
  for (const std::uint32_t corner : curve.corners.at) {
    if (corner < drawn.points.size()) drawn.points[corner].corner = true;
  }
  return drawn;
}

/// The points of a drawn curve; links and forks are those of `before`.
stack::Curve curveOf(const BoardOnSheet& place, const sections::DrawnCurve& drawn, stack::Curve before) {
  stack::Curve fresh = stack::curveThrough(drawn);
  for (SectionPoint& p : fresh.through) p = place.middle + p * place.unit;
  before.through = std::move(fresh.through);
  before.corners = std::move(fresh.corners);
  return before;
}

SectionPoint middleOf(const sections::DrawnCurve& curve) {
  SectionPoint sum;
  for (const sections::DrawnPoint& point : curve.points) sum = sum + point.at;
  return sum / static_cast<double>(curve.points.size());
}

const std::vector<stack::Curve>* curvesOn(const Sheet& sheet) {
  return sheet.layer ? &sheet.recipe.planes[*sheet.layer].curves : nullptr;
}

}  // namespace

bool hasOpenCurves(const Sheet& sheet) {
  const auto* curves = curvesOn(sheet);
  return curves != nullptr && std::ranges::any_of(*curves, &stack::Curve::open);
}

void openLayerBoard(UiState& ui, const Sheet& sheet) {
  const auto* own = curvesOn(sheet);
  const stack::Plane* nearest = traceOf(sheet);
  const bool isNew = own == nullptr || own->empty();
  const auto [middle, half] = squareRound(isNew ? std::vector{circleOn(sheet)} : *own);
  const ModelPoint right = sheet.stand.x, front = sheet.stand.y;
  SectionBoard board;
  board.part = sheet.part;
  board.sheet = {sheet.recipe.picture,
                 sheet.at,
                 sheet.turn,
                 middle,
                 isNew ? half : kRoom * half,
                 right.x > kLevel && front.z > kLevel};
  for (const stack::Curve& curve : own ? *own : std::vector<stack::Curve>()) {
    board.drawing.push_back(drawnOf(*board.sheet, curve));
  }
  for (const stack::Curve& curve : nearest ? nearest->curves : std::vector<stack::Curve>()) {
    std::vector<SectionPoint> outline = stack::outlineOf(curve);
    for (SectionPoint& p : outline) p = toBoard(*board.sheet, p);
    board.below.push_back(std::move(outline));
  }
  if (!board.drawing.empty()) board.tool = BoardTool::Points;
  showBoard(ui, std::move(board));
}

std::optional<Sheet> sheetOfBoard(const document::Document& document, const UiState& ui) {
  if (!ui.sections.board || !ui.sections.board->sheet) return std::nullopt;
  const SectionBoard& board = *ui.sections.board;
  return sheetFor(document, board.part, board.sheet->picture, board.sheet->at, board.sheet->turn);
}

StackRecipe withBoard(const Sheet& sheet, const SectionBoard& board) {
  const BoardOnSheet& place = *board.sheet;
  sections::Drawing fresh = board.shown();
  const auto* own = curvesOn(sheet);
  if (own == nullptr) {
    std::vector<stack::Curve> curves;
    for (const sections::DrawnCurve& drawn : fresh) curves.push_back(curveOf(place, drawn, {}));
    return withCurves(sheet, std::move(curves));
  }
  std::vector<std::size_t> changed;  // curves of the layer that are not on the board as they were
  for (std::size_t i = 0; i < own->size(); ++i) {
    const auto same = std::ranges::find(fresh, drawnOf(place, (*own)[i]));
    if (same == fresh.end()) {
      changed.push_back(i);
    } else {
      fresh.erase(same);
    }
  }
  StackRecipe recipe = sheet.recipe;
  std::vector<stack::Curve>& curves = recipe.planes[*sheet.layer].curves;
  // Those that are nearest to each other are the same curve.
  while (!changed.empty() && !fresh.empty()) {
    std::pair<std::size_t, std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < changed.size(); ++i) {
      const SectionPoint before = middleOf(drawnOf(place, (*own)[changed[i]]));
      for (std::size_t k = 0; k < fresh.size(); ++k) {
        const double away = distance(before, middleOf(fresh[k]));
        if (away >= least) continue;
        least = away;
        nearest = {i, k};
      }
    }
    const auto [i, k] = nearest;
    curves[changed[i]] = curveOf(place, fresh[k], curves[changed[i]]);
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
    fresh.erase(fresh.begin() + static_cast<std::ptrdiff_t>(k));
  }
  for (std::size_t k = changed.size(); k-- > 0;) dropCurve(recipe, *sheet.layer, changed[k]);
  for (const sections::DrawnCurve& drawn : fresh) curves.push_back(curveOf(place, drawn, {}));
  return recipe;
}

}  // namespace spineloft::app
