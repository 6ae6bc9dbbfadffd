#include "engine/descriptive/patch.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "engine/descriptive/planarity.h"
#include "engine/descriptive/square.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/inflate/cushion.h"
#include "engine/inflate/element.h"

namespace spineloft::descriptive {
namespace {

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// Points along the edges of plane faces are nearer to each other than this, a share of the size.
constexpr double kFacedStep = 0.04;
/// A corner of the outline that is a control point, radians of turn.
constexpr double kControlCorner = 0.7;

/// Puts a place on the nearest outline: in the middle of an edge, or instead of a corner that is hardly one and near.
void keepPlace(geometry::Contours& contours, PicturePoint place) {
  constexpr double kNear = 0.3, kStraight = 0.3;  // shares of an edge, radians
  std::vector<PicturePoint>* contour = nullptr;
  std::size_t edge = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (auto& one : contours) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const double away = geometry::distanceToSegment(place, one[i], one[(i + 1) % one.size()]);
      if (away >= nearest) continue;
      nearest = away;
      contour = &one;
      edge = i;
    }
  }
  if (contour == nullptr) return;
  const std::size_t n = contour->size();
  const double length = distance((*contour)[edge], (*contour)[(edge + 1) % n]);
  for (const std::size_t i : {edge, (edge + 1) % n}) {
    const PicturePoint here = (*contour)[i];
    if (distance(here, place) < 1e-9) return;
    const PicturePoint in = here - (*contour)[(i + n - 1) % n], out = (*contour)[(i + 1) % n] - here;
    if (distance(here, place) > kNear * length || std::abs(std::atan2(cross(in, out), dot(in, out))) > kStraight)
      continue;
    (*contour)[i] = place;
    return;
  }
  contour->insert(contour->begin() + static_cast<std::ptrdiff_t>(edge) + 1, place);
}

/// With all kept places as corners, unless the outlines would touch.
geometry::Contours withPlaces(geometry::Contours contours, const Patch::Kept& kept) {
  geometry::Contours with = contours;
  for (const auto* places : {&kept.folds, &kept.others}) {
    for (const PicturePoint place : *places) keepPlace(with, place);
  }
  const geometry::PlaneRegion region = geometry::planeRegion(with);
  return geometry::areSimple(region.points, region.sizes) ? with : contours;
}

/// The triangles of a mesh by the cells of a grid: says quickly that a point is in none.
class TriangleGrid {
 public:
  explicit TriangleGrid(const geometry::PlaneMesh& mesh) {
    if (mesh.empty()) return;
    SectionPoint high = low_ = mesh.points()[0];
    for (std::size_t i = 0; i < mesh.rim(); ++i) {
      const SectionPoint p = mesh.points()[i];
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double longer = std::max(high.x - low_.x, high.y - low_.y);
    cell_ = longer / std::ceil(std::sqrt(static_cast<double>(mesh.triangles().size())));
    across_ = static_cast<int>((high.x - low_.x) / cell_) + 1;
    down_ = static_cast<int>((high.y - low_.y) / cell_) + 1;
    lists_.resize(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_));
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
      const auto [a, b, c] = mesh.triangles()[t];
      const SectionPoint p = mesh.points()[a], q = mesh.points()[b], r = mesh.points()[c];
      const int right = column(std::max({p.x, q.x, r.x})), up = row(std::max({p.y, q.y, r.y}));
      for (int y = row(std::min({p.y, q.y, r.y})); y <= up; ++y) {
        for (int x = column(std::min({p.x, q.x, r.x})); x <= right; ++x) lists_[at(x, y)].push_back(t);
      }
    }
  }
  std::optional<MeshPlace> find(const geometry::PlaneMesh& mesh, SectionPoint p) const {
    if (lists_.empty() || !(p.x >= low_.x && p.y >= low_.y)) return std::nullopt;
    if (p.x > low_.x + across_ * cell_ || p.y > low_.y + down_ * cell_) return std::nullopt;
    for (const std::uint32_t t : lists_[at(column(p.x), row(p.y))]) {
      const auto [i, j, k] = mesh.triangles()[t];
      const SectionPoint a = mesh.points()[i], b = mesh.points()[j], c = mesh.points()[k];
      const double one = cross(b - p, c - p), other = cross(c - p, a - p), last = cross(a - p, b - p);
      if (one < 0 || other < 0 || last < 0) continue;
      const double whole = one + other + last;
      return MeshPlace{{i, j, k}, {one / whole, other / whole, last / whole}};
    }
    return std::nullopt;
  }

 private:
  int column(double x) const { return std::clamp(static_cast<int>((x - low_.x) / cell_), 0, across_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - low_.y) / cell_), 0, down_ - 1); }
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * across_ + x); }

  SectionPoint low_{};
  double cell_ = 1;
  int across_ = 0, down_ = 0;
  std::vector<std::vector<std::uint32_t>> lists_;
};

}  // namespace

