#include "web/edit/shaping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "engine/document/checks.h"
#include "engine/geometry/bounds.h"
#include "engine/geometry/line_distance.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/mesh/laws.h"
#include "engine/shape/reshape.h"
#include "web/edit/preview.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

constexpr double kStraight = 3;       // degrees
constexpr double kWidest = 0.01;      // of the width: what is as wide as the widest place
constexpr double kNearby = 0.15;      // of the smaller extent of an outline, that still is at it
constexpr double kOff = 26;           // CSS pixels that a handle is off the outline
constexpr double kShortest = 4;       // picture pixels of an axis
constexpr double kFitSlack = 0.0015;  // of the size, by which the outline of a thing may be simplified

/// `to`, upright or level of `other` where it is nearly.
PicturePoint straightened(PicturePoint to, PicturePoint other) {
  const PicturePoint along = to - other;
  const double slack = std::tan(kStraight * std::numbers::pi / 180);
  if (std::abs(along.x) < slack * std::abs(along.y)) to.x = other.x;
  if (std::abs(along.y) < slack * std::abs(along.x)) to.y = other.y;
  return to;
}

/// What a picture shows of the depth: more is nearer to who looks from the front.
double depthAt(const SeenShape& seen, PicturePoint p) { return geometry::inModel(*seen.view, p).z; }
bool showsDepth(const SeenShape& seen) { return seen.view && seen.role() == shape::Role::Depth; }

struct Axes {
  PicturePoint along, aside;
};
Axes axesOf(const document::ShapeRecipe& recipe) {
  const PicturePoint along = normalized(recipe.shape.axis.to - recipe.shape.axis.from);
  return {along, {-along.y, along.x}};
}
double across(const SeenShape& seen, PicturePoint p) {
  return dot(p - seen.recipe.shape.axis.from, axesOf(seen.recipe).aside);
}

/// The point of the outline where `measure` is largest, of several the one nearest to the middle of the outline.
template <class Measure>
PicturePoint farthest(const std::vector<PicturePoint>& outline, const Measure& measure) {
  const auto [least, most] = std::ranges::minmax(outline, {}, measure);
  const double enough = measure(most) - kWidest * (measure(most) - measure(least));
  const PicturePoint middle = geometry::boundsOf(std::span<const PicturePoint>(outline)).middle();
  PicturePoint best = most;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    // Between two such points the outline runs straight: the nearest place of it.
    const PicturePoint a = outline[i], b = outline[(i + 1) % outline.size()];
    if (measure(a) < enough) continue;
    const PicturePoint way = b - a;
    const bool straight = measure(b) >= enough && dot(way, way) > 0;
    const double t = straight ? std::clamp(dot(middle - a, way) / dot(way, way), 0.0, 1.0) : 0;
    const PicturePoint at = a + way * t;
    if (distance(at, middle) < distance(best, middle)) best = at;
  }
  return best;
}

/// Outlines go where the measures of the shape go.
void carryOutlines(const document::Document& document, document::ShapeRecipe& recipe,
                   const shape::ShapeParams& before) {
  for (document::Outline& outline : recipe.outlines) {
    const auto view = document::viewOn(document, outline.picture, recipe.picture);
    if (!view.ok()) continue;
    for (auto& line : outline.lines) {
      for (PicturePoint& p : line) {
        p = view.value() ? shape::carried(p, *view.value(), before, recipe.shape)
                         : shape::carried(p, before, recipe.shape);
      }
    }
  }
}

/// More or less depth by a factor: of the outline that says it, else of the ratio.
void deepen(const SeenShape& seen, document::ShapeRecipe& recipe, PicturePoint from, PicturePoint to) {
  const auto [back, front] = std::ranges::minmax(seen.outline, {}, [&](PicturePoint p) { return depthAt(seen, p); });
  const auto drawn = std::ranges::find(recipe.outlines, seen.picture, &document::Outline::picture);
  const bool own = drawn != recipe.outlines.end();
  const double middle = own ? (depthAt(seen, back) + depthAt(seen, front)) / 2 : 0;
  const double before = depthAt(seen, from) - middle, after = depthAt(seen, to) - middle;
  if (!(before > 0)) return;
  const double factor = std::max(after / before, 0.0);
  if (!own) {
    double& ratio = recipe.shape.depth.ratio;
    ratio = std::clamp(ratio * factor, shape::kLeastRatio, shape::kMostRatio);
    return;
  }
  const PicturePoint centre = geometry::inView(*seen.view, {0, 0, middle});
  for (auto& line : drawn->lines) {
    for (PicturePoint& p : line) {
      const bool level = seen.view->from == geometry::ViewFrom::Top;  // depth is y of the picture
      double& c = level ? p.y : p.x;
      const double base = level ? centre.y : centre.x;
      c = base + (c - base) * std::max(factor, 0.05);
    }
  }
}

