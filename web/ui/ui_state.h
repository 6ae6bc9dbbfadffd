// Everything transient: what is selected, where the views look, what the pen is drawing. Never
// saved, never undone.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/geometry/turn.h"
#include "engine/pipeline/derive.h"
#include "engine/ribs/edit/edit_gestures.h"
#include "web/model/cut_draft.h"
#include "web/model/print_report.h"
#include "web/platform/page.h"
#include "web/ui/layout.h"
#include "web/ui/reusable.h"
#include "web/ui/section_ui.h"
#include "web/ui/sizing.h"
#include "web/ui/sketching.h"
#include "web/ui/views.h"

namespace spineloft::app {

class Outcome;
struct CommandEnv;
/// What the answer to a question does, by the question's id.
using Answers = std::map<std::string, std::function<Outcome(const CommandEnv&, const std::string&)>, std::less<>>;

enum class ToolKind : std::uint8_t {
  Draw,       ///< a new part, or a new line for one
  Hand,       ///< moves the picture
  Ribs,       ///< drags rib ends, adds, deletes, locks ribs
  Shape,      ///< a line that nearby rib ends grow or shrink to
  Spine,      ///< moves, bends and extends the spine; a new stroke reposes; of a puff it edits the bones
  Ignore,     ///< scribbles over edges that do not count
  Inflate,    ///< a line round a thing: it swells
  Extrude,    ///< the same: a flat piece
  Pen,        ///< draws on a sketch
  Eraser,     ///< paper again
  Place,      ///< moves, turns and scales parts in the solid view
  Spin,       ///< a line beside an axis: it is turned about it
  Layers,     ///< closed lines on a sheet in the solid view, one above the other
  Primitive,  ///< shapes: from one end of the axis to the other; their handles and outlines
  Lines,      ///< lines of a line drawing, seen and hidden: what they close becomes a piece
  Pull,       ///< lines on the solid, which move its surface out or in
  Bridge,     ///< from a place of the solid to another: a tube joins them
  kCount
};
/// "draw", "hand", "ribs", "shape", "bone", "ignore", "puff", "sheet", "pen", "eraser", "move", "spin",
/// "layers", "shapes", "lines", "pull", "bridge".
std::string_view toolKey(ToolKind tool);
/// What it draws is a part that is made of a region.
constexpr bool drawsRegions(ToolKind tool) {
  return tool == ToolKind::Inflate || tool == ToolKind::Extrude || tool == ToolKind::Spin;
}
/// It is used in the solid view.
constexpr bool worksInSolid(ToolKind tool) {
  return tool == ToolKind::Place || tool == ToolKind::Layers || tool == ToolKind::Pull || tool == ToolKind::Bridge;
}
/// It can cut a thing out of the picture.
constexpr bool cutsOut(ToolKind tool) { return tool == ToolKind::Inflate || tool == ToolKind::Extrude; }
enum class Focus : std::uint8_t { Picture, Solid };
/// The bar whose menu is open: see panels/bar_menu.h.
enum class BarMenu : std::uint8_t { None, Picture, Solid, Edit, Board };
enum class PanelTab : std::uint8_t { Parts, Section, Along, Ends, Look, Relief, Size, Place };

/// A part in the making: what it would become if the gesture in hand ended now. Whoever leads the
/// gesture changes `recipe` and sets `fresh` to false; the page derives the shape as often as time
/// allows, and both views show it in place of the part. See preview.h.
struct Preview {
  document::Recipe recipe;
  std::vector<pull::Pull> pulls;
  std::optional<relief::Relief> relief;
  PartId part;  ///< the one that it replaces on the screen; none: a new part
  document::Look look;
  bool fresh = false;                   ///< `shape` is of this very recipe
  Reusable<pipeline::PartShape> shape;  ///< the last one that could be made
  std::uint64_t revision = 0;           ///< of `shape`; none other had it
  double costMs = 0;                    ///< what the last shape took
  double nextMs = 0;                    ///< not before this time is the next one made
  /// When the exact shape is made if the pointer rests until then; none: the shape is exact.
  std::optional<double> exactMs;
  bool guarded = false;                ///< a shape that goes through itself is not taken
  std::optional<ModelPoint> crossing;  ///< where the one that was asked for last does
  document::Recipe taken;              ///< while guarded: of `shape`
  std::vector<double> pressure;        ///< of the pen, one a point of a stroke that is being drawn
  bool settled() const { return fresh && !exactMs; }
  /// Makes `recipe` a loft where it is none: for gestures of lofts.
  document::LoftRecipe& asLoft() {
    auto* loft = std::get_if<document::LoftRecipe>(&recipe);
    return loft ? *loft : recipe.emplace<document::LoftRecipe>();
  }
  /// The loft that `recipe` is; an empty one where it is none.
  const document::LoftRecipe& loft() const {
    static const document::LoftRecipe kNone;
    const auto* loft = std::get_if<document::LoftRecipe>(&recipe);
    return loft ? *loft : kNone;
  }
};

/// Where the strip of pictures shows a small copy of one.
struct Thumbnail {
  PictureId picture;
  Rect at;
};

/// What the panels show on the canvas: something that can be pressed, or words that lie above a view.
struct Control {
  /// Rib: an end of a rib, for screen readers only; its id is twice its rib, and one more on the right.
  enum class Kind : std::uint8_t { Button, Row, Grip, Field, Slider, Section, Tab, Words, Rib };
  Kind kind = Kind::Button;
  std::string words;  ///< as it says, or what it does
  Rect at;
  bool inSight = true;  ///< nothing of the panel that it is in hides its middle
  bool enabled = true, on = false;
  std::uint32_t id = 0;           ///< Dear ImGui's, by which it is pressed without a pointer; 0: words
  std::string_view command = {};  ///< of the table, which it runs; empty: none
  /// Of a slider, in the unit that it shows.
  struct Slide {
    double low = 0, high = 1, value = 0;
    std::string text;  ///< the value as it is read out
    bool operator==(const Slide&) const = default;
  };
  std::optional<Slide> slide = {};
  bool operator==(const Control&) const = default;
};

/// A control that is worked without a pointer, by its id.
struct AskedControl {
  std::uint32_t id = 0;
  std::optional<double> value = {};  ///< that a slider is to have; none: it is pressed
  int frames = 6;                    ///< that are left to bring it into sight
};
/// "button", "row", "grip", "field", "slider", "section", "tab", "words", "rib".
std::string_view controlKey(Control::Kind kind);

/// A point of the region of a part, as drawn.
struct OutlinePoint {
  std::size_t contour = 0, point = 0;
  bool operator==(const OutlinePoint&) const = default;
};

/// Handles of the gizmo that places parts, see web/edit/gizmo.h.
enum class GizmoHandle : std::uint8_t {
  None,
  MoveX,
  MoveY,
  MoveZ,  ///< arrows along the world's axes
  TurnX,
  TurnY,
  TurnZ,  ///< rings about them
  Plane,  ///< in the plane of the view
  Depth,  ///< away from the eye and back
  Scale,
};

/// What is under the pointer of the sheet for layers.
enum class SheetHold : std::uint8_t {
  Nothing,
  Knob,
  Lean,  ///< a knob that leans it
  Sheet,
  Rail,  ///< a line drawn from here is the rail
  Link,  ///< the mark of two curves that become each other, or might
  Fork,  ///< the knob of a fork
};

/// What lies under the pointer: lit in the views, and what a press would act on.
struct Hover {
  PartId part;                      ///< in either view
  std::optional<ribs::EndRef> end;  ///< of the selected part
  int other = -1;                   ///< one of the other places of the lit end
  int handle = -1;                  ///< of the spine of the selected part
  bool spine = false;               ///< its spine, beside the handles
  int depth = -1;                   ///< in the solid view a handle of its depth, or of depthDots
  int mark = -1;                    ///< a scribble (see marksOf)
  GizmoHandle gizmo = GizmoHandle::None;
  std::optional<OutlinePoint> outline;  ///< of the selected part that is made of a region
  SheetHold sheet = SheetHold::Nothing;
  int joint = -1;                    ///< which link, fork (see jointsOf) or way to lean (kLeans) that is
  int bone = -1;                     ///< of boneHandles of the selected puff
  int axis = -1;                     ///< an end of the axis that is shown, 0 or 1
  int shape = -1;                    ///< of shapeHandles of the shape in hand
  bool outlineOfShape = false;       ///< a line from here redraws its outline
  int crossing = -1;                 ///< of crossingsOn: where a tap swaps two pieces of a line drawing
  int looseEnd = -1;                 ///< of looseEndsOn: where a tap closes a line
  int pull = -1;                     ///< of the pulls of the part in hand: its knob
  int rim = -1;                      ///< an end of the bridge in hand, 0 or 1: its knob
  std::optional<double> along;       ///< a place of the selected part's spine: at it, or in a graph
  std::optional<ClientPoint> brush;  ///< where an eraser or a scribble would begin
  bool operator==(const Hover&) const = default;
};

/// What arrows move and what commands about ribs mean, of the selected part.
struct Chosen {
  std::optional<ribs::EndRef> end;
  int handle = -1;
  std::optional<OutlinePoint> outline = {};  ///< of what is made of a region
  int bone = -1;                             ///< of boneHandles of a puff
  int shape = -1;                            ///< of shapeHandles of a shape
  int crossing = -1;                         ///< of crossingsOn
  int pull = -1;                             ///< of the pulls of the part
  bool operator==(const Chosen&) const = default;
};

/// What the gesture in hand draws and reaches; empty between gestures.
struct InHand {
  std::vector<PicturePoint> stroke;       ///< picture pixels
  double radius = 0;                      ///< of a brush, picture pixels; 0: a thin line
  std::vector<ModelPoint> onSolid;        ///< a line on the surface of the part in hand
  std::vector<ClientPoint> besideSolid;   ///< a line for its outline as it is seen, CSS pixels of the canvas
  bool hidden = false;                    ///< the stroke is of a hidden line
  bool box = false;                       ///< the stroke's first and last point span a box
  std::vector<ribs::EndRef> touched;      ///< rib ends that it moves
  std::optional<ribs::EndRef> end;        ///< the one that is dragged
  int depth = -1;                         ///< the handle or dot of the depth that is dragged
  std::optional<document::PinDepth> pin;  ///< what that dot would be if the gesture ended now
  bool pinShown = false;                  ///< by the pieces
  double pinNextMs = 0;                   ///< not before this time are they made anew
};

/// How the tools work; lasts until it is changed.
struct EditOptions {
  double ribReach = 0.06;        ///< of a dragged rib end, share of the spine's length, 0…0.5
  double spineReach = 0.25;      ///< of a dragged spine point, the same
  bool bothSides = false;        ///< a line changes the other side of the ribs as well
  bool keepRibs = false;         ///< a changed spine takes its ribs along; else edges are found again
  bool wholePicture = false;     ///< a scribble counts for all parts of the picture
  bool paintOver = false;        ///< what a scribble covers is not on the part
  bool depthByPressure = false;  ///< a pen's pressure becomes the depth of the spine
  bool hiddenPen = false;        ///< lines of a line drawing have something in front of them
  double pullReach = 0.12;       ///< radius of a pull, share of the part's diagonal, kLeastPullReach … kMostPullReach
  bool pullSharp = false;        ///< a pull makes an edge along its line
  double bridgeWidth = 1;        ///< of the next bridge, times the usual one, kLeastBridgeWidth … kMostBridgeWidth
  double brush = 14;             ///< radius of a scribble, CSS pixels
  bool operator==(const EditOptions&) const = default;
};
inline constexpr double kMostReach = 0.5, kLeastPullReach = 0.02, kMostPullReach = 0.6;
inline constexpr double kLeastBridgeWidth = 0.2, kMostBridgeWidth = 3;

/// How parts are taken in hand; lasts until it is changed.
struct PlaceOptions {
  bool snap = false;  ///< a dragged part settles on the surface under the pointer
  bool operator==(const PlaceOptions&) const = default;
};

/// What a drag of puff and flat piece is: the thing's outline, a box round it, or a scribble over it.
enum class CutBy : std::uint8_t { Outline, Box, Scribble };

/// A row of the part list: a part, the group whose first part it is, or a solid (and no part).
struct ListRow {
  PartId part;
  GroupId group;
  StepId step = {};
  bool operator==(const ListRow&) const = default;
};

/// Where a row of the part list is.
struct ShownRow {
  ListRow row;
  Rect at;  ///< of its name
};

/// A camera on its way, by some others at even times.
struct CameraFlight {
  Camera from, to;
  double startMs = 0, lengthMs = 300;
  std::vector<Camera> by = {};
  /// At a share of the time, 0…1: it begins and ends gently.
  Camera at(double share) const;
};

/// How a picture was looked at when another came into view.
struct SeenPicture {
  PictureId picture;
  PictureView view;
};

/// How a part lies with what it was drawn over.
enum class Lie : std::uint8_t { InFront, Inside, Behind };
/// The last part, for as long as nothing else was done.
struct NewPart {
  PartId part;
  Lie lie = Lie::Inside;
  std::size_t undo = 0;  ///< steps that there were then
};

/// A solid that was just made, lit for a moment.
struct Flash {
  StepId step;
  double light = 1;                    ///< 0…1
  std::optional<double> sinceMs = {};  ///< none: it is not there yet
};

/// Where the sheet of the tool Layers is (see web/edit/layers.h), and what a hand does with it.
struct LayerUi {
  PartId part;                          ///< whose sheet it is; none: of the next part
  std::optional<double> at = {};        ///< none: where sheets begin
  geometry::Turn turn = {};             ///< of a sheet that lies on no layer, from how it would stand on the rail
  std::vector<SectionPoint> line = {};  ///< that is being drawn on it
  SheetHold held = SheetHold::Nothing;  ///< one of its knobs
  bool drawsRail = false;               ///< the next line in the solid view is the rail
  std::vector<ClientPoint> rail = {};   ///< that line
};

/// Solids made of parts: which one is chosen, what is ticked for the next one, and how the list stands.
struct SolidUi {
  StepId step;            ///< the chosen solid
  bool pointing = false;  ///< a tap on it says where it is open
  /// What *Scoop out* would make hollow, while it is shown: one operand (see edit/hollowing.h).
  std::optional<document::CombineParts> hollow;
  std::optional<Flash> flash;
  std::vector<document::Operand> picked;  ///< ticked, in this order
  std::vector<StepId> folded;             ///< whose parts the list does not show
};

struct UiState {
  Layout layout;
  double canvasWidth = 0, canvasHeight = 0, dpr = 1;
  double share = 0.5;  ///< of the views' room that the picture has

