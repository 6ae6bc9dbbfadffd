#include "engine/inflate/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

#include "engine/inflate/boned_mesh.h"
#include "engine/inflate/row_lines.h"
#include "engine/mesh/self_crossing.h"

namespace spineloft::inflate {
namespace {

using Ids = std::vector<std::uint32_t>;

/// A closed row from a place of it on round to that again.
struct Ring {
  Ids ids;
  std::vector<ModelPoint> at;
  std::size_t steps() const { return ids.size() - 1; }
};

/// How two rows are joined in order: of all ways the one whose joining edges are shortest, by the sum of their squares
/// (Fuchs, Kedem and Uselton 1977), among those near the even one.
class Joining {
 public:
  /// `reach`: how far from the even way, in steps of b; at least what that goes on by from a step of a to the next.
  Joining(const Ring& a, const Ring& b, std::size_t reach)
      : a_(a), b_(b), n_(a.steps()), m_(b.steps()), reach_(std::max(reach, m_ / n_ + 1)) {}

  /// Calls move(i, k, alongB) for each step, from (i, k) along a or b, last one first. Whether no way farther off can
  /// be shorter nearby: the one found keeps away from the ends of the reach.
  template <class Move>
  bool run(const Move& move) {
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
    bool within = true;
    for (std::size_t i = n_, k = m_; i > 0 || k > 0;) {
      const std::size_t low = lowest(i, wide), c = k - low;
      within = within && (c > 0 || low == 0) && (c + 1 < wide || low + wide > m_);
      const bool alongB = viaB[i * wide + c];
      move(alongB ? i : i - 1, alongB ? k - 1 : k, alongB);
      (alongB ? k : i) -= 1;
    }
    return within;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

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
  std::span<const LevelPoint> line;
  std::span<const std::uint32_t> ids;
  std::span<const SectionPoint> row;
};

bool isSameLevel(SectionPoint a, SectionPoint b) {
  constexpr double kSame = 1e-6;
  return std::abs(a.x - b.x) < kSame;
}

/// Between two rows those at the levels of others, in order, none near another one.
std::vector<ProfileRow> rowsBetween(std::span<const SectionPoint> a, std::span<const SectionPoint> b,
                                    std::span<const double> levels) {
  constexpr double kApart = 0.1;  // of the way
  if (isSameLevel(a[0], b[0])) return {};
  std::vector<double> ways;
  for (const double level : levels) ways.push_back((level - a[0].x) / (b[0].x - a[0].x));
  std::ranges::sort(ways);
  std::vector<ProfileRow> rows;
  double last = 0;
  for (const double way : ways) {
    if (way < last + kApart || way > 1 - kApart) continue;
    last = way;
    ProfileRow& row = rows.emplace_back();
    for (std::size_t k = 0; k < a.size(); ++k) row.push_back(lerp(a[k], b[k], way));
  }
  return rows;
}

class Builder {
 public:
  Builder(const Fields& fields, const RowParams& params, mesh::TriMesh& mesh)
      : fields_(fields), bones_(bonesOf(fields)), params_(params), mesh_(mesh), first_(mesh.positions.size()) {}

