#include "engine/pipeline/occluded_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>

namespace spineloft::pipeline {
namespace {

using Polygons = std::vector<std::vector<PicturePoint>>;

/// Of the ribs `first` … `last`, over whose ends on that side something may pass.
surface::OccludedOutline crossingAt(const ribs::RibSet& set, std::size_t first, std::size_t last, bool left,
                                    image::Size picture) {
  // Of the way from the middle to the end.
  constexpr double kOutside = 1.6, kThreshold = 0.85;
  surface::OccludedOutline out;
  const auto band = [&](std::size_t i, double from, double to, Polygons& into) {
    const auto at = [&](std::size_t k, double share) {
      const ribs::Rib& rib = set.ribs[k];
      return toUv(rib.center + ((left ? rib.left : rib.right) - rib.center) * share, picture);
    };
    into.push_back({at(i - 1, from), at(i - 1, to), at(i, to), at(i, from)});
  };
  for (std::size_t i = first + 1; i <= last; ++i) {
    band(i, 1, kOutside, out.outside);
    band(i, kThreshold, 1, out.threshold);
  }
  const std::size_t more = (last - first) / 2 + kBeside, count = set.ribs.size();
  for (std::size_t i = first - std::min(first, more) + 1; i <= std::min(count - 1, last + more); ++i) {
    const ribs::Rib &a = set.ribs[i - 1], &b = set.ribs[i];
    out.reach.push_back({toUv(a.left, picture), toUv(b.left, picture), toUv(b.right, picture), toUv(a.right, picture)});
  }
  return out;
}

/// A colour that a rib meets.
struct Sample {
  int rib;  ///< of those that are looked at
  bool left;
  std::array<std::uint8_t, 3> colour;
};

bool areAlike(const Sample& a, const Sample& b) {
  constexpr int kAlike = 24;
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::abs(a.colour[c] - b.colour[c]) > kAlike) return false;
  }
  return true;
}

/// Share of those samples of which `counts` holds that look like one; nothing when there are none.
template <class Counts>
std::optional<double> shareAlike(const Sample& one, const std::vector<Sample>& samples, const Counts& counts) {
  int looked = 0, alike = 0;
  for (const Sample& other : samples) {
    if (!counts(other)) continue;
    ++looked;
    alike += areAlike(one, other) ? 1 : 0;
  }
  if (looked == 0) return std::nullopt;
  return static_cast<double>(alike) / looked;
}

/// Colours along some of the ribs of a part, evenly spread.
class Sampled {
 public:
  Sampled(const ribs::RibSet& set, const image::Picture& picture)
      : picture_(picture), ribs_(static_cast<int>(std::min(set.ribs.size(), kMost))) {
    if (picture.working.empty()) return;
    for (int k = 0; k < ribs_; ++k) {
      const ribs::Rib& rib = set.ribs[ribOf(static_cast<std::size_t>(k), set.ribs.size())];
      for (const bool left : {true, false}) {
        const PicturePoint way = (left ? rib.left : rib.right) - rib.center;
        // Of the way from the middle to the end.
        for (const double share : {0.1, 0.3, 0.5}) add(rib.center + way * share, {k, left, {}}, own_);
        for (const double share : {0.7, 0.8, 0.9}) {
          add(rib.center + way * share, {k, left, {}}, own_);
          add(rib.center + way * share, {k, left, {}}, rim_);
        }
        for (const double share : {1.15, 1.25, 1.35, 1.45}) add(rib.center + way * share, {k, left, {}}, outside_);
      }
    }
  }
  /// Of the ribs of a set with `count`.
  std::size_t ribOf(std::size_t sampled, std::size_t count) const {
    return sampled * count / static_cast<std::size_t>(ribs_);
  }
  /// One flag a sampled rib.
  std::vector<bool> passed(bool left) const {
    std::vector<int> votes(static_cast<std::size_t>(ribs_));
    for (const Sample& one : rim_) {
      if (one.left == left) votes[static_cast<std::size_t>(one.rib)] += isPassed(one) ? 1 : -1;
    }
    std::vector<bool> out;
    for (const int vote : votes) out.push_back(vote > 0);
    return out;
  }

