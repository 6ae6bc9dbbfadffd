#include "engine/mesh/soften.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "engine/base/vec.h"
#include "engine/mesh/topology.h"

namespace spineloft::mesh {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

ModelPoint at(const TriMesh& mesh, std::uint32_t v) {
  const auto& p = mesh.positions[v];
  return {p[0], p[1], p[2]};
}

/// Neighbours along edges with their weights, and areas.
struct Stiffness {
  struct Edge {
    std::uint32_t to = 0;
    double weight = 0;  ///< half the cotangents of both sides
  };
  std::vector<std::vector<Edge>> edges;
  std::vector<double> areas;  ///< a third of the triangles'
};

Stiffness stiffnessOf(const TriMesh& mesh) {
  Stiffness out{std::vector<std::vector<Stiffness::Edge>>(mesh.positions.size()),
                std::vector<double>(mesh.positions.size(), 0.0)};
  const auto add = [&](std::uint32_t from, std::uint32_t to, double weight) {
    auto& own = out.edges[from];
    const auto known = std::ranges::find(own, to, &Stiffness::Edge::to);
    known == own.end() ? own.push_back({to, weight}) : void(known->weight += weight);
  };
  for (const auto& t : mesh.triangles) {
    const double twice = norm(cross(at(mesh, t[1]) - at(mesh, t[0]), at(mesh, t[2]) - at(mesh, t[0])));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      const double along = dot(at(mesh, a) - at(mesh, t[i]), at(mesh, b) - at(mesh, t[i]));
      const double weight = twice > 0 ? along / (2 * twice) : 0;
      add(a, b, weight);
      add(b, a, weight);
      out.areas[t[i]] += twice / 6;
    }
  }
  return out;
}

/// The ways along edges from the crease, as far as `reach`; infinite beyond.
std::vector<double> waysFrom(const TriMesh& mesh, const std::vector<std::uint32_t>& crease, double reach) {
  std::vector<std::vector<std::uint32_t>> next(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) next[t[i]].push_back(t[(i + 1) % 3]);  // of a closed mesh all edges
  }
  std::vector<double> ways(mesh.positions.size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, std::uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  const auto offer = [&](std::uint32_t v, double way) {
    if (way >= ways[v] || way > reach) return;
    ways[v] = way;
    queue.push({way, v});
  };
  for (const std::uint32_t v : crease) offer(v, 0);
  while (!queue.empty()) {
    const auto [way, v] = queue.top();
    queue.pop();
    if (way > ways[v]) continue;
    for (const std::uint32_t to : next[v]) offer(to, way + distance(at(mesh, v), at(mesh, to)));
  }
  return ways;
}

/// Of each edge the cosine between its triangles, at its half-edges; 1 where it has no two.
std::vector<double> bendsOf(const TriMesh& mesh, const Twins& twins) {
  std::vector<ModelPoint> normals;
  for (const auto& t : mesh.triangles) {
    normals.push_back(normalized(cross(at(mesh, t[1]) - at(mesh, t[0]), at(mesh, t[2]) - at(mesh, t[0]))));
  }
  std::vector<double> bends(twins.of.size(), 1.0);
  for (std::uint32_t h = 0; h < twins.of.size(); ++h) {
    if (twins.of[h] != kNone) bends[h] = dot(normals[h / 3], normals[twins.of[h] / 3]);
  }
  return bends;
}

/// By vertex: it is on a sharp edge that stays, as of a flat end.
std::vector<bool> onRims(const TriMesh& mesh, const std::vector<std::uint32_t>& regions) {
  constexpr double kSharp = 0.5;  // cosine
  const std::vector<double> bends = bendsOf(mesh, findTwins(mesh));
  std::vector<bool> rims(regions.size(), false);
  for (std::uint32_t h = 0; h < bends.size(); ++h) {
    const std::uint32_t a = cornerVertex(mesh, h), b = cornerVertex(mesh, nextHalfEdge(h));
    if (regions[a] == kFixed && regions[b] == kFixed && bends[h] < kSharp) rims[a] = rims[b] = true;
  }
  return rims;
}

/// The crease with the vertices on the sharp edges of its region, also on those that end at a fixed vertex.
void takeInSharp(const TriMesh& mesh, const std::vector<std::uint32_t>& regions, Crease& crease) {
  constexpr double kSharp = 0.966;  // cosine
  const std::vector<double> bends = bendsOf(mesh, findTwins(mesh));
  std::vector<bool> own(mesh.positions.size()), found(mesh.positions.size(), false);
  for (std::size_t v = 0; v < own.size(); ++v) own[v] = crease.region != 0 && regions[v] == crease.region;
  for (const std::uint32_t v : crease.vertices) own[v] = found[v] = true;
  const auto belongs = [&](std::uint32_t v) { return own[v] || regions[v] == kFixed; };
  for (std::uint32_t h = 0; h < bends.size(); ++h) {
    const std::uint32_t a = cornerVertex(mesh, h), b = cornerVertex(mesh, nextHalfEdge(h));
    if (bends[h] < kSharp && (own[a] || own[b]) && belongs(a) && belongs(b)) found[a] = found[b] = true;
  }
  crease.vertices.clear();
  for (std::uint32_t v = 0; v < found.size(); ++v) {
    if (found[v]) crease.vertices.push_back(v);
  }
}

