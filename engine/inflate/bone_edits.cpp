#include "engine/inflate/bone_edits.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/spread.h"
#include "engine/inflate/crossing.h"

namespace spineloft::inflate {
namespace {

constexpr double kFewest = 3, kMost = 1.1;  ///< scales of detail 0 and 1
constexpr double kStep = 0.15;              ///< of the half width, between points of an added branch
constexpr double kLeastLength = 0.15;       ///< of the half width where it begins: a shorter one is a slip
constexpr double kAtRim = 0.02;             ///< of the half width where it begins: nearer to the outline it ends
constexpr double kFade = 2;                 ///< half widths along the skeleton in which what is held fades by e

using Branch = std::vector<std::uint32_t>;

SectionPoint up(PicturePoint p) { return {p.x, -p.y}; }

/// The skeleton of a piece while it is changed.
class Editor {
 public:
  Editor(const geometry::Contours& piece, Skeleton skeleton)
      : skeleton_(std::move(skeleton)),
        outlines_(geometry::planeRegion(piece)),
        rim_(outlines_.points, outlines_.sizes) {}

  bool drop(SectionPoint p, std::size_t edit) {
    const auto place = placeOf(p);
    if (!place) return false;
    const Branch gone = skeleton_.branches[place->branch];
    std::vector<Branch> rest = skeleton_.branches;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place->branch));
    const auto [a, b] = std::pair(componentAt(rest, gone.front()), componentAt(rest, gone.back()));
    if (gone.size() < 2 || a.points == b.points || (a.rings > 0 && b.rings > 0)) return false;
    const bool first = a.rings != b.rings ? a.rings > b.rings : a.largest >= b.largest;
    const Component& kept = first ? a : b;
    leaveOut(gone, edit);
    std::erase_if(rest, [&](const Branch& branch) {
      const bool goes = !std::ranges::binary_search(kept.points, branch.front());
      if (goes) leaveOut(branch, edit);
      return goes;
    });
    if (rest.empty()) {  // nothing but that branch: its largest disc stays
      rest.push_back({*std::ranges::max_element(gone, {}, [&](auto i) { return skeleton_.points[i].radius; })});
    }
    skeleton_.branches = std::move(rest);
    tidy();
    return true;
  }

  bool add(const std::vector<PicturePoint>& drawn) {
    reached_.push_back(kNoPoint);
    if (drawn.size() < 2) return false;
    const auto place = placeOf(up(drawn.front()));
    if (!place) return false;
    const Skeleton before = skeleton_;
    std::vector<SectionPoint> line{skeleton_.points[place->point].at};
    for (const PicturePoint p : drawn) line.push_back(up(p));
    geometry::dropRepeats(line, 1e-9);
    const std::uint32_t start = beginning(line, place->point);
    const Branch branch = grown(line, start);
    if (branch.size() < 2) return restore(before);
    skeleton_.branches.push_back(branch);
    splitAt(start);
    const std::vector<std::uint32_t> reached = reached_;
    reached_.back() = branch.back();
    tidy();
    if (isSound()) return true;
    reached_ = reached;
    return restore(before);
  }

