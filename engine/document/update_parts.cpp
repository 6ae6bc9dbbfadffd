#include "engine/document/update_parts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/document/checks.h"
#include "engine/document/step.h"

namespace spineloft::document {

void addPart(Document& document, Recipe recipe, const Look& look) {
  Part part;
  part.recipe = std::move(recipe);
  part.look = look;
  part.id = PartId{++document.lastPartId};
  part.name = fallbackName(part);
  document.parts.push_back(std::move(part));
}

void erasePart(Document& document, PartId id) {
  std::vector<PartId> gone = bridgesOn(document, id);
  gone.push_back(id);
  for (const PartId one : gone) takeOut(document, {one, {}});
  std::erase_if(document.parts, [&](const Part& part) { return std::ranges::count(gone, part.id) > 0; });
}

namespace {

// What says where a part lies in its picture.
std::vector<PicturePoint> placesOf(const Recipe& recipe) {
  if (const auto* loft = std::get_if<LoftRecipe>(&recipe)) {
    return loft->pose.stroke.empty() ? loft->stroke : loft->pose.stroke;
  }
  if (const auto* shape = std::get_if<ShapeRecipe>(&recipe)) return {shape->shape.axis.from, shape->shape.axis.to};
  std::vector<PicturePoint> places;
  if (const Region* region = regionOf(recipe)) {
    for (const auto& contour : region->contours) places.insert(places.end(), contour.begin(), contour.end());
  }
  if (const auto* lathe = std::get_if<LatheRecipe>(&recipe)) {
    places.push_back(lathe->lathe.axisFrom);
    places.push_back(lathe->lathe.axisTo);
  }
  return places;
}

// How far in front of the picture it lies, picture pixels.
double nearnessOf(const Document& document, const Recipe& recipe) {
  const auto* flat = std::get_if<ExtrudeRecipe>(&recipe);
  const PictureEntry* entry = flat ? findPicture(document, flat->region.picture) : nullptr;
  return entry ? flat->extrude.depth * std::max(entry->size.width, entry->size.height) : 0;
}

// ModelSpace. None: it was not moved, or not as a whole.
std::optional<ModelPoint> shiftOf(const Document& document, const Recipe& before, const Recipe& after) {
  constexpr double kAlike = 1e-6;  // picture pixels
  const std::vector<PicturePoint> from = placesOf(before), to = placesOf(after);
  if (from.empty() || from.size() != to.size()) return std::nullopt;
  const PicturePoint by = to.front() - from.front();
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (distance(to[i] - from[i], by) > kAlike) return std::nullopt;
  }
  const ModelPoint shift{by.x, -by.y, nearnessOf(document, after) - nearnessOf(document, before)};
  return norm(shift) > kAlike ? std::optional(shift) : std::nullopt;
}

}  // namespace

void carryLines(const Document& before, Document& after) {
  std::map<PartId, ModelPoint> shifts;
  for (Box<Part>& box : after.parts) {
    const Part* was = findPart(before, box->id);
    if (was == nullptr || was->recipe == box->recipe || was->pulls != box->pulls || was->relief != box->relief)
      continue;
    const auto by = shiftOf(after, was->recipe, box->recipe);
    if (!by) continue;
    shifts[box->id] = *by;
    if (box->pulls.empty() && !box->relief) continue;
    Part part = box;
    for (pull::Pull& pull : part.pulls) {
      pull::eachPlace(pull, [&](ModelPoint& p) { p += *by; });
    }
    if (part.relief) {
      relief::eachPlace(*part.relief, [&](PicturePoint& p) { p += {by->x, -by->y}; });
    }
    box = std::move(part);
  }
  if (shifts.empty()) return;
  for (Box<Part>& box : after.parts) {
    if (bridgeOf(*box) == nullptr) continue;
    Part part = box;
    for (BridgeEnd* end : {&bridgeOf(part)->from, &bridgeOf(part)->to}) {
      const auto at = shifts.find(end->part);
      for (std::size_t i = 0; at != shifts.end() && i < end->rim.size(); ++i) end->rim[i] += at->second;
    }
    box = std::move(part);
  }
}

Status roomForPart(const Document& document) {
  if (document.parts.size() < kMostParts) return Done{};
  return {Error::ValueOutOfRange, "too many parts"};
}

}  // namespace spineloft::document
