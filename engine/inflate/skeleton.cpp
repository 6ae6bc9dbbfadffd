#include "engine/inflate/skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/polyline.h"
#include "engine/geometry/refine.h"
#include "engine/geometry/spread.h"

namespace spineloft::inflate {
namespace {

constexpr double kSamples = 600;    ///< of all outlines of a piece, about, times the fineness
constexpr double kInside = 0.9;     ///< a circumcentre this share of its radius off the outline is a disc's
constexpr double kSlack = 0.04;     ///< of the radius: tremor that prunes
constexpr double kSameDisc = 0.99;  ///< an end grows on while its disc stays this large
constexpr double kSpacing = 0.15;   ///< of the radius, between points
constexpr double kSameFork = 0.25;  ///< of the radius: forks nearer than this are one, ends nearer are none
constexpr double kMostPoints = 600;
constexpr int kSmoothing = 10;
constexpr double kLambda = 0.5, kMu = -0.53;  ///< Taubin 1995

using geometry::PlaneMesh;
constexpr std::uint32_t kNone = PlaneMesh::kNone;
using Chain = std::vector<SkeletonPoint>;

/// The dual graph of the triangulation of samples: a disc a triangle, an edge where two share an edge.
class MedialAxis {
 public:
  MedialAxis(const PlaneMesh& mesh, const geometry::RimDistance& rim, bool isTree)
      : discs_(mesh.triangles().size()), next_(mesh.triangles().size()), kept_(mesh.triangles().size(), 0) {
    for (std::uint32_t t = 0; t < discs_.size(); ++t) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t twin = mesh.twin(3 * t + c);
        next_[t][c] = twin == kNone ? kNone : twin / 3;
      }
      discs_[t] = discOf(mesh, rim, t);
    }
    findCore(isTree);
  }

  void prune(double sigma) {
    std::vector<std::uint32_t> work;
    for (std::uint32_t t = 0; t < kept_.size(); ++t) {
      if (kept_[t]) work.push_back(t);
    }
    // Kept discs spread outwards; what was reached from its parent is never asked twice.
    for (std::size_t i = 0; i < work.size(); ++i) {
      for (const std::uint32_t child : next_[work[i]]) {
        if (child == kNone || kept_[child] || isCovered(child, work[i], sigma)) continue;
        kept_[child] = 1;
        work.push_back(child);
      }
    }
  }

  void growEnds() {
    const std::vector<char> before = kept_;
    for (std::uint32_t t = 0; t < before.size(); ++t) {
      if (before[t] && degree(before, t) == 1) grow(t);
    }
  }

  /// The kept graph, from an end or fork to the next; a cycle alone is closed: its first disc stands at its end too.
  struct Way {
    std::uint32_t from = 0, to = 0;  ///< nodes: discs by index
    Chain discs;
  };
  std::vector<Way> ways() const {
    std::vector<Way> out;
    std::vector<std::array<char, 3>> used(next_.size(), {0, 0, 0});
    for (const bool rings : {false, true}) {
      for (std::uint32_t t = 0; t < next_.size(); ++t) {
        if (!kept_[t] || (degree(kept_, t) == 2) != rings) continue;
        if (degree(kept_, t) == 0) out.push_back({t, t, {discs_[t]}});
        for (std::size_t c = 0; c < 3; ++c) {
          if (next_[t][c] == kNone || !kept_[next_[t][c]] || used[t][c]) continue;
          out.push_back(wayFrom(t, c, used));
        }
      }
    }
    return out;
  }

