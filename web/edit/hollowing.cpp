#include "web/edit/hollowing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/groups.h"
#include "engine/base/hash.h"
#include "engine/document/update.h"
#include "engine/pipeline/world.h"
#include "engine/publish/solid_plan.h"
#include "web/edit/solid_editing.h"

namespace spineloft::app {
namespace {

using document::Operand;

constexpr double kWideMouth = 0.6, kMouthBelow = 0.2;  // of what the end is wide so far below it; share of the length
constexpr int kHalvings = 6;
constexpr double kFacing = 0.9, kOnePlane = 0.9998, kLid = 0.7;  // cosines; share of what faces the opening

using publish::SolidPlan;

WorldPoint placed(const SolidPlan::Operand& leaf, const std::array<float, 3>& p) {
  const auto& m = leaf.toWorld;
  const double x = p[0], y = p[1], z = p[2];
  return {m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
          m[2] * x + m[6] * y + m[10] * z + m[14]};
}

/// The parts in a node, where they stand.
std::vector<SolidPlan::Operand> leavesOf(const SolidPlan& plan, const SolidPlan::Node& node) {
  std::vector<SolidPlan::Operand> leaves;
  std::vector<SolidPlan::Operand> left = node.operands;
  while (!left.empty()) {
    const SolidPlan::Operand operand = left.back();
    left.pop_back();
    if (!operand.node) {
      leaves.push_back(operand);
      continue;
    }
    const auto& inner = plan.nodes[*operand.node].operands;
    left.insert(left.end(), inner.begin(), inner.end());
  }
  return leaves;
}

/// The corners of a part in the world.
std::vector<WorldPoint> cornersOf(const SolidPlan& plan, const SolidPlan::Operand& leaf) {
  std::vector<WorldPoint> at;
  for (const auto& p : plan.meshes[leaf.mesh].mesh->positions) at.push_back(placed(leaf, p));
  return at;
}

/// The document as it would be, and what its solver would be asked.
struct Planned {
  document::Document document;
  SolidPlan plan;
  const SolidPlan::Node* node = nullptr;  ///< of the new solid
};

std::optional<Planned> planned(const document::Document& document, const pipeline::Derived& derived,
                               const document::CombineParts& draft) {
  Result<document::Document> then = document::update(document, draft);
  if (!then) return std::nullopt;
  Planned out{std::move(then.value()), {}, nullptr};
  out.plan = publish::planSolids(out.document, derived);
  const StepId id = out.document.steps.back()->id;
  const auto at = std::ranges::find_if(out.plan.nodes, [&](const SolidPlan::Node& node) {
    return node.step == id && node.kind == document::StepKind::Hollow;
  });
  if (at == out.plan.nodes.end()) return std::nullopt;
  out.node = &*at;
  return out;
}

document::CombineParts draftOf(Operand what) {
  document::CombineParts draft;
  draft.kind = document::StepKind::Hollow;
  draft.operands = {what};
  return draft;
}

/// Of the parts in it, each for itself; 0: something in it has no shape.
double volumeOf(const CommandEnv& env, Operand what) {
  const auto then = planned(env.studio.document(), env.studio.derived(), draftOf(what));
  if (!then) return 0;
  double six = 0;
  for (const SolidPlan::Operand& leaf : leavesOf(then->plan, *then->node)) {
    double own = 0;
    const std::vector<WorldPoint> at = cornersOf(then->plan, leaf);
    for (const auto& t : then->plan.meshes[leaf.mesh].mesh->triangles) own += dot(at[t[0]], cross(at[t[1]], at[t[2]]));
    six += std::abs(own);
  }
  return six / 6;
}

/// Where a surface crosses a height, and in which of its closed curves each segment lies.
struct Crossing {
  std::vector<std::array<WorldPoint, 2>> segments;
  std::vector<std::uint32_t> curves;  ///< of each segment
};
/// `heights` of the corners above the plane; none is taken to lie on it. Cost: O(triangles + n log n) for n segments.
Crossing crossingOf(const mesh::TriMesh& mesh, const std::vector<WorldPoint>& at, const std::vector<double>& heights) {
  Crossing out;
  std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> edges;  // each is one of two segments
  for (const auto& t : mesh.triangles) {
    std::array<WorldPoint, 2> ends;
    std::size_t count = 0;
    const auto segment = static_cast<std::uint32_t>(out.segments.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      const double a = heights[low], b = heights[high];
      if ((a > 0) == (b > 0)) continue;
      ends[count++] = at[low] + (at[high] - at[low]) * (a / (a - b));
      edges.push_back({{low, high}, segment});
    }
    if (count == 2) out.segments.push_back(ends);
  }
  std::ranges::sort(edges);
  Groups curves(out.segments.size());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].first == edges[i - 1].first) curves.unite(edges[i].second, edges[i - 1].second);
  }
  for (std::uint32_t i = 0; i < out.segments.size(); ++i) out.curves.push_back(curves.of(i));
  return out;
}

