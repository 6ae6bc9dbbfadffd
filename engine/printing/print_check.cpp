#include "engine/printing/print_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/mesh/laws.h"
#include "engine/printing/pieces.h"
#include "engine/printing/stand.h"
#include "engine/printing/triangle.h"

namespace spineloft::printing {
namespace {

constexpr std::array kPrinters = {
    Printer{"a small printer (120 mm)", {120, 120, 120}},
    Printer{"a common printer (180 mm)", {180, 180, 180}},
    Printer{"a usual printer (220 × 220 × 250 mm)", {220, 220, 250}},
    Printer{"a large printer (256 mm)", {256, 256, 256}},
    Printer{"a very large printer (350 mm)", {350, 350, 350}},
};
constexpr double kRays = 2000;

double areaOf(const Corners& t) { return norm(cross(t[1] - t[0], t[2] - t[0])) / 2; }

/// How far along the ray it meets the triangle (Möller and Trumbore 1997); infinite when it does not.
double hit(const Corners& t, Point from, Point direction) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Point e = t[1] - t[0], f = t[2] - t[0], p = cross(direction, f);
  const double det = dot(e, p);
  // Seen from within, an outward triangle turns its back.
  if (!(det < 0)) return kNever;
  const Point s = from - t[0];
  const double u = dot(s, p) / det;
  if (u < 0 || u > 1) return kNever;
  const Point q = cross(s, e);
  const double v = dot(direction, q) / det;
  if (v < 0 || u + v > 1) return kNever;
  const double way = dot(f, q) / det;
  return way > 0 ? way : kNever;
}

/// Thickness at a place of the surface, and how much surface it stands for.
struct Probe {
  double thickness, area;
  Point at;
  std::size_t part;
  bool wall;  ///< the other side is nearly parallel
};

/// Out of the solid, of length 1.
Point outwards(const Corners& t) { return normalized(cross(t[1] - t[0], t[2] - t[0])); }

/// Points evenly over a part: one wherever the area run through passes the next multiple of `share`.
void probe(const mesh::TriMesh& mesh, std::size_t part, double share, std::vector<Probe>& out) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) triangles.push_back(cornersOf(mesh, t));
  double passed = share / 2;
  for (const Corners& t : triangles) {
    const double area = areaOf(t);
    passed += area;
    if (!(passed >= share) || !(area > 0)) continue;
    const double covered = std::floor(passed / share) * share;
    passed -= covered;
    const Point middle = (t[0] + t[1] + t[2]) / 3.0;
    const Point inwards = -outwards(t);
    double way = std::numeric_limits<double>::infinity();
    const Corners* exit = nullptr;
    for (const Corners& other : triangles) {
      const double there = hit(other, middle, inwards);
      if (!(there < way)) continue;
      way = there;
      exit = &other;
    }
    if (exit == nullptr) continue;
    out.push_back({way, covered, middle, part, dot(outwards(*exit), inwards) >= std::cos(kWallSlant)});
  }
}

void findThinnest(std::span<const mesh::TriMesh> parts, PrintCheck& check) {
  double area = 0;
  for (const mesh::TriMesh& mesh : parts) {
    for (const auto& t : mesh.triangles) area += areaOf(cornersOf(mesh, t));
  }
  if (!(area > 0)) return;
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < parts.size(); ++i) probe(parts[i], i, area / kRays, probes);
  std::ranges::sort(probes, {}, &Probe::thickness);
  double sum = 0, all = 0;
  for (const Probe& p : probes) all += p.area;
  for (const Probe& p : probes) {
    if (p.wall) sum += p.area;
    const bool last = &p == &probes.back();
    if (!last && (!p.wall || sum < kThinShare * all)) continue;
    check.thinnest = p.thickness;
    check.thinAt = {p.at.x, p.at.y, p.at.z};
    check.thinPart = p.part;
    return;
  }
}

void findStand(std::span<const mesh::TriMesh> parts, double ground, PrintCheck& check) {
  Point weighted{};
  double volume = 0;
  std::vector<GroundPoint> foot;
  for (const mesh::TriMesh& mesh : parts) {
    for (const auto& t : mesh.triangles) {
      const auto [a, b, c] = cornersOf(mesh, t);
      const double six = dot(a, cross(b, c));
      volume += six / 6;
      weighted += (a + b + c) * (six / 24);
    }
    for (const auto& p : mesh.positions) {
      if (static_cast<double>(p[1]) - ground > kFootReach) continue;
      foot.push_back({static_cast<double>(p[0]), static_cast<double>(p[2])});
    }
  }
  check.volume = volume;
  if (!(volume > 0)) return;
  const Point centre = weighted / volume;
  check.tippingAngle = tippingAngleOf(std::move(foot), {centre.x, centre.z}, centre.y - ground);
}

bool fits(const std::array<double, 3>& size, const std::array<double, 3>& volume) {
  const bool straight = size[0] <= volume[0] && size[1] <= volume[1];
  const bool turned = size[1] <= volume[0] && size[0] <= volume[1];
  return size[2] <= volume[2] && (straight || turned);
}

/// The first printer that it fits into; their number when there is none.
std::size_t printerFor(const std::array<double, 3>& size) {
  const auto fitting =
      std::ranges::find_if(kPrinters, [&](const Printer& printer) { return fits(size, printer.volume); });
  return static_cast<std::size_t>(fitting - kPrinters.begin());
}

bool fitsEnlarged(const PrintCheck& check) {
  if (check.thick() || !(check.thinnest > 0)) return false;
  std::array<double, 3> size = check.size;
  for (double& length : size) length *= kMoreThanNeeded * kLeastWall / check.thinnest;
  return printerFor(size) < kPrinters.size();
}

}  // namespace

std::span<const Printer> printers() { return kPrinters; }

PrintCheck checkPrint(std::span<const mesh::TriMesh> parts) {
  PrintCheck check;
  check.closed = !parts.empty();
  std::array<double, 3> low{}, high{};
  bool any = false;
  for (const mesh::TriMesh& mesh : parts) {
    // Triangles without an area, as solids of several parts have them at their seams, print as nothing.
    const mesh::MeshReport report = mesh::inspect(mesh);
    check.closed = check.closed && report.finite && report.indexed && report.closed && report.outward;
    if (mesh.positions.empty()) continue;
    const mesh::Bounds bounds = mesh::boundsOf(mesh);
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = any ? std::min(low[i], bounds.low[i]) : bounds.low[i];
      high[i] = any ? std::max(high[i], bounds.high[i]) : bounds.high[i];
    }
    any = true;
  }
  check.size = {high[0] - low[0], high[2] - low[2], high[1] - low[1]};
  check.printer = printerFor(check.size);
  findThinnest(parts, check);
  check.enlargingHelps = fitsEnlarged(check);
  findStand(parts, low[1], check);
  check.pieces = countPieces(parts);
  check.footHelps = !check.stands() && flatFoot(parts).has_value();
  return check;
}

}  // namespace spineloft::printing
