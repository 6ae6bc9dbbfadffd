#include "engine/inflate/boned_mesh.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "engine/geometry/spread.h"

namespace spineloft::inflate {
namespace {

using geometry::PlaneMesh;

constexpr double kLattice = 1.25;  ///< spacing that spreadPoints makes one spacing of
constexpr int kRounds = 8;         ///< of splitting edges

/// A mesh point at p, new or there already.
std::optional<std::uint32_t> pointAt(PlaneMesh& mesh, SectionPoint p) {
  if (const auto added = mesh.insert(p)) return added;
  const auto found = mesh.find(p);
  if (!found) return std::nullopt;
  const auto& t = mesh.triangles()[*found];
  const auto away = [&](std::uint32_t corner) { return distance(mesh.points()[corner], p); };
  const std::uint32_t nearest = *std::ranges::min_element(t, {}, away);
  const bool inner = nearest >= mesh.rim();
  return inner ? std::optional(nearest) : std::nullopt;
}

/// Makes every edge of the skeleton an edge of the mesh by splitting those that are not.
bool conform(Boned& boned, bool splitChords) {
  for (int round = 0; round < kRounds; ++round) {
    if (splitChords) boned.mesh.splitChords();
    boned.width.resize(boned.mesh.points().size());
    std::unordered_set<std::uint64_t> edges;
    edges.reserve(3 * boned.mesh.triangles().size());
    for (const auto& [a, b, c] : boned.mesh.triangles()) {
      edges.insert(edgeKey(a, b));
      edges.insert(edgeKey(b, c));
      edges.insert(edgeKey(c, a));
    }
    std::vector<std::array<std::uint32_t, 2>> next;
    bool whole = true;
    for (const auto& [a, b] : boned.edges) {
      if (edges.contains(edgeKey(a, b))) {
        next.push_back({a, b});
        continue;
      }
      whole = false;
      const auto middle = pointAt(boned.mesh, (boned.mesh.points()[a] + boned.mesh.points()[b]) / 2);
      if (!middle || *middle == a || *middle == b) return false;
      boned.width.resize(boned.mesh.points().size());
      const Boned::Width one = boned.width[a], other = boned.width[b];
      boned.width[*middle] = {(one.radius + other.radius) / 2, lerp(one.over, other.over, 0.5)};
      next.push_back({a, *middle});
      next.push_back({*middle, b});
    }
    boned.edges = std::move(next);
    if (whole) return true;
  }
  return false;
}

}  // namespace

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

std::optional<Boned> bonedMesh(const geometry::PlaneRegion& rim, const Bones& bones, double spacing) {
  Boned boned{PlaneMesh(rim.points, rim.sizes), {}, {}};
  if (boned.mesh.empty()) return std::nullopt;
  constexpr double kAll = 1e-3;  // of the spacing: nearer ones are left out
  std::vector<SectionPoint> features;
  for (const SkeletonPoint& p : bones.points) features.push_back(p.at);
  if (spacing > 0) {
    geometry::spreadPoints(
        boned.mesh, rim.sizes, {kAll * spacing, kLattice * spacing},
        {[](std::size_t) { return std::vector<double>{}; }, [](SectionPoint) { return 0.0; }, features});
  }
  // Features come first and keep their order; one that was refused lies on another point.
  std::vector<std::uint32_t> index;
  std::uint32_t at = static_cast<std::uint32_t>(boned.mesh.rim());
  for (const SectionPoint p : features) {
    if (at < boned.mesh.points().size() && boned.mesh.points()[at] == p) {
      index.push_back(at++);
      continue;
    }
    const auto there = pointAt(boned.mesh, p);
    if (!there) return std::nullopt;
    index.push_back(*there);
  }
  boned.width.assign(boned.mesh.points().size(), {});
  for (std::size_t i = 0; i < index.size(); ++i) boned.width[index[i]] = {bones.points[i].radius, bones.points[i].over};
  for (const auto& [a, b] : bones.edges) {
    if (index[a] != index[b]) boned.edges.push_back({index[a], index[b]});
  }
  if (!conform(boned, spacing > 0)) return std::nullopt;
  return boned;
}

}  // namespace spineloft::inflate