/// A curve's length, and the middle of it.
struct Curve {
  double length = 0;
  WorldPoint sum;
  WorldPoint middle() const { return sum * (1 / length); }
};
Curve longestOf(const Crossing& crossing) {
  std::vector<Curve> curves(crossing.segments.size());
  for (std::size_t i = 0; i < crossing.segments.size(); ++i) {
    const auto& [a, b] = crossing.segments[i];
    Curve& curve = curves[crossing.curves[i]];
    curve.length += distance(a, b);
    curve.sum = curve.sum + (a + b) * (distance(a, b) / 2);
  }
  return curves.empty() ? Curve{} : *std::ranges::max_element(curves, {}, &Curve::length);
}

/// What opens in a direction, and how far it reaches that way.
struct Opened {
  Planned then;
  WorldPoint out;  ///< unit
  std::vector<SolidPlan::Operand> leaves;
  std::vector<std::vector<WorldPoint>> corners;  ///< of each leaf
  double low = std::numeric_limits<double>::infinity(), high = -low;
  WorldPoint top;  ///< its outermost corner

  double length() const { return high - low; }
  Crossing at(double level, std::size_t leaf) const {
    std::vector<double> heights;
    for (const WorldPoint& p : corners[leaf]) heights.push_back(dot(p, out) - level);
    return crossingOf(*then.plan.meshes[leaves[leaf].mesh].mesh, corners[leaf], heights);
  }
  /// How long the longest closed curve is in which the surface meets this height.
  double around(double level) const {
    double most = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) most = std::max(most, longestOf(at(level, i)).length);
    return most;
  }
};

/// Whether most of what looks towards the opening is one flat lid, which may lean: the solver opens all of it
/// (squareToLid in web/shell/solids/fields.ts).
bool hasLid(const Opened& opened) {
  std::vector<WorldPoint> facing;  // normals, as long as twice the area
  WorldPoint lean;
  double all = 0, flat = 0;
  for (std::size_t i = 0; i < opened.leaves.size(); ++i) {
    const std::vector<WorldPoint>& at = opened.corners[i];
    for (const auto& t : opened.then.plan.meshes[opened.leaves[i].mesh].mesh->triangles) {
      const WorldPoint normal = cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
      if (!(dot(normal, opened.out) > kFacing * norm(normal))) continue;
      lean = lean + normal;
      all += norm(normal);
      facing.push_back(normal);
    }
  }
  for (const WorldPoint& normal : facing) {
    if (dot(normal, lean) >= kOnePlane * norm(normal) * norm(lean)) flat += norm(normal);
  }
  return flat > kLid * all;
}

/// None: it stays closed, or something in it has no shape.
std::optional<Opened> openedBy(const document::Document& document, const pipeline::Derived& derived,
                               const document::CombineParts& draft) {
  auto then = planned(document, derived, draft);
  if (!then || !then->node->opening) return std::nullopt;
  const auto& way = *then->node->opening;
  Opened opened;
  opened.out = {way[0], way[1], way[2]};
  opened.then = std::move(*then);
  opened.leaves = leavesOf(opened.then.plan, *opened.then.node);
  for (const SolidPlan::Operand& leaf : opened.leaves) {
    for (const WorldPoint& p : opened.corners.emplace_back(cornersOf(opened.then.plan, leaf))) {
      const double along = dot(p, opened.out);
      opened.low = std::min(opened.low, along);
      if (along <= opened.high) continue;
      opened.high = along;
      opened.top = p;
    }
  }
  return opened.low < opened.high ? std::optional(std::move(opened)) : std::nullopt;
}

bool canBeHollow(const document::Document& document, Operand what) {
  const document::Step* step = findStep(document, what.step);
  if (step != nullptr) return step->visible && step->kind != document::StepKind::Hollow;
  const document::Part* part = findPart(document, what.part);
  return part != nullptr && part->visible;
}

}  // namespace