  ToolKind tool = ToolKind::Draw;
  Focus focus = Focus::Picture;
  PanelTab tab = PanelTab::Section;
  unsigned folded = (1u << static_cast<unsigned>(PanelTab::Along)) |
                    (1u << static_cast<unsigned>(PanelTab::Relief));  ///< bits of the column's sections
  PartId selection;
  PartId chosenPart;  ///< the last one that the visitor chose; what is only just drawn is selected without that
  Hover hover;
  Chosen chosen;
  InHand inHand;
  EditOptions edit;
  PictureId picture;          ///< the one in the picture view (see featureAt)
  bool framePending = false;  ///< a part is new: let the camera see it once it has its shape
  PartId redraw;              ///< the next stroke is for this part
  /// The part made of a region whose outline points are in hand: it was tapped or chosen since a drawing tool was
  /// taken; what is only just drawn has none, so that the next line may begin on it.
  PartId pointsOf;
  bool pointsKnown = false;  ///< some were in hand: nobody has to be told how
  PictureId pictureMenu;     ///< whose small menu is open
  Sketching sketching;       ///< pen and eraser

  PictureView pictureView;
  std::vector<SeenPicture> seen;  ///< how the other pictures were last looked at
  bool legendOpen = false;        ///< on a phone, where it is folded at first
  BarMenu barMenu = BarMenu::None;
  double barHead = 0;  ///< CSS pixels of the picture view's head that a fitted picture leaves to a bar
  double barLeft = 0;  ///< CSS pixels that a column takes at the left of a low picture view
  double barFoot = 0;  ///< CSS pixels that a row of buttons takes at the foot of the picture view
  Rect solidButtons;   ///< the row or column of buttons in the solid view; empty: it is not shown
  Rect solidRoom;      ///< of the solid view, what no bar covers, as of the last frame; empty: not known yet
  Camera camera;
  std::optional<CameraFlight> flight;
  bool fliesAlong() const { return flight && !flight->by.empty(); }  ///< a part, for somebody who looks
  bool cameraTouched = false;  ///< the visitor turned it: no flights of our own any more

