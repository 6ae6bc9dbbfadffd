#include "engine/loft/sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/geometry/bend.h"
#include "engine/geometry/ode.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/triangulate.h"
#include "engine/loft/bands.h"
#include "engine/loft/loft.h"
#include "engine/mesh/laws.h"

namespace spineloft::loft {
namespace {

/// The station at share `t` of the way between two; its section joins the sweep.
Station between(const Station& a, const Station& b, double t, Sweep& sweep) {
  Station station = a;
  station.centre = lerp(a.centre, b.centre, t);
  station.across = lerp(a.across, b.across, t);
  station.depth = lerp(a.depth, b.depth, t);
  station.rise = lerp(a.rise, b.rise, t);
  for (std::size_t i = 0; i < station.heights.size(); ++i)
    station.heights[i] = std::lerp(a.heights[i], b.heights[i], t);
  station.middle = lerp(a.middle, b.middle, t);
  station.half = lerp(a.half, b.half, t);
  if (a.shape != b.shape) {
    const std::size_t size = sweep.count() + 1;
    station.shape = sweep.shapes.size() / size;
    for (std::size_t i = 0; i < size; ++i) {
      const SectionPoint p = lerp(sweep.shape(a.shape)[i], sweep.shape(b.shape)[i], t);
      sweep.shapes.push_back(p);
    }
  }
  return station;
}

/// Appends the inner rings of a mouth at one end, from the mouth inwards to the floor.
void addMouth(bool atStart, Sweep& sweep, std::vector<Ring>& rings) {
  constexpr double kInner = 1 - sections::kWall;
  const std::size_t count = sweep.stations.size();
  const auto at = [&](std::size_t i) -> const Station& { return sweep.stations[atStart ? i : count - 1 - i]; };
  const auto step = [&](std::size_t i) { return distance(at(i).centre, at(i + 1).centre); };
  double length = 0;
  for (std::size_t i = 0; i + 1 < count; ++i) length += step(i);
  const double floor = sections::kMouthDepth * length;
  double along = 0, before = 0;
  std::size_t i = 0;
  // A ring just before the floor would leave slivers: skip it.
  for (; i + 1 < count && along <= 0.98 * floor; ++i) {
    rings.push_back({at(i), kInner});
    before = along;
    along += step(i);
  }
  const double last = along - before;
  const double t = last > 0 ? std::clamp((floor - before) / last, 0.05, 1.0) : 0.5;
  rings.push_back({between(at(i - 1), at(i), t, sweep), kInner});
}

void fillPath(Sweep& sweep, RingPath& path) {
  path.rings.clear();
  const std::vector<Station>& stations = sweep.stations;
  const bool deep = stations.size() >= 2 && !sweep.joined;
  const bool startOpen = sweep.startOpen && deep, endOpen = sweep.endOpen && deep;
  path.rings.reserve(2 * stations.size() + 2);
  if (startOpen && !endOpen) {
    addMouth(true, sweep, path.rings);
    std::ranges::reverse(path.rings);
  }
  for (const Station& station : stations) path.rings.push_back({station, 1});
  path.joined = sweep.joined;
  if (startOpen && endOpen) {
    for (auto s = stations.rbegin(); s != stations.rend(); ++s) path.rings.push_back({*s, 1 - sections::kWall});
    path.joined = true;
  } else if (endOpen) {
    addMouth(false, sweep, path.rings);
  }
}

/// How fast the back's colours come from further in, a share of the half width for section y = 1, beside the outline.
constexpr double kFurtherIn = 0.6;

/// Puts vertices and triangles into a mesh.
class Builder {
 public:
  Builder(const Sweep& sweep, image::Size picture, const RingPath& path, SweepMemory& memory, mesh::TriMesh& mesh)
      : sweep_(sweep),
        count_(static_cast<std::uint32_t>(sweep.count())),
        uPerPixel_(1.0 / picture.width),
        vPerPixel_(1.0 / picture.height),
        memory_(memory),
        mesh_(mesh) {
    const std::size_t rings = path.rings.size(), bands = path.joined ? rings : rings - 1;
    mesh_.positions.reserve(rings * count_ + 2);
    mesh_.uv.reserve(rings * count_ + 2);
    mesh_.triangles.reserve(2 * bands * count_ + 2 * count_);
    mesh_.positions.resize(rings * count_);
    mesh_.uv.resize(rings * count_);
    mesh_.triangles.resize(2 * bands * count_);
  }