 private:
  static SkeletonPoint discOf(const PlaneMesh& mesh, const geometry::RimDistance& rim, std::uint32_t t) {
    const auto& [i, j, k] = mesh.triangles()[t];
    const SectionPoint a = mesh.points()[i], b = mesh.points()[j] - a, c = mesh.points()[k] - a;
    const double twice = 2 * cross(b, c);
    const SectionPoint to{(c.y * dot(b, b) - b.y * dot(c, c)) / twice, (b.x * dot(c, c) - c.x * dot(b, b)) / twice};
    const SectionPoint centre = a + to;
    if (isFinite(centre) && mesh.find(centre, t)) {
      const double radius = rim.to(centre);
      if (radius >= kInside * norm(to)) return {centre, radius};
    }
    SectionPoint middle = a + (b + c) / 3;
    double longest = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const SectionPoint p = mesh.points()[mesh.triangles()[t][h % 3]];
      const SectionPoint q = mesh.points()[mesh.triangles()[t][(h + 1) % 3]];
      if (mesh.twin(h) == kNone || distance(p, q) <= longest) continue;
      longest = distance(p, q);
      middle = (p + q) / 2;
    }
    return {middle, rim.to(middle)};
  }

  int degree(const std::vector<char>& among, std::uint32_t t) const {
    return static_cast<int>(std::ranges::count_if(next_[t], [&](auto n) { return n != kNone && among[n]; }));
  }

  /// Cycles and the ways between them; of a tree its largest disc.
  void findCore(bool isTree) {
    if (isTree) {
      const auto largest = std::ranges::max_element(discs_, {}, &SkeletonPoint::radius);
      kept_[static_cast<std::size_t>(largest - discs_.begin())] = 1;
      return;
    }
    std::ranges::fill(kept_, 1);
    std::vector<std::uint32_t> leaves;
    for (std::uint32_t t = 0; t < kept_.size(); ++t) {
      if (degree(kept_, t) <= 1) leaves.push_back(t);
    }
    while (!leaves.empty()) {
      const std::uint32_t t = leaves.back();
      leaves.pop_back();
      kept_[t] = 0;
      for (const std::uint32_t n : next_[t]) {
        if (n != kNone && kept_[n] && degree(kept_, n) == 1) leaves.push_back(n);
      }
    }
  }

  /// Calls visit(disc, parent) for the tree that hangs on `from` at `child`; goes on where it says true.
  template <class Visit>
  void eachBelow(std::uint32_t child, std::uint32_t from, const Visit& visit) const {
    std::vector<std::array<std::uint32_t, 2>> work{{child, from}};
    while (!work.empty()) {
      const auto [t, parent] = work.back();
      work.pop_back();
      if (!visit(t, parent)) continue;
      for (const std::uint32_t n : next_[t]) {
        if (n != kNone && n != parent) work.push_back({n, t});
      }
    }
  }

  bool isCovered(std::uint32_t child, std::uint32_t by, double sigma) const {
    const SkeletonPoint& large = discs_[by];
    bool covered = true;
    eachBelow(child, by, [&](std::uint32_t t, std::uint32_t) {
      const double reach = sigma * (large.radius - discs_[t].radius) + kSlack * large.radius;
      covered = covered && distance(discs_[t].at, large.at) <= reach;
      return covered;
    });
    return covered;
  }

  /// An end goes on along the longest pruned way whose discs stay about as large.
  void grow(std::uint32_t end) {
    const double least = kSameDisc * discs_[end].radius;
    std::vector<double> far(discs_.size(), 0);
    std::vector<std::uint32_t> parents(discs_.size(), kNone);
    std::uint32_t farthest = end;
    for (const std::uint32_t child : next_[end]) {
      if (child == kNone || kept_[child]) continue;
      eachBelow(child, end, [&](std::uint32_t t, std::uint32_t parent) {
        if (discs_[t].radius < least) return false;
        far[t] = far[parent] + distance(discs_[t].at, discs_[parent].at);
        parents[t] = parent;
        if (far[t] > far[farthest]) farthest = t;
        return true;
      });
    }
    for (std::uint32_t t = farthest; t != end; t = parents[t]) kept_[t] = 1;
  }

  Way wayFrom(std::uint32_t start, std::size_t corner, std::vector<std::array<char, 3>>& used) const {
    Way way{start, start, {discs_[start]}};
    std::uint32_t at = start;
    std::size_t out = corner;
    while (true) {
      used[at][out] = 1;
      const std::uint32_t to = next_[at][out];
      const auto back = static_cast<std::size_t>(std::ranges::find(next_[to], at) - next_[to].begin());
      used[to][back] = 1;
      way.discs.push_back(discs_[to]);
      at = way.to = to;
      if (at == start || degree(kept_, at) != 2) return way;
      for (std::size_t c = 0; c < 3; ++c) {
        if (c != back && next_[at][c] != kNone && kept_[next_[at][c]]) out = c;
      }
    }
  }

  std::vector<SkeletonPoint> discs_;
  std::vector<std::array<std::uint32_t, 3>> next_;
  std::vector<char> kept_;
};

