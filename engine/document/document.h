// The document: only what a person authored. A few kilobytes without the pictures; a value that is
// compared, copied and kept in the history. Everything else is derived (pipeline/).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/box.h"
#include "engine/base/ids.h"
#include "engine/base/one_of.h"
#include "engine/base/result.h"
#include "engine/base/units.h"
#include "engine/base/vec.h"
#include "engine/bridge/bridge_params.h"
#include "engine/document/drawing.h"
#include "engine/document/look.h"
#include "engine/document/placement.h"
#include "engine/document/step.h"
#include "engine/extrude/extrude_params.h"
#include "engine/geometry/view.h"
#include "engine/image/image.h"
#include "engine/image/sketch.h"
#include "engine/inflate/inflate_params.h"
#include "engine/lathe/lathe_params.h"
#include "engine/loft/loft.h"
#include "engine/loft/pose.h"
#include "engine/pull/pull_params.h"
#include "engine/relief/relief_params.h"
#include "engine/ribs/base/rib_params.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/edit/edits.h"
#include "engine/shape/shape_params.h"
#include "engine/stack/stack_params.h"

namespace spineloft::document {

/// What a picture shows that is a side of another one.
struct PictureView {
  PictureId of;  ///< the one from the front, which is no side itself
  geometry::View view;
  bool operator==(const PictureView&) const = default;
};

/// A picture on the board: a photo whose pixels are immutable and shared by every document that shows
/// it, or a sketch that is drawn on blank paper (its pixels are derived, see pipeline::Derived). Two
/// entries with equal content hashes show equal pixels.
struct PictureEntry {
  PictureId id;
  std::string name;                               ///< file name or title, UTF-8
  image::Size size;                               ///< original pixels; what strokes and ribs are measured in
  std::shared_ptr<const image::Picture> picture;  ///< null for a sketch
  std::vector<Box<image::SketchStroke>> sketch;   ///< of a sketch, in order
  std::uint64_t contentHash = 0;
  std::vector<ribs::IgnoreMark> ignored;  ///< edges that count for no part
  std::optional<PictureView> view;        ///< none: it is the side of no other
  std::string extra;                      ///< what a file said beyond all this, as JSON; written back as it came
  bool isSketch() const { return picture == nullptr; }
  bool operator==(const PictureEntry& other) const {
    return id == other.id && name == other.name && size == other.size && contentHash == other.contentHash &&
           isSketch() == other.isSketch() && sketch == other.sketch && ignored == other.ignored && view == other.view &&
           extra == other.extra;
  }
};

/// The outline of a part as a picture shows it: one closed line, or two open ones (the two sides of a limb).
struct Outline {
  PictureId picture;                             ///< the part's own, or one that is a side of it
  std::vector<std::vector<PicturePoint>> lines;  ///< as drawn, pixels of that picture
  bool operator==(const Outline&) const = default;
};

/// Recipe of a part made by one stroke: the authored input of spine → ribs → edits → pose → loft.
struct LoftRecipe {
  PictureId picture;                 ///< on which the stroke was drawn
  std::vector<PicturePoint> stroke;  ///< as drawn
  ribs::SpineParams spine;
  ribs::RibParams ribs;
  ribs::RibEdits edits;
  std::vector<ribs::IgnoreMark> ignored;  ///< edges that do not count for this part
  loft::Pose pose;
  loft::LoftParams loft;
  std::optional<Outline> side;  ///< as seen from the right or the left: says the depth of each row (shape/side_fit.h)
  bool operator==(const LoftRecipe&) const = default;
};

/// A piece of a picture: what closed outlines enclose, by even-odd (an outline within another is a
/// hole), or what a pen of a width leaves along open lines.
struct Region {
  PictureId picture;                                ///< on which it was drawn
  std::vector<std::vector<PicturePoint>> contours;  ///< as drawn
  double ribbon = 0;  ///< picture pixels: the pen's width, contours are open lines; 0: closed outlines
  bool open = false;  ///< contours are open lines that an axis closes (LatheRecipe); others close them straight
  bool isOfLines() const { return ribbon > 0 || open; }
  bool operator==(const Region&) const = default;
};

/// Recipe of a part that is an inflated region.
struct InflateRecipe {
  Region region;
  inflate::InflateParams inflate;
  std::optional<Outline> side;  ///< as of a loft
  bool operator==(const InflateRecipe&) const = default;
};

/// Recipe of a flat piece: a region with thickness.
struct ExtrudeRecipe {
  Region region;
  extrude::ExtrudeParams extrude;
  bool operator==(const ExtrudeRecipe&) const = default;
};

/// Recipe of a spun part: a region turned about an axis.
struct LatheRecipe {
  Region region;
  lathe::LatheParams lathe;
  bool operator==(const LatheRecipe&) const = default;
};

/// Recipe of a part drawn slice by slice: curves on planes in space.
struct StackRecipe {
  PictureId picture;  ///< in whose space it stands, and which colours it
  std::vector<stack::Plane> planes;
  stack::Rail rail;
  stack::StackParams stack;
  bool operator==(const StackRecipe&) const = default;
};

/// Recipe of a shape: a primitive, and the outlines that reshape it.
struct ShapeRecipe {
  PictureId picture;  ///< from the front; in whose space it stands, and which colours it
  shape::ShapeParams shape;
  std::vector<Outline> outlines;  ///< at most one a picture, kMostOutlines
  bool operator==(const ShapeRecipe&) const = default;
};

/// Recipe of a piece of a line drawing: what closed outlines enclose, at the depth that the drawing gives it.
struct ElementRecipe {
  PictureId picture;  ///< that of the drawing
  DrawingId drawing;
  descriptive::PieceKind kind = descriptive::PieceKind::Round;
  std::vector<LineOutline> outlines;           ///< ≥ 1; by even-odd
  double stiffness = 1;                        ///< round: how much it stays in a plane
  double front = 1, back = 1;                  ///< round: its thickness to the viewer and away is multiplied by it
  double thickness = descriptive::kThickness;  ///< flat: a share of the picture's longer side
  bool operator==(const ElementRecipe&) const = default;
};

/// Where a bridge stands.
struct BridgeEnd {
  PartId part;                  ///< no bridge itself
  std::vector<ModelPoint> rim;  ///< a closed line on it, in its ModelSpace; where the part is another one than when it
                                ///< was drawn, the nearest places count
  bool operator==(const BridgeEnd&) const = default;
};

/// Recipe of a bridge: a tube from one part to another, or to the same one. It stands where they do; its placement is
/// at rest.
struct BridgeRecipe {
  PictureId picture;  ///< in whose space it stands
  BridgeEnd from, to;
  bridge::BridgeParams bridge;
  bool operator==(const BridgeRecipe&) const = default;
};

/// Every way of making a part. PartKind counts the alternatives in this order.
using AnyRecipe = std::variant<LoftRecipe, InflateRecipe, ExtrudeRecipe, LatheRecipe, StackRecipe, ShapeRecipe,
                               ElementRecipe, BridgeRecipe>;
enum class PartKind : std::uint8_t { Loft, Inflate, Extrude, Lathe, Stack, Shape, Element, Bridge, kCount };
static_assert(std::variant_size_v<AnyRecipe> == static_cast<std::size_t>(PartKind::kCount));
using Recipe = OneOf<AnyRecipe>;
bool operator==(const Recipe& a, const Recipe& b);

struct Part {
  PartId id;
  std::string name;  ///< UTF-8, at most kMaxNameBytes
  Recipe recipe;
  Look look;
  bool visible = true;
  Placement placement;
  std::optional<MirrorPlane> mirror;     ///< it shows a second time, mirrored over this plane
  GroupId group;                         ///< none: it stands alone
  std::vector<pull::Pull> pulls;         ///< what is done to its surface, in this order
  std::optional<relief::Relief> relief;  ///< and then: detail on its front
  std::string extra;                     ///< as PictureEntry::extra
  bool operator==(const Part&) const = default;
};

/// Parts that are taken in hand together. It has at least one part; Part::group says which.
struct Group {
  GroupId id;
  std::string name;  ///< UTF-8, at most kMaxNameBytes
  bool operator==(const Group&) const = default;
};

struct Document {
  std::string name = "Model";
  std::vector<Box<PictureEntry>> pictures;  ///< in the order they were added
  std::vector<Box<Drawing>> drawings;       ///< line drawings, in the order they were begun
  std::vector<Box<Part>> parts;             ///< in the order of the part list
  std::vector<Box<Step>> steps;             ///< solids made from them: a forest (step.h)
  std::vector<Group> groups;                ///< in the order they were made
  Millimetres height{100};                  ///< "How tall?": of the whole model when exported
  /// Ids are never reused.
  std::uint32_t lastPictureId = 0, lastPartId = 0, lastStepId = 0, lastGroupId = 0, lastDrawingId = 0;
  std::string extra;  ///< as PictureEntry::extra
  bool operator==(const Document&) const = default;
};

inline PartKind kindOf(const Recipe& recipe) { return static_cast<PartKind>(recipe.index()); }
inline PartKind kindOf(const Part& part) { return kindOf(part.recipe); }
/// "loft", "puff", "sheet", "lathe", "stack", "shape", "element", "bridge": in files and in the API.
std::string_view kindKey(PartKind kind);
/// Error: none of them: kCount.
PartKind kindFromKey(std::string_view key);
/// A recipe of this kind with nothing drawn yet.
Recipe emptyRecipe(PartKind kind);

/// The recipe of this kind, or null.
inline const LoftRecipe* loftOf(const Part& part) { return std::get_if<LoftRecipe>(&part.recipe); }
inline LoftRecipe* loftOf(Part& part) { return std::get_if<LoftRecipe>(&part.recipe); }
inline const InflateRecipe* inflateOf(const Part& part) { return std::get_if<InflateRecipe>(&part.recipe); }
inline InflateRecipe* inflateOf(Part& part) { return std::get_if<InflateRecipe>(&part.recipe); }
inline const ExtrudeRecipe* extrudeOf(const Part& part) { return std::get_if<ExtrudeRecipe>(&part.recipe); }
inline ExtrudeRecipe* extrudeOf(Part& part) { return std::get_if<ExtrudeRecipe>(&part.recipe); }
inline const LatheRecipe* latheOf(const Part& part) { return std::get_if<LatheRecipe>(&part.recipe); }
inline const StackRecipe* stackOf(const Part& part) { return std::get_if<StackRecipe>(&part.recipe); }
inline StackRecipe* stackOf(Part& part) { return std::get_if<StackRecipe>(&part.recipe); }
inline const ShapeRecipe* shapeOf(const Part& part) { return std::get_if<ShapeRecipe>(&part.recipe); }
inline ShapeRecipe* shapeOf(Part& part) { return std::get_if<ShapeRecipe>(&part.recipe); }
inline const ElementRecipe* elementOf(const Part& part) { return std::get_if<ElementRecipe>(&part.recipe); }
inline ElementRecipe* elementOf(Part& part) { return std::get_if<ElementRecipe>(&part.recipe); }
inline const BridgeRecipe* bridgeOf(const Part& part) { return std::get_if<BridgeRecipe>(&part.recipe); }
inline BridgeRecipe* bridgeOf(Part& part) { return std::get_if<BridgeRecipe>(&part.recipe); }
/// The loft that a part is, or an empty one for other kinds: for what is only looked at.
const LoftRecipe& loftIn(const Part& part);
/// The region of what is made of one, or null.
const Region* regionOf(const Recipe& recipe);
Region* regionOf(Recipe& recipe);

/// The side outline of what may have one (lofts and puffs), or null.
const std::optional<Outline>* sideOf(const Recipe& recipe);
std::optional<Outline>* sideOf(Recipe& recipe);
/// All outlines that a recipe has in views: those of a shape, the side of a loft or a puff.
std::vector<const Outline*> outlinesOf(const Recipe& recipe);
std::vector<Outline*> outlinesOf(Recipe& recipe);

/// The picture on which it was drawn.
PictureId pictureOf(const Recipe& recipe);
inline PictureId pictureOf(const Part& part) { return pictureOf(part.recipe); }
void setPicture(Recipe& recipe, PictureId picture);

inline constexpr std::size_t kMostContours = 500, kMostRegionPoints = 100000;
inline constexpr std::size_t kMostOutlines = 4, kMostOutlinePoints = 20000;  ///< of a part; of one outline
inline constexpr double kLeastRibbon = 0.5, kMostRibbon = 2000;              ///< picture pixels

inline constexpr std::size_t kMaxNameBytes = 200;
inline constexpr std::size_t kMostParts = 5000, kMostPictures = 500;
inline constexpr double kMinHeightMm = 1, kMaxHeightMm = 10000;

/// The entry, or null.
const PictureEntry* findPicture(const Document& document, PictureId id);
const Part* findPart(const Document& document, PartId id);
const Drawing* findDrawing(const Document& document, DrawingId id);
const Group* findGroup(const Document& document, GroupId id);
/// The bridges that stand on a part, in the order of the list.
std::vector<PartId> bridgesOn(const Document& document, PartId id);
/// In the order of the list.
std::vector<PartId> partsOfGroup(const Document& document, GroupId id);

/// Bytes of memory that `next` holds and `base` does not: values in boxes that both share, and photos
/// that both show, cost nothing. What a step of undo costs (History).
std::size_t bytesBeyond(const Document& base, const Document& next);

/// How a picture shows what stands on another one: none where they are the same, and from the front. Error: ViewInvalid
/// (it is no side of the other one).
Result<std::optional<geometry::View>> viewOn(const Document& document, PictureId picture, PictureId front);

/// Hash of a picture's pixels and sizes, as PictureEntry::contentHash holds it.
std::uint64_t contentHash(const image::Picture& picture);
/// The same of a sketch, from its strokes.
std::uint64_t contentHash(image::Size size, std::span<const Box<image::SketchStroke>> sketch);

}  // namespace spineloft::document

extern template struct spineloft::OneOf<spineloft::document::AnyRecipe>;