std::vector<Operand> hollowable(const CommandEnv& env) {
  const document::Document& document = env.studio.document();
  const auto isChosen = [&](Operand what) {
    if (what.step && what.step == env.ui.solids.step) return true;
    const std::vector<PartId> parts = partsIn(document, what);
    return env.ui.selection == env.ui.chosenPart && std::ranges::count(parts, env.ui.selection) > 0;
  };
  std::vector<std::pair<double, Operand>> found;
  for (const Operand what : rootsOf(document)) {
    const double volume = canBeHollow(document, what) ? volumeOf(env, what) : 0;
    if (volume > 0) found.emplace_back(isChosen(what) ? std::numeric_limits<double>::infinity() : volume, what);
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Operand> out;
  for (const auto& each : found) out.push_back(each.second);
  return out;
}

document::CombineParts hollowOf(const CommandEnv& env, Operand what) {
  document::CombineParts draft = draftOf(what);
  draft.opening.side = sideOf(env, draft, {0, 1, 0});
  draft.opening.depth = usualDepth(env, draft);
  return draft;
}

double usualDepth(const CommandEnv& env, const document::CombineParts& draft) {
  const auto opened = openedBy(env.studio.document(), env.studio.derived(), draft);
  if (!opened || hasLid(*opened)) return 0;
  // The inside is about as wide at a depth as the outside is a wall nearer to the end.
  const auto around = [&](double share) { return opened->around(opened->high - share * opened->length()); };
  const double wanted = kWideMouth * around(kMouthBelow);
  double low = 0, high = kMouthBelow;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (around(middle) >= wanted ? high : low) = middle;
  }
  return std::min(high + draft.wall / opened->length(), document::kMostOpening);
}

document::OpeningSide sideOf(const CommandEnv& env, const document::CombineParts& draft, const WorldPoint& direction) {
  const auto then = planned(env.studio.document(), env.studio.derived(), draft);
  if (!then) return draft.opening.side;
  return publish::sideFacing(then->document, env.studio.derived(), *then->document.steps.back(), direction);
}

bool becomesHollow(const document::Document& document, const UiState& ui, PartId part) {
  if (!ui.solids.hollow) return false;
  return std::ranges::count(partsIn(document, ui.solids.hollow->operands.front()), part) > 0;
}

std::optional<Mouth> mouthOf(const document::Document& document, const pipeline::Derived& derived,
                             const document::CombineParts& draft) {
  const auto opened = openedBy(document, derived, draft);
  if (!opened) return std::nullopt;
  Mouth mouth{opened->top, opened->out, {}};  // should the plane meet nothing
  const double length = opened->length();
  const double level = opened->high - std::max(draft.opening.depth * length, std::min(draft.wall, length / 4));
  double longest = 0;
  for (std::size_t i = 0; i < opened->leaves.size(); ++i) {
    const Crossing crossing = opened->at(level, i);
    mouth.rim.insert(mouth.rim.end(), crossing.segments.begin(), crossing.segments.end());
    const Curve curve = longestOf(crossing);
    if (curve.length <= longest) continue;
    longest = curve.length;
    mouth.at = curve.middle();
  }
  return mouth;
}

const std::optional<Mouth>& ShownMouth::of(const document::Document& document, const pipeline::Derived& derived,
                                           const document::CombineParts& draft) {
  Hasher hasher;
  hasher.text("mouth").number(draft.wall).number(draft.opening.side).number(draft.opening.depth);
  for (const PartId id : partsIn(document, draft.operands.front())) {
    const document::Part* part = findPart(document, id);
    const auto at = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
    const document::PictureEntry* entry = part ? findPicture(document, document::pictureOf(*part)) : nullptr;
    if (entry == nullptr || at == derived.parts.end() || !at->shape) continue;
    hasher.number(id.value).number(at->shape->key.hash);
    for (const pipeline::ToWorld& toWorld : pipeline::copiesInWorld(*part, entry->size)) {
      for (const double value : toWorld.linear) hasher.number(value);
      const WorldPoint zero = toWorld(ModelPoint{});
      hasher.number(zero.x).number(zero.y).number(zero.z);
    }
  }
  const std::uint64_t key = hasher.value() | 1u;
  if (key == key_) return mouth_;
  key_ = key;
  mouth_ = mouthOf(document, derived, draft);
  return mouth_;
}

}  // namespace spineloft::app
