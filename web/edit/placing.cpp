#include "web/edit/placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/document/update.h"

namespace spineloft::app {
namespace {

using document::PlaceParts;

const mesh::TriMesh* shapeOf(const pipeline::Derived& derived, PartId part) {
  const auto at = std::ranges::find(derived.parts, part, &pipeline::DerivedPart::id);
  return at == derived.parts.end() || !at->shape ? nullptr : &at->shape->mesh;
}

/// The placement about a pivot of its own: one that was never placed gets the middle of its shape.
document::Placement withPivot(const document::Document& document, const document::Part& part,
                              const document::Placement& placement, const mesh::TriMesh& shape) {
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(part));
  if (entry == nullptr || placement.pivot != WorldPoint{}) return placement;
  return document::about(placement, pipeline::middleOf(shape, pipeline::worldFrame(entry->size)));
}

}  // namespace

std::vector<PartId> withHosts(const document::Document& document, std::span<const PartId> parts) {
  std::vector<PartId> all;
  const auto add = [&](PartId id) {
    if (std::ranges::count(all, id) == 0) all.push_back(id);
  };
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(document, id);
    if (const document::BridgeRecipe* bridge = part ? document::bridgeOf(*part) : nullptr) {
      add(bridge->from.part);
      add(bridge->to.part);
    }
    add(id);
  }
  return all;
}

std::vector<PartId> withGroup(const document::Document& document, PartId id) {
  const document::Part* part = document::findPart(document, id);
  if (part == nullptr) return {};
  return part->group ? document::partsOfGroup(document, part->group) : std::vector<PartId>{id};
}

std::vector<PartId> selectedParts(const document::Document& document, const UiState& ui) {
  std::vector<PartId> parts;
  if (!ui.selection) return parts;
  for (const document::Part& part : document.parts) {
    if (isSelected(document, ui, part.id)) parts.push_back(part.id);
  }
  return parts;
}

bool isSelected(const document::Document& document, const UiState& ui, PartId id) {
  const auto chosen = [&](PartId part) {
    return part == ui.selection || std::ranges::count(ui.alsoSelected, part) > 0;
  };
  if (!ui.selection) return false;
  if (chosen(id)) return true;
  const document::Part* part = document::findPart(document, id);
  if (part == nullptr || !part->group) return false;
  return std::ranges::any_of(
      document.parts, [&](const document::Part& other) { return other.group == part->group && chosen(other.id); });
}

void addToSelection(const document::Document& document, UiState& ui, PartId id) {
  if (!isSelected(document, ui, id)) {
    ui.alsoSelected.push_back(id);
    return;
  }
  const std::vector<PartId> leaving = withGroup(document, id);
  const auto leaves = [&](PartId part) { return std::ranges::count(leaving, part) > 0; };
  std::erase_if(ui.alsoSelected, leaves);
  if (!leaves(ui.selection)) return;
  ui.selection = ui.alsoSelected.empty() ? PartId{} : ui.alsoSelected.front();
  std::erase(ui.alsoSelected, ui.selection);
}

PlaceParts::One standOf(const UiState& ui, const document::Part& part) {
  const auto held = std::ranges::find(ui.placing, part.id, &PlaceParts::One::part);
  if (held != ui.placing.end()) return *held;
  return {part.id, part.placement, part.mirror};
}

pipeline::Copies shownCopies(const UiState& ui, const document::Part& part, image::Size picture) {
  const PlaceParts::One one = standOf(ui, part);
  return pipeline::copiesInWorld(one.placement, one.mirror, picture);
}

pipeline::Copies previewCopies(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                               image::Size picture) {
  if (!ui.preview || !ui.preview->shape) return pipeline::copiesInWorld({}, {}, picture);
  const document::Part* part = document::findPart(document, ui.preview->part);
  if (part != nullptr) return shownCopies(ui, *part, picture);
  if (std::holds_alternative<document::BridgeRecipe>(ui.preview->recipe)) {
    return pipeline::copiesInWorld({}, {}, picture);  // it stands where its parts do
  }
  const document::Placement beside =
      pipeline::standBeside(document, derived, document::pictureOf(ui.preview->recipe), ui.preview->shape->mesh);
  return pipeline::copiesInWorld(beside, {}, picture);
}

std::optional<WorldPoint> centreOf(const document::Document& document, const pipeline::Derived& derived,
                                   const UiState& ui, std::span<const PartId> parts) {
  WorldPoint sum;
  int count = 0;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(document, id);
    const mesh::TriMesh* shape = shapeOf(derived, id);
    if (part == nullptr || shape == nullptr || !part->visible) continue;
    const document::Placement placement = withPivot(document, *part, standOf(ui, *part).placement, *shape);
    sum += placement(placement.pivot);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::vector<PlaceParts::One> movedParts(const document::Document& document, const pipeline::Derived& derived,
                                        std::span<const PartId> asked, const document::Motion& motion) {
  const std::vector<PartId> parts = withHosts(document, asked);
  std::vector<PlaceParts::One> moved;
  bool planesToo = false;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(document, id);
    planesToo = planesToo || (part != nullptr && !part->mirror);
  }
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(document, id);
    if (part == nullptr) continue;
    document::Placement placement = part->placement;
    if (const mesh::TriMesh* shape = shapeOf(derived, id)) {
      placement = withPivot(document, *part, placement, *shape);
    }
    const bool follows = document::bridgeOf(*part) != nullptr;
    PlaceParts::One one{id, follows ? part->placement : document::moved(placement, motion), part->mirror};
    if (one.mirror && planesToo) one.mirror = document::moved(*one.mirror, motion);
    moved.push_back(one);
  }
  return moved;
}

