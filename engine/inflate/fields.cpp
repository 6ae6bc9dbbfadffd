#include "engine/inflate/fields.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <span>
#include <unordered_set>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/geometry/spread.h"
#include "engine/inflate/boned_mesh.h"
#include "engine/inflate/element.h"

namespace spineloft::inflate {
namespace {

using geometry::PlaneMesh;
constexpr std::uint32_t kNone = PlaneMesh::kNone;

constexpr double kPoints = 1000;     ///< of the mesh, about, times the square of the fineness
constexpr double kThin = 0.7;        ///< of the half width of what is thin: the spacing there
constexpr double kMostOnRim = 3000;  ///< points of all outlines, about
constexpr double kNearEnd = 1.5;     ///< spacings of a full mesh: ends nearer to the outline are left out
constexpr double kSmooth = 0.15;     ///< of the half width: how far creases are smoothed
constexpr int kRounds = 8;           ///< of floods
constexpr int kTries = 3;            ///< with a full mesh, and finer ones

/// The half width that a tenth of the skeleton's length is below.
double thinness(const Skeleton& skeleton) {
  std::vector<std::pair<double, double>> stretches;  // radius, length
  double length = 0;
  for (const auto& branch : skeleton.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i) {
      const SkeletonPoint &a = skeleton.points[branch[i - 1]], &b = skeleton.points[branch[i]];
      stretches.push_back({(a.radius + b.radius) / 2, distance(a.at, b.at)});
      length += stretches.back().second;
    }
  }
  if (stretches.empty()) return skeleton.points.front().radius;
  std::ranges::sort(stretches);
  double below = 0;
  for (const auto& [radius, stretch] : stretches) {
    below += stretch;
    if (below >= length / 10) return radius;
  }
  return stretches.back().first;
}

class BoneMaker {
 public:
  BoneMaker(const Skeleton& skeleton, double spacing, double nearEnd)
      : skeleton_(skeleton),
        spacing_(spacing),
        nearEnd_(nearEnd),
        degree_(skeleton.points.size(), 0),
        index_(degree_.size(), kNone) {
    for (const auto& branch : skeleton.branches) {
      for (std::size_t i = 1; i < branch.size(); ++i) ++degree_[branch[i]], ++degree_[branch[i - 1]];
    }
  }
  Bones run() {
    for (const auto& branch : skeleton_.branches) add(trimmed(branch));
    return std::move(bones_);
  }

 private:
  using Branch = std::vector<std::uint32_t>;

  bool isShort(std::uint32_t p) const { return skeleton_.points[p].radius < nearEnd_; }
  /// Without what lies at its free ends near the outline; something of it always stays.
  Branch trimmed(Branch branch) const {
    if (branch.size() < 2) return branch;
    const auto largest =
        *std::ranges::max_element(branch, {}, [&](std::uint32_t p) { return skeleton_.points[p].radius; });
    const bool fromEnd = degree_[branch.front()] == 1, toEnd = degree_[branch.back()] == 1;
    while (toEnd && branch.size() > 1 && branch.back() != largest && isShort(branch.back())) branch.pop_back();
    auto first = branch.begin();
    while (fromEnd && first + 1 != branch.end() && *first != largest && isShort(*first)) ++first;
    branch.erase(branch.begin(), first);
    return branch;
  }
  std::uint32_t add(const SkeletonPoint& p) {
    bones_.points.push_back(p);
    return static_cast<std::uint32_t>(bones_.points.size() - 1);
  }
  std::uint32_t node(std::uint32_t p) {
    if (index_[p] == kNone) index_[p] = add(skeleton_.points[p]);
    return index_[p];
  }
  void add(const Branch& branch) {
    if (branch.size() == 1) {
      node(branch[0]);
      return;
    }
    std::vector<SectionPoint> line;
    double least = spacing_;
    for (const std::uint32_t p : branch) {
      line.push_back(skeleton_.points[p].at);
      least = std::min(least, kThin * skeleton_.points[p].radius);
    }
    const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(line));
    const double step = std::max(least, spacing_ / 4);
    const std::size_t fewest = branch.front() == branch.back() ? 8 : branch.size() > 2 ? 2 : 1;
    const auto steps = std::max(fewest, static_cast<std::size_t>(std::lround(s.back() / step)));
    std::uint32_t last = node(branch.front());
    std::size_t i = 1;
    for (std::size_t k = 1; k <= steps; ++k) {
      const double at = s.back() * static_cast<double>(k) / static_cast<double>(steps);
      while (i + 1 < s.size() && s[i] < at) ++i;
      const double span = s[i] - s[i - 1], share = span > 0 ? std::clamp((at - s[i - 1]) / span, 0.0, 1.0) : 0;
      const SkeletonPoint &p = skeleton_.points[branch[i - 1]], &q = skeleton_.points[branch[i]];
      const SkeletonPoint between{lerp(p.at, q.at, share), std::lerp(p.radius, q.radius, share),
                                  lerp(p.over, q.over, share)};
      const std::uint32_t next = k == steps ? node(branch.back()) : add(between);
      bones_.edges.push_back({last, next});
      last = next;
    }
  }