/// The picture's view is the one that it got unseen, and no outline is drawn by it.
bool isUnaligned(const document::Document& document, PictureId picture) {
  const document::PictureEntry* side = document::findPicture(document, picture);
  if (side == nullptr || !side->view) return false;
  const document::PictureEntry* front = document::findPicture(document, side->view->of);
  const geometry::View& view = side->view->view;
  if (front == nullptr || !(view == plainView(view.from, front->size, side->size))) return false;
  return std::ranges::none_of(document.parts, [&](const document::Part& part) {
    return pictureOf(part) != picture &&
           std::ranges::any_of(document::outlinesOf(part.recipe),
                               [&](const document::Outline* outline) { return outline->picture == picture; });
  });
}

}  // namespace

std::optional<SeenShape> seenShape(const document::Document& document, PartId id, PictureId picture) {
  const document::Part* part = document::findPart(document, id);
  const document::ShapeRecipe* recipe = part ? document::shapeOf(*part) : nullptr;
  if (recipe == nullptr) return std::nullopt;
  const auto view = document::viewOn(document, picture, recipe->picture);
  if (!view.ok()) return std::nullopt;
  auto outline = pipeline::outlineIn(*recipe, document, picture);
  if (!outline.ok()) return std::nullopt;
  return SeenShape{part, *recipe, picture, view.value(), std::move(outline).value()};
}

std::optional<SeenShape> shapeInHand(const document::Document& document, const UiState& ui) {
  if (ui.tool != ToolKind::Primitive) return std::nullopt;
  return seenShape(document, ui.selection, ui.picture);
}

std::optional<SeenShape> shapeShown(const document::Document& document, const UiState& ui) {
  std::optional<SeenShape> seen = shapeInHand(document, ui);
  const auto* recipe = seen && ui.preview && ui.preview->part == seen->part->id
                           ? std::get_if<document::ShapeRecipe>(&ui.preview->recipe)
                           : nullptr;
  if (recipe == nullptr) return seen;
  auto outline = pipeline::outlineIn(*recipe, document, ui.picture);
  if (!outline.ok()) return seen;
  seen->recipe = *recipe;
  seen->outline = std::move(outline).value();
  return seen;
}

const document::Part* partOfViews(const document::Document& document, const UiState& ui) {
  const document::Part* part = document::findPart(document, ui.selection);
  const bool takesOutlines =
      part != nullptr && (document::shapeOf(*part) != nullptr || document::sideOf(part->recipe) != nullptr);
  return takesOutlines && ui.tool == ToolKind::Primitive ? part : nullptr;
}

const document::Part* shapeElsewhere(const document::Document& document, const UiState& ui) {
  const document::Part* part = partOfViews(document, ui);
  return part != nullptr && document::pictureOf(*part) != ui.picture ? part : nullptr;
}

bool isSeenAside(const document::Document& document, const document::Part& part, PictureId picture) {
  return document::sideOf(part.recipe) != nullptr && document::showsSide(document, picture, document::pictureOf(part));
}

const document::Part* partAside(const document::Document& document, const UiState& ui) {
  const document::Part* part = shapeElsewhere(document, ui);
  return part && isSeenAside(document, *part, ui.picture) ? part : nullptr;
}

DrawnSide withSide(const document::Document& document, const document::Part& part, const pipeline::PartShape& shape,
                   document::Outline drawn) {
  DrawnSide side{std::move(drawn), std::nullopt};
  const auto view = document::viewOn(document, side.side.picture, document::pictureOf(part));
  if (!view.ok() || !view.value() || side.side.lines.size() != 1) return side;
  std::vector<PicturePoint>& line = side.side.lines.front();
  if (line.size() < 3) return side;
  const mesh::Bounds bounds = mesh::boundsOf(shape.mesh);
  const PicturePoint low{bounds.low[0], -bounds.high[1]}, high{bounds.high[0], -bounds.low[1]};
  const double size = std::max(high.x - low.x, high.y - low.y) / view.value()->scale, slack = kFitSlack * size;
  line.push_back(line.front());
  line = geometry::simplifiedLine(std::span<const PicturePoint>(line), std::max(0.5, slack));
  line.pop_back();
  if (isUnaligned(document, side.side.picture)) {
    side.view = shape::alignedView(view.value()->from, line, {low, {high.x, low.y}, high, {low.x, high.y}});
  }
  return side;
}