 private:
  static constexpr std::size_t kMost = 64;
  void add(PicturePoint at, Sample sample, std::vector<Sample>& to) const {
    const image::Image& shown = picture_.working;
    const double x = std::floor((at.x + 0.5) * shown.width / picture_.width);
    const double y = std::floor((at.y + 0.5) * shown.height / picture_.height);
    if (!(x >= 0 && y >= 0 && x < shown.width && y < shown.height)) return;
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(shown.width) + static_cast<std::size_t>(x);
    std::copy_n(&shown.pixels[4 * i], 3, sample.colour.begin());
    to.push_back(sample);
  }
  /// Whether a colour just within the part is rather that of something beside it.
  bool isPassed(const Sample& one) const {
    // Ribs near by and far away, as shares of all; least share outside near by, most share of the part far away,
    // and most of the former outside far away.
    constexpr int kNear = 5, kFar = 3;
    constexpr double kCommon = 0.15, kNowhere = 0.02, kRarer = 0.5;
    const auto near = [&](const Sample& s) { return s.left == one.left && std::abs(s.rib - one.rib) <= ribs_ / kNear; };
    const auto far = [&](const Sample& s) { return std::abs(s.rib - one.rib) > ribs_ / kFar; };
    const std::optional<double> beside = shareAlike(one, outside_, near);
    if (!beside || *beside <= kCommon) return false;
    const std::optional<double> own = shareAlike(one, own_, far);
    if (!own || *own >= kNowhere) return false;
    const std::optional<double> around = shareAlike(one, outside_, far);
    return around && *around < kRarer * *beside;
  }

  const image::Picture& picture_;
  int ribs_;
  std::vector<Sample> own_, rim_, outside_;
};

/// Ribs in a row.
struct Stretch {
  std::size_t first, last;
  bool left;
};

/// The stretches of one side at which `isSeen` is false; ribs between two of them that are too near to be believed
/// belong to one.
template <class IsSeen>
void addStretches(std::size_t count, bool left, const IsSeen& isSeen, std::vector<Stretch>& found) {
  const std::size_t ends = doubtfulEnds(count), before = found.size();
  for (std::size_t i = ends; i + ends < count; ++i) {
    if (isSeen(i)) continue;
    if (found.size() == before || i > found.back().last + kBeside + 1) found.push_back({i, i, left});
    found.back().last = i;
  }
}

}  // namespace

std::vector<surface::OccludedOutline> occludedStretches(const ribs::RibSet& set, const image::Picture& picture) {
  constexpr std::size_t kLeast = 5, kMost = 2;
  std::vector<Stretch> found;
  const PassedEnds ends = passedEnds(set, picture);
  for (const bool left : {true, false}) {
    const std::vector<bool>& passed = left ? ends.left : ends.right;
    addStretches(
        set.ribs.size(), left,
        [&](std::size_t i) { return isSeen(left ? set.ribs[i].leftState : set.ribs[i].rightState) && !passed[i]; },
        found);
  }
  std::erase_if(found, [](const Stretch& s) { return s.last - s.first + 1 < kLeast; });
  std::ranges::stable_sort(found, std::ranges::greater{}, [](const Stretch& s) { return s.last - s.first; });
  std::vector<surface::OccludedOutline> out;
  for (std::size_t i = 0; i < std::min(found.size(), kMost); ++i) {
    out.push_back(crossingAt(set, found[i].first, found[i].last, found[i].left, {picture.width, picture.height}));
  }
  return out;
}

PassedEnds passedEnds(const ribs::RibSet& set, const image::Picture& picture) {
  const std::size_t count = set.ribs.size();
  PassedEnds out{std::vector<bool>(count, false), std::vector<bool>(count, false)};
  const Sampled sampled(set, picture);
  for (const bool left : {true, false}) {
    const std::vector<bool> passed = sampled.passed(left);
    for (std::size_t k = 0; k < passed.size(); ++k) {
      if (!passed[k]) continue;
      for (std::size_t i = sampled.ribOf(k, count); i < sampled.ribOf(k + 1, count); ++i) {
        const ribs::RibState state = left ? set.ribs[i].leftState : set.ribs[i].rightState;
        (left ? out.left : out.right)[i] = state == ribs::RibState::Edge;
      }
    }
  }
  return out;
}

}  // namespace spineloft::pipeline
