#include "web/edit/front_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/pipeline/solid.h"

namespace spineloft::app {
namespace {

using document::Operand;
using pipeline::WorldBounds;

constexpr double kSideways = 1e-9;  // a twin that goes along in depth is mirrored by an upright plane

enum class Twin { Always, WhereItGoesAlong, Never };

void addPart(Body& body, const document::Document& document, const pipeline::Derived& derived, PartId id, Twin twin) {
  const document::Part* part = document::findPart(document, id);
  const auto shown = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
  if (part == nullptr || shown == derived.parts.end() || !shown->shape) return;
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
  if (entry == nullptr || !pipeline::isVisible(document, *part)) return;
  pipeline::Copies copies = pipeline::copiesInWorld(*part, entry->size);
  const bool against = part->mirror && std::abs(part->mirror->normal.z) > kSideways;
  if (twin == Twin::Never || (twin == Twin::WhereItGoesAlong && against)) copies.count = 1;
  for (const pipeline::ToWorld& toWorld : copies) body.add(pipeline::worldMesh(shown->shape->mesh, toWorld));
}

/// The greatest z of WorldSpace times `sign` at the middles of the cells of `area`; kNothing where nothing is.
void raise(FrontField& field, const WorldBounds& area, const std::array<WorldPoint, 3>& t, double sign) {
  static constexpr double kN = kFieldCells;
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
      field[row * kFieldCells + i] = std::max(field[row * kFieldCells + i], sign * z);
    }
  }
}

}  // namespace

void Body::add(mesh::TriMesh mesh) {
  for (const auto& p : mesh.positions) pipeline::include(bounds, {p[0], p[1], p[2]});
  meshes.push_back(std::move(mesh));
}

Operand rootWith(const document::Document& document, PartId part) {
  const document::Step* root = rootOf(document, {part, {}});
  return root ? Operand{{}, root->id} : Operand{part, {}};
}

Body bodyOf(const document::Document& document, const pipeline::Derived& derived, Operand root) {
  Body body;
  const document::Step* step = document::findStep(document, root.step);
  const pipeline::DerivedStep* solid = step ? pipeline::shownSolid(document, derived, *step) : nullptr;
  if (solid != nullptr) {
    body.add(solid->solid->mesh);
  } else {
    for (const PartId id : partsIn(document, root)) addPart(body, document, derived, id, Twin::Always);
  }
  return body;
}

Body bodyOf(const document::Document& document, const pipeline::Derived& derived, std::span<const PartId> parts) {
  Body body;
  std::vector<StepId> seen;
  for (const PartId id : parts) {
    const Operand root = rootWith(document, id);
    if (root.part) {
      addPart(body, document, derived, id, Twin::WhereItGoesAlong);
    } else if (std::ranges::count(seen, root.step) == 0) {
      seen.push_back(root.step);
      for (mesh::TriMesh& mesh : bodyOf(document, derived, root).meshes) body.add(std::move(mesh));
    }
  }
  return body;
}

Body bodyAlone(const document::Document& document, const pipeline::Derived& derived, PartId part) {
  Body body;
  addPart(body, document, derived, part, Twin::Never);
  return body;
}

FrontField fieldOf(const Body& body, const WorldBounds& area, double sign) {
  FrontField field(kFieldCells * kFieldCells, kNothing);
  for (const mesh::TriMesh& mesh : body.meshes) {
    const auto at = [&](std::uint32_t i) {
      const auto& p = mesh.positions[i];
      return WorldPoint{p[0], p[1], p[2]};
    };
    for (const auto& [a, b, c] : mesh.triangles) raise(field, area, {at(a), at(b), at(c)}, sign);
  }
  return field;
}

}  // namespace spineloft::app