/// Splits edges in the middle, and the triangles beside them.
class Splitter {
 public:
  Splitter(TriMesh& mesh, std::vector<Crease>& creases, std::vector<std::uint32_t>& regions)
      : mesh_(mesh), creases_(creases), regions_(regions), isCrease_(creases.size()) {
    for (std::size_t i = 0; i < creases.size(); ++i) {
      isCrease_[i].resize(mesh.positions.size(), false);
      for (const std::uint32_t v : creases[i].vertices) isCrease_[i][v] = true;
    }
  }

  /// All edges within `ways` that are longer than `longest`, once. False: there are none.
  bool split(const std::vector<double>& ways, double longest) {
    middles_.clear();
    for (const auto& t : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (std::isfinite(ways[a]) && std::isfinite(ways[b]) && distance(at(mesh_, a), at(mesh_, b)) > longest) {
          addMiddle(a, b);
        }
      }
    }
    return splitAtMiddles();
  }

  /// The edges of all triangles that meet at more than the angle of this cosine near a crease when the vertices are
  /// where `bent` has them, once; edges between fixed vertices stay whole. False: there are none.
  bool splitBent(const TriMesh& bent, double sharp) {
    middles_.clear();
    const std::vector<double> bends = bendsOf(bent, findTwins(bent));
    const auto isFixed = [&](std::uint32_t h) {
      return regions_[cornerVertex(bent, h)] == kFixed && regions_[cornerVertex(bent, nextHalfEdge(h))] == kFixed;
    };
    std::vector<bool> near(bent.positions.size(), false);
    for (const Crease& crease : creases_) {
      const std::vector<double> ways = waysFrom(bent, crease.vertices, crease.reach);
      for (std::size_t v = 0; v < near.size(); ++v) near[v] = near[v] || std::isfinite(ways[v]);
    }
    for (std::uint32_t h = 0; h < bends.size(); ++h) {
      if (bends[h] >= sharp || isFixed(h) || !near[cornerVertex(bent, h)]) continue;
      for (std::uint32_t i = h - h % 3; i < h - h % 3 + 3; ++i) {
        if (!isFixed(i)) addMiddle(cornerVertex(bent, i), cornerVertex(bent, nextHalfEdge(i)));
      }
    }
    return splitAtMiddles();
  }

 private:
  bool splitAtMiddles() {
    if (middles_.empty()) return false;
    const std::vector<std::array<std::uint32_t, 3>> old = std::exchange(mesh_.triangles, {});
    for (const auto& t : old) splitTriangle(t);
    return true;
  }
  static std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    if (a == b || b == 0 || b == kFixed) return a == kFixed ? b : a;
    return a == 0 || a == kFixed ? b : 0;
  }
  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
  }
  void addMiddle(std::uint32_t a, std::uint32_t b) {
    if (!middles_.emplace(keyOf(a, b), static_cast<std::uint32_t>(mesh_.positions.size())).second) return;
    const auto &p = mesh_.positions[a], &q = mesh_.positions[b];
    mesh_.positions.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    if (!mesh_.uv.empty()) {
      const auto &s = mesh_.uv[a], &t = mesh_.uv[b];
      mesh_.uv.push_back({(s[0] + t[0]) / 2, (s[1] + t[1]) / 2});
    }
    regions_.push_back(between(regions_[a], regions_[b]));
    for (std::size_t i = 0; i < creases_.size(); ++i) {
      std::vector<bool>& on = isCrease_[i];
      on.push_back(on[a] && on[b]);
      if (on.back()) creases_[i].vertices.push_back(static_cast<std::uint32_t>(mesh_.positions.size() - 1));
    }
  }
  std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b) const {
    const auto known = middles_.find(keyOf(a, b));
    return known == middles_.end() ? std::nullopt : std::optional(known->second);
  }
  void splitTriangle(std::array<std::uint32_t, 3> t) {
    // The corner first of which the opposite edge is whole, or, where one edge is cut, the one behind that.
    for (int turn = 0; turn < 3; ++turn, std::ranges::rotate(t, t.begin() + 1)) {
      const auto ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      auto& out = mesh_.triangles;
      if (!ab && !bc && !ca) {
        out.push_back(t);
      } else if (ab && bc && ca) {
        out.insert(out.end(), {{t[0], *ab, *ca}, {*ab, t[1], *bc}, {*ca, *bc, t[2]}, {*ab, *bc, *ca}});
      } else if (ab && !bc && !ca) {
        out.insert(out.end(), {{t[0], *ab, t[2]}, {*ab, t[1], t[2]}});
      } else if (ab && !bc && ca) {
        out.push_back({t[0], *ab, *ca});
        if (distance(at(mesh_, *ab), at(mesh_, t[2])) < distance(at(mesh_, t[1]), at(mesh_, *ca))) {
          out.insert(out.end(), {{*ab, t[1], t[2]}, {*ab, t[2], *ca}});
        } else {
          out.insert(out.end(), {{*ab, t[1], *ca}, {t[1], t[2], *ca}});
        }
      } else {
        continue;
      }
      return;
    }
  }

  TriMesh& mesh_;
  std::vector<Crease>& creases_;
  std::vector<std::uint32_t>& regions_;
  std::vector<std::vector<bool>> isCrease_;  ///< by crease and vertex
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

