#include "engine/document/update.h"

#include <algorithm>
#include <cmath>

#include "engine/document/arrange.h"
#include "engine/document/checks.h"
#include "engine/document/params.h"
#include "engine/document/update_drawings.h"
#include "engine/document/update_parts.h"
#include "engine/document/update_steps.h"

namespace spineloft::document {
namespace {

bool known(sections::CapStyle cap) { return cap < sections::CapStyle::kCount; }

/// Changes the element with this id: `change` gets a copy and says whether it may replace the
/// original.
template <class T, class Id, class Change>
Status edit(std::vector<Box<T>>& list, Id id, Error missing, const Change& change) {
  const auto at = std::ranges::find_if(list, [&](const T& entry) { return entry.id == id; });
  if (at == list.end()) return missing;
  T copy = *at;
  if (Status status = change(copy); !status) return status;
  *at = std::move(copy);
  return Done{};
}

/// Applies one action to a copy of the document; every action has its overload, or this does not
/// compile.
struct Apply {
  Document& document;

  template <class Change>
  Status editPart(PartId id, const Change& change) const {
    return edit(document.parts, id, Error::NoSuchPart, change);
  }
  /// The same for what only a loft has. Error: NotABone.
  template <class Change>
  Status editLoft(PartId id, const Change& change) const {
    return editPart(id, [&](Part& part) -> Status {
      LoftRecipe* loft = loftOf(part);
      return loft ? change(*loft) : Status(Error::NotABone);
    });
  }
  /// And for what only a region has. Error: NotARegion.
  template <class Change>
  Status editRegion(PartId id, const Change& change) const {
    return editPart(
        id, [&](Part& part) -> Status { return regionOf(part.recipe) ? change(part) : Status(Error::NotARegion); });
  }
  template <class Change>
  Status editPicture(PictureId id, const Change& change) const {
    return edit(document.pictures, id, Error::NoSuchPicture, change);
  }
  Status roomForPicture() const {
    if (document.pictures.size() < kMostPictures) return Done{};
    return {Error::ValueOutOfRange, "too many pictures"};
  }

  /// Views of what is gone, and outlines in no view of their part, go.
  void forgetUnseen() const {
    for (Box<PictureEntry>& box : document.pictures) {
      if (!box->view || findPicture(document, box->view->of) != nullptr) continue;
      PictureEntry entry = box;
      entry.view.reset();
      box = std::move(entry);
    }
    for (Box<Part>& box : document.parts) {
      Part part = box;
      if (dropUnseen(document, part) > 0) box = std::move(part);
    }
  }

