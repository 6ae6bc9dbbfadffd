#include "web/edit/redrawn_outline.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <span>
#include <utility>

#include "engine/geometry/line_distance.h"
#include "engine/geometry/polyline.h"
#include "engine/mesh/topology.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kPlaces = 24;

/// Edges between triangles that face the eye and those that do not: closed lines on the surface.
class Silhouette {
 public:
  Silhouette(const PulledPart& part, const UiState& ui) : mesh_(part.shape->mesh), seen_(mesh_.positions.size()) {
    for (std::size_t v = 0; v < seen_.size(); ++v) {
      seen_[v] = pointOnCanvas(ui.camera, ui.layout.solid, part.toWorld()(mesh_.positions[v]));
    }
    const ModelPoint eye = part.toWorld().toModel(ui.camera.eye());
    const mesh::Twins twins = mesh::findTwins(mesh_);
    for (std::uint32_t half = 0; half < twins.of.size(); ++half) {
      const std::uint32_t across = twins.of[half];
      if (across == mesh::kNone || !faces(half / 3, eye) || faces(across / 3, eye)) continue;
      const std::uint32_t a = mesh::cornerVertex(mesh_, half), b = mesh::cornerVertex(mesh_, mesh::nextHalfEdge(half));
      if (!seen_[a] || !seen_[b]) continue;
      next_[a].push_back(b);
      next_[b].push_back(a);
    }
  }

  ModelPoint at(std::uint32_t vertex) const {
    const auto& p = mesh_.positions[vertex];
    return {p[0], p[1], p[2]};
  }
  ClientPoint seen(std::uint32_t vertex) const { return *seen_[vertex]; }

  std::optional<std::uint32_t> nearest(ClientPoint p, double reach) const {
    std::optional<std::uint32_t> found;
    for (const auto& [vertex, others] : next_) {
      const double away = distance(seen(vertex), p);
      if (away > reach) continue;
      reach = away;
      found = vertex;
    }
    return found;
  }

  /// Along the outline from one vertex to another, where it is long beside the stroke rather than far from it; empty:
  /// there is no way.
  std::vector<std::uint32_t> way(std::uint32_t from, std::uint32_t to, std::span<const ClientPoint> stroke) const {
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> known{{from, {0, from}}};
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0, from);
    while (!queue.empty() && queue.top().second != to) {
      const auto [cost, vertex] = queue.top();
      queue.pop();
      if (cost > known.at(vertex).first) continue;
      for (const std::uint32_t other : next_.at(vertex)) {
        const double away = geometry::distanceToLine(seen(other), stroke);
        const double sum = cost + distance(seen(vertex), seen(other)) * (1 + away);
        const auto at = known.find(other);
        if (at != known.end() && at->second.first <= sum) continue;
        known[other] = {sum, vertex};
        queue.emplace(sum, other);
      }
    }
    if (!known.contains(to)) return {};
    std::vector<std::uint32_t> out{to};
    while (out.back() != from) out.push_back(known.at(out.back()).second);
    std::ranges::reverse(out);
    return out;
  }

 private:
  bool faces(std::uint32_t triangle, ModelPoint eye) const {
    const auto& t = mesh_.triangles[triangle];
    return dot(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])), eye - at(t[0])) > 0;
  }

  const mesh::TriMesh& mesh_;
  std::vector<std::optional<ClientPoint>> seen_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> next_;
};

/// Where a place of the canvas is, as far from the eye as `beside`: ModelSpace.
ModelPoint besides(const PulledPart& part, const UiState& ui, ClientPoint at, ModelPoint beside) {
  const WorldPoint eye = ui.camera.eye(), back = ui.camera.back();
  const WorldPoint way = rayThrough(ui.camera, ui.layout.solid, at);
  const double depth = dot(part.toWorld()(beside) - eye, back) / dot(way, back);
  return part.toWorld().toModel(eye + way * depth);
}

}  // namespace

std::optional<pull::Pull> redrawnOutline(const PulledPart& part, const UiState& ui,
                                         const std::vector<ClientPoint>& stroke, double reach) {
  if (stroke.size() < 3) return std::nullopt;
  const Silhouette outline(part, ui);
  const auto from = outline.nearest(stroke.front(), reach), to = outline.nearest(stroke.back(), reach);
  if (!from || !to || *from == *to) return std::nullopt;
  const std::vector<std::uint32_t> way = outline.way(*from, *to, stroke);
  if (way.size() < 2) return std::nullopt;
  std::vector<ModelPoint> line;
  for (const std::uint32_t vertex : way) line.push_back(outline.at(vertex));
  const std::vector<ClientPoint> drawn = geometry::resample(std::span(stroke), kPlaces);
  pull::Pull made = usualPull(part, ui.edit, line);
  made.line = geometry::resample(std::span<const ModelPoint>(line), kPlaces);
  made.height = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    made.to.push_back(besides(part, ui, drawn[i], made.line[i]));
    farthest = std::max(farthest, distance(made.to[i], made.line[i]));
  }
  made.radius = std::clamp(std::max(made.radius, farthest), pull::kLeastRadius, pull::kMostRadius);
  return made;
}

}  // namespace spineloft::app