struct Patch::Parts {
  Parts(geometry::PlaneMesh plane, std::vector<std::size_t> sizes, std::vector<double> solution)
      : mesh(std::move(plane)), grid(mesh), rims(std::move(sizes)), poisson(std::move(solution)) {}

  /// A corner of the rim between two control points.
  struct Between {
    std::uint32_t one = 0, other = 0;
    double share = 0;  ///< of the other
  };
  geometry::PlaneMesh mesh;
  TriangleGrid grid;
  std::vector<std::size_t> rims;
  std::vector<double> poisson;
  std::vector<geometry::QpEntry> energy;
  std::size_t controls = 0;  ///< none: flat
  DepthScale scale;
  SectionPoint middle;  ///< of the corners of the rim, shares of the size
  double radius = 1;
  std::vector<Between> rim;                            ///< of a round piece, by corner
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> inside;  ///< of L_II
  Sparse across;                                       ///< −L_IB
  std::optional<FacedSolid> faced;
  std::vector<double> rise, halfThick;  ///< by point, of one between plane faces

  SectionPoint planeAt(std::uint32_t point) const {
    const SectionPoint p = mesh.points()[point];
    return scale.of({p.x, -p.y});
  }
  /// What the coefficients of the plane stand for: 1, and x and y from the middle of the piece over its radius.
  Eigen::Vector3d planeTerms(SectionPoint pixel) const {
    if (faced) return {0, 0, 1};
    const SectionPoint p = scale.of({pixel.x, -pixel.y}) - middle;
    return {p.x / radius, p.y / radius, 1};
  }
  void setPlane();
  void addControls(std::span<const PicturePoint> folds, double alpha);
  bool factorise();
};

void Patch::Parts::setPlane() {
  const auto corners = static_cast<std::uint32_t>(mesh.rim());
  for (std::uint32_t i = 0; i < corners; ++i) middle += planeAt(i) / static_cast<double>(corners);
  radius = 0;
  for (std::uint32_t i = 0; i < corners; ++i) radius = std::max(radius, distance(planeAt(i), middle));
  for (std::uint32_t i = 0; i < 3; ++i) energy.push_back({i, i, i < 2 ? kTurnGauge : kDepthGauge});
}