  Status operator()(const AddPicture& a) const {
    if (!a.picture || a.picture->working.empty()) return Error::PictureEmpty;
    if (Status room = roomForPicture(); !room) return room;
    PictureEntry entry;
    entry.id = PictureId{++document.lastPictureId};
    entry.picture = a.picture;
    entry.name = tidyName(a.name, fallbackName(entry));
    entry.size = {a.picture->width, a.picture->height};
    entry.contentHash = contentHash(*a.picture);
    document.pictures.push_back(std::move(entry));
    return Done{};
  }
  Status operator()(const AddSketch& a) const {
    const auto fits = [](int side) { return side >= image::kLeastSketchSide && side <= image::kMostSketchSide; };
    if (!fits(a.size.width) || !fits(a.size.height)) return {Error::ValueOutOfRange, "paper size"};
    if (Status room = roomForPicture(); !room) return room;
    PictureEntry entry;
    entry.id = PictureId{++document.lastPictureId};
    entry.name = tidyName(a.name, fallbackName(entry));
    entry.size = a.size;
    entry.contentHash = contentHash(a.size, {});
    document.pictures.push_back(std::move(entry));
    return Done{};
  }
  Status operator()(const DrawOnSketch& a) const {
    if (!image::isValid(a.stroke)) return {Error::ValueOutOfRange, "pen stroke"};
    return editPicture(a.picture, [&](PictureEntry& entry) -> Status {
      if (!entry.isSketch()) return {Error::ValueOutOfRange, "not a sketch"};
      if (entry.sketch.size() >= image::kMostSketchStrokes) {
        return {Error::ValueOutOfRange, "too many pen strokes"};
      }
      entry.sketch.push_back(a.stroke);
      entry.contentHash = contentHash(entry.size, entry.sketch);
      return Done{};
    });
  }
  Status operator()(const RenamePicture& a) const {
    return editPicture(a.picture, [&](PictureEntry& entry) -> Status {
      entry.name = tidyName(a.name, fallbackName(entry));
      return Done{};
    });
  }
  Status operator()(const IgnoreForPicture& a) const {
    if (!isValid(a.marks)) return {Error::ValueOutOfRange, "scribble"};
    return editPicture(a.picture, [&](PictureEntry& entry) -> Status {
      entry.ignored = a.marks;
      return Done{};
    });
  }
  Status operator()(const RemovePicture& a) const {
    if (findPicture(document, a.picture) == nullptr) return Error::NoSuchPicture;
    std::vector<PartId> gone;
    for (const Part& part : document.parts) {
      if (pictureOf(part) == a.picture) gone.push_back(part.id);
    }
    for (const PartId id : gone) erasePart(document, id);
    std::erase_if(document.pictures, [&](const PictureEntry& p) { return p.id == a.picture; });
    forgetUnseen();
    return Done{};
  }
  Status operator()(const DrawSpine& a) const {
    if (!known(a.startCap) || !known(a.endCap)) return Error::ValueOutOfRange;
    if (Status room = roomForPart(document); !room) return room;
    if (Status shape = sections::checkShape(a.section); !shape) return shape;
    LoftRecipe recipe;
    recipe.picture = a.picture;
    recipe.stroke = a.stroke;
    recipe.loft.sections.front().shape = a.section;
    recipe.loft.startCap = a.startCap;
    recipe.loft.endCap = a.endCap;
    recipe.pose.depth = a.depth;
    if (!loft::isValid(recipe.pose)) return {Error::ValueOutOfRange, "depth"};
    if (Status stroke = checkStroke(document, recipe); !stroke) return stroke;
    addPart(document, std::move(recipe), a.look);
    return Done{};
  }
  Status operator()(const DrawRegion& a) const {
    if (Status room = roomForPart(document); !room) return room;
    if (Status solid = checkSolid(a.solid); !solid) return solid;
    if (Status drawn = checkRegion(document, a.region); !drawn) return drawn;
    addPart(document, recipeOf(a.region, a.solid), a.look);
    return Done{};
  }
  Status operator()(const RedrawRegion& a) const {
    if (Status drawn = checkRegion(document, a.region); !drawn) return drawn;
    return editRegion(a.part, [&](Part& part) -> Status {
      *regionOf(part.recipe) = a.region;
      dropUnseen(document, part.recipe);
      return Done{};
    });
  }
  Status operator()(const ShapeRegion& a) const {
    if (Status solid = checkSolid(a.solid); !solid) return solid;
    return editRegion(a.part, [&](Part& part) -> Status {
      const Region region = *regionOf(part.recipe);
      const std::optional<Outline> side = inflateOf(part) ? inflateOf(part)->side : std::nullopt;
      part.recipe = recipeOf(region, a.solid);
      if (InflateRecipe* puff = inflateOf(part)) puff->side = side;
      return Done{};
    });
  }
  Status operator()(const RemakePart& a) const {
    if (Status solid = checkSolid(a.solid); !solid) return solid;
    if (Status drawn = checkRegion(document, a.region); !drawn) return drawn;
    return editPart(a.part, [&](Part& part) -> Status {
      part.recipe = recipeOf(a.region, a.solid);
      return Done{};
    });
  }
  Status operator()(const DrawStack& a) const {
    if (Status room = roomForPart(document); !room) return room;
    if (!isValid(a.stack)) return Error::ValueOutOfRange;
    StackRecipe recipe{a.picture, a.planes, a.rail, a.stack};
    if (Status drawn = checkStack(document, recipe); !drawn) return drawn;
    addPart(document, std::move(recipe), a.look);
    return Done{};
  }
  /// Changes what only a stack has. Error: NotAStack.
  template <class Change>
  Status editStack(PartId id, const Change& change) const {
    return editPart(id, [&](Part& part) -> Status {
      StackRecipe* stack = stackOf(part);
      if (stack == nullptr) return Error::NotAStack;
      change(*stack);
      return checkStack(document, *stack);
    });
  }
  Status operator()(const SetPlanes& a) const {
    return editStack(a.part, [&](StackRecipe& stack) { stack.planes = a.planes; });
  }
  Status operator()(const SetRail& a) const {
    return editStack(a.part, [&](StackRecipe& stack) { stack.rail = a.rail; });
  }
  Status operator()(const ShapeStack& a) const {
    if (!isValid(a.stack)) return Error::ValueOutOfRange;
    return editStack(a.part, [&](StackRecipe& stack) { stack.stack = a.stack; });
  }
  Status operator()(const DrawShape& a) const {
    if (Status room = roomForPart(document); !room) return room;
    ShapeRecipe recipe{a.picture, a.shape, a.outlines};
    if (Status drawn = checkShape(document, recipe); !drawn) return drawn;
    addPart(document, std::move(recipe), a.look);
    return Done{};
  }
  /// Changes what only a shape has. Error: NotAShape.
  template <class Change>
  Status editShape(PartId id, const Change& change) const {
    return editPart(id, [&](Part& part) -> Status {
      ShapeRecipe* shape = shapeOf(part);
      if (shape == nullptr) return Error::NotAShape;
      change(*shape);
      return checkShape(document, *shape);
    });
  }
  Status operator()(const SetShape& a) const {
    return editShape(a.part, [&](ShapeRecipe& shape) { shape.shape = a.shape; });
  }
  Status operator()(const SetOutlines& a) const {
    return editShape(a.part, [&](ShapeRecipe& shape) { shape.outlines = a.outlines; });
  }
  /// Error: NoSuchPart, HostIsBridge.
  Status checkHosts(const BridgeRecipe& recipe) const {
    for (const BridgeEnd* end : {&recipe.from, &recipe.to}) {
      const Part* host = findPart(document, end->part);
      if (host == nullptr) return Error::NoSuchPart;
      if (bridgeOf(*host) != nullptr) return Error::HostIsBridge;
    }
    return checkBridge(document, recipe);
  }
  Status operator()(const DrawBridge& a) const {
    if (Status room = roomForPart(document); !room) return room;
    const Part* first = findPart(document, a.from.part);
    if (first == nullptr) return Error::NoSuchPart;
    BridgeRecipe recipe{pictureOf(*first), a.from, a.to, a.bridge};
    if (Status drawn = checkHosts(recipe); !drawn) return drawn;
    addPart(document, std::move(recipe), a.look);
    return Done{};
  }
  Status operator()(const SetBridgeEnds& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      BridgeRecipe* bridge = bridgeOf(part);
      if (bridge == nullptr) return Error::NotABridge;
      bridge->from = a.from;
      bridge->to = a.to;
      return checkHosts(*bridge);
    });
  }
  Status operator()(const SetSide& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      std::optional<Outline>* side = sideOf(part.recipe);
      if (side == nullptr) return Error::TakesNoSide;
      *side = a.side;
      return checkSide(document, part.recipe);
    });
  }
  Status operator()(const SetView& a) const {
    if (a.view) {
      if (Status view = checkView(document, a.picture, *a.view); !view) return view;
    }
    const Status set = editPicture(a.picture, [&](PictureEntry& entry) -> Status {
      entry.view = a.view;
      return Done{};
    });
    if (set) forgetUnseen();
    return set;
  }
  Status operator()(const RedrawSpine& a) const {
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.stroke = a.stroke;
      return checkStroke(document, loft);
    });
  }
  Status operator()(const PoseSpine& a) const {
    if (!loft::isValid(a.pose)) return {Error::ValueOutOfRange, "pose"};
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.pose = a.pose;
      return Done{};
    });
  }
  Status operator()(const EditRibs& a) const {
    if (!ribs::isValid(a.edits)) return {Error::ValueOutOfRange, "rib edits"};
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.edits = a.edits;
      return Done{};
    });
  }
  Status operator()(const IgnoreForPart& a) const {
    if (!isValid(a.marks)) return {Error::ValueOutOfRange, "scribble"};
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.ignored = a.marks;
      return Done{};
    });
  }
  Status operator()(const SetSection& a) const {
    if (Status shape = sections::checkShape(a.section); !shape) return shape;
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.loft.sections = {loft::SectionKey{}};
      loft.loft.sections.front().shape = a.section;
      return Done{};
    });
  }
  Status operator()(const SetSections& a) const {
    if (Status checked = loft::checkSectionKeys(a.sections); !checked) return checked;
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.loft.sections = a.sections;
      return Done{};
    });
  }
  Status operator()(const SetAlong& a) const {
    if (a.kind >= AlongKind::kCount) return {Error::ValueOutOfRange, "curve"};
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      alongOf(loft.loft, a.kind) = a.curve;
      return loft::checkParams(loft.loft);
    });
  }
  Status operator()(const SetCaps& a) const {
    if (!known(a.start) || !known(a.end)) return Error::ValueOutOfRange;
    return editLoft(a.part, [&](LoftRecipe& loft) -> Status {
      loft.loft.startCap = a.start;
      loft.loft.endCap = a.end;
      return Done{};
    });
  }
  Status operator()(const SetLook& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      part.look = a.look;
      return Done{};
    });
  }
  Status operator()(const SetPulls& a) const {
    if (Status checked = pull::checkPulls(a.pulls); !checked) return checked;
    return editPart(a.part, [&](Part& part) -> Status {
      part.pulls = a.pulls;
      return Done{};
    });
  }
  Status operator()(const SetRelief& a) const {
    if (Status checked = a.relief ? checkRelief(document, *a.relief) : Done{}; !checked) return checked;
    return editPart(a.part, [&](Part& part) -> Status {
      part.relief = a.relief;
      return Done{};
    });
  }
  Status operator()(const SetParameter& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      const ParamInfo* info = findParam(kindOf(part), a.key);
      if (info == nullptr) return {Error::ValueOutOfRange, a.key};
      // Written so that NaN fails too.
      if (!(a.value >= info->low && a.value <= info->high)) return {Error::ValueOutOfRange, a.key};
      const double steps = std::round((a.value - info->low) / info->step);
      info->set(part.recipe, std::min(info->high, info->low + steps * info->step));
      return checkDrawn(document, part.recipe);
    });
  }
  Status operator()(const RenamePart& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      part.name = tidyName(a.name, fallbackName(part));
      return Done{};
    });
  }
  Status operator()(const ShowPart& a) const {
    return editPart(a.part, [&](Part& part) -> Status {
      part.visible = a.visible;
      return Done{};
    });
  }
  Status operator()(const DeletePart& a) const {
    if (findPart(document, a.part) == nullptr) return Error::NoSuchPart;
    erasePart(document, a.part);
    return Done{};
  }
  Status operator()(const DrawLine& a) const { return applyDrawing(document, a); }
  Status operator()(const CloseLine& a) const { return applyDrawing(document, a); }
  Status operator()(const HideLine& a) const { return applyDrawing(document, a); }
  Status operator()(const DeleteLine& a) const { return applyDrawing(document, a); }
  Status operator()(const OrderPieces& a) const { return applyDrawing(document, a); }
  Status operator()(const PinDepth& a) const { return applyDrawing(document, a); }
  Status operator()(const SeeDrawing& a) const { return applyDrawing(document, a); }
  Status operator()(const ShapePiece& a) const { return applyDrawing(document, a); }
  Status operator()(const CombineParts& a) const { return applyStep(document, a); }
  Status operator()(const SetStep& a) const { return applyStep(document, a); }
  Status operator()(const OrderOperands& a) const { return applyStep(document, a); }
  Status operator()(const ReleaseStep& a) const { return applyStep(document, a); }
  Status operator()(const DeleteStep& a) const { return applyStep(document, a); }
  Status operator()(const RenameStep& a) const { return applyStep(document, a); }
  Status operator()(const ShowStep& a) const { return applyStep(document, a); }
  Status operator()(const SetStepLook& a) const { return applyStep(document, a); }
  Status operator()(const PlaceParts& a) const { return arrange(document, a); }
  Status operator()(const DuplicateParts& a) const { return arrange(document, a); }
  Status operator()(const GroupParts& a) const { return arrange(document, a); }
  Status operator()(const Ungroup& a) const { return arrange(document, a); }
  Status operator()(const RenameGroup& a) const { return arrange(document, a); }
  Status operator()(const MoveInList& a) const { return arrange(document, a); }
  Status operator()(const SetHeight& a) const {
    if (!(a.height.value >= kMinHeightMm && a.height.value <= kMaxHeightMm)) {
      return {Error::ValueOutOfRange, "height 1 mm to 10 m"};
    }
    document.height = a.height;
    return Done{};
  }
  Status operator()(const RenameDocument& a) const {
    document.name = tidyName(a.name, kFallbackDocumentName);
    return Done{};
  }
};

}  // namespace

Recipe recipeOf(const Region& region, const RegionSolid& solid) {
  struct Made {
    const Region& region;
    Recipe operator()(const inflate::InflateParams& params) const { return InflateRecipe{region, params, {}}; }
    Recipe operator()(const extrude::ExtrudeParams& params) const { return ExtrudeRecipe{region, params}; }
    Recipe operator()(const lathe::LatheParams& params) const { return LatheRecipe{region, params}; }
  };
  return std::visit(Made{region}, solid);
}

Result<Document> update(const Document& document, const Action& action) {
  Document next = document;
  const Status status = std::visit(Apply{next}, action);
  if (!status) return status.failure();
  settleDrawings(document, next);
  carryLines(document, next);
  dropEmptyGroups(next);
  return next;
}

}  // namespace spineloft::document
