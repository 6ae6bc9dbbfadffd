#include "engine/document/update_parts.h"

#include <algorithm>
#include <utility>

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
  takeOut(document, {id, {}});
  std::erase_if(document.parts, [&](const Part& part) { return part.id == id; });
}

Status roomForPart(const Document& document) {
  if (document.parts.size() < kMostParts) return Done{};
  return {Error::ValueOutOfRange, "too many parts"};
}

}  // namespace spineloft::document