  bool move(SectionPoint from, SectionPoint to) {
    const std::vector<int> degree = degrees();
    std::optional<std::uint32_t> node;
    for (const Branch& branch : skeleton_.branches) {
      for (const std::uint32_t end : {branch.front(), branch.back()}) {
        if (degree[end] != 2 && (!node || away(end, from) < away(*node, from))) node = end;
      }
    }
    if (!node || away(*node, from) > skeleton_.points[*node].radius) return false;
    const Skeleton before = skeleton_;
    const SectionPoint shift = to - skeleton_.points[*node].at;
    std::vector<double> share(skeleton_.points.size(), 0.0);
    for (const Branch& branch : skeleton_.branches) bend(branch, *node, share);
    share[*node] = 1;
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (share[i] <= 0) continue;
      skeleton_.points[i] = discAt(skeleton_.points[i].at + shift * share[i]);
      const SkeletonPoint& now = skeleton_.points[i];
      if (!isInside(now.at) || now.radius < kAtRim * before.points[i].radius) return restore(before);
    }
    return (isSound() && passesNoHole(before)) || restore(before);
  }

  /// What is held at points of the skeleton, and elsewhere changes as little as it can; `fades` to 0 over kFade half
  /// widths.
  using Held = std::vector<std::pair<std::uint32_t, double>>;
  std::vector<double> spread(const Held& held, bool fades) const {
    const auto n = static_cast<Eigen::Index>(skeleton_.points.size());
    std::vector<Eigen::Triplet<double, int>> triplets;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    for (const Branch& branch : skeleton_.branches) {
      for (std::size_t i = 1; i < branch.size(); ++i) {
        const auto a = static_cast<int>(branch[i - 1]), b = static_cast<int>(branch[i]);
        const SkeletonPoint &p = skeleton_.points[branch[i - 1]], &q = skeleton_.points[branch[i]];
        const double length = std::max(1e-9, distance(p.at, q.at)), width = kFade * (p.radius + q.radius) / 2;
        const double fade = fades ? length / (2 * width * width) : 0;
        for (const int end : {a, b}) triplets.emplace_back(end, end, 1 / length + fade);
        triplets.emplace_back(a, b, -1 / length);
        triplets.emplace_back(b, a, -1 / length);
      }
    }
    constexpr double kHold = 1e9;  // of the stiffness of a pixel
    for (int i = 0; i < static_cast<int>(n); ++i) triplets.emplace_back(i, i, 1e-12);
    for (const auto& [at, value] : held) {
      triplets.emplace_back(static_cast<int>(at), static_cast<int>(at), kHold);
      load[static_cast<Eigen::Index>(at)] += kHold * value;
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::VectorXd values = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);
    return {values.begin(), values.end()};
  }

  void raise(const Held& heights) {
    if (heights.empty()) return;
    const std::vector<double> over = spread(heights, true);
    for (std::size_t i = 0; i < over.size(); ++i)
      skeleton_.points[i].over.factor = std::clamp(1 + over[i], kLeastFactor, kMostFactor);
  }

  /// The shares of slices that are held at points; those that are not have none, or what others leave, for one that is
  /// everywhere.
  void share(const std::vector<std::optional<std::uint32_t>>& places, std::optional<std::size_t> everywhere) {
    Held none;
    for (const auto& place : places) {
      if (place) none.push_back({*place, 0});
    }
    if (none.empty()) return rest(everywhere.value_or(0));
    for (SkeletonPoint& point : skeleton_.points) point.over.share = {};
    for (std::size_t k = 0, which = 0; k < places.size(); ++k) {
      if (!places[k]) continue;
      Held held = none;
      held[which++].second = 1;
      const std::vector<double> values = spread(held, everywhere.has_value());
      for (std::size_t i = 0; i < values.size(); ++i)
        skeleton_.points[i].over.share[k] = std::clamp(values[i], 0.0, 1.0);
    }
    if (everywhere) rest(*everywhere);
  }

  struct Place {
    std::size_t branch;
    std::uint32_t point;
  };
  /// The nearest one, when `p` lies in its disc.
  std::optional<Place> placeOf(SectionPoint p) const {
    std::optional<Place> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < skeleton_.branches.size(); ++b) {
      const Branch& branch = skeleton_.branches[b];
      for (std::size_t i = 0; i < branch.size(); ++i) {
        // A node is no place of a branch but of all; the middle of an edge tells them apart.
        const SectionPoint at = skeleton_.points[branch[i]].at;
        const double off =
            i > 0 ? geometry::distanceToSegment(p, skeleton_.points[branch[i - 1]].at, at) : distance(p, at);
        if (off >= least) continue;
        least = off;
        best = {b, i > 0 && away(branch[i - 1], p) < away(branch[i], p) ? branch[i - 1] : branch[i]};
      }
    }
    if (!best || away(best->point, p) > skeleton_.points[best->point].radius) return std::nullopt;
    return best;
  }

  EditedSkeleton take(AwakeEdits awake) && {
    countNodes(skeleton_);
    return {std::move(skeleton_), std::move(awake), std::move(gone_), std::move(reached_)};
  }

 private:
  /// One slice has what the others leave.
  void rest(std::size_t slice) {
    for (SkeletonPoint& point : skeleton_.points) {
      auto& share = point.over.share;
      share[slice] = 0;
      share[slice] = std::max(0.0, 1 - std::accumulate(share.begin(), share.end(), 0.0));
    }
  }
  double away(std::uint32_t point, SectionPoint p) const { return distance(skeleton_.points[point].at, p); }
  SkeletonPoint discAt(SectionPoint p) const { return {p, rim_.to(p)}; }
  void leaveOut(const Branch& branch, std::size_t edit) {
    GoneBranch& gone = gone_.emplace_back();
    gone.drop = edit;
    for (const std::uint32_t p : branch) gone.line.push_back(skeleton_.points[p].at);
  }
  bool restore(const Skeleton& before) {
    skeleton_ = before;
    return false;
  }

  /// By even-odd over all outlines.
  bool isInside(SectionPoint p) const {
    bool inside = false;
    std::size_t first = 0;
    for (const std::size_t size : outlines_.sizes) {
      inside ^= geometry::holds(std::span<const SectionPoint>(outlines_.points).subspan(first, size), p);
      first += size;
    }
    return inside;
  }

  /// Ends of branches at each point; inner points of branches count 2.
  std::vector<int> degrees() const {
    std::vector<int> degree(skeleton_.points.size(), 0);
    for (const Branch& branch : skeleton_.branches) {
      for (std::size_t i = 1; i < branch.size(); ++i) ++degree[branch[i - 1]], ++degree[branch[i]];
    }
    return degree;
  }

  struct Component {
    std::vector<std::uint32_t> points;  ///< sorted
    int rings = 0;
    double largest = 0;
  };
  Component componentAt(const std::vector<Branch>& branches, std::uint32_t start) const {
    Component out{{start}, 0, 0};
    std::vector<char> used(branches.size(), 0);
    std::size_t edges = 0;
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t b = 0; b < branches.size(); ++b) {
        const auto has = [&](std::uint32_t p) { return std::ranges::binary_search(out.points, p); };
        if (used[b] || (!has(branches[b].front()) && !has(branches[b].back()))) continue;
        used[b] = 1;
        grows = true;
        edges += branches[b].size() - 1;
        out.points.insert(out.points.end(), branches[b].begin(), branches[b].end());
        std::ranges::sort(out.points);
        const auto [from, to] = std::ranges::unique(out.points);
        out.points.erase(from, to);
      }
    }
    out.rings = static_cast<int>(edges) - static_cast<int>(out.points.size()) + 1;
    for (const std::uint32_t p : out.points) out.largest = std::max(out.largest, skeleton_.points[p].radius);
    return out;
  }

  /// Where a line last crosses the skeleton, as a new point of it; else where it is joined to. The line begins there.
  std::uint32_t beginning(std::vector<SectionPoint>& line, std::uint32_t joined) {
    for (std::size_t i = line.size() - 1; i-- > 0;) {
      std::optional<double> last;
      Place where{};
      for (std::size_t b = 0; b < skeleton_.branches.size(); ++b) {
        const Branch& branch = skeleton_.branches[b];
        for (std::uint32_t k = 1; k < branch.size(); ++k) {
          const auto t =
              crossing(line[i], line[i + 1], skeleton_.points[branch[k - 1]].at, skeleton_.points[branch[k]].at);
          if (t && (!last || *t > *last)) last = t, where = {b, k};
        }
      }
      if (!last) continue;
      const auto point = static_cast<std::uint32_t>(skeleton_.points.size());
      skeleton_.points.push_back(discAt(lerp(line[i], line[i + 1], *last)));
      Branch& branch = skeleton_.branches[where.branch];
      branch.insert(branch.begin() + where.point, point);
      line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i));
      line.front() = skeleton_.points[point].at;
      return point;
    }
    return joined;
  }

  /// New points along a line from `start` on, up to where it leaves the region.
  Branch grown(std::span<const SectionPoint> line, std::uint32_t start) {
    const double width = skeleton_.points[start].radius;
    const std::vector<double> s = geometry::arcLengths(line);
    Branch branch{start};
    double at = 0;
    for (double radius = width; at < s.back();) {
      at = std::min(s.back(), at + std::max(kStep * radius, s.back() / kMostAdded));
      const SkeletonPoint disc = discAt(geometry::pointAt(line, std::span<const double>(s), at));
      if (!isInside(disc.at) || disc.radius < kAtRim * width) break;
      radius = disc.radius;
      branch.push_back(static_cast<std::uint32_t>(skeleton_.points.size()));
      skeleton_.points.push_back(disc);
    }
    if (at < kLeastLength * width) branch.resize(1);
    return branch;
  }
  static constexpr double kMostAdded = 200;

  /// Makes a point inside of a branch an end of two.
  void splitAt(std::uint32_t point) {
    for (std::size_t b = 0; b < skeleton_.branches.size(); ++b) {
      Branch& branch = skeleton_.branches[b];
      const auto found = std::ranges::find(branch, point);
      if (found == branch.end() || found == branch.begin() || found + 1 == branch.end()) continue;
      Branch second(found, branch.end());
      branch.erase(found + 1, branch.end());
      skeleton_.branches.push_back(std::move(second));
      return;
    }
    // A ring without a fork begins anywhere; a point alone is no branch beside others.
    std::erase_if(skeleton_.branches, [&](const Branch& branch) { return branch.size() == 1 && branch[0] == point; });
  }

  /// How much points of a branch go along with its end.
  void bend(const Branch& branch, std::uint32_t node, std::vector<double>& share) const {
    std::vector<SectionPoint> line;
    for (const std::uint32_t p : branch) line.push_back(skeleton_.points[p].at);
    const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(line));
    const bool first = branch.front() == node, last = branch.back() == node;
    for (std::size_t i = 1; i + 1 < branch.size(); ++i) {
      const double way = s[i] / std::max(1e-9, s.back());
      if (first && last) {
        share[branch[i]] = std::abs(1 - 2 * way);
      } else if (first || last) {
        share[branch[i]] = first ? 1 - way : way;
      }
    }
  }

  /// Branches that meet with nothing else between them become one; points of no branch go.
  void tidy() {
    for (bool joined = true; joined;) joined = joinOne();
    std::vector<std::uint32_t> index(skeleton_.points.size(), kNoPoint);
    std::vector<SkeletonPoint> points;
    for (Branch& branch : skeleton_.branches) {
      for (std::uint32_t& p : branch) {
        if (index[p] == kNoPoint) {
          index[p] = static_cast<std::uint32_t>(points.size());
          points.push_back(skeleton_.points[p]);
        }
        p = index[p];
      }
    }
    skeleton_.points = std::move(points);
    for (std::uint32_t& p : reached_) p = p == kNoPoint ? kNoPoint : index[p];
  }

  bool joinOne() {
    const std::vector<int> degree = degrees();
    auto& branches = skeleton_.branches;
    for (std::size_t a = 0; a < branches.size(); ++a) {
      for (std::size_t b = 0; b < branches.size(); ++b) {
        if (a == b || branches[a].size() < 2 || branches[b].size() < 2) continue;
        for (const bool fromFront : {true, false}) {
          const std::uint32_t end = fromFront ? branches[b].front() : branches[b].back();
          if (degree[end] != 2 || branches[a].back() != end) continue;
          if (!fromFront) std::ranges::reverse(branches[b]);
          branches[a].insert(branches[a].end(), branches[b].begin() + 1, branches[b].end());
          branches.erase(branches.begin() + static_cast<std::ptrdiff_t>(b));
          return true;
        }
        const std::uint32_t front = branches[a].front();
        if (degree[front] == 2 && branches[b].front() == front) {
          std::ranges::reverse(branches[a]);
          return true;
        }
      }
    }
    return false;
  }

  /// Whether a stretch between two points within crosses no outline.
  bool isClear(const SkeletonPoint& a, const SkeletonPoint& b) const {
    if (distance(a.at, b.at) < std::max(a.radius, b.radius)) return true;  // in a disc
    std::size_t first = 0;
    for (const std::size_t size : outlines_.sizes) {
      for (std::size_t i = 0, j = size - 1; i < size; j = i++) {
        if (crossing(a.at, b.at, outlines_.points[first + j], outlines_.points[first + i])) return false;
      }
      first += size;
    }
    return true;
  }

  /// Whether no branch was moved over a hole.
  bool passesNoHole(const Skeleton& before) const {
    for (const Branch& branch : skeleton_.branches) {
      for (std::size_t i = 1; i < branch.size(); ++i) {
        const auto now = [&](std::size_t k) { return skeleton_.points[branch[k]].at; };
        const auto was = [&](std::size_t k) { return before.points[branch[k]].at; };
        const std::array<SectionPoint, 4> swept{was(i - 1), was(i), now(i), now(i - 1)};
        std::size_t first = outlines_.sizes[0];
        for (std::size_t hole = 1; hole < outlines_.sizes.size(); first += outlines_.sizes[hole++]) {
          if (geometry::holds(std::span<const SectionPoint>(swept), outlines_.points[first])) return false;
        }
      }
    }
    return true;
  }

  /// Whether it lies within the region and does not cross itself.
  bool isSound() const {
    std::vector<std::array<SectionPoint, 2>> edges;
    for (const Branch& branch : skeleton_.branches) {
      for (std::size_t i = 1; i < branch.size(); ++i) {
        const SkeletonPoint &a = skeleton_.points[branch[i - 1]], &b = skeleton_.points[branch[i]];
        if (!isClear(a, b)) return false;
        edges.push_back({a.at, b.at});
      }
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (crossing(edges[i][0], edges[i][1], edges[k][0], edges[k][1])) return false;
      }
    }
    return true;
  }

  Skeleton skeleton_;
  std::vector<GoneBranch> gone_;
  std::vector<std::uint32_t> reached_;
  geometry::PlaneRegion outlines_;
  geometry::RimDistance rim_;
};

}  // namespace

