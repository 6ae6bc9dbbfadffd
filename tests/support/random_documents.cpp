#include "tests/support/random_documents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "engine/document/params.h"
#include "engine/document/pieces.h"
#include "tests/support/random_recipes.h"

namespace spineloft::testing {
namespace {

using namespace document;

/// Of this kind three times of four, where there is one: few documents have one.
PartId anyPartOf(Rng& rng, const Document& d, PartKind kind) {
  std::vector<PartId> found;
  for (const auto& part : d.parts) {
    if (kindOf(part->recipe) == kind) found.push_back(part->id);
  }
  if (found.empty() || rng.below(4) == 0) return anyPart(rng, d);
  return found[rng.below(static_cast<std::uint32_t>(found.size()))];
}

/// One maker for every alternative of the variant: a new action without one does not compile.
template <class A>
struct Make;
template <>
struct Make<AddPicture> {
  static AddPicture from(Rng& rng, const Document&) {
    return {"picture", rng.below(10) == 0 ? nullptr : ellipsePicture(kWidth, kHeight, rng.below(3))};
  }
};
template <>
struct Make<RemovePicture> {
  static RemovePicture from(Rng& rng, const Document& d) { return {anyPicture(rng, d)}; }
};
template <>
struct Make<DrawSpine> {
  static DrawSpine from(Rng& rng, const Document& d) {
    return {anyPicture(rng, d), anyStroke(rng), anySection(rng), anyCap(rng), anyCap(rng), {}, {}};
  }
};
template <>
struct Make<RedrawSpine> {
  static RedrawSpine from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyStroke(rng)}; }
};
template <>
struct Make<SetSection> {
  static SetSection from(Rng& rng, const Document& d) { return {anyPart(rng, d), anySection(rng)}; }
};
template <>
struct Make<SetCaps> {
  static SetCaps from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyCap(rng), anyCap(rng)}; }
};
template <>
struct Make<SetLook> {
  static SetLook from(Rng& rng, const Document& d) {
    return {anyPart(rng, d),
            {rng.below(2) == 0,
             {static_cast<std::uint8_t>(rng.below(256)), 20, 30},
             static_cast<surface::Paint>(rng.below(static_cast<std::uint32_t>(surface::Paint::kCount))),
             {9, static_cast<std::uint8_t>(rng.below(256)), 7},
             rng.below(2) == 0}};
  }
};
template <>
struct Make<SetParameter> {
  static SetParameter from(Rng& rng, const Document& d) {
    const auto table = paramTable(static_cast<PartKind>(rng.below(3)));
    const ParamInfo& info = table[rng.below(static_cast<std::uint32_t>(table.size()))];
    const double room = info.high - info.low;
    return {anyPart(rng, d), std::string(info.key), rng.uniform(info.low - 0.1 * room, info.high + 0.1 * room)};
  }
};
template <>
struct Make<RenamePart> {
  static RenamePart from(Rng& rng, const Document& d) { return {anyPart(rng, d), std::string(rng.below(300), 'x')}; }
};
template <>
struct Make<ShowPart> {
  static ShowPart from(Rng& rng, const Document& d) { return {anyPart(rng, d), rng.below(2) == 0}; }
};
template <>
struct Make<DeletePart> {
  static DeletePart from(Rng& rng, const Document& d) { return {anyPart(rng, d)}; }
};
template <>
struct Make<SetHeight> {
  static SetHeight from(Rng& rng, const Document&) { return {{rng.uniform(-10, 12000)}}; }
};
template <>
struct Make<RenameDocument> {
  static RenameDocument from(Rng& rng, const Document&) { return {std::string(rng.below(300), 'y')}; }
};

