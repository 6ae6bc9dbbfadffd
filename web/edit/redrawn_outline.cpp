#include "web/edit/redrawn_outline.h"

#include <algorithm>
#include <cmath>
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
constexpr double kStretch = 8;  // CSS pixels
constexpr int kMostStretches = 200;

/// Edges between triangles that face the eye and those that do not, of one copy of a part: closed lines on its surface,
/// in stretches that are short on the canvas.
class Silhouette {
 public:
  Silhouette(const mesh::TriMesh& mesh, const pipeline::ToWorld& toWorld, const UiState& ui)
      : mesh_(mesh), toWorld_(toWorld), ui_(ui) {
    const ModelPoint eye = toWorld.toModel(ui.camera.eye());
    const mesh::Twins twins = mesh::findTwins(mesh);
    std::map<std::uint32_t, std::optional<std::uint32_t>> corners;
    const auto corner = [&](std::uint32_t vertex) {
      const auto [at, isNew] = corners.try_emplace(vertex);
      if (isNew) at->second = add(place(vertex));
      return at->second;
    };
    for (std::uint32_t half = 0; half < twins.of.size(); ++half) {
      const std::uint32_t across = twins.of[half];
      if (across == mesh::kNone || !faces(half / 3, eye) || faces(across / 3, eye)) continue;
      const std::uint32_t a = mesh::cornerVertex(mesh, half), b = mesh::cornerVertex(mesh, mesh::nextHalfEdge(half));
      const auto from = corner(a), to = corner(b);
      if (from && to) join(*from, *to);
    }
  }

  ModelPoint at(std::uint32_t node) const { return nodes_[node].at; }

  std::optional<std::uint32_t> nearest(ClientPoint p, double reach) const {
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const double away = distance(nodes_[i].seen, p);
      if (away > reach) continue;
      reach = away;
      found = i;
    }
    return found;
  }

  /// Along the outline from one node to another, where it is long beside the stroke rather than far from it; empty:
  /// there is no way.
  std::vector<std::uint32_t> way(std::uint32_t from, std::uint32_t to, std::span<const ClientPoint> stroke) const {
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> known{{from, {0, from}}};
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0, from);
    while (!queue.empty() && queue.top().second != to) {
      const auto [cost, node] = queue.top();
      queue.pop();
      if (cost > known.at(node).first) continue;
      for (const std::uint32_t other : nodes_[node].next) {
        const double away = geometry::distanceToLine(nodes_[other].seen, stroke);
        const double sum = cost + distance(nodes_[node].seen, nodes_[other].seen) * (1 + away);
        const auto at = known.find(other);
        if (at != known.end() && at->second.first <= sum) continue;
        known[other] = {sum, node};
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
  struct Node {
    ModelPoint at;
    ClientPoint seen;
    std::vector<std::uint32_t> next;
  };

  ModelPoint place(std::uint32_t vertex) const {
    const auto& p = mesh_.positions[vertex];
    return {p[0], p[1], p[2]};
  }
  bool faces(std::uint32_t triangle, ModelPoint eye) const {
    const auto& t = mesh_.triangles[triangle];
    return dot(cross(place(t[1]) - place(t[0]), place(t[2]) - place(t[0])), eye - place(t[0])) > 0;
  }
  /// None behind the eye.
  std::optional<std::uint32_t> add(ModelPoint at) {
    const auto seen = pointOnCanvas(ui_.camera, ui_.layout.solid, toWorld_(at));
    if (!seen) return std::nullopt;
    nodes_.push_back({at, *seen, {}});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  void link(std::uint32_t a, std::uint32_t b) {
    nodes_[a].next.push_back(b);
    nodes_[b].next.push_back(a);
  }
  void join(std::uint32_t from, std::uint32_t to) {
    const double length = distance(nodes_[from].seen, nodes_[to].seen);
    const int count = std::clamp(static_cast<int>(std::ceil(length / kStretch)), 1, kMostStretches);
    const ModelPoint a = nodes_[from].at, b = nodes_[to].at;
    std::uint32_t last = from;
    for (int i = 1; i < count; ++i) {
      const auto node = add(lerp(a, b, static_cast<double>(i) / count));
      if (!node) continue;
      link(last, *node);
      last = *node;
    }
    link(last, to);
  }

  const mesh::TriMesh& mesh_;
  const pipeline::ToWorld& toWorld_;
  const UiState& ui_;
  std::vector<Node> nodes_;
};

/// Where a place of the canvas is, as far from the eye as `beside`: ModelSpace.
ModelPoint besides(const pipeline::ToWorld& toWorld, const UiState& ui, ClientPoint at, ModelPoint beside) {
  const WorldPoint eye = ui.camera.eye(), back = ui.camera.back();
  const WorldPoint way = rayThrough(ui.camera, ui.layout.solid, at);
  const double depth = dot(toWorld(beside) - eye, back) / dot(way, back);
  return toWorld.toModel(eye + way * depth);
}

std::optional<pull::Pull> ofCopy(const PulledPart& part, const pipeline::ToWorld& toWorld, const UiState& ui,
                                 const std::vector<ClientPoint>& stroke, double reach) {
  const Silhouette outline(part.shape->mesh, toWorld, ui);
  const auto from = outline.nearest(stroke.front(), reach), to = outline.nearest(stroke.back(), reach);
  if (!from || !to || *from == *to) return std::nullopt;
  const std::vector<std::uint32_t> way = outline.way(*from, *to, stroke);
  if (way.size() < 2) return std::nullopt;
  std::vector<ModelPoint> line;
  for (const std::uint32_t node : way) line.push_back(outline.at(node));
  const std::vector<ClientPoint> drawn = geometry::resample(std::span(stroke), kPlaces);
  pull::Pull made = usualPull(part, ui.edit, line);
  made.line = geometry::resample(std::span<const ModelPoint>(line), kPlaces);
  made.height = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    made.to.push_back(besides(toWorld, ui, drawn[i], made.line[i]));
    farthest = std::max(farthest, distance(made.to[i], made.line[i]));
  }
  made.radius = std::clamp(std::max(made.radius, farthest), pull::kLeastRadius, pull::kMostRadius);
  return made;
}

}  // namespace

std::optional<pull::Pull> redrawnOutline(const PulledPart& part, const UiState& ui,
                                         const std::vector<ClientPoint>& stroke, double reach) {
  if (stroke.size() < 3) return std::nullopt;
  for (const pipeline::ToWorld& toWorld : part.copies) {
    if (auto made = ofCopy(part, toWorld, ui, stroke, reach)) return made;
  }
  return std::nullopt;
}

}  // namespace spineloft::app
