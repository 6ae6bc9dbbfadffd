#include "engine/descriptive/prism.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/descriptive/axes.h"

namespace spineloft::descriptive {
namespace {

using Corner = std::uint32_t;

/// By corner of a face, the one to which its edge off the face leads; empty where it is no base of a prism.
std::map<Corner, Corner> edgesBack(const Wireframe& solid, const Wireframe::Face& base) {
  const auto isBase = [&](Corner c) { return std::ranges::find(base, c) != base.end(); };
  std::map<Corner, Corner> out;
  std::set<Corner> others;
  std::size_t edges = 0;
  for (const Wireframe::Face& face : solid.faces) {
    edges += face.size();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Corner a = face[i], b = face[(i + 1) % face.size()];
      if (!isBase(a)) others.insert(a);
      if (isBase(a) && !isBase(b) && !out.try_emplace(a, b).second && out[a] != b) return {};
    }
  }
  const std::size_t n = base.size();
  const bool isPrism = out.size() == n && others.size() == n && edges == 6 * n && solid.faces.size() == n + 2;
  return isPrism ? out : std::map<Corner, Corner>{};
}

bool hasLevelEdge(const Wireframe& solid, const Wireframe::Face& face) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const PicturePoint way = solid.corners[face[(i + 1) % face.size()]] - solid.corners[face[i]];
    if (std::abs(way.y) < 0.105 * std::abs(way.x)) return true;
  }
  return false;
}

ModelPoint upOf(const FacedSolid& solid) {
  ModelPoint best{0, 1, 0};
  double most = -1;
  for (const Wireframe::Face& face : solid.faces) {
    const ModelPoint normal = normalOf(solid, face);
    if (-normal.y <= most) continue;
    most = -normal.y;
    best = normal * -1.0;
  }
  return best;
}

}  // namespace

std::optional<FacedSolid> prismOf(const Wireframe& wireframe, const DepthScale& scale, bool level) {
  for (std::size_t f = 0; f < wireframe.faces.size(); ++f) {
    const auto back = wireframe.isFront[f] ? edgesBack(wireframe, wireframe.faces[f]) : std::map<Corner, Corner>{};
    if (back.empty() || (level && !hasLevelEdge(wireframe, wireframe.faces[f]))) continue;
    const auto drawn = [&](Corner c) { return scale.of(wireframe.corners[c]); };
    SectionPoint way{};
    for (const auto& [from, to] : back) way += (drawn(to) - drawn(from)) / static_cast<double>(back.size());
    const double length = norm(way);
    const bool isOneWay = std::ranges::all_of(back, [&](const auto& edge) {
      const SectionPoint one = drawn(edge.second) - drawn(edge.first);
      return dot(one, way) > std::cos(kOneDirection) * norm(one) * length;
    });
    if (!isOneWay) continue;
    constexpr double kSine = 0.5;
    const double cosine = std::sqrt(1 - kSine * kSine);
    const SectionPoint along = way / length;
    // About the middle of the base, so that corners move as little as they can.
    const auto alongOf = [&](Corner c) { return dot(drawn(c), along); };
    const Wireframe::Face& base = wireframe.faces[f];
    const double middle =
        (alongOf(std::ranges::min(base, {}, alongOf)) + alongOf(std::ranges::max(base, {}, alongOf))) / 2;
    FacedSolid out;
    out.faces = wireframe.faces;
    out.corners.resize(wireframe.corners.size());
    for (const auto& [from, to] : back) {
      const double t = alongOf(from) - middle;
      const SectionPoint p = drawn(from) - along * (t * (1 - cosine));
      out.corners[from] = {p.x, p.y, t * kSine};
      out.corners[to] = {p.x + way.x, p.y + way.y, t * kSine - length * cosine / kSine};
    }
    double mean = 0;
    for (const ModelPoint& p : out.corners) mean += p.z / static_cast<double>(out.corners.size());
    for (std::size_t i = 0; i < out.corners.size(); ++i) {
      out.corners[i].z -= mean;
      const SectionPoint at{out.corners[i].x, out.corners[i].y};
      out.moved = std::max(out.moved, distance(at, drawn(static_cast<Corner>(i))));
    }
    out.up = upOf(out);
    return out;
  }
  return std::nullopt;
}

}  // namespace spineloft::descriptive