template <>
struct Make<PoseSpine> {
  static PoseSpine from(Rng& rng, const Document& d) {
    loft::Pose pose;
    if (rng.below(2) == 0) pose.stroke = anyStroke(rng);
    pose.depth = anyCurve(rng, -30, 30);
    pose.coilTurns = rng.below(2) == 0 ? 0 : rng.uniform(-5, 5);
    pose.coilRadius = rng.uniform(0, 30);
    pose.closed = rng.below(4) == 0;
    return {anyPart(rng, d), pose};
  }
};
template <>
struct Make<EditRibs> {
  static EditRibs from(Rng& rng, const Document& d) {
    ribs::RibEdits edits;
    edits.ends.resize(rng.below(8));
    for (ribs::EndEdit& end : edits.ends) {
      end = {rng.uniform(0, 1.02), rng.below(2) == 0 ? ribs::Side::Left : ribs::Side::Right,
             rng.uniform(-10, 10), rng.uniform(0, 40),
             rng.uniform(0, 0.3),  rng.below(4) == 0};
    }
    for (std::uint32_t i = rng.below(4); i > 0; --i) edits.added.push_back(rng.uniform(0, 1));
    for (std::uint32_t i = rng.below(4); i > 0; --i) edits.removed.push_back(rng.uniform(0, 1));
    for (auto* fan : {&edits.startFan, &edits.endFan}) {
      if (rng.below(4) > 0) continue;
      for (std::uint32_t i = rng.below(14); i > 0; --i) fan->push_back({rng.uniform(-0.5, 3), rng.uniform(-2, 2)});
    }
    return {anyPart(rng, d), edits};
  }
};
template <>
struct Make<IgnoreForPart> {
  static IgnoreForPart from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyMarks(rng)}; }
};
template <>
struct Make<IgnoreForPicture> {
  static IgnoreForPicture from(Rng& rng, const Document& d) { return {anyPicture(rng, d), anyMarks(rng)}; }
};
template <>
struct Make<SetSections> {
  static SetSections from(Rng& rng, const Document& d) {
    std::vector<loft::SectionKey> keys(rng.below(5));
    for (std::size_t i = 0; i < keys.size(); ++i) {
      keys[i].at = (static_cast<double>(i) + rng.uniform(0, 0.9)) / static_cast<double>(keys.size());
      keys[i].shape = anySection(rng);
      keys[i].blend.kind =
          static_cast<sections::BlendKind>(rng.below(static_cast<std::uint32_t>(sections::BlendKind::kCount) + 1));
    }
    return {anyPart(rng, d), keys};
  }
};
template <>
struct Make<SetAlong> {
  static SetAlong from(Rng& rng, const Document& d) {
    const auto kind = static_cast<AlongKind>(rng.below(5));
    return {anyPart(rng, d), kind, anyCurve(rng, -1, 1.2)};
  }
};
template <>
struct Make<AddSketch> {
  static AddSketch from(Rng& rng, const Document&) { return {"sketch", {static_cast<int>(rng.below(200)), kHeight}}; }
};
template <>
struct Make<DrawOnSketch> {
  static DrawOnSketch from(Rng& rng, const Document& d) {
    image::SketchStroke stroke;
    stroke.points = anyStroke(rng);
    stroke.radius = rng.uniform(0, 10);
    stroke.erase = rng.below(4) == 0;
    if (rng.below(2) == 0) stroke.pressure.assign(stroke.points.size(), 0.5f);
    return {anyPicture(rng, d), stroke};
  }
};
template <>
struct Make<RenamePicture> {
  static RenamePicture from(Rng& rng, const Document& d) {
    return {anyPicture(rng, d), std::string(rng.below(300), 'z')};
  }
};

StepId anyStep(Rng& rng, const Document& document) {
  if (document.steps.empty() || rng.below(20) == 0) return StepId{rng.below(9)};
  return document.steps[rng.below(static_cast<std::uint32_t>(document.steps.size()))]->id;
}

Opening anyOpening(Rng& rng) {
  return {static_cast<OpeningSide>(rng.below(static_cast<std::uint32_t>(OpeningSide::kCount) + 1)),
          rng.uniform(0, 0.95)};
}

