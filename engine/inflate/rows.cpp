#include "engine/inflate/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

#include "engine/geometry/corners.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/spread.h"
#include "engine/inflate/boned_mesh.h"

namespace spineloft::inflate {
namespace {

constexpr double kOutline = 1 - 1e-9;  ///< s of the outline itself
constexpr double kOfWidth = 0.25;      ///< of the half width, between points of a row
constexpr double kOfAway = 1.2;        ///< of the distance to the skeleton
constexpr double kLeastInRow = 6;

using Row = std::vector<LevelPoint>;
using Ids = std::vector<std::uint32_t>;

/// The closed line with points so far apart as the place allows, even between corners, which stay.
Row resampled(const Row& line, double spacing) {
  const std::size_t n = line.size();
  std::vector<SectionPoint> closed;
  std::vector<double> steps(n + 1, 0.0);
  double finest = spacing;
  for (std::size_t i = 0; i < n; ++i) {
    const LevelPoint &a = line[i], &b = line[(i + 1) % n];
    const double most =
        std::max(1e-9, std::min({spacing, kOfWidth * (a.half + b.half) / 2, kOfAway * (a.away + b.away) / 2}));
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
      out.push_back(lerp(a, b, way));
    }
  }
  return out;
}

/// The rows of one piece: for each outline the line of a level, once for each level, which every slice has its own of.
class RowTable {
 public:
  RowTable(const Fields& fields, const geometry::Contours& piece, double spacing)
      : fields_(fields), piece_(piece), spacing_(spacing) {}

  /// One row an outline; empty where the level has not one line an outline.
  const std::vector<Row>& at(const ProfileRow& row) {
    std::vector<double> levels;
    for (const SectionPoint p : row) levels.push_back(p.x);
    const auto found = rows_.find(levels);
    if (found != rows_.end()) return found->second;
    const bool outline = std::ranges::all_of(levels, [](double level) { return level >= kOutline; });
    std::vector<Row> made = outline ? outlines() : traced(levels);
    return rows_[std::move(levels)] = std::move(made);
  }

 private:
  std::vector<Row> traced(std::span<const double> levels) const {
    std::vector<Row> rows(fields_.sizes.size());
    for (LevelLine& line : levelLines(fields_, levels)) {
      if (!rows[line.side].empty()) return {};
      rows[line.side] = resampled(line.points, spacing_);
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
        LevelPoint there = lerp(levelPointOf(fields_, a), levelPointOf(fields_, b), share);
        there.at = at;
        row.push_back(there);
      }
      std::ranges::reverse(row);  // the region on the right
      rows.push_back(resampled(row, spacing_));
    }
    return rows;
  }

  const Fields& fields_;
  const geometry::Contours& piece_;
  double spacing_;
  std::map<std::vector<double>, std::vector<Row>> rows_;
};

/// A closed row from a place of it on round to that again.
struct Ring {
  Ids ids;
  std::vector<ModelPoint> at;
  std::size_t steps() const { return ids.size() - 1; }
};

/// How two rows are joined in order: of all ways the one whose joining edges are shortest, by the sum of their squares
/// (Fuchs, Kedem and Uselton 1977). Only ways near the even one are looked at.
class Joining {
 public:
  /// `reach`: how far from the even way, share of the longer row.
  Joining(const Ring& a, const Ring& b, double reach)
      : a_(a),
        b_(b),
        n_(a.steps()),
        m_(b.steps()),
        reach_(static_cast<std::size_t>(kLeastReach + reach * static_cast<double>(std::max(n_, m_)))) {}

