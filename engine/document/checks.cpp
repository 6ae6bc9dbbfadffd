#include "engine/document/checks.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/ribs/spine.h"

namespace spineloft::document {

std::string fallbackName(const Part& part) { return "Part " + std::to_string(part.id.value); }

std::string fallbackName(const Step& step) { return "Solid " + std::to_string(step.id.value); }

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
  return !mark.stroke.empty() && mark.stroke.size() <= loft::kMostStrokePoints &&
         mark.radius >= kLeastRadius && mark.radius <= kMostRadius &&
         std::ranges::all_of(mark.stroke, [](PicturePoint p) { return isFinite(p); });
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

}  // namespace spineloft::document
