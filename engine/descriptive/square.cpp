#include "engine/descriptive/square.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "engine/descriptive/axes.h"
#include "engine/descriptive/prism.h"

namespace spineloft::descriptive {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Weight of Δz² beside Δx² and Δy², and of edges that leave their axis.
constexpr double kDepthWeight = 0.05, kAxisWeight = 9;

struct Edge {
  std::uint32_t a = 0, b = 0;
  std::size_t direction = 0;
};

/// Which directions meet at each corner.
std::vector<std::set<std::size_t>> meetingAt(const std::vector<Edge>& edges, std::size_t corners) {
  std::vector<std::set<std::size_t>> out(corners);
  for (const Edge& edge : edges) {
    out[edge.a].insert(edge.direction);
    out[edge.b].insert(edge.direction);
  }
  return out;
}

/// The directions that meet at most corners, and at how many of them.
std::pair<std::optional<Axes>, std::ptrdiff_t> axesOf(const Directions& directions, const std::vector<Edge>& edges,
                                                      std::size_t corners) {
  const auto at = meetingAt(edges, corners);
  const auto meetings = [&](const Axes& axes) {
    return std::ranges::count_if(at, [&](const std::set<std::size_t>& there) {
      return std::ranges::all_of(axes.direction, [&](std::size_t d) { return there.contains(d); });
    });
  };
  const std::optional<Axes> best = bestAxes(directions.all, [&](const Axes& axes) {
    const auto meeting = meetings(axes);
    const auto count = std::ranges::count_if(edges, [&](const Edge& e) { return axes.of(e.direction) != kNoAxis; });
    // Edges only decide between triples that meet as often.
    return meeting == 0
               ? 0
               : static_cast<double>(meeting) + static_cast<double>(count) / static_cast<double>(edges.size() + 1);
  });
  return {best, best ? meetings(*best) : 0};
}

/// Corner k of a face in the plane of three others, those that span the largest triangle.
struct Plane {
  std::array<std::uint32_t, 3> base{};
  std::uint32_t corner = 0;
};

std::vector<Plane> planesOf(const std::vector<Wireframe::Face>& faces, const std::vector<Vector3d>& X) {
  std::vector<Plane> out;
  for (const Wireframe::Face& face : faces) {
    std::array<std::uint32_t, 3> base{};
    double most = -1;
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = i + 1; j < face.size(); ++j) {
        for (std::size_t k = j + 1; k < face.size(); ++k) {
          const double area = (X[face[j]] - X[face[i]]).cross(X[face[k]] - X[face[i]]).norm();
          if (area <= most) continue;
          most = area;
          base = {face[i], face[j], face[k]};
        }
      }
    }
    for (const std::uint32_t corner : face) {
      if (std::ranges::find(base, corner) == base.end()) out.push_back({base, corner});
    }
  }
  return out;
}

