// Steps: solids made from parts and from other solids. They form a forest: every part and every step is
// an operand of at most one step, which shows in its place.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/result.h"
#include "engine/document/look.h"

namespace spineloft::document {

struct Document;

enum class StepKind : std::uint8_t {
  Join,          ///< all operands as one solid
  Cut,           ///< the first without the others
  Intersection,  ///< what all share
  Hollow,        ///< one operand as a shell with an opening
  kCount
};

/// A part or a step: exactly one of the two ids is set.
struct Operand {
  PartId part;
  StepId step;
  bool operator==(const Operand&) const = default;
};

/// Where a hollow solid is open: nowhere, at an end of the spine of its first loft, or at the side of the
/// world that it turns there.
enum class OpeningSide : std::uint8_t { None, Start, End, Up, Down, Left, Right, Front, Back, kCount };
struct Opening {
  OpeningSide side = OpeningSide::Up;
  double depth = 0;  ///< how much is cut off there, as a share of the solid's length that way, 0…kMostOpening
  bool operator==(const Opening&) const = default;
};

struct Step {
  StepId id;
  std::string name;  ///< UTF-8, at most kMaxNameBytes
  StepKind kind = StepKind::Join;
  std::vector<Operand> operands;  ///< Hollow: one; else at least two
  double blend = 0;               ///< radius at the seams of Join and Cut, WorldSpace, 0…kMostBlend; 0: sharp
  double wall = 0.02;             ///< thickness of Hollow, WorldSpace, kLeastWall…kMostWall
  Opening opening;
  bool ownLook = false;  ///< `look` everywhere, else every face looks as the part it comes from
  Look look;
  bool visible = true;
  std::string extra;  ///< as PictureEntry::extra
  bool operator==(const Step&) const = default;
};

inline constexpr std::size_t kMostSteps = 2000, kMostOperands = 200;
inline constexpr double kLeastWall = 0.002, kMostWall = 0.5, kMostBlend = 0.2, kMostOpening = 0.9;

/// Operands that a step of this kind has at least and at most.
std::size_t leastOperands(StepKind kind);
std::size_t mostOperands(StepKind kind);
/// "join", "cut", "common", "hollow"; "none", "start", "end", "up" …
std::string_view stepKindKey(StepKind kind);
std::string_view openingKey(OpeningSide side);

/// The step, or null.
const Step* findStep(const Document& document, StepId id);
/// The step that has it as operand, or null.
const Step* holderOf(const Document& document, Operand operand);
/// The outermost step that it is in, or null.
const Step* rootOf(const Document& document, Operand operand);
/// All parts in it, in order, its own id for a part.
std::vector<PartId> partsIn(const Document& document, Operand operand);

/// Numbers in range, kinds known, as many operands as the kind wants, each naming one thing, none twice.
/// Whether they exist is the forest's business. Error: ValueOutOfRange.
Status checkStep(const Step& step);
/// Operands exist, none has two holders, no step is inside itself.
bool isForest(const Document& document);
/// Takes out what keeps the steps from being a forest of sound steps; how much.
std::size_t mendForest(Document& document);
/// Takes an operand out of its holder. A step with too few operands left dissolves: what it has left
/// takes its place.
void takeOut(Document& document, Operand operand);
/// The step goes; its operands take its place, or stand alone.
void dissolve(Document& document, StepId id);

}  // namespace spineloft::document