template <>
struct Make<CombineParts> {
  static CombineParts from(Rng& rng, const Document& d) {
    CombineParts combine;
    combine.kind = static_cast<StepKind>(rng.below(static_cast<std::uint32_t>(StepKind::kCount) + 1));
    const std::uint32_t count = combine.kind == StepKind::Hollow ? 1 : 2 + rng.below(3);
    std::vector<Operand> free;
    for (const Part& part : d.parts) {
      if (holderOf(d, {part.id, {}}) == nullptr) free.push_back({part.id, {}});
    }
    for (const Step& step : d.steps) {
      if (holderOf(d, {{}, step.id}) == nullptr) free.push_back({{}, step.id});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      // Now and then one that is in a step already, twice there, or not there at all.
      if (free.empty() || rng.below(12) == 0) {
        combine.operands.push_back({anyPart(rng, d), {}});
        continue;
      }
      const std::uint32_t at = rng.below(static_cast<std::uint32_t>(free.size()));
      combine.operands.push_back(free[at]);
      free.erase(free.begin() + at);
    }
    combine.wall = rng.uniform(0, 0.3);
    combine.opening = anyOpening(rng);
    return combine;
  }
};
template <>
struct Make<SetStep> {
  static SetStep from(Rng& rng, const Document& d) {
    const StepId id = anyStep(rng, d);
    const Step* step = findStep(d, id);
    return {id, step && rng.below(2) == 0 ? step->kind : static_cast<StepKind>(rng.below(4)), rng.uniform(0, 0.22),
            rng.uniform(0, 0.4), anyOpening(rng)};
  }
};
template <>
struct Make<OrderOperands> {
  static OrderOperands from(Rng& rng, const Document& d) {
    OrderOperands order{anyStep(rng, d), {}};
    if (const Step* step = findStep(d, order.step)) order.operands = step->operands;
    if (rng.below(4) != 0) std::ranges::reverse(order.operands);
    if (rng.below(10) == 0) order.operands.push_back({PartId{1}, {}});
    return order;
  }
};
template <>
struct Make<ReleaseStep> {
  static ReleaseStep from(Rng& rng, const Document& d) { return {anyStep(rng, d)}; }
};
template <>
struct Make<DeleteStep> {
  static DeleteStep from(Rng& rng, const Document& d) { return {anyStep(rng, d)}; }
};
template <>
struct Make<RenameStep> {
  static RenameStep from(Rng& rng, const Document& d) { return {anyStep(rng, d), std::string(rng.below(300), 'w')}; }
};
template <>
struct Make<ShowStep> {
  static ShowStep from(Rng& rng, const Document& d) { return {anyStep(rng, d), rng.below(2) == 0}; }
};
template <>
struct Make<SetStepLook> {
  static SetStepLook from(Rng& rng, const Document& d) {
    return {anyStep(rng, d), rng.below(2) == 0, {false, {static_cast<std::uint8_t>(rng.below(256)), 7, 9}}};
  }
};

template <>
struct Make<DrawRegion> {
  static DrawRegion from(Rng& rng, const Document& d) { return {anyRegion(rng, d), anySolid(rng), {}}; }
};
template <>
struct Make<RedrawRegion> {
  static RedrawRegion from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyRegion(rng, d)}; }
};
template <>
struct Make<RemakePart> {
  static RemakePart from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyRegion(rng, d), anySolid(rng)}; }
};
template <>
struct Make<ShapeRegion> {
  static ShapeRegion from(Rng& rng, const Document& d) { return {anyPart(rng, d), anySolid(rng)}; }
};

template <>
struct Make<DrawStack> {
  static DrawStack from(Rng& rng, const Document& d) {
    return {anyPicture(rng, d), anyPlanes(rng), anyRail(rng), anyStackParams(rng), {}};
  }
};
template <>
struct Make<SetPlanes> {
  static SetPlanes from(Rng& rng, const Document& d) { return {anyPartOf(rng, d, PartKind::Stack), anyPlanes(rng)}; }
};
template <>
struct Make<SetRail> {
  static SetRail from(Rng& rng, const Document& d) { return {anyPartOf(rng, d, PartKind::Stack), anyRail(rng)}; }
};
template <>
struct Make<ShapeStack> {
  static ShapeStack from(Rng& rng, const Document& d) {
    return {anyPartOf(rng, d, PartKind::Stack), anyStackParams(rng)};
  }
};

