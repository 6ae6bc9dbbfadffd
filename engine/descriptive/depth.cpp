#include "engine/descriptive/depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "engine/base/groups.h"
#include "engine/descriptive/depth_rows.h"

namespace spineloft::descriptive {
namespace {

using geometry::QpRow;
using geometry::QpTerm;

/// Broken by more than what the solver lets pass.
constexpr double kTolerance = 1e-7;
/// Means over an overlap are taken over about so many cells.
constexpr std::size_t kMeanCells = 64;
/// Soft enough to be seen beside a plane that only its gauge holds, 1 / kDepthGauge.
constexpr double kSlackCost = 1e4;
/// Of pins that contradict each other.
constexpr double kPinWeight = 1e6;

/// a − b, terms of the same unknown added.
std::vector<QpTerm> difference(std::vector<QpTerm> a, const std::vector<QpTerm>& b) {
  for (const QpTerm& term : b) a.push_back({term.unknown, -term.value});
  return a;
}

/// Which overlaps bring pieces together: a forest of pairs, those with the largest piece first, then those that overlap
/// most. A leg hangs on the table, not on the leg that it passes.
std::vector<bool> contacts(const Overlaps& overlaps, std::size_t pieces) {
  std::vector<std::size_t> area(pieces, 0);
  for (std::uint32_t cell = 0; cell < overlaps.cells(); ++cell) {
    for (const std::uint32_t piece : overlaps.in(cell)) ++area[piece];
  }
  const std::vector<Overlap>& all = overlaps.all();
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) {
    return std::pair(std::max(area[all[k].a], area[all[k].b]), all[k].cells.size());
  });
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  Groups groups(pieces);
  for (const std::size_t k : order) {
    if (groups.of(all[k].a) == groups.of(all[k].b)) continue;
    groups.unite(all[k].a, all[k].b);
    pairs.insert({all[k].a, all[k].b});
  }
  std::vector<bool> out;
  for (const Overlap& one : all) out.push_back(pairs.contains({one.a, one.b}));
  return out;
}

class Program {
 public:
  explicit Program(const DepthInput& input) : input_(input), rows_(orderRows(input)) {
    std::uint32_t next = 0;
    for (const Patch& patch : input.patches) {
      offsets_.push_back(next);
      next += static_cast<std::uint32_t>(patch.unknowns());
    }
    qp_.unknowns = next;
    qp_.linear.assign(next, 0.0);
    for (std::size_t piece = 0; piece < input.patches.size(); ++piece) {
      for (const geometry::QpEntry& e : input.patches[piece].energy()) {
        qp_.energy.push_back({e.row + offsets_[piece], e.column + offsets_[piece], e.value});
      }
    }
    for (const Tie& tie : input.ties) {
      addSquare(difference(termsOf(tie.one), termsOf(tie.other)), kTieWeight * tie.weight,
                riseOf(tie.other) - riseOf(tie.one) + tie.nearer);
    }
    pull();
  }

  bool pinsHold() const { return !pinsGiveWay_; }

  /// One solution for these distances of the surfaces from the middles.
  Result<geometry::QpSolution> solve(std::span<const PieceDepth> depths) {
    geometry::Qp program = qp_;
    program.linear = linearFor(depths);
    made_.clear();
    for (const DepthPin& pin : input_.pins) {
      if (pinsGiveWay_) break;
      made_.push_back(kPin);
      program.rows.push_back({termsOf(pin.at), pin.depth - riseOf(pin.at), kPin, true});
    }
    std::vector<std::uint32_t> start;
    for (const std::uint32_t row : binding_) {
      start.push_back(static_cast<std::uint32_t>(program.rows.size()));
      program.rows.push_back(make(row, depths));
    }
    program.more = [&](std::span<const double> z) { return broken(z, depths); };
    // What would give way by more than the gap, had it a slack, cannot hold.
    const geometry::QpOptions options{kTolerance, kSlackCost, start, kSlackCost * kGap};
    Result<geometry::QpSolution> solved = geometry::solveQp(program, options);
    if (!solved && !input_.pins.empty() && !pinsGiveWay_) {
      // Pins that cannot all hold exactly hold as well as they can.
      pinsGiveWay_ = true;
      for (const DepthPin& pin : input_.pins) addSquare(termsOf(pin.at), kPinWeight, pin.depth - riseOf(pin.at));
      binding_.clear();
      return solve(depths);
    }
    if (!solved) return solved;
    binding_.clear();
    for (const std::uint32_t row : solved.value().active) {
      if (made_[row] != kPin) binding_.push_back(made_[row]);
    }
    return solved;
  }
  std::span<const double> unknownsOf(std::size_t piece, std::span<const double> z) const {
    return z.subspan(offsets_[piece], input_.patches[piece].unknowns());
  }

