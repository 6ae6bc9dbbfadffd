#include "engine/mesh/cut_mesh.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace spineloft::mesh {

CutMesh::CutMesh(const TriMesh& mesh) : mesh_(mesh), twins_(mesh::findTwins(mesh).of) {}

std::uint32_t CutMesh::longest(std::uint32_t triangle) const {
  const auto rank = [&](std::uint32_t half) {
    const auto [low, high] = std::pair(std::min(from(half), to(half)), std::max(from(half), to(half)));
    // In one direction for both triangles, so that rounding is the same.
    return std::tuple(distance(at(low), at(high)), low, high);
  };
  std::uint32_t best = 3 * triangle;
  for (std::uint32_t half = best + 1; half < 3 * triangle + 3; ++half) {
    if (rank(half) > rank(best)) best = half;
  }
  return best;
}

std::uint32_t CutMesh::terminal(std::uint32_t triangle) const {
  std::uint32_t half = longest(triangle);
  while (twins_[half] != kNone) {
    const std::uint32_t next = longest(twins_[half] / 3);
    if (next == twins_[half]) break;
    half = next;
  }
  return half;
}

std::uint32_t CutMesh::addVertex(std::uint32_t a, std::uint32_t b, double share) {
  const auto mixed = [&](const auto& values) {
    auto value = values[a];
    for (std::size_t i = 0; i < value.size(); ++i) {
      value[i] = static_cast<float>(values[a][i] + (values[b][i] - values[a][i]) * share);
    }
    return value;
  };
  mesh_.positions.push_back(mixed(mesh_.positions));
  if (!mesh_.uv.empty()) mesh_.uv.push_back(mixed(mesh_.uv));
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void CutMesh::pair(std::uint32_t a, std::uint32_t b) {
  if (a != kNone) twins_[a] = b;
  if (b != kNone) twins_[b] = a;
}

std::uint32_t CutMesh::halve(std::uint32_t half, std::uint32_t middle) {
  const std::uint32_t next = nextHalfEdge(half), end = from(next), beyond = from(lastHalfEdge(half));
  const auto added = static_cast<std::uint32_t>(triangles());
  const std::uint32_t outside = twins_[next];
  mesh_.triangles.push_back({middle, end, beyond});
  twins_.resize(twins_.size() + 3, kNone);
  mesh_.triangles[next / 3][next % 3] = middle;
  pair(3 * added + 1, outside);
  pair(3 * added + 2, next);
  return 3 * added;
}

std::uint32_t CutMesh::split(std::uint32_t half, double share) {
  const std::uint32_t across = twins_[half];
  if (across == kNone) return kNone;
  const std::uint32_t middle = addVertex(from(half), to(half), share);
  const std::uint32_t behind = halve(half, middle), behindAcross = halve(across, middle);
  pair(half, behindAcross);
  pair(behind, across);
  return middle;
}

bool CutMesh::slide(std::uint32_t half, double share) {
  constexpr double kSmooth = 0.985;  // cosine of an angle to the mean normal
  constexpr double kThinnest = 0.2;  // of a triangle's area: less is not left of it
  const std::uint32_t v = from(half);
  std::vector<std::pair<std::uint32_t, ModelPoint>> fan;
  ModelPoint mean{};
  std::uint32_t h = half;
  do {
    fan.emplace_back(h / 3, areaNormal(h / 3));
    mean += fan.back().second;
    h = twins_[lastHalfEdge(h)];
  } while (h != half && h != kNone);
  mean = normalized(mean);
  const auto isSmooth = [&](const auto& one) { return dot(normalized(one.second), mean) > kSmooth; };
  if (h == kNone || !std::ranges::all_of(fan, isSmooth)) return false;
  const std::uint32_t moved = addVertex(v, to(half), share);
  std::swap(mesh_.positions[v], mesh_.positions[moved]);
  const bool keeps = std::ranges::all_of(fan, [&](const auto& one) {
    const auto& [triangle, before] = one;
    return dot(areaNormal(triangle), before) > kThinnest * dot(before, before);
  });
  if (!keeps) std::swap(mesh_.positions[v], mesh_.positions[moved]);
  if (keeps && !mesh_.uv.empty()) mesh_.uv[v] = mesh_.uv[moved];
  mesh_.positions.pop_back();
  if (!mesh_.uv.empty()) mesh_.uv.pop_back();
  return keeps;
}

std::uint32_t CutMesh::splitTriangle(std::uint32_t triangle, ModelPoint p) {
  // On the way from the first corner through p to the edge beyond.
  const std::array<std::uint32_t, 3> t = mesh_.triangles[triangle];
  const ModelPoint normal = areaNormal(triangle), a = at(t[0]), b = at(t[1]), c = at(t[2]);
  const double toB = dot(cross(p - a, c - a), normal), toC = dot(cross(b - a, p - a), normal),
               all = dot(normal, normal);
  const double away = all > 0 ? (toB + toC) / all : 0;
  const std::uint32_t onEdge = addVertex(t[1], t[2], toB + toC > 0 ? std::clamp(toC / (toB + toC), 0.0, 1.0) : 0.5);
  const std::uint32_t middle = addVertex(t[0], onEdge, std::clamp(away, 0.0, 1.0));
  mesh_.positions[onEdge] = mesh_.positions[middle];  // only the way to it was wanted
  if (!mesh_.uv.empty()) mesh_.uv[onEdge] = mesh_.uv[middle];
  mesh_.positions.pop_back();
  if (!mesh_.uv.empty()) mesh_.uv.pop_back();
  const auto added = static_cast<std::uint32_t>(triangles());
  const std::uint32_t beyondB = twins_[3 * triangle + 1], beyondC = twins_[3 * triangle + 2];
  mesh_.triangles[triangle] = {t[0], t[1], onEdge};
  mesh_.triangles.push_back({t[1], t[2], onEdge});
  mesh_.triangles.push_back({t[2], t[0], onEdge});
  twins_.resize(twins_.size() + 6, kNone);
  pair(3 * added, beyondB);
  pair(3 * added + 3, beyondC);
  pair(3 * triangle + 1, 3 * added + 2);
  pair(3 * added + 1, 3 * added + 5);
  pair(3 * added + 4, 3 * triangle + 2);
  return onEdge;
}

}  // namespace spineloft::mesh
