// Sections along a spine.
#pragma once

#include <cstddef>
#include <span>

#include "engine/base/result.h"
#include "engine/sections/blend.h"
#include "engine/sections/section.h"

namespace spineloft::loft {

/// A section somewhere along the spine. Before the first and after the last key the section stays
/// as it is; one key alone is the section of the whole part.
struct SectionKey {
  double at = 0.5;  ///< share of the spine's length, 0…1
  sections::SectionShape shape;
  sections::Blend blend;  ///< from here to the next key
  bool operator==(const SectionKey&) const = default;
};
inline constexpr std::size_t kMostSectionKeys = 32;

/// 1…kMostSectionKeys keys in order, at least geometry::kLeastStep apart, all with the same number of
/// outer curves and holes. Errors: SectionInvalid, ValueOutOfRange.
Status checkSectionKeys(std::span<const SectionKey> keys);

/// The section at a share of the spine's length, as a loft along keys that pass checkSectionKeys has it there. Error:
/// SectionInvalid.
Result<sections::SectionShape> sectionAt(std::span<const SectionKey> keys, double at);

}  // namespace spineloft::loft
