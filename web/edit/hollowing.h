// What *Scoop out* shows before it does it: what becomes hollow, and where it opens.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/command_env.h"

namespace spineloft::app {

/// Parts and solids that stand alone, can be seen and are not hollow. The likeliest comes first: the chosen solid or
/// the part that the visitor chose, not one that is in hand because it was just drawn; then the largest volume.
/// Cost: O(triangles).
std::vector<document::Operand> hollowable(const CommandEnv& env);

/// A hollow of `what` as it is offered: the usual wall, open at the side that looks up, and wide there.
document::CombineParts hollowOf(const CommandEnv& env, document::Operand what);

/// The side of what `draft` makes hollow that looks most in this direction (WorldSpace, any length).
document::OpeningSide sideOf(const CommandEnv& env, const document::CombineParts& draft, const WorldPoint& direction);

/// How much to cut off at the opening of `draft`, as document::Opening has it: nothing at an end that is flat; of a
/// round one so much that the opening is wide. Cost: O(triangles).
double usualDepth(const CommandEnv& env, const document::CombineParts& draft);

/// Whether the part is in what is shown to become hollow.
bool becomesHollow(const document::Document& document, const UiState& ui, PartId part);

/// Where a hollow solid opens, WorldSpace.
struct Mouth {
  WorldPoint at;   ///< the middle of the rim's longest closed curve: not between two peaks, or a part and its twin
  WorldPoint out;  ///< unit, away from the solid
  /// The curve in which the surface meets the plane of the opening, as line segments in no order. The plane is as far
  /// below the outermost point as is cut off there, at least the wall.
  std::vector<std::array<WorldPoint, 2>> rim;
};
/// None: it stays closed, or something in it has no shape. Cost: O(triangles).
std::optional<Mouth> mouthOf(const document::Document& document, const pipeline::Derived& derived,
                             const document::CombineParts& draft);

/// The mouth that is shown, found again only when something that it depends on has changed.
class ShownMouth {
 public:
  const std::optional<Mouth>& of(const document::Document& document, const pipeline::Derived& derived,
                                 const document::CombineParts& draft);

 private:
  std::uint64_t key_ = 0;
  std::optional<Mouth> mouth_;
};

}  // namespace spineloft::app