template <>
struct Make<DrawShape> {
  static DrawShape from(Rng& rng, const Document& d) {
    const PictureId picture = anyPicture(rng, d);
    std::vector<Outline> outlines = anyOutlines(rng, d);
    if (!outlines.empty()) outlines.front().picture = picture;
    return {picture, anyShape(rng), std::move(outlines), {}};
  }
};
template <>
struct Make<SetShape> {
  static SetShape from(Rng& rng, const Document& d) { return {anyPartOf(rng, d, PartKind::Shape), anyShape(rng)}; }
};
template <>
struct Make<SetOutlines> {
  static SetOutlines from(Rng& rng, const Document& d) {
    return {anyPartOf(rng, d, PartKind::Shape), anyOutlines(rng, d)};
  }
};
template <>
struct Make<SetSide> {
  static SetSide from(Rng& rng, const Document& d) {
    std::vector<Outline> outlines = anyOutlines(rng, d);
    return {anyPart(rng, d), outlines.empty() ? std::nullopt : std::optional(std::move(outlines.front()))};
  }
};
template <>
struct Make<SetPulls> {
  static SetPulls from(Rng& rng, const Document& d) {
    SetPulls set{anyPart(rng, d), {}};
    const auto place = [&] { return ModelPoint{rng.uniform(0, 90), rng.uniform(-90, 0), rng.uniform(-20, 20)}; };
    for (std::uint32_t i = rng.below(3); i > 0; --i) {
      pull::Pull pull{{place()}, rng.uniform(-20, 20), {}, rng.uniform(1, 60), rng.below(2) == 0};
      if (rng.below(2) == 0) pull.line.push_back(place());
      if (rng.below(3) == 0) pull.to = {place(), place()};
      if (rng.below(3) == 0) pull.ring = {place(), place(), place(), place()};
      if (rng.below(4) == 0) {
        pull.across = {place(), place()};
        if (!pull.to.empty()) pull.acrossTo = {place(), place(), place()};
      }
      set.pulls.push_back(std::move(pull));
    }
    return set;
  }
};
template <>
struct Make<SetRelief> {
  static SetRelief from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyRelief(rng, d)}; }
};
BridgeEnd anyBridgeEnd(Rng& rng, const Document& d) {
  BridgeEnd end{anyPart(rng, d), {}};
  for (int i = 0; i < 3; ++i) {  // mostly on what is none itself
    const Part* host = findPart(d, end.part);
    if (host == nullptr || bridgeOf(*host) != nullptr) end.part = anyPart(rng, d);
  }
  const ModelPoint middle{rng.uniform(10, 80), rng.uniform(-80, -10), rng.uniform(-20, 20)};
  const double radius = rng.uniform(1, 12);
  for (int i = 0; i < 6; ++i) end.rim.push_back(middle + ModelPoint{radius * std::cos(i), radius * std::sin(i), 0});
  if (rng.below(8) == 0) end.rim.resize(2);
  return end;
}
template <>
struct Make<DrawBridge> {
  static DrawBridge from(Rng& rng, const Document& d) {
    return {anyBridgeEnd(rng, d), anyBridgeEnd(rng, d), {rng.uniform(0.05, 1), rng.uniform(0.2, 4)}, {}};
  }
};
template <>
struct Make<SetBridgeEnds> {
  static SetBridgeEnds from(Rng& rng, const Document& d) {
    return {anyPartOf(rng, d, PartKind::Bridge), anyBridgeEnd(rng, d), anyBridgeEnd(rng, d)};
  }
};
template <>
struct Make<SetView> {
  static SetView from(Rng& rng, const Document& d) {
    if (rng.below(4) == 0) return {anyPicture(rng, d), std::nullopt};
    const auto from = static_cast<geometry::ViewFrom>(rng.below(5));
    return {anyPicture(rng, d),
            PictureView{anyPicture(rng, d), {from, rng.uniform(0, 90), rng.uniform(-0.2, 3), rng.uniform(-50, 50)}}};
  }
};

DrawingId anyDrawing(Rng& rng, const Document& d) {
  if (d.drawings.empty() || rng.below(20) == 0) return DrawingId{rng.below(9)};
  return d.drawings[rng.below(static_cast<std::uint32_t>(d.drawings.size()))]->id;
}
LineId anyLine(Rng& rng, const Document& d, DrawingId id) {
  const Drawing* drawing = findDrawing(d, id);
  if (drawing == nullptr || drawing->lines.empty() || rng.below(20) == 0) return LineId{rng.below(9)};
  return drawing->lines[rng.below(static_cast<std::uint32_t>(drawing->lines.size()))].id;
}
/// Of one drawing as often as not.
PartId anyPiece(Rng& rng, const Document& d) {
  const bool first = !d.drawings.empty() && rng.below(2) == 0;
  const std::vector<const Part*> pieces = piecesOf(d, first ? d.drawings.front()->id : anyDrawing(rng, d));
  return pieces.empty() ? anyPart(rng, d) : pieces[rng.below(static_cast<std::uint32_t>(pieces.size()))]->id;
}
PicturePoint anyPlace(Rng& rng) { return {rng.uniform(0, kWidth), rng.uniform(0, kHeight)}; }
std::vector<PicturePoint> anyOutline(Rng& rng, const Document& d) {
  Region region = anyRegion(rng, d);
  return region.contours.empty() ? std::vector<PicturePoint>{} : std::move(region.contours.front());
}

