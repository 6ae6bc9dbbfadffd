#include "engine/loft/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polygon.h"
#include "engine/geometry/triangulate.h"
#include "engine/loft/loft.h"
#include "engine/mesh/laws.h"

namespace spineloft::loft {
namespace {

/// A ring of the surface: a station, shrunk towards the section's centre for an inner wall.
struct Ring {
  Station station;
  double scale = 1;
};

/// All rings in the order in which the surface runs through them, from its start to its end; the
/// start and end are closed by tips or lids, or joined to each other.
struct RingPath {
  std::vector<Ring> rings;
  bool joined = false;
};

/// Inner rings of a mouth at the front of `stations`, from the mouth inwards to the floor.
std::vector<Ring> mouthRings(std::span<const Station> stations) {
  constexpr double kInner = 1 - kWall;
  std::vector<double> along(stations.size(), 0.0);
  for (std::size_t i = 1; i < stations.size(); ++i) {
    along[i] = along[i - 1] + distance(stations[i - 1].chord.middle(), stations[i].chord.middle());
  }
  const double floor = kMouthDepth * along.back();
  std::vector<Ring> rings;
  std::size_t i = 0;
  // A ring just before the floor would leave slivers: skip it.
  for (; i + 1 < stations.size() && along[i] <= 0.98 * floor; ++i)
    rings.push_back({stations[i], kInner});
  const Station& a = stations[i - 1];
  const Station& b = stations[i];
  const double step = along[i] - along[i - 1];
  const double t = step > 0 ? std::clamp((floor - along[i - 1]) / step, 0.05, 1.0) : 0.5;
  rings.push_back({{{lerp(a.chord.left, b.chord.left, t), lerp(a.chord.right, b.chord.right, t)},
                    a.depth + (b.depth - a.depth) * t},
                   kInner});
  return rings;
}

RingPath pathOf(const Sweep& sweep) {
  RingPath path;
  const std::vector<Station>& stations = sweep.stations;
  const bool deep = stations.size() >= 2;
  const bool startOpen = sweep.startOpen && deep, endOpen = sweep.endOpen && deep;
  path.rings.reserve(2 * stations.size() + 2);
  if (startOpen && !endOpen) {
    const std::vector<Ring> mouth = mouthRings(stations);
    path.rings.assign(mouth.rbegin(), mouth.rend());
  }
  for (const Station& station : stations) path.rings.push_back({station, 1});
  if (startOpen && endOpen) {
    for (auto s = stations.rbegin(); s != stations.rend(); ++s)
      path.rings.push_back({*s, 1 - kWall});
    path.joined = true;
  } else if (endOpen) {
    const std::vector<Station> backwards(stations.rbegin(), stations.rend());
    const std::vector<Ring> mouth = mouthRings(backwards);
    path.rings.insert(path.rings.end(), mouth.begin(), mouth.end());
  }
  return path;
}

/// Puts vertices and triangles into a mesh.
class Builder {
 public:
  Builder(const SweepSection& section, image::Size picture, std::size_t rings)
      : section_(section),
        count_(static_cast<std::uint32_t>(section.points.size())),
        uPerPixel_(1.0 / picture.width),
        vPerPixel_(1.0 / picture.height) {
    mesh_.positions.reserve(rings * count_ + 2);
    mesh_.uv.reserve(rings * count_ + 2);
    mesh_.triangles.reserve(2 * rings * count_ + 2 * count_);
  }

  /// Returns the ring's first vertex.
  std::uint32_t ring(const Ring& ring) {
    const std::uint32_t first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const SectionPoint& p : section_.points) place(ring, shrunk(p, ring.scale));
    return first;
  }

  /// The wall between two rings; the second follows the first along the surface.
  void band(std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t k = 0; k < count_; ++k) {
      const std::uint32_t l = k + 1 < count_ ? k + 1 : 0;
      const std::uint32_t a0 = a + k, a1 = a + l, b0 = b + k, b1 = b + l;
      constexpr double kTie = 1 + 1e-5;  // equal diagonals: always the same one
      if (squared(a0, b1) <= squared(a1, b0) * kTie) {
        mesh_.triangles.push_back({a0, b0, b1});
        mesh_.triangles.push_back({a0, b1, a1});
      } else {
        mesh_.triangles.push_back({a0, b0, a1});
        mesh_.triangles.push_back({a1, b0, b1});
      }
    }
  }

  /// A cone from a ring to a point of the picture plane; `before`: the point comes first.
  void tip(std::uint32_t ring, PicturePoint at, bool before) {
    fan(ring, vertex({at.x, -at.y, 0}, at), !before);
  }

  /// A flat lid on a ring; `before`: it closes the start of the path.
  void lid(std::uint32_t first, const Ring& ring, bool before) {
    if (section_.starShaped) {
      fan(first, place(ring, section_.centre), !before);
      return;
    }
    for (const auto& [i, j, k] : section_.lid) {
      if (before) {
        mesh_.triangles.push_back({first + i, first + j, first + k});
      } else {
        mesh_.triangles.push_back({first + i, first + k, first + j});
      }
    }
  }

