#include "engine/document/checks.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/inflate/profile.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::document {
namespace {

constexpr double kFarthest = 1e6;  // picture pixels: beyond it is no place that a hand means

}  // namespace

std::string fallbackName(const Part& part) { return "Part " + std::to_string(part.id.value); }

std::string fallbackName(const Step& step) { return "Solid " + std::to_string(step.id.value); }
std::string fallbackName(const Group& group) { return "Group " + std::to_string(group.id.value); }

std::string fallbackName(const PictureEntry& entry) {
  return (entry.isSketch() ? "Sketch " : "Picture ") + std::to_string(entry.id.value);
}

std::string tidyName(std::string name, std::string_view fallback) {
  if (name.empty()) return std::string(fallback);
  name = validUtf8(std::move(name));
  if (name.size() <= kMaxNameBytes) return name;
  std::size_t end = kMaxNameBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
  name.resize(end);
  return name;
}

bool isValid(const ribs::IgnoreMark& mark) {
  constexpr double kLeastRadius = 0.5, kMostRadius = 500;  // picture pixels
  return !mark.stroke.empty() && mark.stroke.size() <= loft::kMostStrokePoints && mark.radius >= kLeastRadius &&
         mark.radius <= kMostRadius && std::ranges::all_of(mark.stroke, [](PicturePoint p) { return isFinite(p); });
}

bool isValid(std::span<const ribs::IgnoreMark> marks) {
  return marks.size() <= ribs::kMostIgnoreMarks &&
         std::ranges::all_of(marks, [](const ribs::IgnoreMark& mark) { return isValid(mark); });
}

Status checkStroke(const Document& document, const LoftRecipe& recipe) {
  const PictureEntry* entry = findPicture(document, recipe.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, entry->size, recipe.spine);
  if (!spine) return spine.failure();
  return Done{};
}

Status checkRegion(const Document& document, const Region& region) {
  const PictureEntry* entry = findPicture(document, region.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const bool isRibbon = region.ribbon != 0;
  if (isRibbon && !(region.ribbon >= kLeastRibbon && region.ribbon <= kMostRibbon)) {
    return {Error::ValueOutOfRange, "width of the line"};
  }
  if (region.contours.size() > kMostContours) return {Error::ValueOutOfRange, "too many outlines"};
  std::size_t points = 0;
  const std::size_t least = region.isOfLines() ? 2 : 3;
  bool any = false;
  PicturePoint low{kFarthest, kFarthest}, high{-kFarthest, -kFarthest};
  for (const auto& contour : region.contours) {
    points += contour.size();
    any = any || contour.size() >= least;
    for (const PicturePoint p : contour) {
      if (!isFinite(p) || std::abs(p.x) > kFarthest || std::abs(p.y) > kFarthest) {
        return Error::StrokeNotFinite;
      }
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  if (points > kMostRegionPoints) return {Error::ValueOutOfRange, "too many points"};
  if (!any) return Error::RegionEmpty;
  const bool onPicture =
      high.x >= -0.5 && high.y >= -0.5 && low.x <= entry->size.width - 0.5 && low.y <= entry->size.height - 0.5;
  if (!onPicture) return Error::RegionOutside;
  return Done{};
}

Status checkStack(const Document& document, const StackRecipe& recipe) {
  if (findPicture(document, recipe.picture) == nullptr) return Error::NoSuchPicture;
  return stack::checkPlanes(recipe.planes, recipe.rail);
}

Status checkSolid(const RegionSolid& solid) {
  if (!std::visit([](const auto& params) { return isValid(params); }, solid)) return Error::ValueOutOfRange;
  const auto* puff = std::get_if<inflate::InflateParams>(&solid);
  if (puff == nullptr || puff->profile.isSoft()) return Done{};
  const auto curves = inflate::profileCurves(puff->profile.slices.front().shape, puff->sides);
  return curves ? Status(Done{}) : Status(curves.failure());
}

Status checkDrawn(const Document& document, const Recipe& recipe) {
  if (const auto* stack = std::get_if<StackRecipe>(&recipe)) return checkStack(document, *stack);
  if (const Region* region = regionOf(recipe)) return checkRegion(document, *region);
  const auto* loft = std::get_if<LoftRecipe>(&recipe);
  return loft ? checkStroke(document, *loft) : Status(Error::NoSuchPart);
}

bool holdsWork(const Document& document) {
  return !document.parts.empty() || std::ranges::any_of(document.pictures, [](const PictureEntry& entry) {
    return !entry.sketch.empty() || !entry.ignored.empty();
  });
}

}  // namespace spineloft::document
