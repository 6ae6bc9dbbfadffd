#include "engine/pull/displacement.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace spineloft::pull {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Role = Sheet::Role;

constexpr double kThin = 1e-3;  // of the longest side squared: a thinner triangle has no more say than that

struct Weights {
  std::vector<std::array<double, 3>> cotangents;  // of every triangle, at its corners
  std::vector<double> areas;                      // of every vertex: a third of its triangles
};

Weights weightsOf(const Sheet& sheet) {
  Weights weights;
  weights.areas.assign(sheet.points.size(), 0.0);
  weights.cotangents.reserve(sheet.triangles.size());
  for (const auto& t : sheet.triangles) {
    const std::array<ModelPoint, 3> sides{sheet.points[t[2]] - sheet.points[t[1]],
                                          sheet.points[t[0]] - sheet.points[t[2]],
                                          sheet.points[t[1]] - sheet.points[t[0]]};
    const double area2 = norm(cross(sides[0], sides[1]));
    const double longest2 = std::max({dot(sides[0], sides[0]), dot(sides[1], sides[1]), dot(sides[2], sides[2])});
    // All three are divided by the same, so that the energy of the triangle stays one that is never negative.
    const double by = std::max({area2, kThin * longest2, 1e-30});
    weights.cotangents.push_back(
        {-dot(sides[1], sides[2]) / by, -dot(sides[2], sides[0]) / by, -dot(sides[0], sides[1]) / by});
    for (const std::uint32_t v : t) weights.areas[v] += area2 / 6;
  }
  return weights;
}

// Rows and columns of the Laplacian for all vertices; minus the integral of the Laplacian.
std::vector<Eigen::Triplet<double, int>> laplacian(const Sheet& sheet, const Weights& weights) {
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(12 * sheet.triangles.size());
  for (std::size_t k = 0; k < sheet.triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<int>(sheet.triangles[k][(i + 1) % 3]),
                 b = static_cast<int>(sheet.triangles[k][(i + 2) % 3]);
      const double half = weights.cotangents[k][i] / 2;
      entries.emplace_back(a, b, -half);
      entries.emplace_back(b, a, -half);
      entries.emplace_back(a, a, half);
      entries.emplace_back(b, b, half);
    }
  }
  return entries;
}

}  // namespace

bool spread(Sheet& sheet, Stiffness stiffness) {
  const auto count = static_cast<Eigen::Index>(sheet.points.size());
  const Weights weights = weightsOf(sheet);
  // Free vertices first, the others behind them.
  std::vector<int> column(sheet.points.size());
  int free = 0;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] == Role::Free) column[v] = free++;
  }
  if (free == 0) return true;
  Eigen::MatrixXd fixed = Eigen::MatrixXd::Zero(count - free, 3);
  int other = free;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] == Role::Free) continue;
    fixed.row(other - free) << sheet.moves[v].x, sheet.moves[v].y, sheet.moves[v].z;
    column[v] = other++;
  }
  std::vector<Eigen::Triplet<double, int>> toFree, toFixed;
  for (const auto& entry : laplacian(sheet, weights)) {
    const int row = column[static_cast<std::size_t>(entry.row())], at = column[static_cast<std::size_t>(entry.col())];
    if (at < free) {
      toFree.emplace_back(row, at, entry.value());
    } else {
      toFixed.emplace_back(row, at - free, entry.value());
    }
  }
  Sparse freeColumns(count, free), fixedColumns(count, count - free);
  freeColumns.setFromTriplets(toFree.begin(), toFree.end());
  fixedColumns.setFromTriplets(toFixed.begin(), toFixed.end());
  Sparse system;
  Eigen::MatrixXd load;
  if (stiffness == Stiffness::AlongLines) {
    system = freeColumns.topRows(free);
    load = -(fixedColumns.topRows(free) * fixed);
  } else {
    Eigen::VectorXd rows(count);
    // Of a rim vertex both the Laplacian and the area are those of the side that follows: nothing moves beyond.
    for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
      const bool counts = stiffness == Stiffness::Smooth || sheet.roles[v] != Role::Rim;
      rows[column[v]] = counts ? 1 / std::max(weights.areas[v], 1e-12) : 0;
    }
    const Sparse weighted = Sparse(freeColumns.transpose()) * rows.asDiagonal();
    system = weighted * freeColumns;
    load = -(weighted * (fixedColumns * fixed));
  }
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(system);
  if (factor.info() != Eigen::Success) return false;
  const Eigen::MatrixXd solved = factor.solve(load);
  if (!solved.allFinite()) return false;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] != Role::Free) continue;
    const auto row = solved.row(column[v]);
    sheet.moves[v] = {row[0], row[1], row[2]};
  }
  return true;
}

}  // namespace spineloft::pull
