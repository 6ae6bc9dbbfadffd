// pullStage: after a shape is made, before its relief.
#include <memory>
#include <new>
#include <utility>

#include "engine/pipeline/cache.h"
#include "engine/pipeline/keys.h"
#include "engine/pipeline/part_shape.h"
#include "engine/pull/pull.h"

namespace spineloft::pipeline {
namespace {

ModelPoint vertexOf(const mesh::TriMesh& mesh, std::uint32_t vertex) {
  const auto& p = mesh.positions[vertex];
  return {p[0], p[1], p[2]};
}

PulledLine lineOf(const pull::Reach& reach, const mesh::TriMesh& mesh, double share) {
  PulledLine line;
  line.share = share;
  for (const std::uint32_t vertex : reach.line) line.points.push_back(vertexOf(mesh, vertex));
  line.ring = reach.ring;
  line.out = reach.out;
  return line;
}

Result<std::shared_ptr<const pull::Reach>> knownReach(const mesh::TriMesh& mesh, const pull::Pull& pull,
                                                      ShapeKey before, Cache& cache) {
  const ReachKey key = before ? reachKey(before, pull) : ReachKey{};
  if (auto known = key ? cache.reach(key) : nullptr) return known;
  Result<pull::Reach> made = pull::reachOf(mesh, pull);
  if (!made) return made.failure();
  auto reach = std::make_shared<const pull::Reach>(std::move(made).value());
  if (key) cache.keepReach(key, reach);
  return reach;
}

}  // namespace

Status pullStage(std::span<const pull::Pull> pulls, ShapeKey before, TraceQuality quality, Cache& cache,
                 PartShape& shape) {
  try {
    mesh::TriMesh mesh = shape.mesh, pulled;
    std::vector<PulledLine> lines;
    for (const pull::Pull& pull : pulls) {
      const auto reach = knownReach(mesh, pull, before, cache);
      if (!reach) return reach.failure();
      double share = 1;
      if (quality == TraceQuality::Live) {
        pull::moveMesh(*reach.value(), pull, pulled);
      } else {
        share = pull::pullMesh(*reach.value(), pull, pulled);
      }
      lines.push_back(lineOf(*reach.value(), pulled, share));
      std::swap(mesh, pulled);
      if (before) before = pulledKey(before, pull, share);
    }
    shape.mesh = std::move(mesh);
    shape.pulled = std::move(lines);
    if (quality == TraceQuality::Live) shape.quality = quality;
    return Done{};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::pipeline
