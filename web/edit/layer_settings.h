// What is set for a whole part made of layers: the line that its layers stand on, how often they stand there, how one
// becomes the next, and how its surface is. Panels preview and commands act through the same functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/document/document.h"

namespace spineloft::app {

/// Why something cannot be done to a part of layers, and what to do.
inline constexpr const char* kNoRail = "its layers stand on no rail: place each by itself";
inline constexpr const char* kRepeated = "its layers are repeated along their line: set Times to 1 first";

/// The farthest that a curve is from its plane's origin, picture pixels.
double reachOf(const document::StackRecipe& recipe);

/// Ready rails: straight up, straight across, straight away from the viewer, round and closed, and a spring of three
/// rounds about an upright axis.
enum class RailShape : std::uint8_t { Up, Across, Deep, Ring, Spring };
struct RailShapeName {
  RailShape shape;
  std::string_view key, label;
};
inline constexpr std::array kRailShapes = {
    RailShapeName{RailShape::Up, "up", "Up"}, RailShapeName{RailShape::Across, "across", "Across"},
    RailShapeName{RailShape::Deep, "deep", "Away"}, RailShapeName{RailShape::Ring, "ring", "Ring"},
    RailShapeName{RailShape::Spring, "spring", "Spring"}};
/// Which of them a rail is; none for another one.
std::optional<RailShape> railShapeOf(const stack::Rail& rail);
/// The layers on a ready rail about the middle of their own, as far apart as there is room; straight ones are as long
/// as the largest side of what they replace.
document::StackRecipe withRail(const document::StackRecipe& recipe, RailShape shape);
/// The layers at the same shares of another rail; on a closed one, or where they are repeated, as far apart as there is
/// room.
document::StackRecipe withRail(const document::StackRecipe& recipe, const stack::Rail& rail);
/// The same along a line that was drawn: the mean of their middles lies on it, wherever on the sheets they are.
document::StackRecipe withDrawnRail(const document::StackRecipe& recipe, const stack::Rail& rail);
/// On the rail through the middles of the layers, which stay where they are. Errors: those of stack::ontoCentres;
/// StackInvalid where layers are repeated.
Result<document::StackRecipe> withRailThroughMiddles(const document::StackRecipe& recipe);

inline constexpr int kMostRepeats = 20;  ///< on the page
/// How often all layers stand along the rail; none where they cannot be repeated (stack/run.h).
std::optional<std::uint32_t> repeatsOf(const document::StackRecipe& recipe);
/// Expects repeatsOf.
document::StackRecipe withRepeats(const document::StackRecipe& recipe, std::uint32_t times);

/// The blend between all layers; none where there are different ones.
std::optional<sections::BlendKind> blendOf(const document::StackRecipe& recipe);
document::StackRecipe withBlend(const document::StackRecipe& recipe, sections::BlendKind blend);

document::StackRecipe withBumps(const document::StackRecipe& recipe, const stack::Rough& rough);

/// What becomes of lines that stay open; none without one.
std::optional<stack::CurveUse> openLinesOf(const document::StackRecipe& recipe);
/// All of them become walls, `wall` picture pixels wide, or ground, filled down to the lowest line of the ground that
/// there is, or, where one goes below that, to one below all of them. What is so already stays as it is.
document::StackRecipe withOpenLines(const document::StackRecipe& recipe, stack::CurveUse use, double wall);

/// Width of the first wall, picture pixels; none without one.
std::optional<double> wallOf(const document::StackRecipe& recipe);
/// Gives all walls this width.
document::StackRecipe withWalls(const document::StackRecipe& recipe, double width);

}  // namespace spineloft::app