template <>
struct Make<DrawLine> {
  static DrawLine from(Rng& rng, const Document& d) {
    const bool closed = rng.below(3) != 0;
    const bool more = !d.drawings.empty() && rng.below(2) == 0;
    return {more ? d.drawings.front()->picture : anyPicture(rng, d),
            closed ? anyOutline(rng, d) : anyStroke(rng),
            anyStretches(rng),
            closed,
            {}};
  }
};
template <>
struct Make<CloseLine> {
  static CloseLine from(Rng& rng, const Document& d) {
    const DrawingId drawing = anyDrawing(rng, d);
    return {drawing, anyLine(rng, d, drawing), {}};
  }
};
template <>
struct Make<HideLine> {
  static HideLine from(Rng& rng, const Document& d) {
    const DrawingId drawing = anyDrawing(rng, d);
    return {drawing, anyLine(rng, d, drawing), anyStretches(rng)};
  }
};
template <>
struct Make<DeleteLine> {
  static DeleteLine from(Rng& rng, const Document& d) {
    const DrawingId drawing = anyDrawing(rng, d);
    return {drawing, anyLine(rng, d, drawing)};
  }
};
template <>
struct Make<OrderPieces> {
  static OrderPieces from(Rng& rng, const Document& d) {
    const PartId over = anyPiece(rng, d);
    const Part* part = findPart(d, over);
    const ElementRecipe* element = part ? elementOf(*part) : nullptr;
    const std::vector<const Part*> pieces = piecesOf(d, element ? element->drawing : DrawingId{});
    const bool near = !pieces.empty() && rng.below(8) != 0;
    return {over, near ? pieces[rng.below(static_cast<std::uint32_t>(pieces.size()))]->id : anyPart(rng, d),
            anyPlace(rng)};
  }
};
template <>
struct Make<PinDepth> {
  static PinDepth from(Rng& rng, const Document& d) {
    const DrawingId drawing = anyDrawing(rng, d);
    const bool given = rng.below(4) != 0;
    return {drawing, anyLine(rng, d, drawing), rng.uniform(-0.05, 1.05),
            given ? std::optional(rng.uniform(-30, 30)) : std::nullopt};
  }
};
template <>
struct Make<SeeDrawing> {
  static SeeDrawing from(Rng& rng, const Document& d) {
    return {anyDrawing(rng, d), static_cast<descriptive::SeenFrom>(rng.below(3))};
  }
};
template <>
struct Make<ShapePiece> {
  static ShapePiece from(Rng& rng, const Document& d) {
    return {anyPiece(rng, d), static_cast<descriptive::PieceKind>(rng.below(3))};
  }
};

std::vector<PartId> anyParts(Rng& rng, const Document& d) {
  std::vector<PartId> parts(rng.below(4));
  for (PartId& part : parts) part = anyPart(rng, d);
  std::ranges::sort(parts);
  parts.erase(std::ranges::unique(parts).begin(), parts.end());
  return parts;
}
GroupId anyGroup(Rng& rng, const Document& d) {
  if (d.groups.empty() || rng.below(10) == 0) return GroupId{rng.below(9)};
  return d.groups[rng.below(static_cast<std::uint32_t>(d.groups.size()))].id;
}
WorldPoint anyWorldPoint(Rng& rng, double far) {
  return {rng.uniform(-far, far), rng.uniform(-far, far), rng.uniform(-far, far)};
}
std::optional<MirrorPlane> anyMirror(Rng& rng) {
  if (rng.below(2) == 0) return std::nullopt;
  return MirrorPlane{anyWorldPoint(rng, 1), normalized(anyWorldPoint(rng, 1))};
}
template <>
struct Make<PlaceParts> {
  static PlaceParts from(Rng& rng, const Document& d) {
    PlaceParts action;
    for (const PartId part : anyParts(rng, d)) {
      action.parts.push_back({part, randomPlacement(rng), anyMirror(rng)});
      if (rng.below(20) == 0) action.parts.back().placement.scale = -1;
      if (rng.below(4) == 0) action.parts.back().placement = {};
    }
    return action;
  }
};
template <>
struct Make<DuplicateParts> {
  static DuplicateParts from(Rng& rng, const Document& d) {
    return {anyParts(rng, d), anyWorldPoint(rng, 0.5), anyMirror(rng)};
  }
};
template <>
struct Make<GroupParts> {
  static GroupParts from(Rng& rng, const Document& d) { return {anyParts(rng, d), std::string(rng.below(20), 'g')}; }
};
template <>
struct Make<Ungroup> {
  static Ungroup from(Rng& rng, const Document& d) { return {anyGroup(rng, d)}; }
};
template <>
struct Make<RenameGroup> {
  static RenameGroup from(Rng& rng, const Document& d) { return {anyGroup(rng, d), std::string(rng.below(300), 'h')}; }
};
template <>
struct Make<MoveInList> {
  static MoveInList from(Rng& rng, const Document& d) {
    return {anyParts(rng, d), rng.below(3) == 0 ? PartId{} : anyPart(rng, d)};
  }
};

