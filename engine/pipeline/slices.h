// The slices of one part in the terms of others: along a bone, where ribs give them a size, and on a rail, of true
// size.
#pragma once

#include <vector>

#include "engine/document/document.h"

namespace spineloft::pipeline {

struct PartShape;

/// Places are shares of the length of bone or rail.
struct Slices {
  Result<std::vector<loft::SectionKey>> onBone;  ///< that a loft may have (loft::checkSectionKeys), or why not
  std::vector<stack::Plane> onRail;
  std::vector<stack::Pattern> patterns;  ///< of `onRail`
  stack::Rail rail;                      ///< the bone in its pose, or the rail: where `onRail` is as the part was
};

/// Of a loft and its shape: its sections along a bone; and on a rail sections of the width, depth and twist that it has
/// there, so many that straight lines between them stay within kSliceTolerance of its largest half width, but about
/// kMostCopied at most. Tilt is left out. Errors: TooFewRibs, SectionInvalid.
Result<Slices> slicesOf(const document::LoftRecipe& recipe, const PartShape& shape);
inline constexpr double kSliceTolerance = 0.02;
inline constexpr std::size_t kMostCopied = 24;

/// Of a part made of layers: its planes, or, where some of them are off the rail, those on the rail through their
/// centres (stack::ontoCentres); and the outlines on them as sections, of more than loft::kMostSectionKeys as many,
/// spread evenly; patterns are not repeated along a bone. Errors: those of ontoCentres; StackInvalid (layers that are
/// repeated while others are off the rail).
Result<Slices> slicesOf(const document::StackRecipe& recipe);

}  // namespace spineloft::pipeline
