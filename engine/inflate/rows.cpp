#include "engine/inflate/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "engine/geometry/corners.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/spread.h"

namespace spineloft::inflate {
namespace {

constexpr double kOutline = 1 - 1e-9;               ///< s of the outline itself
constexpr double kOfWidth = 0.25;                   ///< of the half width, between points of a row
constexpr double kAtBone = 0.08, kFromBone = 0.45;  ///< and near the skeleton: that much, and more with s
constexpr double kLeastInRow = 6;

using Row = std::vector<LevelPoint>;
using Ids = std::vector<std::uint32_t>;

/// The closed line with points so far apart as the place allows, even between corners, which stay.
Row resampled(const Row& line, double level, double spacing) {
  const std::size_t n = line.size();
  std::vector<SectionPoint> closed;
  std::vector<double> steps(n + 1, 0.0);
  const double share = std::min(kOfWidth, kAtBone + kFromBone * level);
  double finest = spacing;
  for (std::size_t i = 0; i < n; ++i) {
    const LevelPoint &a = line[i], &b = line[(i + 1) % n];
    const double most = std::max(1e-9, std::min(spacing, share * (a.half + b.half) / 2));
    steps[i + 1] = steps[i] + distance(a.at, b.at) / most;
    finest = std::min(finest, most);
    closed.push_back(a.at);
  }
  closed.push_back(closed.front());
  // Corners by the way along the line, then by steps.
  const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(closed));
  std::vector<double> corners =
      geometry::cornersOf(std::span<const SectionPoint>(closed), std::span<const double>(s), finest);
  for (double& corner : corners) {
    corner = steps[static_cast<std::size_t>(std::ranges::lower_bound(s, corner) - s.begin())];
  }
  if (corners.empty()) corners.push_back(0);
  const auto pieces = static_cast<double>(corners.size());
  Row out;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double from = corners[c], to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + steps[n];
    const auto count = static_cast<int>(std::ceil(std::max(to - from, kLeastInRow / pieces) - 1e-9));
    for (int k = 0; k < count; ++k) {
      const double at = std::fmod(from + (to - from) * k / count, steps[n]);
      const auto after = std::ranges::upper_bound(steps, at);
      const std::size_t i = std::min(static_cast<std::size_t>(after - steps.begin()), n) - 1;
      const LevelPoint &a = line[i], &b = line[(i + 1) % n];
      const double span = steps[i + 1] - steps[i], way = span > 0 ? std::clamp((at - steps[i]) / span, 0.0, 1.0) : 0;
      out.push_back({lerp(a.at, b.at, way), std::lerp(a.half, b.half, way)});
    }
  }
  return out;
}

/// The rows of one piece: for each outline the line of a level, once for each level.
class RowTable {
 public:
  RowTable(const Fields& fields, const geometry::Contours& piece, double spacing)
      : fields_(fields), piece_(piece), spacing_(spacing) {}

  /// One row an outline; empty where the level has not one line an outline.
  const std::vector<Row>& at(double level) {
    const auto found = rows_.find(level);
    if (found != rows_.end()) return found->second;
    return rows_[level] = level >= kOutline ? outlines() : traced(level);
  }

 private:
  std::vector<Row> traced(double level) const {
    std::vector<Row> rows(fields_.sizes.size());
    for (LevelLine& line : levelLines(fields_, level)) {
      if (!rows[line.side].empty()) return {};
      rows[line.side] = resampled(line.points, level, spacing_);
    }
    const bool whole = std::ranges::none_of(rows, [](const Row& row) { return row.empty(); });
    return whole ? rows : std::vector<Row>{};
  }
  /// The outlines themselves; H is that of the nearest place on the rim of the fields.
  std::vector<Row> outlines() const {
    const auto& points = fields_.mesh.points();
    const geometry::RimDistance rim(std::span<const SectionPoint>(points).first(fields_.mesh.rim()), fields_.sizes);
    std::vector<std::uint32_t> next(fields_.mesh.rim());
    std::uint32_t first = 0;
    for (const std::size_t size : fields_.sizes) {
      for (std::uint32_t i = 0; i < size; ++i) next[first + i] = first + (i + 1) % static_cast<std::uint32_t>(size);
      first += static_cast<std::uint32_t>(size);
    }
    std::vector<Row> rows;
    for (const auto& outline : geometry::sampleRegion(piece_, std::min(spacing_, fields_.spacing))) {
      Row row;
      for (const PicturePoint p : outline) {
        const SectionPoint at{p.x, -p.y};
        const std::uint32_t a = rim.nearest(at).edge, b = next[a];
        const SectionPoint along = points[b] - points[a];
        const double share = std::clamp(dot(at - points[a], along) / std::max(1e-12, dot(along, along)), 0.0, 1.0);
        row.push_back({at, std::lerp(fields_.half[a], fields_.half[b], share)});
      }
      std::ranges::reverse(row);  // the region on the right
      rows.push_back(resampled(row, 1, spacing_));
    }
    return rows;
  }

  const Fields& fields_;
  const geometry::Contours& piece_;
  double spacing_;
  std::map<double, std::vector<Row>> rows_;
};

