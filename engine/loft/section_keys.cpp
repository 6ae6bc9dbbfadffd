#include <algorithm>
#include <cmath>

#include "engine/loft/section_key.h"
#include "engine/sections/contour.h"

namespace spineloft::loft {
namespace {

/// How many holes each outer curve has, in order of size: equal for shapes that can become each other.
std::vector<int> makeUp(const std::vector<sections::SectionPiece>& pieces) {
  std::vector<int> holes(pieces.size(), 0), outers;
  for (const sections::SectionPiece& piece : pieces) {
    if (piece.hole) ++holes[piece.outer];
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].hole) outers.push_back(holes[i]);
  }
  std::ranges::sort(outers);
  return outers;
}

}  // namespace

Status checkSectionKeys(std::span<const SectionKey> keys) {
  if (keys.empty() || keys.size() > kMostSectionKeys) return {Error::ValueOutOfRange, "slices"};
  double before = -1;
  std::vector<int> first;
  for (const SectionKey& key : keys) {
    if (!(key.at >= 0 && key.at <= 1)) return {Error::ValueOutOfRange, "place of a slice"};
    if (before >= 0 && key.at - before < geometry::kLeastStep) {
      return {Error::ValueOutOfRange, "slices too close"};
    }
    if (!isValid(key.blend)) return {Error::ValueOutOfRange, "blend"};
    if (key.shape.preset >= sections::SectionPreset::kCount) return {Error::ValueOutOfRange, "slice"};
    if (keys.size() == 1 && !key.shape.drawn()) break;  // nothing that it could disagree with
    std::vector<int> pieces = {0};
    if (key.shape.drawn()) {
      const Result<std::vector<sections::SectionPiece>> read = sections::readShape(key.shape);
      if (!read) return read.failure();
      pieces = makeUp(read.value());
    }
    if (before >= 0 && pieces != first) {
      return {Error::SectionInvalid, "all slices of one part need the same number of pieces and holes"};
    }
    if (before < 0) first = std::move(pieces);
    before = key.at;
  }
  return Done{};
}

}  // namespace spineloft::loft
