#include "web/edit/picker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/mesh/ray_hit.h"
#include "web/edit/placing.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kRun = 64;  // triangles a box

WorldPoint normalOf(const mesh::TriMesh& mesh, std::size_t triangle, const pipeline::ToWorld& toWorld) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const WorldPoint at = toWorld(mesh.positions[a]);
  const WorldPoint out = cross(toWorld(mesh.positions[b]) - at, toWorld(mesh.positions[c]) - at);
  return normalized(toWorld.flips ? -out : out);
}

/// How far along the ray the box begins (0 inside it); infinite when the ray misses it.
template <class Box>
double toBox(const Box& box, ModelPoint eye, ModelPoint direction) {
  const std::array<double, 3> from{eye.x, eye.y, eye.z}, way{direction.x, direction.y, direction.z};
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (way[k] == 0) {
      const bool outside = from[k] < static_cast<double>(box.low[k]) || from[k] > static_cast<double>(box.high[k]);
      if (outside) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double a = (static_cast<double>(box.low[k]) - from[k]) / way[k];
    const double b = (static_cast<double>(box.high[k]) - from[k]) / way[k];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far ? near : std::numeric_limits<double>::infinity();
}

}  // namespace

const Picker::Entry& Picker::entryOf(const std::shared_ptr<const pipeline::PartShape>& shape) {
  std::erase_if(entries_, [](const Entry& entry) { return entry.shape.expired(); });
  for (const Entry& entry : entries_) {
    if (!entry.shape.owner_before(shape) && !shape.owner_before(entry.shape)) return entry;
  }
  constexpr float kFar = std::numeric_limits<float>::max();
  const Box none{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  Entry entry{shape, none, {}};
  const auto grow = [](Box& box, const std::array<float, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  };
  const mesh::TriMesh& mesh = shape->mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % kRun == 0) entry.runs.push_back(none);
    for (const std::uint32_t corner : mesh.triangles[i]) {
      grow(entry.runs.back(), mesh.positions[corner]);
      grow(entry.whole, mesh.positions[corner]);
    }
  }
  entries_.push_back(std::move(entry));
  return entries_.back();
}

RayHit Picker::firstHit(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                        const Ray& ray, std::span<const PartId> without) {
  RayHit best;
  // In ModelSpace of each part; lengths along the ray stay comparable, as its direction is scaled.
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const document::Part& part = document.parts[i];
    const auto& shape = derived.parts[i].shape;
    const document::PictureEntry* picture = document::findPicture(document, document::pictureOf(part));
    if (!shape || !showsItself(document, derived, part) || picture == nullptr) continue;
    if (std::ranges::count(without, part.id) > 0) continue;
    const Entry& entry = entryOf(shape);
    for (const pipeline::ToWorld& toWorld : shownCopies(ui, part, picture->size)) {
      const ModelPoint eye = toWorld.toModel(ray.eye);
      const ModelPoint direction = toWorld.alongInModel(ray.direction);
      if (!(toBox(entry.whole, eye, direction) < nearest)) continue;
      for (std::size_t run = 0; run < entry.runs.size(); ++run) {
        if (!(toBox(entry.runs[run], eye, direction) < nearest)) continue;
        const std::size_t last = std::min((run + 1) * kRun, shape->mesh.triangles.size());
        const mesh::RayHit hit = mesh::firstHit(shape->mesh, eye, direction, run * kRun, last);
        if (hit.far >= nearest) continue;
        nearest = hit.far;
        best = {part.id, ray.eye + ray.direction * hit.far, normalOf(shape->mesh, hit.triangle, toWorld)};
      }
    }
  }
  for (const document::Step& step : document.steps) {
    const pipeline::DerivedStep* shown = shownSolid(document, derived, step);
    if (shown == nullptr) continue;
    const ModelPoint eye{ray.eye.x, ray.eye.y, ray.eye.z}, direction{ray.direction.x, ray.direction.y, ray.direction.z};
    for (const pipeline::SolidPiece& piece : shown->solid->pieces) {
      if (std::ranges::count(without, piece.part) > 0) continue;
      const mesh::RayHit hit = mesh::firstHit(piece.mesh, eye, direction);
      if (hit.far >= nearest) continue;
      nearest = hit.far;
      best = {piece.part, ray.eye + ray.direction * hit.far, normalOf(piece.mesh, hit.triangle, pipeline::ToWorld{})};
    }
  }
  return best;
}

}  // namespace spineloft::app