/// Control points at folds and corners, and evenly between them; every corner of the rim between two of them.
void Patch::Parts::addControls(std::span<const PicturePoint> folds, double alpha) {
  const auto& points = mesh.points();
  std::vector<bool> isFold(mesh.rim(), false), isControl(mesh.rim(), false);
  for (const PicturePoint fold : folds) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < mesh.rim(); ++i) {
      const SectionPoint at{fold.x, -fold.y};
      if (distance(points[i], at) < distance(points[best], at)) best = i;
    }
    isFold[best] = isControl[best] = true;
  }
  double length = 0;
  std::uint32_t first = 0;
  const auto step = [&](std::uint32_t from, std::uint32_t i, std::uint32_t n) {
    return distance(points[from + i % n], points[from + (i + 1) % n]);
  };
  for (const std::size_t size : rims) {
    const auto n = static_cast<std::uint32_t>(size);
    for (std::uint32_t i = 0; i < n; ++i) length += step(first, i, n);
    first += n;
  }
  const double spacing = length / static_cast<double>(kControls);
  ControlLoops loops;
  first = 0;
  rim.resize(mesh.rim());
  for (const std::size_t size : rims) {
    const auto n = static_cast<std::uint32_t>(size);
    double own = 0;
    for (std::uint32_t i = 0; i < n; ++i) own += step(first, i, n);
    const double gap = std::min(spacing, own / 8);
    for (std::uint32_t i = 0; i < n; ++i) {
      const SectionPoint in = points[first + i] - points[first + (i + n - 1) % n];
      const SectionPoint out = points[first + (i + 1) % n] - points[first + i];
      if (std::abs(std::atan2(cross(in, out), dot(in, out))) > kControlCorner) isControl[first + i] = true;
    }
    std::uint32_t start = 0;
    while (start < n && !isControl[first + start]) ++start;
    if (start == n) isControl[first + (start = 0)] = true;
    // Between two fixed ones as many as lie a gap apart, evenly.
    std::vector<double> s{0};
    for (std::uint32_t i = 0; i < n; ++i) s.push_back(s.back() + step(first, start + i, n));
    for (std::uint32_t from = 0, to = 1; from < n; from = to++) {
      while (to < n && !isControl[first + (start + to) % n]) ++to;
      const double parts = std::max(1.0, std::round((s[to] - s[from]) / gap));
      double next = 1;
      for (std::uint32_t i = from + 1; i < to; ++i) {
        if (s[i] < s[from] + (s[to] - s[from]) * next / parts - 1e-9 * own) continue;
        isControl[first + (start + i) % n] = true;
        while (s[from] + (s[to] - s[from]) * next / parts <= s[i] + 1e-9 * own) ++next;
      }
    }
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (isControl[first + (start + i) % n]) chosen.push_back(i);
    }
    const auto base = static_cast<std::uint32_t>(loops.points.size());
    for (std::uint32_t k = 0; k < chosen.size(); ++k) {
      const std::uint32_t from = chosen[k], to = k + 1 < chosen.size() ? chosen[k + 1] : n;
      const auto next = static_cast<std::uint32_t>((k + 1) % chosen.size());
      for (std::uint32_t i = from; i < to; ++i) {
        rim[first + (start + i) % n] = {base + k, base + next, (s[i] - s[from]) / (s[to] - s[from])};
      }
      const std::uint32_t corner = first + (start + from) % n;
      loops.points.push_back(planeAt(corner));
      loops.isFold.push_back(isFold[corner]);
    }
    loops.sizes.push_back(chosen.size());
    first += n;
  }
  controls = loops.points.size();
  for (const geometry::QpEntry& e : planarityEnergy(loops, alpha)) energy.push_back({e.row + 3, e.column + 3, e.value});
  for (std::uint32_t i = 0; i < controls; ++i) energy.push_back({i + 3, i + 3, kControlGauge});
}

bool Patch::Parts::factorise() {
  const auto corners = static_cast<std::uint32_t>(mesh.rim());
  const auto inner = static_cast<Eigen::Index>(mesh.points().size() - mesh.rim());
  std::vector<Eigen::Triplet<double, int>> own, other;
  for (const auto& t : mesh.triangles()) {
    const inflate::Element element = inflate::elementOf(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < corners) continue;
      const auto row = static_cast<int>(t[i] - corners);
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = element.stiffness(i, k);
        if (t[k] < corners) {
          const Between& between = rim[t[k]];
          other.emplace_back(row, static_cast<int>(between.one), -value * (1 - between.share));
          other.emplace_back(row, static_cast<int>(between.other), -value * between.share);
        } else if (t[k] <= t[i]) {
          own.emplace_back(row, static_cast<int>(t[k] - corners), value);
        }
      }
    }
  }
  Sparse stiffness(inner, inner);
  stiffness.setFromTriplets(own.begin(), own.end());
  across.resize(inner, static_cast<Eigen::Index>(controls));
  across.setFromTriplets(other.begin(), other.end());
  if (inner > 0) inside.compute(stiffness);
  return inner == 0 || inside.info() == Eigen::Success;
}