  /// What there is so far.
  struct Mark {
    std::size_t points, triangles;
  };
  Mark mark() const { return {mesh_.positions.size(), mesh_.triangles.size()}; }
  void backTo(const Mark& mark) {
    points_.resize(mark.points - first_);
    mesh_.positions.resize(mark.points);
    mesh_.uv.resize(mark.points);
    mesh_.triangles.resize(mark.triangles);
  }

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
  /// Triangles between two closed rows that run the same way, outside on the right of the way from a to b, by joining
  /// their points in order. False, and nothing is added, where that would fold the strip.
  bool join(const Strip& a, const Strip& b) {
    const bool upright = std::ranges::equal(a.row, b.row, isSameLevel);  // in the plane one line
    if (upright && a.ids.size() == b.ids.size()) {
      wall(a.ids, b.ids);
      return true;
    }
    constexpr std::size_t kNear = 8;
    for (const std::size_t reach : {kNear, b.ids.size()}) {
      const Triangles made = joined(a.ids, b.ids, reach);
      if (!upright && folds(made)) continue;
      mesh_.triangles.insert(mesh_.triangles.end(), made.begin(), made.end());
      return true;
    }
    return false;
  }
  /// The same over a triangulation of what lies between them in the plane, with points of the surface there. Where
  /// slices at places have them in another order than here, rows may cross: they are joined as they are. False where
  /// they cross in any other case.
  bool spread(const Strip& a, const Strip& b) {
    if (between(a, b)) return true;
    const Triangles made = joined(a.ids, b.ids, b.ids.size());
    mesh_.triangles.insert(mesh_.triangles.end(), made.begin(), made.end());
    bool in = false, out = false;
    for (std::size_t k = 0; k < a.row.size(); ++k) {
      if (isSameLevel(a.row[k], b.row[k])) continue;
      (b.row[k].x < a.row[k].x ? in : out) = true;
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
  /// Twice as far off the even way as long as that may be shorter.
  Triangles joined(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, std::size_t reach) const {
    const auto [startA, startB] = closest(a, b);
    const Ring one = ring(a, startA), other = ring(b, startB);
    Triangles out;
    const auto move = [&](std::size_t i, std::size_t k, bool alongB) {
      if (alongB) {
        out.push_back({one.ids[i], other.ids[k], other.ids[k + 1]});
      } else {
        out.push_back({one.ids[i + 1], one.ids[i], other.ids[k]});
      }
    };
    while (!Joining(one, other, reach).run(move)) {
      out.clear();
      reach *= 2;
    }
    return out;
  }
  /// Between rows of which each point is over one of the other: the shorter way across each quadrangle.
  void wall(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
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
    const bool outwards = runsInside(a.line, b.line);
    const Strip &low = outwards ? a : b, &high = outwards ? b : a;
    std::optional<Band> band = bandBetween(low.line, high.line);
    if (!band) return false;
    geometry::PlaneMesh& plane = band->mesh;
    Ids corners(low.ids.begin(), low.ids.end());
    corners.insert(band->lowFirst ? corners.end() : corners.begin(), high.ids.rbegin(), high.ids.rend());
    fill(plane, (band->lowFirst ? low : high).ids.size());
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
    for (const auto& [i, k, l] : plane.triangles()) {
      mesh_.triangles.push_back({corners[i], corners[outwards ? l : k], corners[outwards ? k : l]});
    }
    return true;
  }
  /// Points where edges are long, or join two corners of one row.
  void fill(geometry::PlaneMesh& plane, std::size_t first) const {
    constexpr int kRounds = 8;
    constexpr double kLong = 2;  // spacings
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
  Ring ring(std::span<const std::uint32_t> row, std::size_t start) const {
    Ring out;
    for (std::size_t i = 0; i <= row.size(); ++i) {
      out.ids.push_back(row[(start + i) % row.size()]);
      out.at.push_back(at(out.ids.back()));
    }
    return out;
  }
  /// The first place of a row and the place of another one that is nearest to it.
  std::array<std::size_t, 2> closest(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) const {
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

/// The surface over a piece, whose rows may cross or not.
class Surface {
 public:
  Surface(const Fields& fields, const geometry::Contours& piece, const MatchedCurves& curves, const RowParams& params,
          const RowTable::Way& way, bool mayCross, mesh::TriMesh& mesh)
      : mayCross_(mayCross),
        outlines_(fields.sizes.size()),
        table_(fields, piece, way),
        builder_(fields, params, mesh) {
    constexpr double kFinest = 1.0 / 64, kCoarsest = 0.3;  // half widths between rows
    const double step = std::clamp(params.spacing / meanHalf(fields), kFinest, kCoarsest / params.fineness);
    for (const std::vector<ProfileCurve>& curve : curves) {
      curves_.push_back({rowsOf(curve, step), curve.front().closed});
      for (const ProfileRow& row : curves_.back().rows) levels_.push_back(row[0].x);
    }
  }
  /// False where rows do not lie within each other.
  bool run() {
    return std::ranges::all_of(curves_, [&](const Curve& curve) { return add(curve); });
  }
  /// Whether rows cross in the plane; where none do the surface of one slice does not go through itself.
  bool rowsCross() const { return table_.cross(); }

 private:
  struct Curve {
    std::vector<ProfileRow> rows;
    bool closed;
  };

  bool add(const Curve& curve) {
    const auto onAxis = [](const ProfileRow& row) { return row.front().x == 0; };
    const std::vector<ProfileRow>& rows = curve.rows;
    std::vector<std::vector<Ids>> ids(rows.size());  // by row and outline
    for (std::size_t j = 0; j < rows.size(); ++j) {
      if (onAxis(rows[j])) continue;
      const std::vector<Row>& lines = table_.at(rows[j]);
      if (lines.size() != outlines_) return false;
      for (const Row& line : lines) ids[j].push_back(builder_.add(line, rows[j]));
    }
    const std::size_t strips = rows.size() - (curve.closed ? 0 : 1);
    for (std::size_t j = 0; j < strips; ++j) {
      const std::size_t next = (j + 1) % rows.size();
      const bool begins = onAxis(rows[j]), ends = onAxis(rows[next]);
      if (begins || ends) {
        const std::size_t row = begins ? next : j;
        if (!builder_.close(table_.at(rows[row]), ids[row], rows[begins ? j : next], ends)) return false;
        continue;
      }
      const std::vector<Row>&lines = table_.at(rows[j]), &others = table_.at(rows[next]);
      for (std::size_t o = 0; o < outlines_; ++o) {
        if (!strip({lines[o], ids[j][o], rows[j]}, {others[o], ids[next][o], rows[next]}, o)) return false;
      }
    }
    return true;
  }

  /// A strip that needs points within has the levels of the profile as rows too, so that what lies above and below it
  /// has the same borders; if they fit in.
  bool strip(const Strip& a, const Strip& b, std::size_t outline) {
    if (builder_.join(a, b)) return true;
    const Builder::Mark before = builder_.mark();
    if (inStrips(a, b, outline)) return true;
    builder_.backTo(before);
    return builder_.spread(a, b) || mayCross_;
  }
  bool inStrips(const Strip& a, const Strip& b, std::size_t outline) {
    const std::vector<ProfileRow> rows = rowsBetween(a.row, b.row, levels_);
    std::vector<Ids> ids;
    ids.reserve(rows.size());
    Strip last = a;
    const auto next = [&](const Strip& strip) { return builder_.join(last, strip) || builder_.spread(last, strip); };
    for (const ProfileRow& row : rows) {
      const std::vector<Row>& lines = table_.at(row);
      if (lines.size() != outlines_) return false;
      ids.push_back(builder_.add(lines[outline], row));
      const Strip strip{lines[outline], ids.back(), row};
      if (!next(strip)) return false;
      last = strip;
    }
    return next(b);
  }

  bool mayCross_;
  std::size_t outlines_;
  std::vector<Curve> curves_;
  std::vector<double> levels_;  ///< of all rows, in the first slice
  RowTable table_;
  Builder builder_;
};

}  // namespace

Status addRows(const Fields& fields, const geometry::Contours& piece, const MatchedCurves& curves,
               const RowParams& params, mesh::TriMesh& mesh) {
  // Rows of a narrow edge lie near each other: long chords would cut into their neighbours.
  constexpr double kOfEdge = 0.5;  // of its width
  constexpr int kTries = 3;        // with rows twice as fine each, and outlines that no row crosses
  const double spacing = fields.reach > 0 ? std::min(kOfEdge * fields.reach, params.spacing) : params.spacing;
  const std::size_t points = mesh.positions.size(), triangles = mesh.triangles.size();
  const bool plain = isPlain(curves), changing = curves.front().size() > 1;
  for (int attempt = 0; attempt <= kTries; ++attempt) {
    const bool last = attempt == kTries;
    const RowTable::Way way{last ? spacing : std::ldexp(spacing, -attempt), params.fineness, attempt > 0};
    Surface surface(fields, piece, curves, params, way, last, mesh);
    const bool sound =
        surface.run() && ((!last && (plain || !(changing || surface.rowsCross()))) || !mesh::selfCrossing(mesh));
    if (sound) return Done{};
    mesh.positions.resize(points);
    mesh.uv.resize(points);
    mesh.triangles.resize(triangles);
  }
  return {Error::SectionInvalid, "it would make this puff go through itself"};
}

}  // namespace spineloft::inflate