/// A closed row from a place of it on round to that again; a row of one point is only that.
struct Ring {
  Ids ids;
  std::vector<ModelPoint> at;
  std::vector<char> turns;  ///< a walk turns round here, at an end of the skeleton
  std::size_t steps() const { return ids.size() - 1; }
};

/// How two rows are joined in order: of all ways the one whose joining edges are shortest, by the sum of their squares
/// (Fuchs, Kedem and Uselton 1977). Where a walk turns round, no point is joined to what lies on both sides of the
/// turn, which is the same. Only ways near the even one are looked at.
class Joining {
 public:
  /// `reach`: how far from the even way, share of the longer row.
  Joining(const Ring& a, const Ring& b, double reach)
      : a_(a),
        b_(b),
        n_(a.steps()),
        m_(b.steps()),
        reach_(static_cast<std::size_t>(kLeastReach + reach * static_cast<double>(std::max(n_, m_)))) {}

  /// Calls move(i, k, alongB) for each step, from (i, k) along a or b, last one first; false when there is no way.
  template <class Move>
  bool run(const Move& move) {
    const std::size_t wide = std::min(2 * reach_ + 1, m_ + 1);
    std::vector<Costs> above(wide, kNone), now(wide, kNone);
    from_.assign((n_ + 1) * wide, {0, 0});
    for (std::size_t i = 0; i <= n_; ++i) {
      const std::size_t low = lowest(i, wide), before = i > 0 ? lowest(i - 1, wide) : 0;
      for (std::size_t c = 0; c < wide; ++c) {
        const std::size_t k = low + c;
        Costs& cost = now[c] = kNone;
        if (i == 0 && k == 0) {
          cost = {0, 0};
          continue;
        }
        const ModelPoint off = a_.at[i] - b_.at[k];
        const double apart = dot(off, off);
        if (i > 0 && k >= before && k - before < wide)
          add(cost, 0, above[k - before], {a_.turns[i - 1] != 0, i == 1 && k == 0});
        if (k > 0 && c > 0) add(cost, 1, now[c - 1], {b_.turns[k - 1] != 0, i == 0 && k == 1});
        from_[i * wide + c] = {viaB_[0], viaB_[1]};
        cost[0] += apart;
        cost[1] += apart;
      }
      above.swap(now);
    }
    const Costs& end = above[m_ - lowest(n_, wide)];
    if (!std::isfinite(std::min(end[0], end[1]))) return false;
    bool alongB = end[1] < end[0];
    for (std::size_t i = n_, k = m_; i > 0 || k > 0;) {
      const bool before = from_[i * wide + k - lowest(i, wide)][alongB];
      move(alongB ? i : i - 1, alongB ? k - 1 : k, alongB);
      (alongB ? k : i) -= 1;
      alongB = before;
    }
    return true;
  }

 private:
  /// Of being joined so far, by the last move: along a, or along b.
  using Costs = std::array<double, 2>;
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr Costs kNone{kNever, kNever};
  static constexpr double kLeastReach = 10;

  /// The band of b at a place of a.
  std::size_t lowest(std::size_t i, std::size_t wide) const {
    const std::size_t even = n_ > 0 ? i * m_ / n_ : 0;
    return std::min(even > reach_ ? even - reach_ : 0, m_ + 1 - wide);
  }
  struct Before {
    bool turn, start;
  };
  /// A move along a (0) or b (1) after the cheaper of the moves that may be before it.
  void add(Costs& cost, std::size_t along, const Costs& before, Before where) {
    const bool other = along == 0;  // after a turn only a move along the other row
    const bool viaB = where.turn ? other : before[1] < before[0];
    cost[along] = where.start ? (where.turn ? kNever : 0) : before[viaB];
    viaB_[along] = viaB;
  }

  const Ring &a_, &b_;
  std::size_t n_, m_, reach_;
  std::array<bool, 2> viaB_{};
  std::vector<std::array<bool, 2>> from_;
};

class Builder {
 public:
  Builder(const Fields& fields, const RowParams& params, mesh::TriMesh& mesh)
      : fields_(fields), params_(params), mesh_(mesh), first_(mesh.positions.size()) {}