Patch::Patch(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Patch::Patch(Patch&&) noexcept = default;
Patch& Patch::operator=(Patch&&) noexcept = default;
Patch::~Patch() = default;

Result<Patch> Patch::make(const Sheet& sheet, const Piece& piece, const Kept& kept, const DepthScale& scale,
                          int points) {
  const double spacing = inflate::cushionSpacing(geometry::areaOf(sheet.region), points);
  if (piece.kind == PieceKind::Flat) {
    const geometry::PlaneRegion region = geometry::planeRegion(withPlaces(sheet.region, kept));
    auto parts =
        std::make_unique<Parts>(geometry::PlaneMesh(region.points, region.sizes), region.sizes, std::vector<double>{});
    if (parts->mesh.empty()) return Error::RegionTooFine;
    parts->scale = scale;
    parts->setPlane();
    return Patch(std::move(parts));
  }
  const geometry::PlaneRegion region =
      geometry::planeRegion(withPlaces(geometry::sampleRegion(sheet.region, spacing), kept));
  const inflate::Cushion coarse = inflate::evenCushion(region, inflate::kCoarse * spacing);
  if (coarse.u.empty()) return Error::RegionTooFine;
  inflate::Cushion fine = inflate::fineCushion(region, coarse, 1, spacing);
  if (fine.u.empty()) return Error::RegionTooFine;
  auto parts = std::make_unique<Parts>(std::move(fine.mesh), region.sizes, std::move(fine.u));
  parts->scale = scale;
  parts->setPlane();
  parts->addControls(kept.folds, piece.stiffness);
  if (!parts->factorise()) return Error::RegionTooFine;
  return Patch(std::move(parts));
}

namespace {

/// The faces that are seen from the front, or those seen from behind, over a plane.
class Cover {
 public:
  Cover(const FacedSolid& solid, bool front) {
    for (const Wireframe::Face& face : solid.faces) {
      Face one;
      ModelPoint normal{};
      for (std::size_t i = 0; i < face.size(); ++i) {
        const ModelPoint a = solid.corners[face[i]], b = solid.corners[face[(i + 1) % face.size()]];
        one.outline.push_back({a.x, a.y});
        normal += cross(a, b);
        one.at += a / static_cast<double>(face.size());
      }
      if ((normal.z > 0) != front || normal.z == 0) continue;
      one.slope = {-normal.x / normal.z, -normal.y / normal.z};
      faces_.push_back(std::move(one));
    }
  }
  bool empty() const { return faces_.empty(); }
  /// The height of the face over p, or of the nearest one.
  double at(SectionPoint p) const {
    const Face* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_) {
      double away = std::numeric_limits<double>::infinity();
      const std::size_t n = face.outline.size();
      for (std::size_t i = 0; i < n; ++i) {
        away = std::min(away, geometry::distanceToSegment(p, face.outline[i], face.outline[(i + 1) % n]));
      }
      if (geometry::holds(std::span<const SectionPoint>(face.outline), p)) away = -away;
      if (away >= least) continue;
      least = away;
      best = &face;
    }
    return best->at.z + dot(best->slope, p - SectionPoint{best->at.x, best->at.y});
  }

 private:
  struct Face {
    std::vector<SectionPoint> outline;
    ModelPoint at{};
    SectionPoint slope;
  };
  std::vector<Face> faces_;
};

/// The outline of faces seen from the front, as a cycle of corners; and edges inside it, by whether their faces are
/// seen from the front or from behind.
struct SeenEdges {
  std::vector<std::uint32_t> outline;
  std::vector<std::array<std::uint32_t, 2>> inside, behind;
};
SeenEdges seenEdges(const FacedSolid& solid) {
  std::vector<bool> isFront;
  std::array<std::set<std::array<std::uint32_t, 2>>, 2> edges;  // from behind, from the front
  for (const Wireframe::Face& face : solid.faces) {
    double area = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const ModelPoint a = solid.corners[face[i]], b = solid.corners[face[(i + 1) % face.size()]];
      area += a.x * b.y - a.y * b.x;
    }
    isFront.push_back(area > 0);
    for (std::size_t i = 0; i < face.size(); ++i) {
      edges[isFront.back()].insert({face[i], face[(i + 1) % face.size()]});
    }
  }
  SeenEdges out{outerCycle(solid.faces, isFront), {}, {}};
  for (const bool front : {false, true}) {
    for (const auto& [a, b] : edges[front]) {
      if (a < b && edges[front].contains({b, a})) (front ? out.inside : out.behind).push_back({a, b});
    }
  }
  return out;
}

}  // namespace