  /// The vertices of the ring at `index`. Returns the first of them.
  std::uint32_t ring(const Ring& ring, std::size_t index) {
    const auto first = static_cast<std::uint32_t>(index * count_);
    const Station station = ring.station;  // a copy: what is written does not lie in it
    if (!alike_ || shape_ != station.shape || scale_ != ring.scale) readShape(ring);
    const PaintedPoint* from = memory_.points.data();
    for (std::uint32_t k = 0; k < count_; ++k) place(station, from[k], first + k);
    return first;
  }

  /// The walls between all rings, which are there.
  WallTally walls(const RingPath& path) {
    WallTally tally(mesh_.positions[0][2]);
    const std::size_t rings = path.rings.size();
    RingPlanes *before = &memory_.planes[0], *after = &memory_.planes[1];
    read(0, *before);
    tally.addVertices(*before);
    for (std::size_t i = 1; i < rings; ++i) {
      read(i, *after);
      tally.addVertices(*after);
      wall(i - 1, i, {*before, *after, 0, 0}, tally);
      std::swap(before, after);
    }
    if (path.joined) {
      read(0, *after);
      wall(rings - 1, 0, {*before, *after, 0, 0}, tally);
    }
    return tally;
  }

  /// A cone from a ring to a point; `before`: the point comes first.
  void tip(std::uint32_t ring, const Tip& tip, bool before) {
    const std::uint32_t hub = another();
    vertex(tip.at, tip.paint, hub);
    fan(ring, hub, !before);
  }

  /// A flat lid on a ring; `before`: it closes the start of the path. False when the section cannot be
  /// filled.
  bool lid(std::uint32_t first, const Ring& ring, bool before) {
    const std::span<const SectionPoint> shape = sweep_.shape(ring.station.shape);
    constexpr double kMargin = 0.02;  // section units: thinner lid triangles would be slivers
    if (sweep_.sizes.size() == 1 && geometry::seesAllEdges(shape.first(count_), shape[count_], kMargin)) {
      const std::uint32_t hub = another();
      place(ring.station, {shape[count_], paintedAt(shape[count_])}, hub);
      fan(first, hub, !before);
      return true;
    }
    const auto triangles = geometry::triangulate(shape.first(count_), sweep_.sizes);
    for (const auto& [i, j, k] : triangles) {
      if (before) {
        mesh_.triangles.push_back({first + i, first + j, first + k});
      } else {
        mesh_.triangles.push_back({first + i, first + k, first + j});
      }
    }
    return !triangles.empty();
  }

 private:
  /// A vertex more, to be placed.
  std::uint32_t another() {
    mesh_.positions.emplace_back();
    mesh_.uv.emplace_back();
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  void read(std::size_t ring, RingPlanes& planes) const {
    planes.read(std::span(mesh_.positions).subspan(ring * count_, count_), sweep_.sizes);
  }
  void wall(std::size_t a, std::size_t b, Band band, WallTally& tally) {
    band.firstA = static_cast<std::uint32_t>(a * count_);
    band.firstB = static_cast<std::uint32_t>(b * count_);
    makeWalls(band, sweep_.sizes, mesh_.triangles.data() + 2 * count_ * a, tally);
  }

  // Most rings are of the shape of the one before.
  void readShape(const Ring& ring) {
    const std::span<const SectionPoint> shape = sweep_.shape(ring.station.shape);
    memory_.points.resize(count_);
    for (std::uint32_t k = 0; k < count_; ++k) {
      const SectionPoint p = ring.scale == 1 ? shape[k] : lerp(shape[count_], shape[k], ring.scale);
      memory_.points[k] = {p, paintedAt(p)};
    }
    shape_ = ring.station.shape;
    scale_ = ring.scale;
    alike_ = true;
  }

  void place(const Station& station, const PaintedPoint& p, std::uint32_t at) {
    ModelPoint off = station.across * p.at.x + station.depth * p.at.y;
    if (station.bend != ModelPoint{}) off += geometry::heldBack(off, station.bend);
    PicturePoint paint = station.middle + station.half * p.paint;
    if (station.rise != ModelPoint{}) {
      const ModelPoint up = station.rise * geometry::aroundFour(station.heights, p.at.x, p.at.y);
      off += up;
      paint += PicturePoint{up.x, -up.y};
    }
    vertex(station.centre + off, paint, at);
  }

  /// Which point of its rib colours a point of a section, −1 … 1. The front shows the picture as it is seen. The back
  /// does in its middle; nearer to the outline it takes what is further in, for else the sides would be drawn out of
  /// the outline's own pixels, row by row.
  static double paintedAt(SectionPoint p) {
    const double x = std::clamp(p.x, -1.0, 1.0), back = std::clamp(-p.y, 0.0, 1.0);
    return x * (1 - kFurtherIn * back * (1 - back) * (1 - back));
  }

  /// `paint`: the point of the picture that colours the vertex.
  void vertex(ModelPoint p, PicturePoint paint, std::uint32_t at) {
    mesh_.positions[at] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    const double u = (paint.x + 0.5) * uPerPixel_, v = (paint.y + 0.5) * vPerPixel_;
    mesh_.uv[at] = {static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))};
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