  mesh::TriMesh take() { return std::move(mesh_); }

 private:
  SectionPoint shrunk(SectionPoint p, double scale) const {
    return scale == 1 ? p : lerp(section_.centre, p, scale);
  }

  std::uint32_t place(const Ring& ring, SectionPoint p) {
    const Chord& chord = ring.station.chord;
    const PicturePoint at = chord.middle() + chord.across() * (p.x / 2);
    const PicturePoint paint = chord.middle() + chord.across() * (paintedAt(p.x) / 2);
    return vertex({at.x, -at.y, ring.station.depth * p.y}, paint);
  }

  /// Where across the rib (−1…1) the picture is taken from for the surface at x. The fourth power
  /// leaves the front as it is and turns inwards only near the rim.
  static double paintedAt(double x) { return x * (1 - kRimInset * x * x * x * x); }

  /// `paint`: the point of the picture that colours the vertex.
  std::uint32_t vertex(ModelPoint p, PicturePoint paint) {
    mesh_.positions.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    const double u = (paint.x + 0.5) * uPerPixel_, v = (paint.y + 0.5) * vPerPixel_;
    mesh_.uv.push_back(
        {static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  /// Triangles from the edges of a ring to a hub: `ahead` when the hub follows the ring.
  void fan(std::uint32_t ring, std::uint32_t hub, bool ahead) {
    for (std::uint32_t k = 0; k < count_; ++k) {
      const std::uint32_t l = k + 1 < count_ ? k + 1 : 0;
      if (ahead) {
        mesh_.triangles.push_back({ring + k, hub, ring + l});
      } else {
        mesh_.triangles.push_back({hub, ring + k, ring + l});
      }
    }
  }

  double squared(std::uint32_t i, std::uint32_t j) const {
    const auto& p = mesh_.positions[i];
    const auto& q = mesh_.positions[j];
    const double x = static_cast<double>(p[0]) - static_cast<double>(q[0]);
    const double y = static_cast<double>(p[1]) - static_cast<double>(q[1]);
    const double z = static_cast<double>(p[2]) - static_cast<double>(q[2]);
    return x * x + y * y + z * z;
  }

  const SweepSection& section_;
  std::uint32_t count_;
  double uPerPixel_, vPerPixel_;
  mesh::TriMesh mesh_;
};

double signedVolume(const mesh::TriMesh& mesh) {
  const ModelPoint origin{mesh.positions[0][0], mesh.positions[0][1], mesh.positions[0][2]};
  const auto at = [&](std::uint32_t v) {
    const auto& p = mesh.positions[v];
    return ModelPoint{p[0], p[1], p[2]} - origin;
  };
  double volume = 0;
  for (const auto& t : mesh.triangles) volume += dot(at(t[0]), cross(at(t[1]), at(t[2])));
  return volume / 6;
}

}  // namespace

SweepSection prepareSection(std::span<const SectionPoint> points) {
  SweepSection section;
  section.points.assign(points.begin(), points.end());
  section.centre = geometry::centroid(points);
  constexpr double kMargin = 0.02;  // section units: thinner lid triangles would be slivers
  section.starShaped = geometry::seesAllEdges(points, section.centre, kMargin);
  if (!section.starShaped) section.lid = geometry::triangulate(points);
  section.shortestEdge = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    section.shortestEdge =
        std::min(section.shortestEdge, distance(points[i], points[(i + 1) % points.size()]));
  }
  return section;
}

mesh::TriMesh sweepMesh(const Sweep& sweep, const SweepSection& section, image::Size picture) {
  const RingPath path = pathOf(sweep);
  Builder builder(section, picture, path.rings.size());
  std::uint32_t first = 0, last = 0;
  for (std::size_t i = 0; i < path.rings.size(); ++i) {
    const std::uint32_t ring = builder.ring(path.rings[i]);
    if (i == 0) first = ring;
    if (i > 0) builder.band(last, ring);
    last = ring;
  }
  if (path.joined) {
    builder.band(last, first);
  } else {
    if (sweep.startTip) {
      builder.tip(first, *sweep.startTip, true);
    } else {
      builder.lid(first, path.rings.front(), true);
    }
    if (sweep.endTip) {
      builder.tip(last, *sweep.endTip, false);
    } else {
      builder.lid(last, path.rings.back(), false);
    }
  }
  mesh::TriMesh mesh = builder.take();
  // A part that runs back over itself more than ahead: what remains is seen from its inside.
  if (signedVolume(mesh) < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

bool hasSoundTriangles(const mesh::TriMesh& mesh) {
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  double diagonal = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = bounds.high[axis] - bounds.low[axis];
    diagonal += side * side;
  }
  const double least = 2 * mesh::kDegenerateArea * diagonal;
  const double leastSquared = 4 * least * least;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const auto at = [&](std::uint32_t v) {
      const auto& p = mesh.positions[v];
      return ModelPoint{p[0], p[1], p[2]};
    };
    const ModelPoint a = at(t[0]), n = cross(at(t[1]) - a, at(t[2]) - a);
    return dot(n, n) > leastSquared;
  });
}

}  // namespace spineloft::loft