/// Makes a squared solid, step by step.
class Squarer {
 public:
  Squarer(const Wireframe& wireframe, const DepthScale& scale) : wireframe_(wireframe), scale_(scale) {
    for (const PicturePoint p : wireframe.corners) {
      const SectionPoint at = scale.of(p);
      drawn_.emplace_back(at.x, at.y);
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    for (const Wireframe::Face& face : wireframe.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
        if (known.insert(std::minmax(a, b)).second) edges_.push_back({std::min(a, b), std::max(a, b), 0});
      }
    }
  }
  Result<FacedSolid> make() {
    std::vector<SectionPoint> ways;
    for (const Edge& edge : edges_) {
      const Vector2d way = drawn_[edge.b] - drawn_[edge.a];
      ways.push_back({way.x(), way.y()});
    }
    std::vector<int> at(drawn_.size());
    for (const Edge& edge : edges_) {
      ++at[edge.a];
      ++at[edge.b];
    }
    directions_ = directionsOf(ways, [&](std::size_t e, std::size_t f) {
      const Edge &one = edges_[e], &other = edges_[f];
      // At a corner of only two edges they go straight on.
      const auto isCorner = [&](std::uint32_t c) { return at[c] > 2 && (c == other.a || c == other.b); };
      return isCorner(one.a) || isCorner(one.b);
    });
    for (std::size_t e = 0; e < edges_.size(); ++e) edges_[e].direction = directions_.of[e];
    const auto [axes, meeting] = axesOf(directions_, edges_, drawn_.size());
    // Two corners of six say nothing of right angles: any three directions of a tent can be axes.
    const bool isWeak = !axes || 3 * meeting <= static_cast<std::ptrdiff_t>(drawn_.size());
    if (std::optional<FacedSolid> prism = isWeak ? prismOf(wireframe_, scale_, axes.has_value()) : std::nullopt) {
      if (!axes || prism->moved <= kMostMoved) return *std::move(prism);
    }
    if (!axes) return Failure{Error::ShapeInvalid, "no three of its edges meet at right angles"};
    axes_ = *axes;
    lift();
    polish();
    FacedSolid out;
    out.faces = wireframe_.faces;
    double mean = 0;
    for (const Vector3d& x : X_) mean += x.z() / static_cast<double>(X_.size());
    for (std::size_t i = 0; i < X_.size(); ++i) {
      if (!X_[i].allFinite()) return Failure{Error::ShapeInvalid, "its faces are no planes"};
      out.corners.push_back({X_[i].x(), X_[i].y(), X_[i].z() - mean});
      out.moved = std::max(out.moved, (X_[i].head<2>() - drawn_[i]).norm());
    }
    out.up = upOf(out);
    for (const Plane& plane : planes_) out.offPlane = std::max(out.offPlane, std::abs(offPlane(plane, nullptr)));
    if (!(volume() > 0) || out.offPlane > 1e-3) return Failure{Error::ShapeInvalid, "its faces are no planes"};
    return out;
  }