  const Sweep& sweep_;
  std::uint32_t count_;
  double uPerPixel_, vPerPixel_;
  SweepMemory& memory_;
  mesh::TriMesh& mesh_;
  // Of which ring the memory's points are, once there are any.
  std::size_t shape_ = 0;
  double scale_ = 1;
  bool alike_ = false;
};

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

/// By the flux of (0, 0, z): every triangle's shadow times its mean height above the first vertex.
double signedVolume(const mesh::TriMesh& mesh, Triangles triangles) {
  const double ground = mesh.positions[0][2];
  double volume = 0;
  for (const auto& t : triangles) {
    const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double ax = a[0], ay = a[1];
    const double shadow = (b[0] - ax) * (c[1] - ay) - (b[1] - ay) * (c[0] - ax);
    volume += shadow * (static_cast<double>(a[2]) + static_cast<double>(b[2]) + static_cast<double>(c[2]) - 3 * ground);
  }
  return volume / 6;
}

/// The law of area (mesh/laws.h) with a factor 2 in hand. `tally` is of the first `rings` vertices.
double leastArea(const mesh::TriMesh& mesh, const WallTally& tally, std::size_t rings) {
  mesh::Bounds bounds = tally.bounds();
  for (const auto& p : std::span(mesh.positions).subspan(rings)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.low[axis] = std::min<double>(bounds.low[axis], p[axis]);
      bounds.high[axis] = std::max<double>(bounds.high[axis], p[axis]);
    }
  }
  double diagonal = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = bounds.high[axis] - bounds.low[axis];
    diagonal += side * side;
  }
  return 2 * mesh::kDegenerateArea * diagonal;
}

bool areLarger(const mesh::TriMesh& mesh, Triangles triangles, double area) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    const auto at = [&](std::uint32_t v) {
      const auto& p = mesh.positions[v];
      return ModelPoint{p[0], p[1], p[2]};
    };
    const ModelPoint a = at(t[0]), n = cross(at(t[1]) - a, at(t[2]) - a);
    return dot(n, n) > 4 * area * area;
  });
}

}  // namespace

std::size_t Sweep::count() const { return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}); }

std::span<const SectionPoint> Sweep::shape(std::size_t which) const {
  const std::size_t size = count() + 1;
  return std::span(shapes).subspan(which * size, size);
}

bool sweepMesh(Sweep& sweep, image::Size picture, SweepMemory& memory, mesh::TriMesh& mesh) {
  RingPath& path = memory.path;
  fillPath(sweep, path);
  Builder builder(sweep, picture, path, memory, mesh);
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < path.rings.size(); ++i) last = builder.ring(path.rings[i], i);
  const WallTally tally = builder.walls(path);
  const std::size_t walls = mesh.triangles.size(), rings = mesh.positions.size();
  if (!path.joined) {
    if (sweep.startTip) {
      builder.tip(0, *sweep.startTip, true);
    } else if (!builder.lid(0, path.rings.front(), true)) {
      return false;
    }
    if (sweep.endTip) {
      builder.tip(last, *sweep.endTip, false);
    } else if (!builder.lid(last, path.rings.back(), false)) {
      return false;
    }
  }
  const Triangles all(mesh.triangles), ends = all.subspan(walls);
  // What single precision leaves in doubt is looked at again, triangle by triangle.
  double volume = tally.volume() + signedVolume(mesh, ends);
  if (std::abs(volume) <= tally.volumeError()) volume = signedVolume(mesh, all);
  const double least = leastArea(mesh, tally, rings);
  const bool sound = !all.empty() && areLarger(mesh, tally.surelyLarger(least) ? ends : all, least);
  // A part that runs back over itself more than ahead: what remains is seen from its inside.
  if (volume < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return sound;
}

}  // namespace spineloft::loft