 private:
  static constexpr std::uint32_t kPin = 0xffffffffu;

  std::vector<QpTerm> termsOf(const PiecePlace& place) const {
    const double whole = 1;
    return input_.patches[place.piece].depthOf({&place.at, 1}, {&whole, 1}, offsets_[place.piece]);
  }
  double riseOf(const PiecePlace& place) const { return input_.patches[place.piece].riseAt(place.at); }
  /// What its terms are at least.
  double leastOfTerms(const OrderRow& row, std::span<const PieceDepth> depths) const {
    return leastOf(row, depths) - riseOf(row.a) + riseOf(row.b);
  }
  /// weight · (Σ terms − target)².
  void addSquare(const std::vector<QpTerm>& terms, double weight, double target) {
    for (const QpTerm& a : terms) {
      qp_.linear[a.unknown] -= weight * target * a.value;
      for (const QpTerm& b : terms) {
        if (b.unknown <= a.unknown) qp_.energy.push_back({a.unknown, b.unknown, weight * a.value * b.value});
      }
    }
  }
  /// Planes of pieces that overlap are a distance apart over all of the overlap; apart_ is what it multiplies.
  void pull() {
    const auto& overlaps = input_.orders.overlaps.all();
    const std::vector<bool> isNear = contacts(input_.orders.overlaps, input_.patches.size());
    for (std::size_t k = 0; k < overlaps.size(); ++k) {
      const Order& order = input_.orders.orders[k];
      const auto& cells = overlaps[k].cells;
      const std::size_t step = 1 + cells.size() / kMeanCells;
      const double weight =
          (isNear[k] ? kPull : kPassingPull) * static_cast<double>(step) / static_cast<double>(cells.size());
      std::vector<QpTerm>& sum = apart_.emplace_back();
      for (std::size_t i = 0; i < cells.size(); i += step) {
        const PicturePoint p = input_.orders.overlaps.middle(cells[i]);
        const auto over = input_.patches[order.over].planeDepthOf({p.x, -p.y}, offsets_[order.over]);
        const auto under = input_.patches[order.under].planeDepthOf({p.x, -p.y}, offsets_[order.under]);
        const std::vector<QpTerm> terms = difference(over, under);
        addSquare(terms, weight, 0);
        for (const QpTerm& term : terms) sum.push_back({term.unknown, weight * term.value});
      }
    }
  }
  /// The distance at which neither of two pieces has to turn: the largest that a row asks for.
  std::vector<double> linearFor(std::span<const PieceDepth> depths) const {
    std::vector<double> linear = qp_.linear, distance(apart_.size(), 0.0);
    for (const OrderRow& row : rows_) {
      if (input_.orders.orders[row.overlap].kind == OrderKind::Inside) continue;
      distance[row.overlap] = std::max(distance[row.overlap], leastOfTerms(row, depths));
    }
    for (std::size_t k = 0; k < apart_.size(); ++k) {
      for (const QpTerm& term : apart_[k]) linear[term.unknown] -= distance[k] * term.value;
    }
    return linear;
  }
  QpRow make(std::uint32_t row, std::span<const PieceDepth> depths) {
    made_.push_back(row);
    const OrderRow& one = rows_[row];
    return {difference(termsOf(one.a), termsOf(one.b)), leastOfTerms(one, depths), one.overlap, false};
  }
  /// The worst of each kind in each overlap.
  std::vector<QpRow> broken(std::span<const double> z, std::span<const PieceDepth> depths) {
    std::vector<std::vector<double>> middles;
    for (std::size_t piece = 0; piece < input_.patches.size(); ++piece) {
      middles.push_back(input_.patches[piece].depthsOf(unknownsOf(piece, z)));
    }
    std::map<std::pair<std::uint32_t, OrderRow::Kind>, std::pair<double, std::uint32_t>> worst;
    for (std::uint32_t i = 0; i < rows_.size(); ++i) {
      const OrderRow& row = rows_[i];
      const double apart = row.a.at.of(middles[row.a.piece]) - row.b.at.of(middles[row.b.piece]);
      const double missing = leastOf(row, depths) - apart;
      if (!(missing > 2 * kTolerance)) continue;
      const auto [at, isNew] = worst.try_emplace({row.overlap, row.kind}, missing, i);
      if (!isNew && missing > at->second.first) at->second = {missing, i};
    }
    std::vector<QpRow> out;
    for (const auto& [key, one] : worst) {
      // A row that gave way to a contradiction stays broken.
      if (std::ranges::find(made_, one.second) == made_.end()) out.push_back(make(one.second, depths));
    }
    return out;
  }