 private:
  Vector2d unitOf(const Edge& edge) const {
    const SectionPoint unit = directions_.all[edge.direction].unit;
    return {unit.x, unit.y};
  }
  double volume() const {
    double six = 0;
    for (const Wireframe::Face& face : wireframe_.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) six += X_[face[0]].dot(X_[face[i]].cross(X_[face[i + 1]]));
    }
    return six / 6;
  }
  /// Depths by least squares; the unknowns are z of every corner, then the slope of every direction that is no axis.
  void lift() {
    for (const Vector2d& p : drawn_) X_.emplace_back(p.x(), p.y(), 0);
    planes_ = planesOf(wireframe_.faces, X_);
    const auto corners = static_cast<Index>(drawn_.size()), others = static_cast<Index>(directions_.all.size());
    const auto rows = static_cast<Index>(edges_.size() + planes_.size()) + 1 + others;
    MatrixXd M = MatrixXd::Zero(rows, corners + others);
    VectorXd right = VectorXd::Zero(rows);
    Index row = 0;
    for (const Edge& edge : edges_) {
      const double along = (drawn_[edge.b] - drawn_[edge.a]).dot(unitOf(edge));
      M(row, edge.b) += 1;
      M(row, edge.a) -= 1;
      if (const std::size_t axis = axes_.of(edge.direction); axis != kNoAxis) {
        right[row] = axes_.slope[axis] * along;
      } else {
        M(row, corners + static_cast<Index>(edge.direction)) = -along;
      }
      ++row;
    }
    for (const Plane& plane : planes_) {
      const auto [i, j, k] = plane.base;
      Matrix3d base;
      base << drawn_[i].x(), drawn_[j].x(), drawn_[k].x(), drawn_[i].y(), drawn_[j].y(), drawn_[k].y(), 1, 1, 1;
      const Vector3d weights =
          base.colPivHouseholderQr().solve(Vector3d(drawn_[plane.corner].x(), drawn_[plane.corner].y(), 1));
      const double scale = 1 / (1 + weights.norm());
      M(row, plane.corner) += scale;
      M(row, i) -= scale * weights[0];
      M(row, j) -= scale * weights[1];
      M(row, k) -= scale * weights[2];
      ++row;
    }
    for (Index c = 0; c < corners; ++c) M(row, c) = 1 / static_cast<double>(corners);
    ++row;
    // Slopes that no edge has.
    for (Index d = 0; d < others; ++d) M(row + d, corners + d) = 1e-6;
    const VectorXd solved = M.completeOrthogonalDecomposition().solve(right);
    for (std::size_t i = 0; i < X_.size(); ++i) X_[i].z() = solved[static_cast<Index>(i)];
    // Of the two that look alike (Necker) what is seen is in front.
    if (volume() < 0) {
      for (Vector3d& x : X_) x.z() = -x.z();
    }
    planes_ = planesOf(wireframe_.faces, X_);
  }
  /// How far the corner of a plane is from its base, and the derivatives of that by the four corners.
  double offPlane(const Plane& plane, std::array<Vector3d, 4>* by) const {
    const Vector3d &o = X_[plane.base[0]], &x = X_[plane.corner];
    const Vector3d a = X_[plane.base[1]] - o, b = X_[plane.base[2]] - o, c = x - o;
    const Vector3d normal = a.cross(b);
    const double length = std::max(normal.norm(), 1e-12);
    if (by != nullptr) {
      (*by)[1] = b.cross(c) / length;
      (*by)[2] = c.cross(a) / length;
      (*by)[3] = normal / length;
      (*by)[0] = -((*by)[1] + (*by)[2] + (*by)[3]);
    }
    return c.dot(normal) / length;
  }
  /// Orthonormal axes nearest to the mean directions of their edges.
  std::array<Vector3d, 3> axesNow() const {
    Matrix3d means = Matrix3d::Zero();
    for (const Edge& edge : edges_) {
      const std::size_t axis = axes_.of(edge.direction);
      if (axis == kNoAxis) continue;
      const Vector3d way = X_[edge.b] - X_[edge.a];
      const double sign = way.head<2>().dot(unitOf(edge)) < 0 ? -1 : 1;
      means.col(static_cast<Index>(axis)) += sign * way;
    }
    for (Index k = 0; k < 3; ++k) means.col(k).normalize();
    const Eigen::JacobiSVD<Matrix3d> svd(means, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d axes = svd.matrixU() * svd.matrixV().transpose();
    return {axes.col(0), axes.col(1), axes.col(2)};
  }
  ModelPoint upOf(const FacedSolid& solid) const {
    constexpr double kBase = 0.94;  // cosine of 20°
    const std::array<Vector3d, 3> axes = axesNow();
    const Vector3d most = std::ranges::max(axes, {}, [](const Vector3d& axis) { return std::abs(axis.y()); });
    const ModelPoint axis = ModelPoint{most.x(), most.y(), most.z()} * (most.y() < 0 ? -1.0 : 1.0);
    ModelPoint up = axis;
    double best = kBase;
    for (const Wireframe::Face& face : solid.faces) {
      const ModelPoint down = normalOf(solid, face) * -1.0;
      if (dot(down, axis) <= best) continue;
      best = dot(down, axis);
      up = down;
    }
    return up;
  }
  void polish() {
    const std::vector<Vector3d> start = X_;
    const auto n = static_cast<Index>(3 * X_.size());
    const auto constraints = static_cast<Index>(planes_.size());
    for (int round = 0; round < kMostRounds; ++round) {
      const std::array<Vector3d, 3> axes = axesNow();
      MatrixXd J = MatrixXd::Zero(n + 3 * static_cast<Index>(edges_.size()), n);
      VectorXd r = VectorXd::Zero(J.rows());
      for (std::size_t i = 0; i < X_.size(); ++i) {
        for (Index k = 0; k < 3; ++k) {
          const Index at = 3 * static_cast<Index>(i) + k;
          const double weight = k == 2 ? std::sqrt(kDepthWeight) : 1;
          J(at, at) = weight;
          r[at] = weight * (X_[i][k] - start[i][k]);
        }
      }
      Index row = n;
      for (const Edge& edge : edges_) {
        const std::size_t axis = axes_.of(edge.direction);
        if (axis == kNoAxis) continue;
        const Matrix3d across = std::sqrt(kAxisWeight) * (Matrix3d::Identity() - axes[axis] * axes[axis].transpose());
        J.block<3, 3>(row, 3 * static_cast<Index>(edge.b)) = across;
        J.block<3, 3>(row, 3 * static_cast<Index>(edge.a)) = -across;
        r.segment<3>(row) = across * (X_[edge.b] - X_[edge.a]);
        row += 3;
      }
      const VectorXd step = stepOf(J, r, constraints);
      for (std::size_t i = 0; i < X_.size(); ++i) X_[i] += step.segment<3>(3 * static_cast<Index>(i));
      if (!(step.norm() > 1e-11)) break;
    }
  }
  /// The least of |J dx + r|² with all planes held to first order; planes that follow from others count once.
  VectorXd stepOf(const MatrixXd& J, const VectorXd& r, Index constraints) const {
    const Index n = J.cols();
    MatrixXd C = MatrixXd::Zero(n, constraints);  // transposed
    VectorXd c(constraints);
    for (Index k = 0; k < constraints; ++k) {
      const Plane& plane = planes_[static_cast<std::size_t>(k)];
      std::array<Vector3d, 4> by;
      c[k] = offPlane(plane, &by);
      const std::array<std::uint32_t, 4> of{plane.base[0], plane.base[1], plane.base[2], plane.corner};
      for (std::size_t i = 0; i < 4; ++i) C.block<3, 1>(3 * static_cast<Index>(of[i]), k) += by[i];
    }
    if (constraints == 0) return J.colPivHouseholderQr().solve(-r);
    Eigen::ColPivHouseholderQR<MatrixXd> qr(C);
    qr.setThreshold(1e-9);
    const Index rank = qr.rank();
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(n, n);
    const VectorXd wanted = (qr.colsPermutation().transpose() * c).head(rank);
    const MatrixXd R = qr.matrixR().topLeftCorner(rank, rank);
    const VectorXd held = -Q.leftCols(rank) * R.transpose().triangularView<Eigen::Lower>().solve(wanted);
    if (rank == n) return held;
    const MatrixXd free = Q.rightCols(n - rank);
    const VectorXd along = (J * free).colPivHouseholderQr().solve(-(r + J * held));
    return held + free * along;
  }

  const Wireframe& wireframe_;
  const DepthScale& scale_;
  std::vector<Vector2d> drawn_;
  std::vector<Edge> edges_;
  Directions directions_;
  Axes axes_;
  std::vector<Plane> planes_;
  std::vector<Vector3d> X_;
};

}  // namespace

