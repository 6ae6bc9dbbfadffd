// Everything a person can do to a document, as values. Each is a verb of intent.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/one_of.h"
#include "engine/document/document.h"

namespace spineloft::document {

/// Puts a picture on the board.
struct AddPicture {
  std::string name;
  std::shared_ptr<const image::Picture> picture;
};
/// Blank paper to draw on.
struct AddSketch {
  std::string name;
  image::Size size{1024, 768};
};
/// One more stroke on a sketch.
struct DrawOnSketch {
  PictureId picture;
  image::SketchStroke stroke;
};
struct RenamePicture {
  PictureId picture;
  std::string name;
};
/// Takes a picture and the parts drawn on it away.
struct RemovePicture {
  PictureId picture;
};
/// A new part from one stroke (picture pixels of `picture`).
struct DrawSpine {
  PictureId picture;
  std::vector<PicturePoint> stroke;
  sections::SectionShape section = {};
  sections::CapStyle startCap = sections::CapStyle::Round, endCap = sections::CapStyle::Round;
  Look look = {};
  geometry::AlongCurve depth = {};  ///< of the spine, from a pen's pressure; see loft::Pose
};
/// A new stroke for an existing part, on which its ribs are looked for again: drawn, moved, bent,
/// extended. Everything else about the part stays, edits at their places along the spine too.
struct RedrawSpine {
  PartId part;
  std::vector<PicturePoint> stroke;
};
/// The ribs as they are on another line, in depth, coiled or joined to a ring; a default pose puts the
/// part back where it was traced.
struct PoseSpine {
  PartId part;
  loft::Pose pose;
};
/// What was changed about the ribs by hand, as a whole (made by edit_gestures of engine/ribs).
struct EditRibs {
  PartId part;
  ribs::RibEdits edits;
};
/// The scribbles over edges that do not count for this part.
struct IgnoreForPart {
  PartId part;
  std::vector<ribs::IgnoreMark> marks;
};
/// The same for every part of a picture.
struct IgnoreForPicture {
  PictureId picture;
  std::vector<ribs::IgnoreMark> marks;
};
/// What a region becomes, and how.
using RegionSolid = std::variant<inflate::InflateParams, extrude::ExtrudeParams, lathe::LatheParams>;
/// The recipe of it.
Recipe recipeOf(const Region& region, const RegionSolid& solid);
/// A new part from a region.
struct DrawRegion {
  Region region;
  RegionSolid solid;
  Look look = {};
};
/// Another region for a part that is made of one: drawn anew, or with points moved.
struct RedrawRegion {
  PartId part;
  Region region;
};
/// How a part is made of its region; parameters of another kind make it that kind. A puff that stays one keeps its side
/// outline.
struct ShapeRegion {
  PartId part;
  RegionSolid solid;
};
/// A part made of a region in place of what it was; name, look, place, pulls and relief stay.
struct RemakePart {
  PartId part;
  Region region;
  RegionSolid solid;
};
/// A new part drawn slice by slice.
struct DrawStack {
  PictureId picture;
  std::vector<stack::Plane> planes;
  stack::Rail rail = {};
  stack::StackParams stack = {};
  Look look = {};
};
/// The planes of such a part, as a whole.
struct SetPlanes {
  PartId part;
  std::vector<stack::Plane> planes;
};
/// The line that its planes stand on.
struct SetRail {
  PartId part;
  stack::Rail rail;
};
/// How it is finished.
struct ShapeStack {
  PartId part;
  stack::StackParams stack;
};
/// A new shape, reshaped by outlines where there are any.
struct DrawShape {
  PictureId picture;
  shape::ShapeParams shape = {};
  std::vector<Outline> outlines = {};
  Look look = {};
};
/// How a shape is made, but for its outlines.
struct SetShape {
  PartId part;
  shape::ShapeParams shape;
};
/// The outlines of a shape, as a whole.
struct SetOutlines {
  PartId part;
  std::vector<Outline> outlines;
};
/// The side outline of a loft or a puff; none: its depth is its own again.
struct SetSide {
  PartId part;
  std::optional<Outline> side;
};
/// A new bridge between two places of parts.
struct DrawBridge {
  BridgeEnd from, to;
  bridge::BridgeParams bridge = {};
  Look look = {};
};
/// Where a bridge stands.
struct SetBridgeEnds {
  PartId part;
  BridgeEnd from, to;
};
/// A picture becomes the side of another one, or of none; outlines that thereby are in no view of their part go.
struct SetView {
  PictureId picture;
  std::optional<PictureView> view;
};
/// One more line of the line drawing on a picture, which begins with its first line. What it closes becomes a piece.
struct DrawLine {
  PictureId picture;
  std::vector<PicturePoint> points;
  std::vector<descriptive::Stretch> hidden = {};
  bool closed = false;
  Look look = {};  ///< of a new piece
};
/// The last point of a line is joined to its first.
struct CloseLine {
  DrawingId drawing;
  LineId line;
  Look look = {};  ///< of a new piece
};
/// Where a line is hidden, as a whole.
struct HideLine {
  DrawingId drawing;
  LineId line;
  std::vector<descriptive::Stretch> hidden;
};
/// Outlines that it was part of close without it; a piece that has no other line of its own goes.
struct DeleteLine {
  DrawingId drawing;
  LineId line;
};
/// Of two pieces that overlap at a place, who is in front there.
struct OrderPieces {
  PartId over, under;
  PicturePoint at;
};
/// The depth of a place on a line; none: it is not given any more.
struct PinDepth {
  DrawingId drawing;
  LineId line;
  double at = 0;            ///< share of the line's length
  std::optional<double> z;  ///< picture pixels
};
/// From where things with right angles are seen in a drawing.
struct SeeDrawing {
  DrawingId drawing;
  descriptive::SeenFrom from = descriptive::SeenFrom::Above;
};
/// What a piece is made of its outlines.
struct ShapePiece {
  PartId part;
  descriptive::PieceKind kind = descriptive::PieceKind::Round;
};
/// One section for the whole part.
struct SetSection {
  PartId part;
  sections::SectionShape section = {};
};
/// Several sections along the spine.
struct SetSections {
  PartId part;
  std::vector<loft::SectionKey> sections;
};
enum class AlongKind : std::uint8_t { Twist, Squash, Tilt, Bulge, kCount };
/// One of the curves of loft::LoftParams.
struct SetAlong {
  PartId part;
  AlongKind kind = AlongKind::Twist;
  geometry::AlongCurve curve;
};
struct SetCaps {
  PartId part;
  sections::CapStyle start = sections::CapStyle::Round, end = sections::CapStyle::Round;
};
struct SetLook {
  PartId part;
  Look look = {};
};
/// All pulls of a part.
struct SetPulls {
  PartId part;
  std::vector<pull::Pull> pulls;
};
/// The relief of a part; none: without.
struct SetRelief {
  PartId part;
  std::optional<relief::Relief> relief = {};
};
/// One entry of the parameter table (params.h).
struct SetParameter {
  PartId part;
  std::string key;
  double value = 0;
};
struct RenamePart {
  PartId part;
  std::string name;
};
struct ShowPart {
  PartId part;
  bool visible = true;
};
/// A part goes, and the bridges that stand on it.
struct DeletePart {
  PartId part;
};
/// Where parts stand, all at once. The same placement as before is no error.
struct PlaceParts {
  struct One {
    PartId part;
    Placement placement = {};
    std::optional<MirrorPlane> mirror = {};  ///< live symmetry: it shows a second time beyond this plane
  };
  std::vector<One> parts;
};
/// Copies that stand right behind their originals in the list, moved by `by`; with `over` mirrored
/// copies. The copies of a whole group are a new group, those of all parts of a solid a solid like it.
struct DuplicateParts {
  std::vector<PartId> parts;
  WorldPoint by = {};
  std::optional<MirrorPlane> over = {};
};
/// Makes one group of parts, behind the first of them in the list. Those of other groups leave them.
struct GroupParts {
  std::vector<PartId> parts;
  std::string name;
};
/// Its parts stand alone again, where they are.
struct Ungroup {
  GroupId group;
};
struct RenameGroup {
  GroupId group;
  std::string name;
};
/// Moves parts, in their order, before another one in the list, or to its end. A single part that
/// comes to lie between two parts of a group joins it; one that leaves its group's neighbourhood
/// leaves the group.
struct MoveInList {
  std::vector<PartId> parts;
  PartId before;  ///< none: the end
};
struct SetHeight {
  Millimetres height;
};
struct RenameDocument {
  std::string name;
};

/// A new solid from parts and solids. Operands that stand in the same step come out of it, and the new
/// solid takes the place of the first; those that stand in different ones are refused (AlreadyUsed).
struct CombineParts {
  StepKind kind = StepKind::Join;
  std::vector<Operand> operands;
  double wall = Step{}.wall;
  Opening opening;
};
/// Kind and measures of a solid; operands, name and look are not looked at.
struct SetStep {
  StepId step;
  StepKind kind = StepKind::Join;
  double blend = 0, wall = Step{}.wall;
  Opening opening;
};
/// The same operands in another order.
struct OrderOperands {
  StepId step;
  std::vector<Operand> operands;
};
/// Breaks a solid apart: what it is made of takes its place.
struct ReleaseStep {
  StepId step;
};
/// Takes a solid and every part in it away.
struct DeleteStep {
  StepId step;
};
struct RenameStep {
  StepId step;
  std::string name;
};
struct ShowStep {
  StepId step;
  bool visible = true;
};
/// `own`: everywhere, else every face looks as the part it comes from.
struct SetStepLook {
  StepId step;
  bool own = false;
  Look look = {};
};

using AnyAction =
    std::variant<AddPicture, RemovePicture, DrawSpine, RedrawSpine, SetSection, SetCaps, SetLook, SetParameter,
                 RenamePart, ShowPart, DeletePart, SetHeight, RenameDocument, PoseSpine, EditRibs, IgnoreForPart,
                 IgnoreForPicture, SetSections, SetAlong, AddSketch, DrawOnSketch, RenamePicture, CombineParts, SetStep,
                 OrderOperands, ReleaseStep, DeleteStep, RenameStep, ShowStep, SetStepLook, DrawRegion, RedrawRegion,
                 ShapeRegion, RemakePart, PlaceParts, DuplicateParts, GroupParts, Ungroup, RenameGroup, MoveInList,
                 DrawStack, SetPlanes, SetRail, ShapeStack, DrawShape, SetShape, SetOutlines, SetView, DrawLine,
                 CloseLine, HideLine, DeleteLine, OrderPieces, PinDepth, SeeDrawing, ShapePiece, SetSide, SetPulls,
                 SetRelief, DrawBridge, SetBridgeEnds>;
using Action = OneOf<AnyAction>;

}  // namespace spineloft::document

extern template struct spineloft::OneOf<spineloft::document::AnyAction>;