  const Skeleton& skeleton_;
  double spacing_, nearEnd_;
  std::vector<int> degree_;
  std::vector<std::uint32_t> index_;
  Bones bones_;
};

/// What a plane mesh means for its points: stiffness between neighbours, and masses.
struct Operators {
  struct Entry {
    std::uint32_t i, k;  ///< i > k
    double weight;       ///< of (x_i − x_k)²/2, twice per inner edge
  };
  std::vector<Entry> entries;
  std::vector<double> mass;
};
Operators operatorsOf(const PlaneMesh& mesh) {
  Operators out;
  out.mass.assign(mesh.points().size(), 0.0);
  out.entries.reserve(3 * mesh.triangles().size());
  for (const auto& t : mesh.triangles()) {
    const Element element = elementOf(mesh, t);
    for (std::size_t c = 0; c < 3; ++c) {
      out.mass[t[c]] += element.area2 / 6;
      const std::size_t n = (c + 1) % 3;
      out.entries.push_back({std::max(t[c], t[n]), std::min(t[c], t[n]), -element.stiffness(c, n)});
    }
  }
  return out;
}

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;
using Triplets = std::vector<Eigen::Triplet<double, int>>;

/// Values diffused twice over kSmooth times the local half width; empty when that fails.
class Diffusion {
 public:
  Diffusion(const Operators& operators, const std::vector<double>& half) : mass_(operators.mass) {
    const auto n = static_cast<Eigen::Index>(mass_.size());
    std::vector<double> diagonal = mass_;
    Triplets triplets;
    triplets.reserve(operators.entries.size() + mass_.size());
    for (const auto& [i, k, weight] : operators.entries) {
      const double reach = kSmooth * (half[i] + half[k]) / 2, w = weight * reach * reach;
      triplets.emplace_back(static_cast<int>(i), static_cast<int>(k), -w);
      diagonal[i] += w;
      diagonal[k] += w;
    }
    for (int i = 0; i < static_cast<int>(n); ++i) triplets.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
    Matrix matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    factor_.compute(matrix);
  }
  bool ok() const { return factor_.info() == Eigen::Success; }
  std::vector<double> operator()(std::vector<double> values) const {
    Eigen::VectorXd load(static_cast<Eigen::Index>(values.size()));
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < values.size(); ++i) load[static_cast<Eigen::Index>(i)] = mass_[i] * values[i];
      const Eigen::VectorXd solved = factor_.solve(load);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = solved[static_cast<Eigen::Index>(i)];
    }
    return values;
  }

 private:
  const std::vector<double>& mass_;
  Factor factor_;
};

/// w with Δw = g where `fixed` does not hold it at what it is; false when that fails.
bool solveFor(const Operators& operators, const std::vector<char>& fixed, const std::vector<double>& g,
              std::vector<double>& w) {
  std::vector<int> row(w.size(), -1);
  int n = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (!fixed[i]) row[i] = n++;
  }
  if (n == 0) return true;
  Eigen::VectorXd load(n);
  std::vector<double> diagonal(static_cast<std::size_t>(n), 0.0);
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (row[i] >= 0) load[row[i]] = -operators.mass[i] * g[i];
  }
  Triplets triplets;
  triplets.reserve(operators.entries.size());
  for (const auto& [i, k, weight] : operators.entries) {
    for (const auto& [own, other] : {std::pair{i, k}, std::pair{k, i}}) {
      if (row[own] < 0) continue;
      diagonal[static_cast<std::size_t>(row[own])] += weight;
      if (row[other] < 0) load[row[own]] += weight * w[other];
    }
    if (row[i] >= 0 && row[k] >= 0) triplets.emplace_back(std::max(row[i], row[k]), std::min(row[i], row[k]), -weight);
  }
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
  Matrix matrix(n, n);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const Factor factor(matrix);
  if (factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd solved = factor.solve(load);
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (row[i] < 0) continue;
    w[i] = solved[row[i]];
    if (!std::isfinite(w[i])) return false;
  }
  return true;
}