  /// What the next part is made with.
  sections::SectionShape section;
  sections::CapStyle startCap = sections::CapStyle::Round, endCap = sections::CapStyle::Round;
  document::Look look;
  inflate::InflateParams inflate;
  extrude::ExtrudeParams extrude;
  lathe::LatheParams lathe;
  shape::Primitive primitive = shape::Primitive::Ball;
  PictureId axisOf;  ///< the picture whose axis `lathe` has; others have theirs in the middle (see spinning.h)
  std::optional<CutDraft> cut;  ///< what is being cut out of the picture
  CutBy cutBy = CutBy::Outline;
  std::optional<PrintReport> print;   ///< the last check for printing
  bool printWaits = false;            ///< one was asked for, and waits for the solver
  std::optional<std::size_t> beside;  ///< of things(): what stands beside the solid, to compare
  bool secondColour = false;          ///< the colours of the panel are for what is below

  std::vector<PartId> alsoSelected;  ///< besides `selection`, each once (see placing.h)
  PlaceOptions place;
  /// Where the gesture in hand has the parts it holds; empty between gestures.
  std::vector<document::PlaceParts::One> placing;
  std::vector<ShownRow> rows;            ///< in sight, as of the last frame
  std::optional<ListRow> listDrag;       ///< the row of the part list that is dragged
  GizmoHandle held = GizmoHandle::None;  ///< by the gesture in hand