/// Moves what is free to where the surface is fair.
void fair(TriMesh& mesh, const std::vector<double>& ways, const std::vector<std::uint32_t>& regions, double reach) {
  const Stiffness stiffness = stiffnessOf(mesh);
  const std::vector<bool> rims = onRims(mesh, regions);
  std::vector<int> index(mesh.positions.size(), -1);
  std::vector<std::uint32_t> free;
  for (std::uint32_t v = 0; v < index.size(); ++v) {
    if (!(ways[v] < reach) || regions[v] == kFixed || !(stiffness.areas[v] > 0)) continue;
    index[v] = static_cast<int>(free.size());
    free.push_back(v);
  }
  if (free.empty()) return;
  const auto n = static_cast<Eigen::Index>(free.size());
  std::vector<Eigen::Triplet<double, int>> triplets;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
  const auto row = [&](std::uint32_t v) { return Eigen::RowVector3d(at(mesh, v).x, at(mesh, v).y, at(mesh, v).z); };
  for (std::uint32_t v = 0; v < index.size(); ++v) {
    const auto& edges = stiffness.edges[v];
    const bool near = index[v] >= 0 || std::ranges::any_of(edges, [&](const auto& e) { return index[e.to] >= 0; });
    if (!near || rims[v] || !(stiffness.areas[v] > 0)) continue;
    std::vector<std::pair<std::uint32_t, double>> entries{{v, 0.0}};
    for (const auto& [to, weight] : edges) {
      entries[0].second += weight;
      entries.push_back({to, -weight});
    }
    Eigen::RowVector3d known = Eigen::RowVector3d::Zero();
    for (const auto& [to, weight] : entries) {
      if (index[to] < 0) known += weight * row(to);
    }
    const double share = 1 / stiffness.areas[v];
    for (const auto& [to, weight] : entries) {
      if (index[to] < 0) continue;
      right.row(index[to]) -= share * weight * known;
      for (const auto& [other, otherWeight] : entries) {
        if (index[other] >= 0 && index[other] <= index[to]) {
          triplets.emplace_back(index[to], index[other], share * weight * otherWeight);
        }
      }
    }
  }
  constexpr double kPull = 400;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double pull = kPull * std::pow(ways[free[i]] / reach, 4) * stiffness.areas[free[i]] / std::pow(reach, 4);
    triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), pull);
    right.row(static_cast<Eigen::Index>(i)) += pull * row(free[i]);
  }
  Sparse system(n, n);
  system.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(system);
  if (factor.info() != Eigen::Success) return;
  const Eigen::MatrixX3d moved = factor.solve(right);
  if (!moved.allFinite()) return;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto place = moved.row(static_cast<Eigen::Index>(i));
    mesh.positions[free[i]] = {static_cast<float>(place[0]), static_cast<float>(place[1]),
                               static_cast<float>(place[2])};
  }
}

}  // namespace

void soften(TriMesh& mesh, std::vector<Crease> creases, std::vector<std::uint32_t>& regions) {
  constexpr double kLongest = 0.35, kMargin = 1.25;  // of the reach
  constexpr double kSharp = 0.866;                   // cosine
  constexpr int kMostRounds = 6;
  for (Crease& crease : creases) takeInSharp(mesh, regions, crease);
  Splitter splitter(mesh, creases, regions);
  for (const Crease& crease : creases) {
    for (int round = 0; round < kMostRounds; ++round) {
      if (!splitter.split(waysFrom(mesh, crease.vertices, kMargin * crease.reach), kLongest * crease.reach)) break;
    }
  }
  const auto faired = [&] {
    TriMesh out = mesh;
    for (const Crease& crease : creases) {
      fair(out, waysFrom(out, crease.vertices, crease.reach), regions, crease.reach);
    }
    return out;
  };
  TriMesh bent = faired();
  // What is still sharp bends more than its triangles can follow.
  mesh = splitter.splitBent(bent, kSharp) ? faired() : std::move(bent);
}

}  // namespace spineloft::mesh