/// Lets no point that is not fixed be a minimum (sign 1, from low values up) or a maximum (sign −1, from high ones
/// down): each has a neighbour that was reached before it and lies on the other side of it.
bool flood(const std::vector<std::vector<std::uint32_t>>& neighbours, const std::vector<char>& source, double sign,
           std::vector<double>& w) {
  constexpr double kStep = 1e-9;
  using Item = std::pair<double, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<char> reached(w.size(), 0);
  bool changed = false;
  for (std::uint32_t i = 0; i < w.size(); ++i) {
    if (!source[i]) continue;
    reached[i] = 1;
    queue.push({sign * w[i], i});
  }
  while (!queue.empty()) {
    const auto [value, at] = queue.top();
    queue.pop();
    for (const std::uint32_t n : neighbours[at]) {
      if (reached[n]) continue;
      reached[n] = 1;
      if (sign * w[n] <= value) {
        w[n] = sign * (value + kStep);
        changed = true;
      }
      queue.push({sign * w[n], n});
    }
  }
  return changed;
}

std::vector<std::vector<std::uint32_t>> neighboursOf(const PlaneMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> out(mesh.points().size());
  for (const auto& t : mesh.triangles()) {
    for (std::size_t c = 0; c < 3; ++c) {
      out[t[c]].push_back(t[(c + 1) % 3]);
      out[t[c]].push_back(t[(c + 2) % 3]);
    }
  }
  return out;
}

/// s, the distance to the skeleton, and what it has at its nearest place.
struct Measured {
  std::vector<double> s, away, half, toRim;
  std::vector<Over> over;
};
Measured measure(const Fields& fields, const std::vector<Boned::Width>& width) {
  const auto& points = fields.mesh.points();
  std::vector<SectionPoint> ends;
  std::vector<std::uint32_t> of;
  const auto put = [&](std::uint32_t p) {
    ends.push_back(points[p]);
    of.push_back(p);
  };
  for (const auto& [a, b] : fields.bones) put(a), put(b);
  if (ends.empty()) put(static_cast<std::uint32_t>(std::ranges::find(fields.onBone, 1) - fields.onBone.begin()));
  const std::vector<std::size_t> sizes(fields.bones.empty() ? 1 : fields.bones.size(), fields.bones.empty() ? 1 : 2);
  const geometry::RimDistance toBone(ends, sizes);
  const geometry::RimDistance toRim(std::span<const SectionPoint>(points).first(fields.mesh.rim()), fields.sizes);
  const std::size_t count = points.size();
  Measured out{std::vector(count, 1.0), std::vector(count, 0.0), std::vector(count, 0.0), std::vector(count, 0.0),
               std::vector(count, Over{})};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [away, edge] = toBone.nearest(points[i]);
    const std::uint32_t a = of[edge], b = of[sizes[0] == 2 ? edge ^ 1u : edge];
    const SectionPoint along = points[b] - points[a];
    const double squared = dot(along, along);
    const double share = squared > 0 ? std::clamp(dot(points[i] - points[a], along) / squared, 0.0, 1.0) : 0;
    out.away[i] = away;
    out.half[i] = std::lerp(width[a].radius, width[b].radius, share);
    out.over[i] = lerp(width[a].over, width[b].over, share);
    if (i < fields.mesh.rim()) continue;
    out.toRim[i] = toRim.to(points[i]);
    out.s[i] = fields.onBone[i] ? 0 : away / std::max(1e-12, away + out.toRim[i]);
  }
  return out;
}

