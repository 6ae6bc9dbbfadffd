#include "engine/document/params.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::document {
namespace {

/// What `value` holds of the recipe of kind R: a member of it, read and written as a double.
template <class R, auto Part, auto Member>
ParamInfo entry(ParamInfo info) {
  info.get = [](const Recipe& recipe) {
    const R* mine = std::get_if<R>(&recipe);
    return mine ? static_cast<double>((mine->*Part).*Member) : 0.0;
  };
  info.set = [](Recipe& recipe, double value) {
    R* mine = std::get_if<R>(&recipe);
    if (mine == nullptr) return;
    auto& member = (mine->*Part).*Member;
    using T = std::remove_reference_t<decltype(member)>;
    if constexpr (std::is_same_v<T, double>) {
      member = value;
    } else {
      member = static_cast<T>(std::lround(value));
    }
  };
  return info;
}

/// The same of a member of the recipe of a piece.
template <auto Member>
ParamInfo own(ParamInfo info) {
  info.get = [](const Recipe& recipe) {
    const auto* mine = std::get_if<ElementRecipe>(&recipe);
    return mine ? mine->*Member : 0.0;
  };
  info.set = [](Recipe& recipe, double value) {
    if (auto* mine = std::get_if<ElementRecipe>(&recipe)) mine->*Member = value;
  };
  return info;
}

std::span<const ParamInfo> loftTable() {
  using loft::LoftParams, ribs::SpineParams;
  constexpr auto kSpine = &LoftRecipe::spine;
  constexpr auto kLoft = &LoftRecipe::loft;
  static const std::array kTable = {
      entry<LoftRecipe, kSpine, &SpineParams::ribs>({"ribs", "Ribs", "ribs", 2, 400, 1, Measure::Plain, true}),
      entry<LoftRecipe, kSpine, &SpineParams::smoothness>(
          {"smoothness", "Smoothing of the bone", "", 0, 0.2, 0.005, Measure::Percent, true}),
      entry<LoftRecipe, kLoft, &LoftParams::sectionPoints>(
          {"sides", "Corners around", "", 12, 128, 4, Measure::Plain, true}),
      entry<LoftRecipe, kLoft, &LoftParams::capRings>(
          {"cap-rings", "Rings of round ends", "", 1, 32, 1, Measure::Plain, true}),
  };
  return kTable;
}

std::span<const ParamInfo> inflateTable() {
  using inflate::InflateParams;
  constexpr auto kPuff = &InflateRecipe::inflate;
  constexpr auto hasEdge = [](const Recipe& recipe) {
    const inflate::ProfileParams& profile = std::get<InflateRecipe>(recipe).inflate.profile;
    return !profile.isSoft() && profile.across == inflate::Across::Length;
  };
  constexpr auto hasProfile = [](const Recipe& recipe) {
    return !std::get<InflateRecipe>(recipe).inflate.profile.isSoft();
  };
  static const std::array kTable = {
      entry<InflateRecipe, kPuff, &InflateParams::height>(
          {"height", "Height", "times", inflate::kLeastHeight, inflate::kMostHeight, 0.05, Measure::Percent}),
      entry<InflateRecipe, kPuff, &InflateParams::points>(
          {"points", "Points", "", inflate::kLeastPoints, inflate::kMostPoints, 100, Measure::Plain, true}),
      ParamInfo{"bone-detail", "Few or many bones", "", 0, 1, 0.05, Measure::Percent, false, hasProfile,
                [](const Recipe& recipe) { return std::get<InflateRecipe>(recipe).inflate.bones.detail; },
                [](Recipe& recipe, double value) { std::get<InflateRecipe>(recipe).inflate.bones.detail = value; }},
      ParamInfo{"reach", "Width of the edge", "of the picture", inflate::kLeastReach, 0.5, 0.005, Measure::Length,
                false, hasEdge,
                [](const Recipe& recipe) { return std::get<InflateRecipe>(recipe).inflate.profile.reach; },
                [](Recipe& recipe, double value) { std::get<InflateRecipe>(recipe).inflate.profile.reach = value; }},
      ParamInfo{"follow", "Thick where it is wide", "", 0, 1, 0.01, Measure::Percent, false, hasProfile,
                [](const Recipe& recipe) { return std::get<InflateRecipe>(recipe).inflate.profile.follow; },
                [](Recipe& recipe, double value) { std::get<InflateRecipe>(recipe).inflate.profile.follow = value; }},
  };
  return kTable;
}

std::span<const ParamInfo> extrudeTable() {
  using extrude::ExtrudeParams;
  constexpr auto kSheet = &ExtrudeRecipe::extrude;
  static const std::array kTable = {
      entry<ExtrudeRecipe, kSheet, &ExtrudeParams::thickness>({"thickness", "Thickness", "of the picture",
                                                               extrude::kLeastThickness, extrude::kMostThickness, 0.002,
                                                               Measure::Length}),
      entry<ExtrudeRecipe, kSheet, &ExtrudeParams::edgeSize>(
          {"edge-size", "Size of the edge", "of half the thickness", 0, 1, 0.05, Measure::Percent}),
      entry<ExtrudeRecipe, kSheet, &ExtrudeParams::depth>(
          {"depth", "Nearer", "of the picture", -extrude::kMostDepth, extrude::kMostDepth, 0.005, Measure::Length}),
  };
  return kTable;
}

std::span<const ParamInfo> latheTable() {
  using lathe::LatheParams;
  constexpr auto kSpun = &LatheRecipe::lathe;
  static const std::array kTable = {
      entry<LatheRecipe, kSpun, &LatheParams::turn>(
          {"turn", "How far round", "degrees", lathe::kLeastTurn, lathe::kMostTurn, 5, Measure::Plain}),
      entry<LatheRecipe, kSpun, &LatheParams::sides>(
          {"sides", "Faces around", "", lathe::kLeastSides, lathe::kRoundSides, 1, Measure::Plain}),
      entry<LatheRecipe, kSpun, &LatheParams::wall>(
          {"wall", "Wall", "of the picture", 0, lathe::kMostWall, 0.001, Measure::Length}),
      entry<LatheRecipe, kSpun, &LatheParams::squash>(
          {"squash", "Depth", "times", lathe::kLeastSquash, lathe::kMostSquash, 0.05, Measure::Percent}),
  };
  return kTable;
}

std::span<const ParamInfo> stackTable() {
  using stack::StackParams;
  constexpr auto kStack = &StackRecipe::stack;
  static const std::array kTable = {
      entry<StackRecipe, kStack, &StackParams::melt>(
          {"melt", "Rounding of forks", "times", 0, 1, 0.05, Measure::Percent, true}),
      entry<StackRecipe, kStack, &StackParams::sides>(
          {"sides", "Corners around", "", stack::kLeastSides, stack::kMostSides, 4, Measure::Plain, true}),
      entry<StackRecipe, kStack, &StackParams::capRings>(
          {"cap-rings", "Rings of round ends", "", 1, stack::kMostCapRings, 1, Measure::Plain, true}),
  };
  return kTable;
}

std::span<const ParamInfo> shapeTable() {
  using shape::ShapeParams;
  constexpr auto kShape = &ShapeRecipe::shape;
  static const std::array kTable = {
      ParamInfo{"depth", "Depth", "times", shape::kLeastRatio, shape::kMostRatio, 0.05, Measure::Percent, false,
                nullptr, [](const Recipe& recipe) { return std::get<ShapeRecipe>(recipe).shape.depth.ratio; },
                [](Recipe& recipe, double value) { std::get<ShapeRecipe>(recipe).shape.depth.ratio = value; }},
      entry<ShapeRecipe, kShape, &ShapeParams::levels>(
          {"levels", "Levels", "", shape::kLeastLevels, shape::kMostLevels, 1, Measure::Plain, true}),
      entry<ShapeRecipe, kShape, &ShapeParams::sides>(
          {"sides", "Corners around", "", shape::kLeastSides, shape::kMostSides, 4, Measure::Plain, true}),
      entry<ShapeRecipe, kShape, &ShapeParams::capRings>(
          {"cap-rings", "Rings of round ends", "", 1, shape::kMostCapRings, 1, Measure::Plain, true}),
  };
  return kTable;
}

std::span<const ParamInfo> bridgeTable() {
  using bridge::BridgeParams;
  constexpr auto kBridge = &BridgeRecipe::bridge;
  static const std::array kTable = {
      entry<BridgeRecipe, kBridge, &BridgeParams::waist>(
          {"waist", "Middle", "times", bridge::kLeastWaist, bridge::kMostWaist, 0.05, Measure::Percent}),
      entry<BridgeRecipe, kBridge, &BridgeParams::bow>(
          {"bow", "Arch", "times", bridge::kLeastBow, bridge::kMostBow, 0.1, Measure::Percent}),
  };
  return kTable;
}

std::span<const ParamInfo> elementTable() {
  constexpr auto isRound = [](const Recipe& recipe) {
    return std::get<ElementRecipe>(recipe).kind == descriptive::PieceKind::Round;
  };
  constexpr auto isFlat = [](const Recipe& recipe) {
    return std::get<ElementRecipe>(recipe).kind == descriptive::PieceKind::Flat;
  };
  static const std::array kTable = {
      own<&ElementRecipe::front>({"front", "Fat in front", "times", descriptive::kLeastFront, descriptive::kMostFront,
                                  0.05, Measure::Percent, false, isRound}),
      own<&ElementRecipe::back>({"back", "Fat behind", "times", descriptive::kLeastFront, descriptive::kMostFront, 0.05,
                                 Measure::Percent, false, isRound}),
      own<&ElementRecipe::thickness>({"thickness", "Thickness", "of the picture", extrude::kLeastThickness,
                                      extrude::kMostThickness, 0.002, Measure::Length, false, isFlat}),
      own<&ElementRecipe::stiffness>({"stiffness", "Stiff", "times", descriptive::kLeastStiffness,
                                      descriptive::kMostStiffness, 0.1, Measure::Plain, true, isRound}),
  };
  return kTable;
}

}  // namespace