  const DepthInput& input_;
  std::vector<OrderRow> rows_;
  std::vector<std::uint32_t> offsets_;
  geometry::Qp qp_;                         ///< energy, and what of the linear part does not depend on thickness
  std::vector<std::vector<QpTerm>> apart_;  ///< by overlap
  std::vector<std::uint32_t> made_;         ///< by row of the program: which of rows_
  std::vector<std::uint32_t> binding_;      ///< of the last solution
  bool pinsGiveWay_ = false;
};

/// How far front and back are from the middle, where it has these slopes.
void setThickness(const Patch& patch, const Piece& piece, const DepthScale& scale, std::span<const double> slopes,
                  PieceDepth& depth) {
  const std::size_t n = patch.mesh().points().size();
  depth.front.assign(n, 0.0);
  depth.back.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double tilt = std::min(kMostTilt, std::sqrt(1 + slopes[i] * slopes[i]));
    if (patch.faced() != nullptr) {
      depth.front[i] = depth.back[i] = patch.halfThick()[i];
    } else if (piece.kind == PieceKind::Flat) {
      const double thickness = piece.thickness > 0 ? piece.thickness / scale.size : kThickness;
      depth.front[i] = depth.back[i] = thickness / 2 * tilt;
    } else if (i >= patch.mesh().rim()) {
      const double t = std::sqrt(std::max(0.0, patch.poisson()[i])) / scale.size * tilt;
      depth.front[i] = piece.front * t;
      depth.back[i] = std::max(piece.back * t, kLeastThick - depth.front[i]);
    }
  }
}

}  // namespace

Result<Depths> solveDepths(const DepthInput& input) {
  Depths out;
  for (std::size_t i = 0; i < input.patches.size(); ++i) {
    PieceDepth depth;
    const std::vector<double> level(input.patches[i].mesh().points().size(), 0.0);
    setThickness(input.patches[i], input.pieces[i], input.scale, level, depth);
    out.pieces.push_back(std::move(depth));
  }
  Program program(input);
  for (int pass = 0; pass < 2; ++pass) {
    const Result<geometry::QpSolution> solved = program.solve(out.pieces);
    if (!solved) return solved.failure();
    const geometry::QpSolution& solution = solved.value();
    out.stats = {solution.z.size(), solution.rows.size(), solution.active.size(), out.stats.rounds + solution.rounds,
                 solution.broken,   program.pinsHold()};
    out.conflict = solution.conflict;
    for (std::size_t i = 0; i < input.patches.size(); ++i) {
      PieceDepth& depth = out.pieces[i];
      depth.middle = input.patches[i].depthsOf(program.unknownsOf(i, solution.z));
      if (pass > 0) continue;
      setThickness(input.patches[i], input.pieces[i], input.scale, input.patches[i].slopesOf(depth.middle), depth);
    }
  }
  return out;
}

}  // namespace spineloft::descriptive