  std::uint32_t add(const LevelPoint& p, double z) {
    const double thick = std::pow(p.half, params_.follow) * std::pow(params_.widest, 1 - params_.follow);
    const ModelPoint at{p.at.x, p.at.y, z * thick * params_.height};
    points_.push_back(at);
    mesh_.positions.push_back({static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
    const double u = (p.at.x + 0.5) / params_.picture.width, v = (0.5 - p.at.y) / params_.picture.height;
    mesh_.uv.push_back({static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  Ids add(const Row& row, double z) {
    Ids ids;
    for (const LevelPoint& p : row) ids.push_back(add(p, z));
    return ids;
  }
  /// The points of the skeleton at a height: by point of the mesh of the fields.
  Ids addBones(double z) {
    Ids ids(fields_.onBone.size(), 0);
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      if (fields_.onBone[i]) ids[i] = add({fields_.mesh.points()[i], fields_.half[i]}, z);
    }
    return ids;
  }

  /// Triangles between two closed rows that run the same way, outside on the right of the way from a to b.
  bool join(const Ids& a, const Ids& b) {
    const auto [startA, startB] = closest(a, b);
    const Ring one = ring(a, startA), other = ring(b, startB);
    const auto add = [&](std::size_t i, std::size_t k, bool alongB) {
      if (alongB) {
        mesh_.triangles.push_back({one.ids[i], other.ids[k], other.ids[k + 1]});
      } else {
        mesh_.triangles.push_back({one.ids[i + 1], one.ids[i], other.ids[k]});
      }
    };
    constexpr double kNear = 0.1;
    const bool walk = std::ranges::count(one.turns, 1) + std::ranges::count(other.turns, 1) > 0;
    return (!walk && Joining(one, other, kNear).run(add)) || Joining(one, other, 1).run(add);
  }

 private:
  const ModelPoint& at(std::uint32_t id) const { return points_[id - first_]; }
  double squared(std::uint32_t a, std::uint32_t b) const { return dot(at(a) - at(b), at(a) - at(b)); }
  Ring ring(const Ids& row, std::size_t start) const {
    Ring out;
    const std::size_t n = row.size();
    for (std::size_t i = 0; i < n + (n > 1 ? 1 : 0); ++i) {
      out.ids.push_back(row[(start + i) % n]);
      out.at.push_back(at(out.ids.back()));
      out.turns.push_back(n > 1 && row[(start + i + n - 1) % n] == row[(start + i + 1) % n]);
    }
    return out;
  }
  /// The places of two rows that belong together most clearly: the nearest two. Of a walk only those count that it
  /// passes once, because of another one it is not clear which passing is meant; there always are some (ends, or
  /// rings).
  std::array<std::size_t, 2> closest(const Ids& a, const Ids& b) const {
    const Ids once = placesPassedOnce(a), other = placesPassedOnce(b);
    // Of two plain rows one place will do.
    const std::size_t tries = once.size() == a.size() && other.size() == b.size() ? 1 : once.size();
    std::array<std::size_t, 2> best{0, 0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tries; ++i) {
      for (const std::uint32_t k : other) {
        const double apart = squared(a[once[i]], b[k]);
        if (apart >= least) continue;
        least = apart;
        best = {once[i], k};
      }
    }
    return best;
  }
  static Ids placesPassedOnce(const Ids& row) {
    Ids order(row.size()), out;
    for (std::uint32_t i = 0; i < row.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return row[i]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool before = i > 0 && row[order[i - 1]] == row[order[i]];
      const bool after = i + 1 < order.size() && row[order[i + 1]] == row[order[i]];
      if (!before && !after) out.push_back(order[i]);
    }
    std::ranges::sort(out);
    return out;
  }

  const Fields& fields_;
  const RowParams& params_;
  mesh::TriMesh& mesh_;
  std::size_t first_;
  std::vector<ModelPoint> points_;  ///< those added, exactly
};

double meanHalf(const Fields& fields) {
  double sum = 0, area = 0;
  const auto& points = fields.mesh.points();
  for (const auto& [a, b, c] : fields.mesh.triangles()) {
    const double own = cross(points[b] - points[a], points[c] - points[a]);
    sum += own * (fields.half[a] + fields.half[b] + fields.half[c]) / 3;
    area += own;
  }
  return sum / area;
}

}  // namespace

Status addRows(const Fields& fields, const geometry::Contours& piece, std::span<const ProfileCurve> curves,
               const RowParams& params, mesh::TriMesh& mesh) {
  constexpr double kFinest = 1.0 / 64, kCoarsest = 0.3;  // half widths between rows
  const double step = std::clamp(params.spacing / meanHalf(fields), kFinest, kCoarsest);
  RowTable table(fields, piece, params.spacing);
  const auto walks = walksRoundBones(fields);
  Builder builder(fields, params, mesh);
  const std::size_t outlines = fields.sizes.size();
  for (const ProfileCurve& curve : curves) {
    const ProfileCurve rows = withRows(curve, step);
    std::vector<std::vector<Ids>> ids;  // by row and outline
    for (const SectionPoint q : rows.points) {
      std::vector<Ids>& of = ids.emplace_back(outlines);
      if (q.x == 0) {
        const Ids bones = builder.addBones(q.y);
        for (std::size_t o = 0; o < outlines; ++o) {
          for (const std::uint32_t p : walks[o]) of[o].push_back(bones[p]);
        }
        continue;
      }
      const std::vector<Row>& lines = table.at(q.x);
      if (lines.size() != outlines) return Error::RegionTooFine;
      for (std::size_t o = 0; o < outlines; ++o) of[o] = builder.add(lines[o], q.y);
    }
    const std::size_t strips = ids.size() - (rows.closed ? 0 : 1);
    for (std::size_t j = 0; j < strips; ++j) {
      for (std::size_t o = 0; o < outlines; ++o) {
        if (!builder.join(ids[j][o], ids[(j + 1) % ids.size()][o])) return Error::RegionTooFine;
      }
    }
  }
  return Done{};
}

}  // namespace spineloft::inflate