double mmPerUnit(const document::Document& document, const pipeline::Derived& derived) {
  const auto bounds = pipeline::worldBounds(document, derived);
  const double tall = bounds ? bounds->high.y - bounds->low.y : 0;
  return tall > 0 ? document.height.value / tall : 0;
}

std::vector<document::Action> placeActions(const document::Document& document, const pipeline::Derived& derived,
                                           std::vector<PlaceParts::One> parts) {
  constexpr double kSteps = 100;  // heights are kept in hundredths of a millimetre
  std::vector<document::Action> actions{PlaceParts{std::move(parts)}};
  const Result<document::Document> after = document::update(document, actions.front());
  const auto was = pipeline::worldBounds(document, derived);
  if (!after || !was) return actions;
  const auto is = pipeline::worldBounds(after.value(), derived);
  const double before = was->high.y - was->low.y, now = is->high.y - is->low.y;
  if (!(before > 0) || !(now > 0) || now == before) return actions;
  const double mm = std::round(document.height.value * now / before * kSteps) / kSteps;
  actions.push_back(document::SetHeight{{std::clamp(mm, document::kMinHeightMm, document::kMaxHeightMm)}});
  return actions;
}

std::span<const MirrorAxis> mirrorAxes() {
  // Things seen from the side need the second one.
  static constexpr std::array kAxes = {MirrorAxis{"x", "Left and right", "Left, right", "sides-x", {1, 0, 0}},
                                       MirrorAxis{"z", "Front and back", "Front, back", "sides-z", {0, 0, 1}},
                                       MirrorAxis{"y", "Top and bottom", "Top, bottom", "sides-y", {0, 1, 0}}};
  return kAxes;
}

bool isAcross(const document::MirrorPlane& plane, const MirrorAxis& axis) {
  constexpr double kAlong = 0.999;  // turned with the model, it is its own
  return std::abs(dot(plane.normal, axis.normal)) > kAlong;
}

document::MirrorPlane planeFor(const document::Document& document, const pipeline::Derived& derived,
                               std::span<const PartId> parts, const MirrorAxis& axis) {
  document::MirrorPlane plane;
  plane.normal = axis.normal;
  const auto others = pipeline::boundsWithout(document, derived, parts);
  const auto own = pipeline::boundsOf(document, derived, parts);
  if (others) {
    plane.point = others->centre();
  } else if (own) {
    plane.point = own->centre() + plane.normal * (dot(own->high - own->low, plane.normal) / 2);
  }
  return plane;
}

std::optional<document::Motion> settleOn(const document::Document& document, const pipeline::Derived& derived,
                                         std::span<const PartId> parts, WorldPoint at, WorldPoint normal) {
  constexpr double kLevel = 1e-9;  // as low as the lowest, world units
  const auto bounds = pipeline::boundsOf(document, derived, parts);
  if (!bounds) return std::nullopt;
  const WorldPoint middle = bounds->centre();
  double lowest = std::numeric_limits<double>::infinity(), nearest = lowest;
  WorldPoint foot;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(document, id);
    const mesh::TriMesh* shape = shapeOf(derived, id);
    const document::PictureEntry* entry = part ? document::findPicture(document, document::pictureOf(*part)) : nullptr;
    if (entry == nullptr || shape == nullptr || !part->visible) continue;
    const pipeline::Copies copies = pipeline::copiesInWorld(*part, entry->size);
    for (const auto& p : shape->positions) {
      const WorldPoint w = (*copies.begin())(p);
      const double level = dot(w, normal), aside = distance(w, middle);
      if (level > lowest + kLevel || (level > lowest - kLevel && aside >= nearest)) continue;
      lowest = std::min(lowest, level);
      nearest = aside;
      foot = w;
    }
  }
  document::Motion motion;
  motion.move = at - foot;
  return motion;
}

double placeNumber(const document::Part& part, std::string_view key, double mm) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const geometry::Angles angles = geometry::anglesOf(part.placement.turn);
  if (key == "x") return part.placement.move.x * mm;
  if (key == "y") return part.placement.move.y * mm;
  if (key == "z") return part.placement.move.z * mm;
  if (key == "tip") return angles.tip * kDegrees;
  if (key == "turn") return angles.turn * kDegrees;
  if (key == "lean") return angles.roll * kDegrees;
  return key == "size" ? part.placement.scale * 100 : 0;
}

}  // namespace spineloft::app