Result<FacedSolid> squared(const Wireframe& wireframe, const DepthScale& scale) {
  return Squarer(wireframe, scale).make();
}

ModelPoint normalOf(const FacedSolid& solid, const Wireframe::Face& face) {
  ModelPoint normal{};
  for (std::size_t i = 0; i < face.size(); ++i) {
    normal += cross(solid.corners[face[i]], solid.corners[face[(i + 1) % face.size()]]);
  }
  return normalized(normal);
}

double depthOnEdge(const FacedSolid& solid, SectionPoint p) {
  double depth = 0, least = std::numeric_limits<double>::infinity();
  // A corner is where it was moved to.
  const ModelPoint nearest =
      std::ranges::min(solid.corners, {}, [&](const ModelPoint& c) { return distance(p, {c.x, c.y}); });
  if (distance(p, {nearest.x, nearest.y}) <= solid.moved) return nearest.z;
  for (const Wireframe::Face& face : solid.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const ModelPoint a = solid.corners[face[i]], b = solid.corners[face[(i + 1) % face.size()]];
      const SectionPoint from{a.x, a.y}, along = SectionPoint{b.x, b.y} - from;
      const double squared = dot(along, along);
      const double t = squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0.0;
      const double away = distance(p, from + along * t);
      if (away >= least) continue;
      least = away;
      depth = a.z + (b.z - a.z) * t;
    }
  }
  return depth;
}

bool isSquare(const Wireframe& wireframe, double size) {
  const Result<FacedSolid> made = squared(wireframe, {wireframe.corners[0], size});
  return made.ok() && made.value().moved <= kMostMoved;
}

}  // namespace spineloft::descriptive
