#include "web/edit/depth_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "engine/pipeline/solid.h"
#include "engine/pipeline/world.h"

namespace spineloft::app {
namespace {

using document::Operand;
using pipeline::WorldBounds;

constexpr std::size_t kCells = 96;  // along each side of what two things have in common
constexpr double kReach = 0.04;     // into what is touched, of the thinner one's depth
constexpr double kLevel = 1e-6;     // world units: as good as there, in the meshes' numbers
constexpr double kSideways = 1e-9;  // a twin that goes along in depth is mirrored by an upright plane
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// What a part or solid shows, as it stands in the world.
struct Body {
  std::vector<mesh::TriMesh> meshes;
  std::optional<WorldBounds> bounds;

  void add(mesh::TriMesh mesh) {
    for (const auto& p : mesh.positions) pipeline::include(bounds, {p[0], p[1], p[2]});
    meshes.push_back(std::move(mesh));
  }
};

void addPart(Body& body, const document::Document& document, const pipeline::Derived& derived, PartId id, bool moves) {
  const document::Part* part = document::findPart(document, id);
  const auto shown = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
  if (part == nullptr || shown == derived.parts.end() || !shown->shape) return;
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
  if (entry == nullptr || !pipeline::isVisible(document, *part)) return;
  pipeline::Copies copies = pipeline::copiesInWorld(*part, entry->size);
  if (moves && part->mirror && std::abs(part->mirror->normal.z) > kSideways) copies.count = 1;
  for (const pipeline::ToWorld& toWorld : copies) body.add(pipeline::worldMesh(shown->shape->mesh, toWorld));
}

/// A part, or what is seen of a solid: its own mesh where it is solved, else its parts.
Body bodyOf(const document::Document& document, const pipeline::Derived& derived, Operand root) {
  Body body;
  const document::Step* step = document::findStep(document, root.step);
  const pipeline::DerivedStep* solid = step ? pipeline::shownSolid(document, derived, *step) : nullptr;
  if (solid != nullptr) {
    body.add(solid->solid->mesh);
  } else {
    for (const PartId id : partsIn(document, root)) addPart(body, document, derived, id, false);
  }
  return body;
}

Operand rootWith(const document::Document& document, PartId part) {
  const document::Step* root = rootOf(document, {part, {}});
  return root ? Operand{{}, root->id} : Operand{part, {}};
}

/// What is moved, each solid of it as a whole.
Body bodyOf(const document::Document& document, const pipeline::Derived& derived, std::span<const PartId> parts) {
  Body body;
  std::vector<StepId> seen;
  for (const PartId id : parts) {
    const Operand root = rootWith(document, id);
    if (root.part) {
      addPart(body, document, derived, id, true);
    } else if (std::ranges::count(seen, root.step) == 0) {
      seen.push_back(root.step);
      for (mesh::TriMesh& mesh : bodyOf(document, derived, root).meshes) body.add(std::move(mesh));
    }
  }
  return body;
}

/// Where each thing that is none of `parts` comes first in the list, and whether that is below them.
struct Neighbour {
  Operand root;
  bool below;
};
std::vector<Neighbour> neighboursOf(const document::Document& document, std::span<const PartId> parts) {
  std::vector<Neighbour> out;
  bool passed = false;
  for (const document::Part& part : document.parts) {
    if (std::ranges::count(parts, part.id) > 0) {
      passed = true;
      continue;
    }
    const Operand root = rootWith(document, part.id);
    if (std::ranges::find(out, root, &Neighbour::root) == out.end()) out.push_back({root, passed});
  }
  return out;
}

/// The greatest z of WorldSpace times `sign` at the middles of the cells of `area`; kNothing where nothing is.
using Field = std::vector<double>;
void raise(Field& field, const WorldBounds& area, const std::array<WorldPoint, 3>& t, double sign) {
  static constexpr double kN = kCells;
  const double width = (area.high.x - area.low.x) / kN, height = (area.high.y - area.low.y) / kN;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto from = [](double v) { return static_cast<std::size_t>(std::clamp(std::ceil(v - 0.5), 0.0, kN)); };
  const auto to = [](double v) { return static_cast<std::size_t>(std::clamp(std::floor(v + 0.5), 0.0, kN)); };
  const double twice = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  if (twice == 0) return;
  for (std::size_t row = from((low - area.low.y) / height); row < to((high - area.low.y) / height); ++row) {
    const double y = area.low.y + (static_cast<double>(row) + 0.5) * height;
    for (std::size_t i = from((left - area.low.x) / width); i < to((right - area.low.x) / width); ++i) {
      const double x = area.low.x + (static_cast<double>(i) + 0.5) * width;
      const double b = ((x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (y - t[0].y)) / twice;
      const double c = ((t[1].x - t[0].x) * (y - t[0].y) - (x - t[0].x) * (t[1].y - t[0].y)) / twice;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const double z = t[0].z + b * (t[1].z - t[0].z) + c * (t[2].z - t[0].z);
      field[row * kCells + i] = std::max(field[row * kCells + i], sign * z);
    }
  }
}

Field fieldOf(const Body& body, const WorldBounds& area, double sign) {
  Field field(kCells * kCells, kNothing);
  for (const mesh::TriMesh& mesh : body.meshes) {
    const auto at = [&](std::uint32_t i) {
      const auto& p = mesh.positions[i];
      return WorldPoint{p[0], p[1], p[2]};
    };
    for (const auto& [a, b, c] : mesh.triangles) raise(field, area, {at(a), at(b), at(c)}, sign);
  }
  return field;
}

/// How far `own` goes along `sign` · z until it is past `other` but for a little. None where they have no place of
/// the picture plane in common.
std::optional<double> wayPast(const Body& own, const Body& other, double sign) {
  if (!own.bounds || !other.bounds) return std::nullopt;
  const WorldBounds &a = *own.bounds, &b = *other.bounds;
  const WorldBounds area{{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), 0},
                         {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), 0}};
  if (!(area.low.x < area.high.x) || !(area.low.y < area.high.y)) return std::nullopt;
  // The far side of what is passed against the near side of what passes it.
  const Field far = fieldOf(other, area, sign), near = fieldOf(own, area, -sign);
  double way = kNothing;
  for (std::size_t i = 0; i < far.size(); ++i) {
    if (far[i] != kNothing && near[i] != kNothing) way = std::max(way, far[i] + near[i]);
  }
  if (way == kNothing) return std::nullopt;
  return way - kReach * std::min(a.high.z - a.low.z, b.high.z - b.low.z);
}

std::string nameOf(const document::Document& document, Operand root) {
  if (const document::Step* step = document::findStep(document, root.step)) return step->name;
  const document::Part* part = document::findPart(document, root.part);
  return part ? part->name : std::string();
}

/// All that a solid is made of, or nothing of it.
bool wholeSolids(const document::Document& document, std::span<const PartId> parts) {
  return std::ranges::all_of(parts, [&](PartId id) {
    return std::ranges::all_of(partsIn(document, rootWith(document, id)),
                               [&](PartId other) { return std::ranges::count(parts, other) > 0; });
  });
}

}  // namespace

std::optional<DepthMove> depthMove(const document::Document& before, const document::Document& after,
                                   const pipeline::Derived& derived, std::span<const PartId> parts) {
  if (!wholeSolids(before, parts)) return std::nullopt;
  const Body own = bodyOf(before, derived, parts);
  const std::vector<Neighbour> was = neighboursOf(before, parts), is = neighboursOf(after, parts);
  std::optional<DepthMove> best;
  for (const Neighbour& one : is) {
    const auto old = std::ranges::find(was, one.root, &Neighbour::root);
    if (old == was.end() || old->below == one.below) continue;
    const double sign = one.below ? 1 : -1;
    const std::optional<double> way = wayPast(own, bodyOf(before, derived, one.root), sign);
    if (!way || *way <= kLevel || (best && *way <= std::abs(best->by))) continue;
    best = DepthMove{sign * *way, nameOf(before, one.root)};
  }
  return best;
}

}  // namespace spineloft::app
