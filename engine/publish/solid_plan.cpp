#include "engine/publish/solid_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/base/hash.h"
#include "engine/pipeline/world.h"

namespace spineloft::publish {
namespace {

using document::Document;
using document::OpeningSide;
using document::Step;
using document::StepKind;

class Planner {
 public:
  Planner(const Document& document, const pipeline::Derived& derived, const Substitute* instead)
      : document_(document), derived_(derived), instead_(instead) {}

  SolidPlan plan() {
    for (const Step& step : document_.steps) {
      if (holderOf(document_, {{}, step.id}) != nullptr) continue;
      const std::size_t nodes = plan_.nodes.size(), meshes = plan_.meshes.size();
      if (const auto root = add(step, 0)) {
        plan_.roots.push_back(*root);
      } else {
        plan_.nodes.resize(nodes);
        plan_.meshes.resize(meshes);
      }
    }
    return std::move(plan_);
  }

  OpeningSide facing(const Step& step, const WorldPoint& direction) const {
    const double length = std::sqrt(dot(direction, direction));
    if (!(length > 0) || !std::isfinite(length)) return OpeningSide::Up;
    constexpr double kHardly = 0.05;
    OpeningSide best = OpeningSide::Up;
    double most = -2;
    // The ends of the spine come first in their order, before the sides of the world.
    for (int i = static_cast<int>(OpeningSide::None) + 1; i < static_cast<int>(OpeningSide::kCount); ++i) {
      const auto side = static_cast<OpeningSide>(i);
      const bool isEnd = side == OpeningSide::Start || side == OpeningSide::End;
      const auto out = isEnd ? endOf(step, side == OpeningSide::Start) : directionOf(step, side);
      if (!out) continue;
      const double faces = ((*out)[0] * direction.x + (*out)[1] * direction.y + (*out)[2] * direction.z) / length;
      if (faces + (isEnd ? kHardly : 0) <= most) continue;
      most = faces + (isEnd ? kHardly : 0);
      best = side;
    }
    return best;
  }

 private:
  /// The step's node; none while something in it has no shape.
  std::optional<std::size_t> add(const Step& step, std::size_t depth) {
    if (depth > document_.steps.size()) return std::nullopt;
    SolidPlan::Node node;
    node.step = step.id;
    node.kind = step.kind;
    const bool blends = step.kind == StepKind::Join || step.kind == StepKind::Cut;
    node.blend = blends ? step.blend : 0;
    Hasher hasher;
    hasher.text("solid").number(step.kind).number(node.blend).number(step.operands.size());
    for (const document::Operand& operand : step.operands) {
      auto made = operand.part ? partOperands(operand.part) : stepOperands(operand.step, depth);
      if (made.empty()) return std::nullopt;
      // A part and its twin are one thing to cut from, to cut with and to share.
      const bool asOne = step.kind == StepKind::Cut || step.kind == StepKind::Intersection;
      if (made.size() > 1 && asOne) made = {joined(std::move(made), step.id)};
      hasher.number(made.size());
      for (const SolidPlan::Operand& each : made) mix(each, hasher);
      node.operands.insert(node.operands.end(), made.begin(), made.end());
    }
    if (step.kind == StepKind::Hollow) {
      node.wall = step.wall;
      node.opening = directionOf(step, step.opening.side);
      node.cut = node.opening ? step.opening.depth : 0;
      hasher.number(node.wall).number(node.cut).number(node.opening.has_value());
      if (node.opening) {
        for (const double value : *node.opening) hasher.number(value);
      }
    }
    node.key = SolidKey{hasher.value()};
    plan_.nodes.push_back(std::move(node));
    return plan_.nodes.size() - 1;
  }

  SolidPlan::Operand joined(std::vector<SolidPlan::Operand> operands, StepId step) {
    SolidPlan::Node node;
    Hasher hasher;
    hasher.text("twins");
    for (const SolidPlan::Operand& each : operands) mix(each, hasher);
    node.key = SolidKey{hasher.value()};
    node.step = step;
    node.operands = std::move(operands);
    plan_.nodes.push_back(std::move(node));
    SolidPlan::Operand operand;
    operand.node = plan_.nodes.size() - 1;
    return operand;
  }

  void mix(const SolidPlan::Operand& operand, Hasher& hasher) const {
    if (operand.node) {
      hasher.number(plan_.nodes[*operand.node].key.hash);
      return;
    }
    hasher.number(plan_.meshes[operand.mesh].key.hash).number(operand.part.value);
    for (const double value : operand.toWorld) hasher.number(value);
  }

  std::vector<SolidPlan::Operand> stepOperands(StepId id, std::size_t depth) {
    const Step* step = findStep(document_, id);
    SolidPlan::Operand operand;
    if (step != nullptr) operand.node = add(*step, depth + 1);
    return operand.node ? std::vector{operand} : std::vector<SolidPlan::Operand>{};
  }

  const pipeline::PartShape* shapeOf(PartId id) const {
    const auto at = std::ranges::find(derived_.parts, id, &pipeline::DerivedPart::id);
    return at != derived_.parts.end() ? at->shape.get() : nullptr;
  }