double lengthOf(const Chain& chain) {
  double length = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) length += distance(chain[i].at, chain[i - 1].at);
  return length;
}

/// The way from disc to disc in units of their spacing.
std::vector<double> stepsAlong(const Chain& chain) {
  std::vector<double> s(chain.size(), 0.0);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const double radius = std::max(1e-9, (chain[i].radius + chain[i - 1].radius) / 2);
    s[i] = s[i - 1] + distance(chain[i].at, chain[i - 1].at) / (kSpacing * radius);
  }
  return s;
}

/// Without discs nearer to the one before than the spacing; both ends stay.
Chain contracted(const Chain& chain) {
  Chain out{chain.front()};
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const double least = kSpacing * chain[i].radius;
    const bool apart = distance(chain[i].at, out.back().at) >= least && distance(chain[i].at, chain.back().at) >= least;
    if (apart) out.push_back(chain[i]);
  }
  if (chain.size() > 1) out.push_back(chain.back());
  return out;
}

/// Evenly in units of the spacing, `stretch` times it apart at most, in at least `least` steps.
Chain resampled(const Chain& chain, double stretch, std::size_t least) {
  const std::vector<double> s = stepsAlong(chain);
  const auto steps = std::max(least, static_cast<std::size_t>(std::ceil(s.back() / stretch)));
  Chain out;
  std::size_t i = 1;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double at = s.back() * static_cast<double>(k) / static_cast<double>(steps);
    while (i + 1 < chain.size() && s[i] < at) ++i;
    const double span = s[i] - s[i - 1], share = span > 0 ? std::clamp((at - s[i - 1]) / span, 0.0, 1.0) : 0;
    out.push_back({lerp(chain[i - 1].at, chain[i].at, share),
                   chain[i - 1].radius + (chain[i].radius - chain[i - 1].radius) * share});
  }
  out.front() = chain.front();
  out.back() = chain.back();
  return out;
}

/// Taubin's steps; ends stay where they are, a ring has none.
void smooth(Chain& chain, bool ring) {
  const std::size_t n = chain.size() - (ring ? 1 : 0);
  std::vector<SectionPoint> shift(n);
  for (int pass = 0; pass < 2 * kSmoothing; ++pass) {
    for (std::size_t i = 0; i < n; ++i) {
      if (!ring && (i == 0 || i + 1 == n)) continue;
      const SectionPoint before = chain[(i + n - 1) % n].at, after = chain[(i + 1) % n].at;
      shift[i] = ((before + after) / 2 - chain[i].at) * (pass % 2 == 0 ? kLambda : kMu);
    }
    for (std::size_t i = 0; i < n; ++i) chain[i].at += shift[i];
  }
  if (ring) chain.back() = chain.front();
}

/// Nodes that are one: of forks that hardly stand apart the one with the larger disc.
class Nodes {
 public:
  explicit Nodes(const std::vector<MedialAxis::Way>& ways) {
    for (const auto& way : ways) {
      for (const std::uint32_t node : {way.from, way.to})
        add(node, node == way.from ? way.discs.front() : way.discs.back());
    }
    std::vector<int> degree(ids_.size(), 0);
    for (const auto& way : ways) ++degree[at(way.from)], ++degree[at(way.to)];
    for (const auto& way : ways) {
      const std::size_t a = at(way.from), b = at(way.to);
      // Two forks, or a fork and an end that hardly leaves it.
      if (a == b || std::max(degree[a], degree[b]) < 3 || degree[a] == 2 || degree[b] == 2) continue;
      if (lengthOf(way.discs) < kSameFork * std::max(discs_[a].radius, discs_[b].radius)) join(a, b);
    }
  }
  /// Which node stands for it.
  std::size_t of(std::uint32_t node) const { return root(at(node)); }
  const SkeletonPoint& disc(std::size_t root) const { return discs_[root]; }
  std::size_t count() const { return ids_.size(); }

