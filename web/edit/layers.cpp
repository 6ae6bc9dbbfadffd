#include "web/edit/layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/sections/drawing.h"
#include "engine/sections/open_line.h"
#include "web/edit/layer_joints.h"
#include "web/edit/layer_settings.h"
#include "web/edit/placing.h"

namespace spineloft::app {
namespace {

using document::StackRecipe;
using Points = std::vector<SectionPoint>;

constexpr double kNewLength = 0.5, kNewHalf = 0.32;  // of the picture's shorter side
constexpr double kNewCurve = 0.5;                    // of the sheet's half side
constexpr double kNewMelt = 0.35;                    // of forks
constexpr double kMargin = 1.2;                      // of the sheet about its curves
constexpr double kKnob = 1.12;                       // of the half side, from the middle
constexpr double kSame = 0.006;                      // of the rail: a sheet so near to a layer lies on it
constexpr double kApart = 0.01;                      // of the rail: no layer is moved nearer to another
constexpr double kOpenGap = 0.5;                     // of a line's length between its ends: it is not meant to close
constexpr double kNewWall = 0.12;                    // width of a wall, of the sheet's half side
constexpr double kLeastGround = 0.1;                 // of the sheet's half side: ground below its line
constexpr double kDegree = std::numbers::pi / 180;

/// Upright in the middle of the picture.
stack::Rail railOn(image::Size picture) {
  const double length = kNewLength * std::min(picture.width, picture.height);
  const double x = (picture.width - 1) / 2.0, y = -(picture.height - 1) / 2.0;
  return {{{x, y - length / 2, 0}, {x, y + length / 2, 0}}, false};
}

bool isStraight(const stack::Rail& rail) { return rail.points.size() == 2 && !rail.closed; }

/// The nearest layer that the sheet lies on, rather one that stands on the rail.
std::optional<std::size_t> layerAt(const Sheet& sheet) {
  const std::vector<stack::Plane>& planes = sheet.recipe.planes;
  const auto away = [&](std::size_t i) {
    return std::pair(planes[i].origin.has_value(), std::abs(planes[i].at - sheet.at));
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (away(i).second <= kSame && (!best || away(i) < away(*best))) best = i;
  }
  return best;
}

double reachOf(const stack::Plane& plane) {
  double reach = 0;
  for (const stack::Curve& curve : plane.curves) {
    for (const SectionPoint p : curve.through) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  }
  return reach;
}

/// Puts the sheet where `at` says, or on the nearest layer. False: there is none to put it on.
bool place(Sheet& sheet) {
  const std::vector<stack::Plane>& planes = sheet.recipe.planes;
  sheet.at = std::clamp(sheet.at, 0.0, mostAt(sheet));
  if (sheet.onRail()) {
    sheet.layer = layerAt(sheet);
  } else {
    if (planes.empty()) return false;
    sheet.layer = static_cast<std::size_t>(std::lround(sheet.at));
    sheet.at = static_cast<double>(*sheet.layer);
  }
  if (sheet.layer) sheet.turn = planes[*sheet.layer].turn;
  return true;
}

/// Stands it up there.
bool stand(Sheet& sheet) {
  stack::Plane plane;
  plane.at = std::min(sheet.at, 1.0);
  plane.turn = sheet.turn;
  if (sheet.layer) plane = sheet.recipe.planes[*sheet.layer];
  stack::Plane home;
  home.at = plane.at;
  if (!sheet.onRail()) home.origin = ModelPoint{};
  const auto stands = stack::standsOf({plane, home}, sheet.recipe.rail);
  if (!stands) return false;
  sheet.stand = stands.value()[0];
  sheet.home = stands.value()[1];
  if (sheet.layer) sheet.turn = turnOf(sheet, plane);
  const std::vector<ModelPoint>& rail = sheet.recipe.rail.points;
  if (sheet.at > 1 && sheet.onRail()) sheet.stand.origin = rail[0] + (rail[1] - rail[0]) * sheet.at;
  return true;
}

/// The pattern that repeats the last layer, or null: nothing stands beyond its first run.
const stack::Pattern* lastPattern(const StackRecipe& recipe) {
  const auto& patterns = recipe.stack.patterns;
  const auto last = std::ranges::find(patterns, recipe.planes.size() - 1, &stack::Pattern::last);
  return last == patterns.end() || recipe.planes.empty() ? nullptr : &*last;
}

/// A layer was put in as number `i`: runs that it stands within, or at whose ends copies leave room for it, have it
/// too.
void countIn(StackRecipe& recipe, std::size_t i) {
  const std::vector<stack::Plane>& planes = recipe.planes;
  const auto number = static_cast<std::uint32_t>(i);
  for (auto& [first, last, times, spacing] : recipe.stack.patterns) {
    const bool after = number == last + 1;
    if (number <= last) ++last;
    if (number < first || (number == first && planes[last].at - planes[i].at >= spacing)) ++first;
    if (after && planes[i].at - planes[first].at < spacing) last = number;
  }
}

/// Layer number `i` was taken out.
void countOut(StackRecipe& recipe, std::size_t i) {
  auto& patterns = recipe.stack.patterns;
  std::erase_if(patterns, [&](const stack::Pattern& pattern) { return pattern.first == i && pattern.last == i; });
  for (stack::Pattern& pattern : patterns) {
    if (i < pattern.first) --pattern.first;
    if (i <= pattern.last) --pattern.last;
  }
}

double lengthOf(const Points& line) { return geometry::arcLengths(std::span<const SectionPoint>(line)).back(); }

SectionPoint middleOf(const Points& outline) { return geometry::centroid(std::span<const SectionPoint>(outline)); }

/// Middle and mean radius of the largest curve of the trace.
struct Round {
  SectionPoint middle;
  double radius = 0;
};
Round roundOn(const Sheet& sheet) {
  Round round{{}, kNewCurve * sheet.half};
  const stack::Plane* trace = sheet.layer ? &sheet.recipe.planes[*sheet.layer] : traceOf(sheet);
  double most = 0;
  for (const stack::Curve& curve : trace ? trace->curves : std::vector<stack::Curve>()) {
    const Points outline = stack::outlineOf(curve);
    const double area = std::abs(geometry::signedArea(std::span<const SectionPoint>(outline)));
    if (area <= most) continue;
    most = area;
    round = {middleOf(outline), std::sqrt(area / std::numbers::pi)};
  }
  return round;
}

/// The foot of new ground on the sheet: where that of the part's first ground is in space, but below the line.
double footFor(const Sheet& sheet, const stack::Curve& line) {
  const auto byHeight = [](SectionPoint a, SectionPoint b) { return a.y < b.y; };
  const double low = std::ranges::min_element(line.through, byHeight)->y;
  double foot = low;
  const auto stands = stack::standsOf(sheet.recipe.planes, sheet.recipe.rail);
  for (std::size_t i = 0; stands && i < sheet.recipe.planes.size(); ++i) {
    const auto& curves = sheet.recipe.planes[i].curves;
    const auto ground = std::ranges::find(curves, stack::CurveUse::Ground, &stack::Curve::as);
    if (ground == curves.end()) continue;
    const SectionPoint under{ground->through.front().x, ground->base};
    foot = sheet.stand.in(stands.value()[i].at(under)).y;
    break;
  }
  return foot < low ? foot : low - kLeastGround * sheet.half;
}

std::optional<Sheet> placedSheet(const document::Document& document, PartId id, PictureId picture,
                                 std::optional<double> at, const geometry::Turn& turn) {
  const document::Part* part = document::findPart(document, id);
  if (id && (part == nullptr || document::stackOf(*part) == nullptr)) return std::nullopt;
  const document::PictureEntry* entry = document::findPicture(document, part ? document::pictureOf(*part) : picture);
  if (entry == nullptr) return std::nullopt;
  Sheet sheet;
  sheet.recipe.picture = entry->id;
  sheet.recipe.rail = railOn(entry->size);
  sheet.recipe.stack.melt = kNewMelt;
  if (part != nullptr) {
    sheet.part = part->id;
    sheet.recipe = *document::stackOf(*part);
    if (!sheet.recipe.planes.empty()) sheet.at = sheet.onRail() ? sheet.recipe.planes.back().at : mostAt(sheet);
  }
  if (at) sheet.at = *at;
  sheet.turn = turn;
  return place(sheet) ? std::optional(std::move(sheet)) : std::nullopt;
}

/// What `make` gives for the part in hand, else for the next one.
std::optional<Sheet> ofShown(const document::Document& document, const UiState& ui, decltype(placedSheet) make) {
  if (ui.tool != ToolKind::Layers || ui.sections.board) return std::nullopt;
  const document::Part* part = document::findPart(document, ui.selection);
  const bool ours = layersInHand(document, ui) != nullptr;
  if (ours && !part->visible) return std::nullopt;
  const PartId id = ours ? part->id : PartId{};
  const bool placed = ui.layers.part == id && ui.layers.at;
  return placed ? make(document, id, ui.picture, ui.layers.at, ui.layers.turn)
                : make(document, id, ui.picture, std::nullopt, {});
}

}  // namespace

double newWallOf(const Sheet& sheet) { return wallOf(sheet.recipe).value_or(kNewWall * sheet.half); }

double mostAt(const Sheet& sheet) {
  if (!sheet.onRail()) return sheet.recipe.planes.empty() ? 0 : static_cast<double>(sheet.recipe.planes.size() - 1);
  if (const stack::Pattern* run = lastPattern(sheet.recipe)) {
    return 1 - (run->times - 1) * run->spacing;
  }
  return isStraight(sheet.recipe.rail) ? kMostGrowth : 1;
}

std::optional<Sheet> sheetFor(const document::Document& document, PartId id, PictureId picture,
                              std::optional<double> at, const geometry::Turn& turn) {
  std::optional<Sheet> sheet = placedSheet(document, id, picture, at, turn);
  if (!sheet || !stand(*sheet)) return std::nullopt;
  const image::Size size = document::findPicture(document, sheet->recipe.picture)->size;
  sheet->half = kNewHalf * std::min(size.width, size.height);
  for (std::size_t i = 0; i < sheet->recipe.planes.size(); ++i) {
    if (sheet->onRail() || i == sheet->layer) {
      sheet->half = std::max(sheet->half, kMargin * reachOf(sheet->recipe.planes[i]));
    }
  }
  return sheet;
}

const document::StackRecipe* layersInHand(const document::Document& document, const UiState& ui) {
  const document::Part* part = document::findPart(document, ui.selection);
  return part != nullptr ? document::stackOf(*part) : nullptr;
}

std::optional<Sheet> shownPlace(const document::Document& document, const UiState& ui) {
  return ofShown(document, ui, placedSheet);
}

std::optional<Sheet> shownSheet(const document::Document& document, const UiState& ui) {
  return ofShown(document, ui, sheetFor);
}

std::optional<Sheet> sheetInHand(const document::Document& document, const UiState& ui) {
  std::optional<Sheet> sheet = shownSheet(document, ui);
  if (!sheet || !sheet->layer || !ui.preview || ui.preview->part != sheet->part) return sheet;
  const auto* moved = std::get_if<StackRecipe>(&ui.preview->recipe);
  if (moved == nullptr || *sheet->layer >= moved->planes.size()) return sheet;
  const Result<stack::Stand> stand = stack::standOf(moved->planes[*sheet->layer], moved->rail);
  if (stand) sheet->stand = stand.value();
  return sheet;
}

void placeSheet(UiState& ui, const Sheet& sheet, double at) {
  if (ui.layers.part != sheet.part || !ui.layers.at) ui.layers = {sheet.part};
  ui.layers.at = std::clamp(at, 0.0, mostAt(sheet));
}

pipeline::ToWorld sheetInWorld(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                               const Sheet& sheet) {
  const document::PictureEntry* entry = document::findPicture(document, sheet.recipe.picture);
  const image::Size size = entry ? entry->size : image::Size{1, 1};
  const document::Part* part = document::findPart(document, sheet.part);
  if (part != nullptr) return *shownCopies(ui, *part, size).begin();
  return *previewCopies(document, derived, ui, size).begin();
}

std::optional<SectionPoint> onSheet(const Sheet& sheet, const pipeline::ToWorld& toWorld, const UiState& ui,
                                    ClientPoint at) {
  const ModelPoint eye = toWorld.toModel(ui.camera.eye());
  const ModelPoint way = toWorld.alongInModel(rayThrough(ui.camera, ui.layout.solid, at));
  const double towards = dot(way, sheet.stand.normal());
  constexpr double kFlat = 0.02;  // seen from so flat, a pixel is too long on the sheet to draw
  if (!(std::abs(towards) > kFlat * norm(way))) return std::nullopt;
  const double far = dot(sheet.stand.origin - eye, sheet.stand.normal()) / towards;
  if (!(far > 0)) return std::nullopt;
  return sheet.stand.in(eye + way * far);
}

bool isOnSheet(const Sheet& sheet, SectionPoint p) { return std::max(std::abs(p.x), std::abs(p.y)) <= sheet.half; }

std::vector<ModelPoint> cornersOf(const Sheet& sheet) {
  const double h = sheet.half;
  std::vector<ModelPoint> corners;
  for (const SectionPoint p : {SectionPoint{-h, -h}, {h, -h}, {h, h}, {-h, h}}) corners.push_back(sheet.stand.at(p));
  return corners;
}

ModelPoint knobOf(const Sheet& sheet) { return sheet.stand.at({kKnob * sheet.half, 0}); }

ModelPoint leanKnobOf(const Sheet& sheet, double Lean::* way) {
  const double out = kKnob * sheet.half;
  return sheet.stand.at(way == &Lean::front ? SectionPoint{0, out} : SectionPoint{-out, 0});
}

geometry::Turn turnOf(const Sheet& sheet, const stack::Plane& plane) {
  if (!plane.origin) return plane.turn;
  const auto stand = stack::standOf(plane, sheet.recipe.rail);
  return stand ? stack::turnBetween(sheet.home, stand.value()) : plane.turn;
}

double mostLean(const Sheet& sheet, double Lean::* way) {
  constexpr double kAnywhere = 180, kHalfway = 89;  // beyond that it has turned to the side as well
  if (!sheet.isFree()) return kMostLean;
  return way == &Lean::side ? kAnywhere : kHalfway;
}

// The sheet's normal points back along the rail.
Lean leanOf(const Sheet& sheet) {
  const geometry::Angles angles = geometry::anglesOf(sheet.turn);
  return {-angles.tip / kDegree, angles.turn / kDegree};
}

geometry::Turn turnFor(const Sheet& sheet, const Lean& lean) {
  const Lean now = leanOf(sheet);  // of a recipe it may be more than a hand leans it
  const auto radians = [&](double Lean::* way) {
    const double most = std::max(mostLean(sheet, way), std::abs(now.*way));
    return std::clamp(lean.*way, -most, most) * kDegree;
  };
  const double roll = geometry::anglesOf(sheet.turn).roll;
  return geometry::turnOf({-radians(&Lean::front), radians(&Lean::side), roll});
}

StackRecipe withTurn(const Sheet& sheet, const geometry::Turn& turn) {
  StackRecipe recipe = sheet.recipe;
  if (!sheet.layer) return recipe;
  stack::Plane& plane = recipe.planes[*sheet.layer];
  if (!plane.origin) {
    plane.turn = turn;
    return recipe;
  }
  stack::Plane leant;
  leant.at = plane.at;
  leant.turn = turn;
  if (const auto stand = stack::standOf(leant, recipe.rail)) {
    plane.turn = stack::turnBetween({{}, {1, 0, 0}, {0, 1, 0}}, stand.value());
  }
  return recipe;
}

Result<std::vector<stack::Curve>> curvesOf(const Sheet& sheet, std::span<const SectionPoint> line) {
  Points small;
  for (const SectionPoint p : line) small.push_back(p / sheet.half);
  const bool open = !small.empty() && distance(small.front(), small.back()) > kOpenGap * lengthOf(small);
  sections::Drawing drawing;
  if (open) {
    auto drawn = sections::drawOpenLine(small);
    if (!drawn) return drawn.failure();
    drawing.push_back(std::move(drawn).value());
  } else {
    auto drawn = sections::drawFreehand(small, {});
    if (!drawn) return drawn.failure();
    drawing = std::move(drawn).value();
  }
  std::vector<stack::Curve> curves;
  for (const sections::DrawnCurve& drawn : drawing) {
    stack::Curve curve;
    for (const sections::DrawnPoint& point : drawn.points) {
      if (point.corner) curve.corners.at.push_back(static_cast<std::uint32_t>(curve.through.size()));
      curve.through.push_back(point.at * sheet.half);
    }
    if (open) {
      curve.open = true;
      curve.as = openLinesOf(sheet.recipe).value_or(stack::CurveUse::Ribbon);
      if (curve.as == stack::CurveUse::Ribbon) curve.width = newWallOf(sheet);
      if (curve.as == stack::CurveUse::Ground) curve.base = footFor(sheet, curve);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

stack::Curve circleOn(const Sheet& sheet) {
  const auto [m, r] = roundOn(sheet);
  return {{{m.x + r, m.y}, {m.x, m.y + r}, {m.x - r, m.y}, {m.x, m.y - r}}, {}};
}

stack::Curve squareOn(const Sheet& sheet) {
  const auto [m, radius] = roundOn(sheet);
  const double r = radius * std::sqrt(std::numbers::pi) / 2;
  return {{{m.x + r, m.y + r}, {m.x - r, m.y + r}, {m.x - r, m.y - r}, {m.x + r, m.y - r}}, {true, {}}};
}

const stack::Plane* traceOf(const Sheet& sheet) {
  const std::vector<stack::Plane>& planes = sheet.recipe.planes;
  const stack::Plane *before = nullptr, *after = nullptr;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i == sheet.layer) continue;
    const double at = sheet.onRail() ? planes[i].at : static_cast<double>(i);
    if (at < sheet.at) before = &planes[i];
    if (at > sheet.at && after == nullptr) after = &planes[i];
  }
  return before ? before : after;
}

StackRecipe withCurves(const Sheet& sheet, std::vector<stack::Curve> curves) {
  StackRecipe recipe = sheet.recipe;
  double at = sheet.at;
  if (sheet.onRail() && at > 1) {
    std::vector<ModelPoint>& rail = recipe.rail.points;
    rail[1] = rail[0] + (rail[1] - rail[0]) * at;
    for (stack::Plane& plane : recipe.planes) plane.at /= at;
    at = 1;
  }
  std::size_t own = 0;
  if (sheet.layer) {
    own = *sheet.layer;
  } else {
    stack::Plane plane;
    plane.at = at;
    plane.turn = sheet.turn;
    const auto place = std::ranges::upper_bound(recipe.planes, at, {}, &stack::Plane::at);
    own = static_cast<std::size_t>(place - recipe.planes.begin());
    recipe.planes.insert(place, plane);
    countIn(recipe, own);
    recipe.planes[own].curves = curves;  // it follows the one before from now on
    dropLinksTo(recipe, own);
    return recipe;
  }
  std::vector<Points> outlines;
  for (const stack::Curve& curve : curves) outlines.push_back(stack::outlineOf(curve));
  std::vector<stack::Curve>& kept = recipe.planes[own].curves;
  for (std::size_t i = kept.size(); i-- > 0;) {
    const Points outline = stack::outlineOf(kept[i]);
    const auto meets = [&](const Points& drawn) { return sections::outlinesMeet(outline, drawn); };
    if (std::ranges::any_of(outlines, meets)) dropCurve(recipe, own, i);
  }
  for (stack::Curve& curve : curves) kept.push_back(std::move(curve));
  return recipe;
}

StackRecipe withMovedLayer(const Sheet& sheet, double to) {
  StackRecipe recipe = sheet.recipe;
  if (!sheet.layer || !sheet.onRail()) return recipe;
  const std::size_t i = *sheet.layer, last = recipe.planes.size() - 1;
  const stack::Pattern* run = lastPattern(recipe);
  const double least = run && run->first == i ? recipe.planes[run->last].at - run->spacing + kApart : 0;
  const double low = std::max(i > 0 ? recipe.planes[i - 1].at + kApart : 0, least);
  const double high = i < last ? recipe.planes[i + 1].at - kApart : mostAt(sheet);
  if (low > high) return recipe;
  const double at = std::clamp(to, low, high);
  recipe.planes[i].at = std::min(at, 1.0);
  if (at <= 1) return recipe;
  std::vector<ModelPoint>& rail = recipe.rail.points;
  rail[1] = rail[0] + (rail[1] - rail[0]) * at;
  for (std::size_t k = 0; k < i; ++k) recipe.planes[k].at /= at;
  return recipe;
}

document::Look layerLook(const UiState& ui) {
  document::Look look = ui.look;
  look.textured = false;
  return look;
}

StackRecipe withoutLayer(const Sheet& sheet) {
  StackRecipe recipe = sheet.recipe;
  if (!sheet.layer) return recipe;
  dropLinksTo(recipe, *sheet.layer);
  recipe.planes.erase(recipe.planes.begin() + static_cast<std::ptrdiff_t>(*sheet.layer));
  countOut(recipe, *sheet.layer);
  return recipe;
}

}  // namespace spineloft::app