  /// The part in its place, and its twin where it has live symmetry; none while it has no shape.
  std::vector<SolidPlan::Operand> partOperands(PartId id) {
    const document::Part* part = findPart(document_, id);
    const pipeline::PartShape* shape = shapeOf(id);
    const document::PictureEntry* entry =
        part == nullptr ? nullptr : findPicture(document_, document::pictureOf(*part));
    if (entry == nullptr || shape == nullptr) return {};
    const bool replaced = instead_ != nullptr && instead_->part == id;
    const SolidPlan::Mesh mesh{replaced ? instead_->key : shape->key, replaced ? instead_->mesh : &shape->mesh};
    const auto known = std::ranges::find(plan_.meshes, mesh.key, &SolidPlan::Mesh::key);
    SolidPlan::Operand operand;
    operand.mesh = static_cast<std::size_t>(known - plan_.meshes.begin());
    if (known == plan_.meshes.end()) plan_.meshes.push_back(mesh);
    operand.part = id;
    std::vector<SolidPlan::Operand> operands;
    for (const pipeline::ToWorld& toWorld : pipeline::copiesInWorld(*part, entry->size)) {
      operand.toWorld = matrixOf(toWorld);
      operands.push_back(operand);
    }
    return operands;
  }

  static std::array<double, 16> matrixOf(const pipeline::ToWorld& toWorld) {
    const WorldPoint zero = toWorld(ModelPoint{});
    const auto& m = toWorld.linear;
    return {m[0], m[3], m[6], 0, m[1], m[4], m[7], 0, m[2], m[5], m[8], 0, zero.x, zero.y, zero.z, 1};
  }

  std::optional<std::array<double, 3>> directionOf(const Step& step, OpeningSide side) const {
    const std::array<double, 3> up{0, 1, 0};
    switch (side) {
      case OpeningSide::Up:
        return up;
      case OpeningSide::Down:
        return {{0, -1, 0}};
      case OpeningSide::Left:
        return {{-1, 0, 0}};
      case OpeningSide::Right:
        return {{1, 0, 0}};
      case OpeningSide::Front:
        return {{0, 0, 1}};
      case OpeningSide::Back:
        return {{0, 0, -1}};
      case OpeningSide::Start:
        return endOf(step, true).value_or(up);
      case OpeningSide::End:
        return endOf(step, false).value_or(up);
      case OpeningSide::None:
      case OpeningSide::kCount:
        break;
    }
    return std::nullopt;
  }

  /// The direction in which the spine of the step's first part leaves it; none when it has none.
  std::optional<std::array<double, 3>> endOf(const Step& step, bool start) const {
    const std::vector<PartId> parts = partsIn(document_, {{}, step.id});
    const document::Part* part = parts.empty() ? nullptr : findPart(document_, parts.front());
    const pipeline::PartShape* shape = parts.empty() ? nullptr : shapeOf(parts.front());
    if (part == nullptr || shape == nullptr || shape->centreLine.size() < 2) return std::nullopt;
    const document::PictureEntry* entry = findPicture(document_, document::pictureOf(*part));
    if (entry == nullptr) return std::nullopt;
    const pipeline::Copies copies = pipeline::copiesInWorld(*part, entry->size);
    const std::vector<ModelPoint>& line = shape->centreLine;
    const std::size_t n = line.size(), inner = std::min(n - 1, 1 + n / 8);
    const ModelPoint way = start ? line.front() - line[inner] : line.back() - line[n - 1 - inner];
    const WorldPoint leaves = copies.begin()->along(way);
    std::array<double, 3> out{leaves.x, leaves.y, leaves.z};
    const double length = std::hypot(out[0], out[1], out[2]);
    if (!(length > 0)) return std::nullopt;
    for (double& value : out) value /= length;
    return out;
  }

  const Document& document_;
  const pipeline::Derived& derived_;
  const Substitute* instead_;
  SolidPlan plan_;
};

}  // namespace

SolidPlan planSolids(const Document& document, const pipeline::Derived& derived, const Substitute* instead) {
  return Planner(document, derived, instead).plan();
}

SolidKey aloneKey(PartId part, const pipeline::PartShape& shape) {
  return SolidKey{Hasher().text("alone").number(shape.key.hash).number(part.value).value()};
}

void planAlone(SolidPlan& plan, PartId part, const pipeline::PartShape& shape) {
  const auto known = std::ranges::find(plan.meshes, shape.key, &SolidPlan::Mesh::key);
  SolidPlan::Operand operand;
  operand.mesh = static_cast<std::size_t>(known - plan.meshes.begin());
  if (known == plan.meshes.end()) plan.meshes.push_back({shape.key, &shape.mesh});
  operand.part = part;
  for (std::size_t i = 0; i < 4; ++i) operand.toWorld[5 * i] = 1;
  SolidPlan::Node node;
  node.key = aloneKey(part, shape);
  node.operands.push_back(operand);
  plan.nodes.push_back(std::move(node));
}

document::OpeningSide sideFacing(const document::Document& document, const pipeline::Derived& derived,
                                 const document::Step& step, const WorldPoint& direction) {
  return Planner(document, derived, nullptr).facing(step, direction);
}

}  // namespace spineloft::publish
