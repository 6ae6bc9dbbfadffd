#include "engine/descriptive/planarity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spineloft::descriptive {
namespace {

using Window = std::vector<std::uint32_t>;

/// The points of a run, in order; `isRound`: it ends where it begins.
struct ControlRun {
  Window points;
  bool isRound = false;
};

std::vector<ControlRun> runsOf(const ControlLoops& loops) {
  std::vector<ControlRun> runs;
  std::uint32_t first = 0;
  for (const std::size_t size : loops.sizes) {
    const auto n = static_cast<std::uint32_t>(size);
    std::vector<std::uint32_t> folds;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (loops.isFold[first + i]) folds.push_back(i);
    }
    // One fold alone breaks nothing: the run from it to itself is the whole outline.
    if (folds.empty()) folds.push_back(0);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      ControlRun run{{}, folds.size() == 1 && !loops.isFold[first + folds[0]]};
      const std::uint32_t to = k + 1 < folds.size() ? folds[k + 1] : folds[0] + n;
      for (std::uint32_t i = folds[k]; i < to; ++i) run.points.push_back(first + i % n);
      if (!run.isRound && folds.size() > 1) run.points.push_back(first + to % n);
      runs.push_back(std::move(run));
    }
    first += n;
  }
  return runs;
}

/// Half overlapping parts of a run, `parts` of them without the overlap.
void addWindows(const ControlRun& run, std::size_t parts, std::vector<Window>& windows) {
  const std::size_t n = run.points.size();
  if (n < 4) return;
  const std::size_t size = std::max<std::size_t>(4, (n + parts - 1) / parts);
  if (size >= n) {
    if (parts == 1) windows.push_back(run.points);
    return;
  }
  const std::size_t stride = std::max<std::size_t>(1, size / 2);
  const std::size_t last = run.isRound ? n : n - size + 1;
  for (std::size_t from = 0; from < last; from += stride) {
    Window window;
    for (std::size_t i = 0; i < size; ++i) window.push_back(run.points[(from + i) % n]);
    windows.push_back(std::move(window));
  }
  if (!run.isRound) windows.emplace_back(run.points.end() - static_cast<std::ptrdiff_t>(size), run.points.end());
}

/// Adds factor · R / r² / m of one window.
void addWindow(const ControlLoops& loops, const Window& window, double factor, std::vector<geometry::QpEntry>& out) {
  const auto m = static_cast<Eigen::Index>(window.size());
  SectionPoint mean{};
  for (const std::uint32_t i : window) mean += loops.points[i] / static_cast<double>(m);
  double radius = 0;
  for (const std::uint32_t i : window) radius = std::max(radius, distance(loops.points[i], mean));
  if (!(radius > 0)) return;
  Eigen::MatrixXd plane(m, 3);
  for (Eigen::Index i = 0; i < m; ++i) {
    const SectionPoint p = (loops.points[window[static_cast<std::size_t>(i)]] - mean) / radius;
    plane.row(i) << p.x, p.y, 1;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> own((plane.transpose() * plane).eval());
  Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(m, m);
  for (int k = 0; k < 3; ++k) {
    const double value = own.eigenvalues()[k];
    if (value <= kRank * kRank * own.eigenvalues()[2]) continue;
    const Eigen::VectorXd direction = plane * own.eigenvectors().col(k) / std::sqrt(value);
    rest -= direction * direction.transpose();
  }
  rest *= factor / (radius * radius * static_cast<double>(m));
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index k = 0; k < m; ++k) {
      const std::uint32_t row = window[static_cast<std::size_t>(i)], column = window[static_cast<std::size_t>(k)];
      if (column <= row) out.push_back({row, column, rest(i, k)});
    }
  }
}

}  // namespace

std::vector<geometry::QpEntry> planarityEnergy(const ControlLoops& loops, double alpha) {
  const std::vector<ControlRun> runs = runsOf(loops);
  std::vector<Window> windows;
  const bool anyFold = std::ranges::find(loops.isFold, true) != loops.isFold.end();
  if (!anyFold && loops.sizes.size() > 1) {
    Window all(loops.points.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    windows.push_back(std::move(all));
  }
  for (const ControlRun& run : runs) {
    for (const std::size_t parts : {1, 2, 4, 8}) addWindows(run, parts, windows);
  }
  std::vector<geometry::QpEntry> out;
  for (const Window& window : windows) addWindow(loops, window, 8 * alpha / static_cast<double>(windows.size()), out);
  // Entries of one place, once.
  std::ranges::sort(out,
                    [](const auto& a, const auto& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (kept > 0 && out[kept - 1].row == out[i].row && out[kept - 1].column == out[i].column) {
      out[kept - 1].value += out[i].value;
    } else {
      out[kept++] = out[i];
    }
  }
  out.resize(kept);
  return out;
}

}  // namespace spineloft::descriptive