/// In the ring of which outline each triangle lies: from the rim inwards up to the skeleton. False when one has none.
bool findSides(Fields& fields) {
  const PlaneMesh& mesh = fields.mesh;
  std::unordered_set<std::uint64_t> bones;
  for (const auto& [a, b] : fields.bones) bones.insert(edgeKey(a, b));
  std::vector<std::uint32_t> outlineOf;
  for (std::uint32_t o = 0; o < fields.sizes.size(); ++o) outlineOf.insert(outlineOf.end(), fields.sizes[o], o);
  fields.side.assign(mesh.triangles().size(), kNone);
  std::vector<std::uint32_t> work;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles().size(); ++h) {
    if (mesh.twin(h) != kNone || fields.side[h / 3] != kNone) continue;
    fields.side[h / 3] = outlineOf[mesh.triangles()[h / 3][h % 3]];
    work.push_back(h / 3);
  }
  while (!work.empty()) {
    const std::uint32_t t = work.back();
    work.pop_back();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t twin = mesh.twin(h);
      if (twin == kNone) continue;
      const auto& corners = mesh.triangles()[t];
      if (bones.contains(edgeKey(corners[h % 3], corners[(h + 1) % 3]))) continue;
      std::uint32_t& other = fields.side[twin / 3];
      if (other == kNone) {
        other = fields.side[t];
        work.push_back(twin / 3);
      } else if (other != fields.side[t]) {
        return false;
      }
    }
  }
  return std::ranges::find(fields.side, kNone) == fields.side.end();
}

/// Smooths one number of Over, where it is not the same everywhere.
template <class Number>
void carry(const Diffusion& diffuse, const Number& number, std::vector<Over>& over) {
  const double first = number(over.front());
  if (std::ranges::all_of(over, [&](Over& one) { return number(one) == first; })) return;
  std::vector<double> values;
  for (Over& one : over) values.push_back(number(one));
  values = diffuse(std::move(values));
  for (std::size_t i = 0; i < over.size(); ++i) number(over[i]) = values[i];
}

/// The gradient at each point: the mean of those of the triangles round it by their areas.
std::vector<SectionPoint> gradientsOf(const PlaneMesh& mesh, const std::vector<double>& values) {
  std::vector<SectionPoint> out(values.size());
  std::vector<double> area(values.size(), 0.0);
  for (const auto& t : mesh.triangles()) {
    const Element element = elementOf(mesh, t);
    SectionPoint sum{};  // times twice the area
    for (std::size_t c = 0; c < 3; ++c) sum += element.gradient[c] * values[t[c]];
    for (const std::uint32_t p : t) {
      out[p] += sum;
      area[p] += element.area2;
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (area[i] > 0) out[i] = out[i] / area[i];
  }
  return out;
}

/// With points so far apart. In a coarse mesh outlines keep points that are nearer: rows would cross outlines that are
/// long chords; and the skeleton its ends: without them narrow tips are too thick.
Result<Fields> fieldsAt(const geometry::Contours& piece, const Skeleton& skeleton, double spacing, double fineness) {
  const geometry::PlaneRegion rim = geometry::planeRegion(geometry::sampleRegion(piece, std::sqrt(fineness) * spacing));
  const Bones bones = BoneMaker(skeleton, spacing, kNearEnd * fineness * spacing).run();
  std::optional<Boned> boned = bonedMesh(rim, bones, spacing);
  if (!boned) return Error::RegionTooFine;
  Fields fields{
      std::move(boned->mesh), rim.sizes, std::move(boned->edges), {}, {}, {}, {}, {}, {}, {}, {}, {}, spacing, 0};
  const std::size_t count = fields.mesh.points().size(), onRim = fields.mesh.rim();
  fields.onBone.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) fields.onBone[i] = boned->width[i].radius > 0;
  if (!findSides(fields)) return Error::RegionTooFine;
  const Measured measured = measure(fields, boned->width);
  const Operators operators = operatorsOf(fields.mesh);
  const auto neighbours = neighboursOf(fields.mesh);

  std::vector<double> w(count), g(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) w[i] = measured.s[i] * measured.s[i];
  for (const auto& [i, k, weight] : operators.entries) {
    g[i] += weight * (w[k] - w[i]);
    g[k] += weight * (w[i] - w[k]);
  }
  for (std::size_t i = 0; i < count; ++i) g[i] /= operators.mass[i];
  for (std::size_t i = 0; i < onRim; ++i) {  // of half a neighbourhood nothing is known: as its inner neighbours
    double sum = 0;
    int inner = 0;
    for (const std::uint32_t n : neighbours[i]) {
      if (n >= onRim) sum += g[n], ++inner;
    }
    g[i] = inner > 0 ? sum / inner : 0;
  }
  const Diffusion diffuse(operators, measured.half);
  if (!diffuse.ok()) return Error::RegionTooFine;
  fields.half = diffuse(measured.half);
  fields.away = measured.away;
  fields.toRim = measured.toRim;
  fields.over = measured.over;
  carry(diffuse, [](Over& over) -> double& { return over.factor; }, fields.over);
  for (std::size_t k = 0; k < kMostSlices; ++k) {
    carry(diffuse, [k](Over& over) -> double& { return over.share[k]; }, fields.over);
  }
  g = diffuse(std::move(g));
  std::vector<char> fixed = fields.onBone, outlines(count, 0);
  std::fill_n(outlines.begin(), onRim, 1);
  std::fill_n(fixed.begin(), onRim, 1);
  if (!solveFor(operators, fixed, g, w)) return Error::RegionTooFine;
  for (std::size_t i = 0; i < count; ++i) {
    if (!fixed[i]) w[i] = std::clamp(w[i], 1e-6, 1 - 1e-6);
  }
  for (int round = 0; round < kRounds; ++round) {
    const bool up = flood(neighbours, fields.onBone, 1, w), down = flood(neighbours, outlines, -1, w);
    if (!up && !down) break;
  }
  fields.s.resize(count);
  for (std::size_t i = 0; i < count; ++i) fields.s[i] = fields.onBone[i] ? 0 : std::sqrt(std::clamp(w[i], 0.0, 1.0));
  fields.rise = gradientsOf(fields.mesh, fields.s);
  fields.widening = gradientsOf(fields.mesh, fields.half);
  return fields;
}

}  // namespace