double scaleFor(double detail) {
  const bool few = detail < 0.5;
  const double from = few ? kFewest : kScale, to = few ? kScale : kMost;
  return from * std::pow(to / from, few ? 2 * detail : 2 * detail - 1);
}

Result<EditedSkeleton> editedSkeleton(const geometry::Contours& piece, const BoneEdits& edits,
                                      std::span<const ProfileSlice> slices, double fineness) {
  Result<Skeleton> found = skeletonOf(piece, scaleFor(edits.detail), fineness);
  if (!found) return found.failure();
  Editor editor(piece, std::move(found).value());
  AwakeEdits awake;
  for (std::size_t i = 0; i < edits.drop.size(); ++i) awake.drop.push_back(editor.drop(up(edits.drop[i]), i));
  for (const auto& line : edits.add) awake.add.push_back(editor.add(line));
  for (const BoneMove& move : edits.move) awake.move.push_back(editor.move(up(move.from), up(move.to)));
  std::vector<std::pair<std::uint32_t, double>> heights;
  for (const BoneHeight& height : edits.heights) {
    const auto place = editor.placeOf(up(height.at));
    awake.heights.push_back(place.has_value());
    if (place) heights.push_back({place->point, height.factor - 1});
  }
  editor.raise(heights);
  std::vector<std::optional<std::uint32_t>> places;
  std::optional<std::size_t> everywhere;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const auto place = slices[k].at ? editor.placeOf(up(*slices[k].at)) : std::nullopt;
    places.push_back(place ? std::optional(place->point) : std::nullopt);
    awake.slices.push_back(!slices[k].at || place);
    if (!slices[k].at && !everywhere) everywhere = k;
  }
  editor.share(places, everywhere);
  return std::move(editor).take(std::move(awake));
}

bool isAwake(std::span<const EditedSkeleton> pieces, std::vector<char> AwakeEdits::* kind, std::size_t number) {
  return std::ranges::any_of(pieces, [&](const EditedSkeleton& piece) {
    const std::vector<char>& awake = piece.awake.*kind;
    return number < awake.size() && awake[number] != 0;
  });
}

int asleep(std::span<const EditedSkeleton> pieces) {
  int out = 0;
  if (pieces.empty()) return out;
  for (const auto kind :
       {&AwakeEdits::drop, &AwakeEdits::add, &AwakeEdits::move, &AwakeEdits::heights, &AwakeEdits::slices}) {
    for (std::size_t i = 0; i < (pieces.front().awake.*kind).size(); ++i) out += !isAwake(pieces, kind, i);
  }
  return out;
}

}  // namespace spineloft::inflate