std::string_view holdKey(ShapeHold hold) {
  static constexpr std::array<std::string_view, 5> kKeys = {"from", "to", "middle", "width", "depth"};
  return kKeys[static_cast<std::size_t>(hold)];
}

std::vector<ShapeHandle> shapeHandles(const SeenShape& seen) {
  if (seen.outline.empty()) return {};
  if (seen.view) {
    if (!showsDepth(seen)) return {};
    const PicturePoint nearer = geometry::inView(*seen.view, {0, 0, 1}) - geometry::inView(*seen.view, {});
    return {{ShapeHold::Depth, farthest(seen.outline, [&](PicturePoint p) { return depthAt(seen, p); }),
             normalized(nearer)}};
  }
  const auto& [from, to] = seen.recipe.shape.axis;
  const auto [along, aside] = axesOf(seen.recipe);
  const PicturePoint width = farthest(seen.outline, [&](PicturePoint p) { return across(seen, p); });
  return {{ShapeHold::From, from, along * -1.0},
          {ShapeHold::To, to, along},
          {ShapeHold::Middle, (from + to) / 2, {}},
          {ShapeHold::Width, width, aside}};
}

PicturePoint heldAt(const ShapeHandle& handle, double zoom) { return handle.at + handle.out * (kOff / zoom); }

int shapeHandleAt(const std::vector<ShapeHandle>& handles, PicturePoint p, double zoom, double reach) {
  int best = -1;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const double away = distance(heldAt(handles[i], zoom), p) * zoom;
    if (away > reach) continue;
    reach = away;
    best = static_cast<int>(i);
  }
  return best;
}

std::string shapeSentence(ShapeHold hold) {
  switch (hold) {
    case ShapeHold::From:
      return std::string(words::tr("The end where the shape begins. Arrows move it."));
    case ShapeHold::To:
      return std::string(words::tr("The other end of the shape. Arrows move it."));
    case ShapeHold::Middle:
      return std::string(words::tr("The middle of the shape. Arrows move all of it."));
    case ShapeHold::Width:
      return std::string(words::tr("The width of the shape. Arrows change it."));
    case ShapeHold::Depth:
      break;
  }
  return std::string(words::tr("The depth of the shape. Arrows change it."));
}

std::optional<document::ShapeRecipe> draggedShape(const document::Document& document, const SeenShape& seen,
                                                  const ShapeHandle& handle, PicturePoint to) {
  document::ShapeRecipe recipe = seen.recipe;
  shape::ShapeParams& shape = recipe.shape;
  const shape::Axis before = shape.axis;
  switch (handle.hold) {
    case ShapeHold::From:
      shape.axis.from = straightened(to, before.to);
      break;
    case ShapeHold::To:
      shape.axis.to = straightened(to, before.from);
      break;
    case ShapeHold::Middle:
      shape.axis = {before.from + (to - handle.at), before.to + (to - handle.at)};
      break;
    case ShapeHold::Width: {
      const double was = across(seen, handle.at), now = across(seen, to);
      if (!(was > 0)) return std::nullopt;
      shape.width = std::max(shape.width * now / was, shape::kLeastWidth);
      break;
    }
    case ShapeHold::Depth:
      deepen(seen, recipe, handle.at, to);
      break;
  }
  if (!shape::isValid(shape) || distance(shape.axis.from, shape.axis.to) < kShortest) return std::nullopt;
  if (handle.hold != ShapeHold::Depth) carryOutlines(document, recipe, seen.recipe.shape);
  if (!pipeline::outlineIn(recipe, document, recipe.picture).ok()) return std::nullopt;
  return recipe;
}