Result<Patch> Patch::make(const FacedSolid& solid, const DepthScale& scale) {
  const Cover front(solid, true), back(solid, false);
  const SeenEdges edges = seenEdges(solid);
  if (front.empty() || back.empty() || edges.outline.size() < 3) {
    return Failure{Error::ShapeInvalid, "what is seen of it has more than one outline"};
  }
  // Pixels, y up.
  const auto pixel = [&](SectionPoint p) {
    return SectionPoint{p.x * scale.size + scale.middle.x, p.y * scale.size - scale.middle.y};
  };
  const auto flat = [&](std::uint32_t corner) {
    return SectionPoint{solid.corners[corner].x, solid.corners[corner].y};
  };
  std::vector<SectionPoint> rim, inner;
  const auto along = [&](std::uint32_t a, std::uint32_t b, std::vector<SectionPoint>& points) {
    const double steps = std::ceil(distance(flat(a), flat(b)) / kFacedStep);
    for (double i = 0; i < steps; ++i) points.push_back(lerp(flat(a), flat(b), i / steps));
  };
  for (std::size_t i = 0; i < edges.outline.size(); ++i) {
    along(edges.outline[i], edges.outline[(i + 1) % edges.outline.size()], rim);
  }
  for (const auto* some : {&edges.inside, &edges.behind}) {
    for (const auto& [a, b] : *some) along(a, b, inner);
    for (const auto& [a, b] : *some) inner.push_back(flat(b));
  }
  for (const auto& [a, b] : edges.inside) {
    for (const auto& [c, d] : edges.behind) {
      const SectionPoint r = flat(b) - flat(a), q = flat(d) - flat(c);
      const double whole = cross(r, q);
      if (whole == 0) continue;
      const double t = cross(flat(c) - flat(a), q) / whole, u = cross(flat(c) - flat(a), r) / whole;
      if (t > 0 && t < 1 && u > 0 && u < 1) inner.push_back(flat(a) + r * t);
    }
  }
  std::vector<SectionPoint> pixels;
  for (const SectionPoint p : rim) pixels.push_back(pixel(p));
  const std::array<std::size_t, 1> sizes{rim.size()};
  auto parts = std::make_unique<Parts>(geometry::PlaneMesh(pixels, sizes), std::vector<std::size_t>{rim.size()},
                                       std::vector<double>{});
  if (parts->mesh.empty()) return Failure{Error::ShapeInvalid, "what is seen of it has more than one outline"};
  for (const SectionPoint p : inner) parts->mesh.insert(pixel(p));
  parts->grid = TriangleGrid(parts->mesh);
  parts->scale = scale;
  parts->faced = solid;
  parts->setPlane();
  for (std::uint32_t i = 0; i < parts->mesh.points().size(); ++i) {
    const SectionPoint p = parts->planeAt(i);
    const double high = front.at(p), low = std::min(high, back.at(p));
    parts->rise.push_back((high + low) / 2);
    parts->halfThick.push_back(i < rim.size() ? 0 : (high - low) / 2);
  }
  return Patch(std::move(parts));
}

const geometry::PlaneMesh& Patch::mesh() const { return parts_->mesh; }
const std::vector<std::size_t>& Patch::rims() const { return parts_->rims; }
const std::vector<double>& Patch::poisson() const { return parts_->poisson; }
const FacedSolid* Patch::faced() const { return parts_->faced ? &*parts_->faced : nullptr; }
const std::vector<double>& Patch::halfThick() const { return parts_->halfThick; }
double Patch::riseAt(const MeshPlace& place) const { return parts_->faced ? place.of(parts_->rise) : 0; }
std::size_t Patch::unknowns() const { return 3 + parts_->controls; }
const std::vector<geometry::QpEntry>& Patch::energy() const { return parts_->energy; }