  Answers answers;  ///< to what was asked so far

  Reusable<Preview> preview;
  std::uint64_t previewShapes = 0;  ///< counts the shapes of all previews
  SectionUi sections;
  SolidUi solids;
  LayerUi layers;
  std::optional<NewPart> newPart;  ///< where it was drawn over others
  bool allTools = true;            ///< else the views have those of a first visit
  bool moreNumbers = false;        ///< panels show the numbers that few need
  bool spaceHeld = false;
  platform::Palette palette;
  bool touch = false;                 ///< the last pointer was a finger: larger targets
  bool penSeen = false;               ///< a pen was used: fingers no longer draw
  std::vector<Thumbnail> thumbnails;  ///< of the strip, as of the last frame
  std::vector<Rect> overlays;         ///< ImGui windows above the views, as of the last frame
  std::vector<Control> controls;      ///< as of the last frame
  std::optional<AskedControl> asked;  ///< to be worked in this frame
  std::uint32_t wantedInSight = 0;    ///< the control that its panel is to bring into sight; 0: none
};

void closeMenus(UiState& ui);

/// The next part is made as the first one of a new page.
void resetNextPart(UiState& ui);

/// Brings a picture into view as it was last looked at, the first time whole.
void featureAt(UiState& ui, PictureId picture);

}  // namespace spineloft::app