DrawnShape withLine(const document::Document& document, const SeenShape& seen, const std::vector<PicturePoint>& line) {
  DrawnShape drawn{seen.recipe, std::nullopt};
  std::vector<PicturePoint> outline = shape::redrawn(seen.outline, line);
  if (isUnaligned(document, seen.picture) && shape::isWhole(seen.outline, line)) {
    const auto front = pipeline::outlineIn(seen.recipe, document, seen.recipe.picture);
    if (front.ok()) drawn.view = shape::alignedView(seen.view->from, outline, front.value());
  }
  document::ShapeRecipe& recipe = drawn.recipe;
  const shape::Role role = seen.role();
  std::erase_if(recipe.outlines, [&](const document::Outline& other) {
    const auto view = document::viewOn(document, other.picture, recipe.picture);
    return other.picture == seen.picture || (view.ok() && shape::roleOf(recipe.shape.axis, view.value()) == role);
  });
  if (!seen.view) recipe.shape.axis = shape::alongOutline(recipe.shape.axis, outline);
  recipe.outlines.push_back({seen.picture, {std::move(outline)}});
  return drawn;
}

document::ShapeRecipe previewOfLine(const document::Document& document, const SeenShape& seen,
                                    const std::vector<PicturePoint>& line) {
  DrawnShape drawn = withLine(document, seen, line);
  if (!drawn.view) return std::move(drawn.recipe);
  for (PicturePoint& p : drawn.recipe.outlines.back().lines.front()) {
    p = geometry::inView(*seen.view, geometry::inModel(*drawn.view, p));
  }
  return std::move(drawn.recipe);
}

bool drawsOutline(const SeenShape& seen, PicturePoint from, double reach) {
  if (seen.view) return true;
  const std::span<const PicturePoint> outline = seen.outline;
  const geometry::Bounds<PicturePoint> box = geometry::boundsOf(outline);
  const PicturePoint size = box.high - box.low;
  return geometry::distanceToLine(from, outline, true) <= std::max(reach, kNearby * std::min(size.x, size.y));
}

document::ShapeRecipe nextShape(const UiState& ui, PicturePoint from, PicturePoint to) {
  document::ShapeRecipe recipe;
  recipe.picture = ui.picture;
  recipe.shape.primitive = ui.primitive;
  recipe.shape.axis = {from, straightened(to, from)};
  recipe.shape.width =
      std::max(shape::kLeastWidth, shape::readyShape(ui.primitive).width * distance(from, recipe.shape.axis.to));
  return recipe;
}

Result<document::ShapeRecipe> fittedShape(const document::Document& document, const document::ShapeRecipe& recipe,
                                          const std::vector<PicturePoint>& outline) {
  Result<shape::ShapeParams> fitted = shape::fittedTo(recipe.shape, outline);
  if (!fitted.ok()) return fitted.failure();
  document::ShapeRecipe plain = recipe;
  plain.shape = std::move(fitted).value();
  plain.outlines.clear();
  document::ShapeRecipe drawn = plain;
  drawn.shape.axis = shape::alongOutline(drawn.shape.axis, outline);
  const double slack = kFitSlack * std::max(distance(drawn.shape.axis.from, drawn.shape.axis.to), drawn.shape.width);
  std::vector<PicturePoint> closed = outline;
  closed.push_back(outline.front());
  closed = geometry::simplifiedLine(std::span<const PicturePoint>(closed), std::max(0.5, slack));
  closed.pop_back();
  drawn.outlines.push_back({recipe.picture, {std::move(closed)}});
  return pipeline::outlineIn(drawn, document, recipe.picture).ok() ? drawn : plain;
}

std::span<const SideName> sideNames() {
  using geometry::ViewFrom;
  // Who looks from the right of the thing sees its front at the left.
  static constexpr std::array kNames = {
      SideName{ViewFrom::Right, "Looks left", "From a side: its front is at the left"},
      SideName{ViewFrom::Left, "Looks right", "From a side: its front is at the right"},
      SideName{ViewFrom::Back, "From behind", "From behind"},
      SideName{ViewFrom::Top, "From above", "From above: its front is at the foot"},
  };
  static_assert(kNames.size() == static_cast<std::size_t>(ViewFrom::kCount));
  return kNames;
}

geometry::View plainView(geometry::ViewFrom from, image::Size front, image::Size side) {
  const bool top = from == geometry::ViewFrom::Top, back = from == geometry::ViewFrom::Back;
  geometry::View view{from, (side.width - 1) / 2.0, static_cast<double>(front.height) / side.height, 0};
  if (top) view.scale = static_cast<double>(front.width) / side.width;
  view.shift = (1 - view.scale) / 2;  // edges of pixels upon edges
  if (top) view.shift = -view.shift;
  if (top) view.middle = (side.height - 1) / 2.0;
  if (back) {
    view.middle = -view.shift / view.scale;
    view.shift = (front.width - 1 + view.scale * (side.width - 1)) / 2;
  }
  return view;
}

}  // namespace spineloft::app