Fields withReach(Fields fields, double reach) {
  fields.reach = reach;
  fields.rise.clear();
  std::vector<char> outlines(fields.s.size(), 0);
  std::fill_n(outlines.begin(), fields.mesh.rim(), 1);
  for (std::size_t i = 0; i < fields.s.size(); ++i) fields.s[i] = std::min(fields.s[i], 1 - fields.toRim[i] / reach);
  const auto neighbours = neighboursOf(fields.mesh);
  for (int round = 0; round < kRounds; ++round) {
    const bool up = flood(neighbours, fields.onBone, 1, fields.s), down = flood(neighbours, outlines, -1, fields.s);
    if (!up && !down) break;
  }
  return fields;
}

Over lerp(const Over& a, const Over& b, double t) {
  Over out{std::lerp(a.factor, b.factor, t), {}};
  for (std::size_t k = 0; k < kMostSlices; ++k) out.share[k] = std::lerp(a.share[k], b.share[k], t);
  return out;
}

std::size_t bytesOf(const Fields& fields) {
  const std::size_t points = fields.mesh.points().size(), triangles = fields.mesh.triangles().size();
  constexpr std::size_t kOfPoint = 3 * sizeof(SectionPoint) + 4 * sizeof(double) + sizeof(Over) + 1, kOfTriangle = 32;
  return points * kOfPoint + triangles * kOfTriangle;
}

Result<Fields> fieldsOf(const geometry::Contours& piece, const Skeleton& skeleton, double fineness) {
  const double even = std::sqrt(geometry::areaOf(piece) / (std::sqrt(0.75) * kPoints)), thin = thinness(skeleton);
  const double full = std::min(even, kThin * thin), least = geometry::perimeterOf(piece) / kMostOnRim;
  Result<Fields> fields = fieldsAt(piece, skeleton, std::max(full / fineness, least), fineness);
  for (int attempt = fineness < 1 ? 0 : 1; attempt < kTries && !fields; ++attempt) {
    fields = fieldsAt(piece, skeleton, std::ldexp(std::max(full, least), -attempt), 1);
  }
  return fields;
}

}  // namespace spineloft::inflate