 private:
  void add(std::uint32_t node, const SkeletonPoint& disc) {
    if (std::ranges::find(ids_, node) != ids_.end()) return;
    ids_.push_back(node);
    discs_.push_back(disc);
    parent_.push_back(parent_.size());
  }
  std::size_t at(std::uint32_t node) const {
    return static_cast<std::size_t>(std::ranges::find(ids_, node) - ids_.begin());
  }
  std::size_t root(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (discs_[a].radius < discs_[b].radius) std::swap(a, b);
    parent_[b] = a;
  }
  std::vector<std::uint32_t> ids_;
  std::vector<SkeletonPoint> discs_;
  std::vector<std::size_t> parent_;
};

/// The ways as smooth branches on common points.
Skeleton skeletonFrom(const std::vector<MedialAxis::Way>& ways) {
  Skeleton skeleton;
  const Nodes nodes(ways);
  std::vector<std::uint32_t> point(nodes.count(), kNone);
  double steps = 0;
  for (const auto& way : ways) steps += stepsAlong(way.discs).back();
  const double stretch = std::max(1.0, steps / kMostPoints);
  const auto pointOf = [&](std::size_t node) {
    if (point[node] == kNone) {
      point[node] = static_cast<std::uint32_t>(skeleton.points.size());
      skeleton.points.push_back(nodes.disc(node));
    }
    return point[node];
  };
  for (const auto& way : ways) {
    const std::size_t from = nodes.of(way.from), to = nodes.of(way.to);
    const bool alone = way.discs.size() == 1, merged = way.from != way.to && from == to && way.discs.size() > 1;
    const bool loop = way.from == way.to && !alone;
    // The way that two forks were joined along is gone; another one between them is a loop now.
    if (merged && lengthOf(way.discs) < kSameFork * nodes.disc(from).radius) continue;
    Chain chain = way.discs;
    chain.front() = nodes.disc(from);
    chain.back() = nodes.disc(to);
    const bool ring = loop && ways.size() == 1;
    if (!alone) {
      constexpr std::size_t kLeastSteps = 2, kLeastOfLoop = 8;
      chain = resampled(contracted(chain), stretch, loop || merged ? kLeastOfLoop : kLeastSteps);
      smooth(chain, ring);
    }
    std::vector<std::uint32_t> branch{pointOf(from)};
    if (ring) skeleton.points[branch[0]] = chain.front();
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      branch.push_back(static_cast<std::uint32_t>(skeleton.points.size()));
      skeleton.points.push_back(chain[i]);
    }
    if (!alone) branch.push_back(pointOf(to));
    skeleton.branches.push_back(std::move(branch));
  }
  if (skeleton.branches.empty()) skeleton.branches.push_back({pointOf(nodes.of(ways.front().from))});
  return skeleton;
}

}  // namespace

Result<Skeleton> skeletonOf(const geometry::Contours& piece, double sigma, double fineness) {
  const geometry::PlaneRegion samples =
      geometry::planeRegion(geometry::sampleRegion(piece, geometry::perimeterOf(piece) / (fineness * kSamples)));
  const PlaneMesh mesh(samples.points, samples.sizes);
  if (mesh.empty()) return Error::RegionTooFine;
  MedialAxis axis(mesh, geometry::RimDistance(samples.points, samples.sizes), samples.sizes.size() == 1);
  axis.prune(sigma);
  axis.growEnds();
  Skeleton skeleton = skeletonFrom(axis.ways());
  const geometry::PlaneRegion outlines = geometry::planeRegion(piece);
  const geometry::RimDistance rim(outlines.points, outlines.sizes);
  for (SkeletonPoint& p : skeleton.points) p.radius = rim.to(p.at);
  countNodes(skeleton);
  return skeleton;
}

void countNodes(Skeleton& skeleton) {
  std::vector<int> degree(skeleton.points.size(), 0);
  std::size_t edges = 0;
  for (const auto& branch : skeleton.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i, ++edges) ++degree[branch[i]], ++degree[branch[i - 1]];
  }
  skeleton.ends = static_cast<int>(std::ranges::count(degree, 1));
  skeleton.forks = static_cast<int>(std::ranges::count_if(degree, [](int d) { return d > 2; }));
  skeleton.rings = static_cast<int>(edges) - static_cast<int>(skeleton.points.size()) + 1;
}

double lengthOf(const Skeleton& skeleton) {
  double length = 0;
  for (const auto& branch : skeleton.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i) {
      length += distance(skeleton.points[branch[i]].at, skeleton.points[branch[i - 1]].at);
    }
  }
  return length;
}

}  // namespace spineloft::inflate