std::span<const ParamInfo> paramTable(PartKind kind) {
  switch (kind) {
    case PartKind::Inflate:
      return inflateTable();
    case PartKind::Extrude:
      return extrudeTable();
    case PartKind::Lathe:
      return latheTable();
    case PartKind::Stack:
      return stackTable();
    case PartKind::Shape:
      return shapeTable();
    case PartKind::Element:
      return elementTable();
    case PartKind::Bridge:
      return bridgeTable();
    case PartKind::Loft:
    case PartKind::kCount:
      break;
  }
  return loftTable();
}

const ParamInfo* findParam(PartKind kind, std::string_view key) {
  const auto table = paramTable(kind);
  const auto at = std::ranges::find(table, key, &ParamInfo::key);
  return at == table.end() ? nullptr : &*at;
}

geometry::AlongCurve& alongOf(loft::LoftParams& params, AlongKind kind) {
  switch (kind) {
    case AlongKind::Twist:
      return params.twist;
    case AlongKind::Squash:
      return params.squash;
    case AlongKind::Tilt:
      return params.tilt;
    case AlongKind::Bulge:
    case AlongKind::kCount:
      break;
  }
  return params.bulge;
}

const geometry::AlongCurve& alongOf(const loft::LoftParams& params, AlongKind kind) {
  return alongOf(const_cast<loft::LoftParams&>(params), kind);
}

}  // namespace spineloft::document
