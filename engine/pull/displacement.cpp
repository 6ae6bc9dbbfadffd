#include "engine/pull/displacement.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

// The energy of a sheet's displacement, in its free vertices: half of xᵀ energy x + xᵀ coupling (what is given).
struct System {
  std::vector<int> column;  // of every vertex: free ones first, the others behind them
  int free = 0;
  Sparse energy, coupling;
};

System systemOf(const Sheet& sheet, const Weights& weights, Stiffness stiffness) {
  const auto count = static_cast<Eigen::Index>(sheet.points.size());
  System system;
  system.column.resize(sheet.points.size());
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] == Role::Free) system.column[v] = system.free++;
  }
  int other = system.free;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] != Role::Free) system.column[v] = other++;
  }
  std::vector<Eigen::Triplet<double, int>> toFree, toFixed;
  for (const auto& entry : laplacian(sheet, weights)) {
    const int row = system.column[static_cast<std::size_t>(entry.row())],
              at = system.column[static_cast<std::size_t>(entry.col())];
    if (at < system.free) {
      toFree.emplace_back(row, at, entry.value());
    } else {
      toFixed.emplace_back(row, at - system.free, entry.value());
    }
  }
  Sparse freeColumns(count, system.free), fixedColumns(count, count - system.free);
  freeColumns.setFromTriplets(toFree.begin(), toFree.end());
  fixedColumns.setFromTriplets(toFixed.begin(), toFixed.end());
  if (stiffness == Stiffness::AlongLines) {
    system.energy = freeColumns.topRows(system.free);
    system.coupling = fixedColumns.topRows(system.free);
    return system;
  }
  Eigen::VectorXd rows(count);
  // Of a rim vertex both the Laplacian and the area are those of the side that follows: nothing moves beyond.
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    const bool counts = stiffness == Stiffness::Smooth || sheet.roles[v] != Role::Rim;
    rows[system.column[v]] = counts ? 1 / std::max(weights.areas[v], 1e-12) : 0;
  }
  const Sparse weighted = Sparse(freeColumns.transpose()) * rows.asDiagonal();
  system.energy = weighted * freeColumns;
  system.coupling = weighted * fixedColumns;
  return system;
}

// None where there is no solution in doubles.
std::optional<Eigen::MatrixXd> solved(const System& system, const Eigen::MatrixXd& load) {
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(system.energy);
  if (factor.info() != Eigen::Success) return std::nullopt;
  Eigen::MatrixXd out = factor.solve(load);
  return out.allFinite() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace

bool spread(Sheet& sheet, Stiffness stiffness) {
  const System system = systemOf(sheet, weightsOf(sheet), stiffness);
  if (system.free == 0) return true;
  Eigen::MatrixXd given = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(sheet.points.size()) - system.free, 3);
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] != Role::Free)
      given.row(system.column[v] - system.free) << sheet.moves[v].x, sheet.moves[v].y, sheet.moves[v].z;
  }
  const auto moves = solved(system, -(system.coupling * given));
  if (!moves) return false;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] != Role::Free) continue;
    const auto row = moves->row(system.column[v]);
    sheet.moves[v] = {row[0], row[1], row[2]};
  }
  return true;
}

bool swell(Sheet& sheet, Stiffness stiffness, ModelPoint out) {
  const Weights weights = weightsOf(sheet);
  const System system = systemOf(sheet, weights, stiffness);
  if (system.free == 0) return true;
  Eigen::MatrixXd load(system.free, 1);
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] == Role::Free) load(system.column[v], 0) = weights.areas[v];
  }
  const auto heights = solved(system, load);
  const double most = heights ? heights->maxCoeff() : 0;
  if (!(most > 0)) return false;
  for (std::size_t v = 0; v < sheet.roles.size(); ++v) {
    if (sheet.roles[v] == Role::Free) sheet.moves[v] = out * ((*heights)(system.column[v], 0) / most);
  }
  return true;
}

}  // namespace spineloft::pull
