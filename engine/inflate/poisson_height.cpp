#include "engine/inflate/poisson_height.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "engine/inflate/element.h"

namespace spineloft::inflate {
namespace {

constexpr double kLoad = 4;  // −Δ(R² − r²)

}  // namespace

std::vector<double> poissonHeight(const geometry::PlaneMesh& mesh) {
  const std::size_t rim = mesh.rim(), count = mesh.points().size();
  std::vector<double> u(count, 0.0);
  if (count <= rim) return u;
  const auto free = static_cast<Eigen::Index>(count - rim);
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(6 * mesh.triangles().size());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(free);
  for (const auto& t : mesh.triangles()) {
    const Element element = elementOf(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < rim) continue;
      const auto row = static_cast<int>(t[i] - rim);
      load[row] += kLoad * element.area2 / 6;
      for (std::size_t k = 0; k < 3; ++k) {
        if (t[k] < rim || t[k] > t[i]) continue;
        const double value = dot(element.gradient[i], element.gradient[k]) / (2 * element.area2);
        entries.emplace_back(row, static_cast<int>(t[k] - rim), value);
      }
    }
  }
  Eigen::SparseMatrix<double> stiffness(free, free);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor(stiffness);
  if (factor.info() != Eigen::Success) return {};
  const Eigen::VectorXd solved = factor.solve(load);
  for (Eigen::Index i = 0; i < free; ++i) {
    const double value = solved[i];
    if (!std::isfinite(value)) return {};
    u[rim + static_cast<std::size_t>(i)] = std::max(0.0, value);
  }
  return u;
}

std::vector<double> rimRadii(const geometry::PlaneMesh& mesh, const std::vector<double>& u) {
  // Twice: along the two edges of the rim at each corner, weighted by the triangles' areas.
  std::vector<double> slope(mesh.rim(), 0.0), weight(mesh.rim(), 0.0);
  for (const auto& t : mesh.triangles()) {
    const Element element = elementOf(mesh, t);
    SectionPoint gradient{};
    for (std::size_t i = 0; i < 3; ++i) gradient += element.gradient[i] * u[t[i]];
    const double steep = norm(gradient) / element.area2;
    for (const std::uint32_t p : t) {
      if (p >= mesh.rim()) continue;
      slope[p] += steep * element.area2;
      weight[p] += element.area2;
    }
  }
  for (std::size_t i = 0; i < slope.size(); ++i) {
    slope[i] = weight[i] > 0 ? slope[i] / weight[i] / 2 : 0;
  }
  return slope;
}

double valueAt(const geometry::PlaneMesh& mesh, const std::vector<double>& u, SectionPoint p) {
  const std::optional<std::uint32_t> found = mesh.find(p);
  if (!found) return 0;
  const auto& t = mesh.triangles()[*found];
  const auto& points = mesh.points();
  const SectionPoint a = points[t[0]], b = points[t[1]], c = points[t[2]];
  const double whole = cross(b - a, c - a);
  const double atA = cross(b - p, c - p), atB = cross(c - p, a - p), atC = cross(a - p, b - p);
  return (u[t[0]] * atA + u[t[1]] * atB + u[t[2]] * atC) / whole;
}

}  // namespace spineloft::inflate