  /// Calls move(i, k, alongB) for each step, from (i, k) along a or b, last one first.
  template <class Move>
  void run(const Move& move) {
    const std::size_t wide = std::min(2 * reach_ + 1, m_ + 1);
    std::vector<double> above(wide, kNever), now(wide, kNever);
    std::vector<char> viaB((n_ + 1) * wide, 0);
    for (std::size_t i = 0; i <= n_; ++i) {
      const std::size_t low = lowest(i, wide), before = i > 0 ? lowest(i - 1, wide) : 0;
      for (std::size_t c = 0; c < wide; ++c) {
        const std::size_t k = low + c;
        const double alongA = i > 0 && k >= before && k - before < wide ? above[k - before] : kNever;
        const double alongB = c > 0 ? now[c - 1] : kNever;
        const ModelPoint off = a_.at[i] - b_.at[k];
        viaB[i * wide + c] = alongB < alongA;
        now[c] = (i == 0 && k == 0 ? 0 : std::min(alongA, alongB)) + dot(off, off);
      }
      above.swap(now);
    }
    for (std::size_t i = n_, k = m_; i > 0 || k > 0;) {
      const bool alongB = viaB[i * wide + k - lowest(i, wide)];
      move(alongB ? i : i - 1, alongB ? k - 1 : k, alongB);
      (alongB ? k : i) -= 1;
    }
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kLeastReach = 10;

  /// The band of b at a place of a.
  std::size_t lowest(std::size_t i, std::size_t wide) const {
    const std::size_t even = i * m_ / n_;
    return std::min(even > reach_ ? even - reach_ : 0, m_ + 1 - wide);
  }

  const Ring &a_, &b_;
  std::size_t n_, m_, reach_;
};

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A row that is a border of a strip.
struct Strip {
  const Row& line;
  const Ids& ids;
  const ProfileRow& row;
};

class Builder {
 public:
  Builder(const Fields& fields, const RowParams& params, mesh::TriMesh& mesh)
      : fields_(fields), bones_(bonesOf(fields)), params_(params), mesh_(mesh), first_(mesh.positions.size()) {}