std::vector<geometry::QpTerm> Patch::depthOf(std::span<const MeshPlace> places, std::span<const double> weights,
                                             std::uint32_t offset) const {
  const Parts& parts = *parts_;
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  Vector sum = Vector::Zero(static_cast<Eigen::Index>(parts.controls));
  Vector load = Vector::Zero(parts.across.rows());
  const auto corners = static_cast<std::uint32_t>(parts.mesh.rim());
  bool isInner = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = places[i].weights[k] * weights[i];
      const std::uint32_t point = places[i].points[k];
      plane += weight * parts.planeTerms(parts.mesh.points()[point]);
      if (weight == 0 || parts.controls == 0) continue;
      if (point < corners) {
        const Parts::Between& between = parts.rim[point];
        sum[between.one] += weight * (1 - between.share);
        sum[between.other] += weight * between.share;
      } else {
        load[point - corners] += weight;
        isInner = true;
      }
    }
  }
  if (isInner) sum += parts.across.transpose() * parts.inside.solve(load);
  std::vector<geometry::QpTerm> terms;
  const auto add = [&](std::size_t unknown, double value) {
    if (std::abs(value) > 1e-13) terms.push_back({offset + static_cast<std::uint32_t>(unknown), value});
  };
  for (std::size_t i = 0; i < 3; ++i) add(i, plane[static_cast<Eigen::Index>(i)]);
  for (std::size_t i = 0; i < parts.controls; ++i) add(3 + i, sum[static_cast<Eigen::Index>(i)]);
  return terms;
}

std::vector<geometry::QpTerm> Patch::planeDepthOf(SectionPoint p, std::uint32_t offset) const {
  const Eigen::Vector3d terms = parts_->planeTerms(p);
  return {{offset, terms[0]}, {offset + 1, terms[1]}, {offset + 2, terms[2]}};
}

std::vector<double> Patch::depthsOf(std::span<const double> unknowns) const {
  const Parts& parts = *parts_;
  std::vector<double> out(parts.mesh.points().size());
  const Eigen::Vector3d plane(unknowns[0], unknowns[1], unknowns[2]);
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = plane.dot(parts.planeTerms(parts.mesh.points()[i]));
  for (std::size_t i = 0; i < parts.rise.size(); ++i) out[i] += parts.rise[i];
  if (parts.controls == 0) return out;
  const std::size_t corners = parts.mesh.rim();
  const std::span<const double> bends = unknowns.subspan(3);
  for (std::size_t i = 0; i < corners; ++i) {
    const Parts::Between& between = parts.rim[i];
    out[i] += bends[between.one] * (1 - between.share) + bends[between.other] * between.share;
  }
  if (corners == out.size()) return out;
  const Eigen::Map<const Vector> controls(bends.data(), static_cast<Eigen::Index>(bends.size()));
  const Vector inner = parts.inside.solve(parts.across * controls);
  for (std::size_t i = corners; i < out.size(); ++i) out[i] += inner[static_cast<Eigen::Index>(i - corners)];
  return out;
}

std::vector<double> Patch::slopesOf(std::span<const double> depths) const {
  const geometry::PlaneMesh& mesh = parts_->mesh;
  std::vector<double> slope(depths.size(), 0.0), weight(depths.size(), 0.0);
  for (const auto& t : mesh.triangles()) {
    const inflate::Element element = inflate::elementOf(mesh, t);
    SectionPoint gradient{};
    for (std::size_t k = 0; k < 3; ++k) gradient += element.gradient[k] * depths[t[k]];
    for (const std::uint32_t p : t) {
      slope[p] += norm(gradient) * parts_->scale.size;
      weight[p] += element.area2;
    }
  }
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = weight[i] > 0 ? slope[i] / weight[i] : 0;
  return slope;
}

std::optional<MeshPlace> Patch::find(SectionPoint p) const { return parts_->grid.find(parts_->mesh, p); }

MeshPlace Patch::onRim(SectionPoint p) const {
  const auto& points = parts_->mesh.points();
  MeshPlace best{{0, 0, 0}, {1, 0, 0}};
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t first = 0;
  for (const std::size_t size : parts_->rims) {
    const auto n = static_cast<std::uint32_t>(size);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t one = first + i, other = first + (i + 1) % n;
      const SectionPoint along = points[other] - points[one];
      const double squared = dot(along, along);
      const double t = squared > 0 ? std::clamp(dot(p - points[one], along) / squared, 0.0, 1.0) : 0.0;
      const double away = distance(p, points[one] + along * t);
      if (away >= least) continue;
      least = away;
      best = {{one, other, other}, {1 - t, t, 0}};
    }
    first += n;
  }
  return best;
}

}  // namespace spineloft::descriptive