template <std::size_t... I>
Action makeAction(std::index_sequence<I...>, std::size_t which, Rng& rng, const Document& d) {
  using Maker = Action (*)(Rng&, const Document&);
  constexpr std::array<Maker, sizeof...(I)> makers = {[](Rng& r, const Document& doc) -> Action {
    return Make<std::variant_alternative_t<I, AnyAction>>::from(r, doc);
  }...};
  return makers[which](rng, d);
}

}  // namespace

std::shared_ptr<const image::Picture> ellipsePicture(int width, int height, std::uint64_t seed) {
  auto picture = std::make_shared<image::Picture>();
  picture->width = width;
  picture->height = height;
  picture->working.width = width;
  picture->working.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width * 2 - 1, v = (y + 0.5) / height * 2 - 1;
      const bool inside = u * u / 0.64 + v * v / 0.25 < 1;
      const auto tone = static_cast<std::uint8_t>((inside ? 60 : 230) + static_cast<int>(seed % 20));
      for (const std::uint8_t channel : {tone, tone, tone, std::uint8_t{255}}) {
        picture->working.pixels.push_back(channel);
      }
    }
  }
  return picture;
}

std::vector<PicturePoint> randomStroke(Rng& rng, int width, int height) {
  const int count = 2 + static_cast<int>(rng.below(59));
  const double y = rng.uniform(0.35, 0.65) * height, wave = rng.uniform(0, 0.1) * height;
  const double left = rng.uniform(0.1, 0.3) * width, right = rng.uniform(0.6, 0.9) * width;
  std::vector<PicturePoint> stroke;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    stroke.push_back({left + (right - left) * t, y + wave * std::sin(5 * t)});
  }
  return stroke;
}

document::Placement randomPlacement(Rng& rng) {
  document::Placement placement;
  const auto point = [&] { return WorldPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}; };
  placement.pivot = point();
  placement.move = point();
  placement.turn = geometry::turnAbout(point(), rng.uniform(-3.1, 3.1));
  placement.scale = std::exp(rng.uniform(-1.5, 1.5));
  placement.mirrored = rng.below(3) == 0;
  return placement;
}

document::Action randomAction(Rng& rng, const document::Document& document) {
  constexpr std::size_t kActions = std::variant_size_v<AnyAction>;
  // A board without pictures accepts little: fill it first.
  std::size_t which = document.pictures.empty() && rng.below(4) != 0 ? 0 : rng.below(kActions);
  // Removing a whole picture is rare in life, and would keep the random documents small.
  if (std::holds_alternative<RemovePicture>(makeAction(std::make_index_sequence<kActions>{}, which, rng, document)) &&
      rng.below(4) != 0) {
    which = 2;
  }
  // So would steps that are asked for before there is any.
  const std::size_t combine = Action(CombineParts{}).index(), lastOfSteps = Action(SetStepLook{}).index();
  if (which > combine && which <= lastOfSteps && document.steps.empty()) which = combine;
  if (which == combine && document.parts.size() < 2) which = 2;
  // And what is asked of lines and pieces.
  const std::size_t line = Action(DrawLine{}).index(), order = Action(OrderPieces{}).index();
  const bool pair = !document.drawings.empty() && piecesOf(document, document.drawings.front()->id).size() > 1;
  if (which > line && document.drawings.empty()) which = line;
  if (which == order && !pair) which = line;
  return makeAction(std::make_index_sequence<kActions>{}, which, rng, document);
}

}  // namespace spineloft::testing