  /// A point of a row, its z in each slice.
  std::uint32_t add(const LevelPoint& p, const ProfileRow& row) {
    double z = 0;
    for (std::size_t k = 0; k < row.size(); ++k) z += p.over.share[k] * row[k].y;
    const double thick = thicknessOf(fields_.widthOf(p.half), params_);
    const ModelPoint at{p.at.x, p.at.y, z * thick * p.over.factor * params_.height};
    points_.push_back(at);
    mesh_.positions.push_back({static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
    const double u = (p.at.x + 0.5) / params_.picture.width, v = (0.5 - p.at.y) / params_.picture.height;
    mesh_.uv.push_back({static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  Ids add(const Row& line, const ProfileRow& row) {
    Ids ids;
    for (const LevelPoint& p : line) ids.push_back(add(p, row));
    return ids;
  }
  /// Triangles between two closed rows that run the same way, outside on the right of the way from a to b: joined in
  /// order; where that would fold them, with points of the surface in between. False where the rows cross and should
  /// not.
  bool join(const Strip& a, const Strip& b) {
    constexpr double kNear = 0.1, kAny = 1;
    constexpr double kSame = 1e-6;
    const auto same = [](SectionPoint p, SectionPoint q) { return std::abs(p.x - q.x) < kSame; };
    const bool upright = std::ranges::equal(a.row, b.row, same);  // in the plane one line
    if (upright && a.ids.size() == b.ids.size()) {
      wall(a.ids, b.ids);
      return true;
    }
    for (const double reach : {kNear, kAny}) {
      const Triangles made = joined(a.ids, b.ids, reach);
      if (!upright && folds(made)) continue;
      mesh_.triangles.insert(mesh_.triangles.end(), made.begin(), made.end());
      return true;
    }
    if (between(a, b)) return true;
    const Triangles made = joined(a.ids, b.ids, kNear);
    mesh_.triangles.insert(mesh_.triangles.end(), made.begin(), made.end());
    bool in = false, out = false;
    for (std::size_t k = 0; k < a.row.size(); ++k) {
      in |= b.row[k].x < a.row[k].x - kSame;
      out |= b.row[k].x > a.row[k].x + kSame;
    }
    return in && out;
  }

  /// Triangles from the rows of one level, one an outline, to the row on the axis; they face up or down.
  bool close(const std::vector<Row>& lines, const std::vector<Ids>& ids, const ProfileRow& axis, bool up) {
    geometry::PlaneRegion rim;
    Ids corners;
    for (std::size_t o = 0; o < lines.size(); ++o) {  // rows have the region on their right
      for (const LevelPoint& p : lines[o] | std::views::reverse) rim.points.push_back(p.at);
      corners.insert(corners.end(), ids[o].rbegin(), ids[o].rend());
      rim.sizes.push_back(lines[o].size());
    }
    std::optional<Boned> boned;
    if (fields_.reach > 0) boned = bonedMesh(rim, bones_, params_.spacing);  // a plain has points of its own
    if (!boned) boned = bonedMesh(rim, bones_, 0);  // where nothing lies between rows and skeleton
    if (!boned) return false;
    for (std::size_t i = boned->mesh.rim(); i < boned->mesh.points().size(); ++i) {
      corners.push_back(add(within(boned->mesh.points()[i], boned->width[i]), axis));
    }
    for (const auto& [a, b, c] : boned->mesh.triangles()) {
      mesh_.triangles.push_back({corners[a], corners[up ? b : c], corners[up ? c : b]});
    }
    return true;
  }

 private:
  /// The skeleton as the fields have it; as widths the half widths there.
  static Bones bonesOf(const Fields& fields) {
    Bones bones;
    std::vector<std::uint32_t> index(fields.onBone.size(), 0);
    for (std::uint32_t i = 0; i < index.size(); ++i) {
      if (!fields.onBone[i]) continue;
      index[i] = static_cast<std::uint32_t>(bones.points.size());
      bones.points.push_back({fields.mesh.points()[i], fields.half[i], fields.over[i]});
    }
    for (const auto& [a, b] : fields.bones) bones.edges.push_back({index[a], index[b]});
    return bones;
  }
  /// A point between the first rows and the skeleton: of the skeleton, or with what the fields have there.
  LevelPoint within(SectionPoint p, const Boned::Width& width) const {
    if (width.radius > 0) return {p, width.radius, width.over, 0};
    const auto found = fields_.mesh.find(p);
    if (!found) return {p, fields_.reach, {}, 0};
    const auto& [a, b, c] = fields_.mesh.triangles()[*found];
    const auto& points = fields_.mesh.points();
    const double area = cross(points[b] - points[a], points[c] - points[a]);
    const double atC = cross(points[b] - points[a], p - points[a]) / area;
    const double atB = cross(p - points[a], points[c] - points[a]) / area;
    const LevelPoint one = levelPointOf(fields_, a);
    const double away = atB + atC;
    LevelPoint out = one;
    if (away > 0) out = lerp(one, lerp(levelPointOf(fields_, b), levelPointOf(fields_, c), atC / away), away);
    out.at = p;
    return out;
  }
  const ModelPoint& at(std::uint32_t id) const { return points_[id - first_]; }
  Triangles joined(const Ids& a, const Ids& b, double reach) const {
    const auto [startA, startB] = closest(a, b);
    const Ring one = ring(a, startA), other = ring(b, startB);
    Triangles out;
    Joining(one, other, reach).run([&](std::size_t i, std::size_t k, bool alongB) {
      if (alongB) {
        out.push_back({one.ids[i], other.ids[k], other.ids[k + 1]});
      } else {
        out.push_back({one.ids[i + 1], one.ids[i], other.ids[k]});
      }
    });
    return out;
  }
  /// Between rows of which each point is over one of the other: the shorter way across each quadrangle.
  void wall(const Ids& a, const Ids& b) {
    const auto away = [&](std::uint32_t p, std::uint32_t q) { return dot(at(p) - at(q), at(p) - at(q)); };
    for (std::size_t i = a.size(); i-- > 0;) {
      const std::size_t k = (i + 1) % a.size();
      if (away(a[k], b[i]) < away(a[i], b[k])) {
        mesh_.triangles.push_back({a[k], b[i], b[k]});
        mesh_.triangles.push_back({a[k], a[i], b[i]});
      } else {
        mesh_.triangles.push_back({a[k], a[i], b[k]});
        mesh_.triangles.push_back({a[i], b[i], b[k]});
      }
    }
  }
  /// Whether some of them lie the other way round in the plane than most.
  bool folds(const Triangles& made) const {
    double up = 0, down = 0;
    for (const auto& [a, b, c] : made) {
      const ModelPoint one = at(b) - at(a), other = at(c) - at(a);
      const double turn = one.x * other.y - one.y * other.x;
      (turn > 0 ? up : down) += std::abs(turn);
    }
    constexpr double kRounding = 1e-9;
    return std::min(up, down) > kRounding * std::max(up, down);
  }
  /// The strip between two rows that lie apart in the plane, with points of its own. False when they do not.
  bool between(const Strip& a, const Strip& b) {
    // Rows have the outline on their left: the higher one holds more where they run clockwise, else less.
    const auto area = [](const Row& line) {
      std::vector<SectionPoint> at;
      for (const LevelPoint& p : line) at.push_back(p.at);
      return geometry::signedArea(std::span<const SectionPoint>(at));
    };
    const bool outwards = area(b.line) < area(a.line);
    const Strip &low = outwards ? a : b, &high = outwards ? b : a;
    // Rows have the outline on their left: the strip is to the left of the lower, to the right of the higher.
    geometry::PlaneRegion rim;
    Ids corners;
    const auto put = [&](const Strip& strip, bool turned) {
      std::vector<SectionPoint> line;
      for (const LevelPoint& p : strip.line) line.push_back(p.at);
      Ids ids = strip.ids;
      if (turned) std::ranges::reverse(line), std::ranges::reverse(ids);
      const bool outer = geometry::signedArea(std::span<const SectionPoint>(line)) > 0;
      rim.points.insert(outer ? rim.points.begin() : rim.points.end(), line.begin(), line.end());
      corners.insert(outer ? corners.begin() : corners.end(), ids.begin(), ids.end());
      rim.sizes.insert(outer ? rim.sizes.begin() : rim.sizes.end(), line.size());
    };
    put(low, false);
    put(high, true);
    geometry::PlaneMesh plane(rim.points, rim.sizes);
    std::size_t borders = 0;
    for (std::uint32_t h = 0; h < 3 * plane.triangles().size(); ++h)
      borders += plane.twin(h) == geometry::PlaneMesh::kNone;
    if (borders != rim.points.size()) return false;  // they cross
    spread(plane, rim.sizes[0]);
    for (std::size_t i = plane.rim(); i < plane.points().size(); ++i) {
      const SectionPoint p = plane.points()[i];
      const LevelPoint there = within(p, {});
      double from = 0, to = 0;
      for (std::size_t k = 0; k < low.row.size(); ++k) {
        from += there.over.share[k] * low.row[k].x;
        to += there.over.share[k] * high.row[k].x;
      }
      constexpr double kApart = 1e-3;
      const double way = to > from ? std::clamp((shareAt(p) - from) / (to - from), kApart, 1 - kApart) : 0.5;
      ProfileRow row;
      for (std::size_t k = 0; k < low.row.size(); ++k) row.push_back(lerp(low.row[k], high.row[k], way));
      corners.push_back(add(there, row));
    }
    if (std::getenv("DBG")) {
      int open = 0; for (std::uint32_t h = 0; h < 3 * plane.triangles().size(); ++h) open += plane.twin(h) == geometry::PlaneMesh::kNone;
      std::printf("BETWEEN rows %zu %zu area %.1f %.1f levels %.3f %.3f slices %zu z %.3f %.3f points %zu rim %zu tris %zu open %d out %d\n", a.line.size(), b.line.size(), area(a.line), area(b.line), a.row[0].x, b.row[0].x, a.row.size(), a.row[0].y, b.row[0].y, plane.points().size(), plane.rim(), plane.triangles().size(), open, outwards);
    }
    for (const auto& [i, k, l] : plane.triangles()) {
      mesh_.triangles.push_back({corners[i], corners[outwards ? l : k], corners[outwards ? k : l]});
    }
    return true;
  }
  /// Points where edges are long, or join two corners of one row.
  void spread(geometry::PlaneMesh& plane, std::size_t first) const {
    constexpr int kRounds = 8;
    constexpr double kLong = 1.25;  // spacings
    for (int round = 0; round < kRounds; ++round) {
      std::vector<SectionPoint> middles;
      for (std::uint32_t h = 0; h < 3 * plane.triangles().size(); ++h) {
        const std::uint32_t a = plane.triangles()[h / 3][h % 3], b = plane.triangles()[h / 3][(h + 1) % 3];
        if (a > b || plane.twin(h) == geometry::PlaneMesh::kNone) continue;
        const bool chord = b < plane.rim() && (a < first) == (b < first);
        const SectionPoint p = plane.points()[a], q = plane.points()[b];
        if (chord || distance(p, q) > kLong * params_.spacing) middles.push_back((p + q) / 2);
      }
      if (middles.empty()) return;
      for (const SectionPoint p : middles) plane.insert(p);
    }
    plane.splitChords();
  }
  double shareAt(SectionPoint p) const {
    const auto found = fields_.mesh.find(p);
    if (!found) return 1;
    const auto& [a, b, c] = fields_.mesh.triangles()[*found];
    const auto& points = fields_.mesh.points();
    const double area = cross(points[b] - points[a], points[c] - points[a]);
    const double atC = cross(points[b] - points[a], p - points[a]) / area;
    const double atB = cross(p - points[a], points[c] - points[a]) / area;
    return fields_.s[a] * (1 - atB - atC) + fields_.s[b] * atB + fields_.s[c] * atC;
  }
  Ring ring(const Ids& row, std::size_t start) const {
    Ring out;
    for (std::size_t i = 0; i <= row.size(); ++i) {
      out.ids.push_back(row[(start + i) % row.size()]);
      out.at.push_back(at(out.ids.back()));
    }
    return out;
  }
  /// The first place of a row and the place of another one that is nearest to it.
  std::array<std::size_t, 2> closest(const Ids& a, const Ids& b) const {
    const auto off = [&](std::uint32_t id) { return dot(at(a[0]) - at(id), at(a[0]) - at(id)); };
    return {0, static_cast<std::size_t>(std::ranges::min_element(b, {}, off) - b.begin())};
  }

  const Fields& fields_;
  const Bones bones_;
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
    sum += own * (fields.widthOf(fields.half[a]) + fields.widthOf(fields.half[b]) + fields.widthOf(fields.half[c])) / 3;
    area += own;
  }
  return sum / area;
}

}  // namespace

double thicknessOf(double width, const RowParams& params) {
  return std::pow(width, params.follow) * std::pow(params.widest, 1 - params.follow);
}

namespace {

enum class Made { Whole, RowsCross, TooFine };

/// With points so far apart along rows.
Made rowsAt(const Fields& fields, const geometry::Contours& piece, const MatchedCurves& curves, const RowParams& params,
            double spacing, mesh::TriMesh& mesh) {
  constexpr double kFinest = 1.0 / 64, kCoarsest = 0.3;  // half widths between rows
  const double step = std::clamp(params.spacing / meanHalf(fields), kFinest, kCoarsest);
  RowTable table(fields, piece, spacing);
  Builder builder(fields, params, mesh);
  const std::size_t outlines = fields.sizes.size();
  const auto onAxis = [](const ProfileRow& row) { return row.front().x == 0; };
  Made made = Made::Whole;
  for (const std::vector<ProfileCurve>& curve : curves) {
    const std::vector<ProfileRow> rows = rowsOf(curve, step);
    std::vector<std::vector<Ids>> ids(rows.size());  // by row and outline
    for (std::size_t j = 0; j < rows.size(); ++j) {
      if (onAxis(rows[j])) continue;
      const std::vector<Row>& lines = table.at(rows[j]);
      if (lines.size() != outlines) return Made::TooFine;
      for (const Row& line : lines) ids[j].push_back(builder.add(line, rows[j]));
    }
    const std::size_t strips = rows.size() - (curve.front().closed ? 0 : 1);
    for (std::size_t j = 0; j < strips; ++j) {
      const std::size_t next = (j + 1) % rows.size();
      const bool begins = onAxis(rows[j]), ends = onAxis(rows[next]);
      if (begins || ends) {
        const std::size_t row = begins ? next : j;
        if (!builder.close(table.at(rows[row]), ids[row], rows[begins ? j : next], ends)) return Made::TooFine;
        continue;
      }
      const std::vector<Row>&lines = table.at(rows[j]), &others = table.at(rows[next]);
      for (std::size_t o = 0; o < outlines; ++o) {
        const bool joined = builder.join({lines[o], ids[j][o], rows[j]}, {others[o], ids[next][o], rows[next]});
        if (!joined) made = Made::RowsCross;
      }
    }
  }
  return made;
}

}  // namespace

Status addRows(const Fields& fields, const geometry::Contours& piece, const MatchedCurves& curves,
               const RowParams& params, mesh::TriMesh& mesh) {
  // Rows of a narrow edge lie near each other: long chords would cut into their neighbours.
  constexpr double kOfEdge = 0.5;  // of its width
  constexpr int kTries = 4;
  double spacing = fields.reach > 0 ? std::min(kOfEdge * fields.reach, params.spacing) : params.spacing;
  const std::size_t points = mesh.positions.size(), triangles = mesh.triangles.size();
  for (int attempt = 1;; ++attempt) {
    const Made made = rowsAt(fields, piece, curves, params, spacing, mesh);
    if (made == Made::TooFine) return Error::RegionTooFine;
    if (made == Made::Whole || attempt == kTries) return Done{};
    mesh.positions.resize(points);
    mesh.uv.resize(points);
    mesh.triangles.resize(triangles);
    spacing /= 2;
  }
}

}  // namespace spineloft::inflate
