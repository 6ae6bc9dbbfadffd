#include "engine/loft/stations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/polygon.h"

namespace spineloft::loft {
namespace {

/// Ribs wobble by a pixel; seen from the front that is the silhouette, but in depth it would be a
/// wrinkle. The window shrinks towards the ends, so that steady tapers and both ends stay as they are.
void smoothDepths(std::span<Flat> body, double reach, StationMemory& memory) {
  std::vector<double>&depths = memory.depths, &weights = memory.weights;
  depths.resize(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) depths[i] = body[i].depth;
  weights.clear();
  for (double k = 0; k <= std::ceil(3 * reach); ++k) {
    weights.push_back(reach > 0 ? std::exp(-k * k / (2 * reach * reach)) : 1);
  }
  for (std::size_t i = 0; i < body.size(); ++i) {
    const std::size_t window = std::min({weights.size() - 1, i, body.size() - 1 - i});
    double sum = depths[i], total = 1;
    for (std::size_t k = 1; k <= window; ++k) {
      sum += weights[k] * (depths[i - k] + depths[i + k]);
      total += 2 * weights[k];
    }
    constexpr double kMost = 1.5;  // a waist between wide ribs must not become a blade
    body[i].depth = std::clamp(sum / total, depths[i] / kMost, depths[i] * kMost);
  }
}

void flatStations(const Outline& outline, double centring, StationMemory& memory) {
  memory.line.follow(outline, centring);
  const std::size_t first = outline.startTip ? 1 : 0;
  std::vector<Flat>& stations = memory.flat;
  stations.clear();
  stations.reserve(outline.chords.size());
  for (std::size_t i = 0; i < outline.chords.size(); ++i) {
    const PicturePoint across = outline.chords[i].across();
    const double square = std::abs(cross(across, memory.line.travel[first + i]));
    stations.push_back({outline.chords[i], std::max(square, kLeastDepth * norm(across)) / 2});
  }
  const std::size_t body = outline.bodyEnd - outline.bodyBegin;
  smoothDepths(std::span(stations).subspan(outline.bodyBegin, body), centring, memory);
}

/// The curves along the spine at one place.
struct Along {
  double twist = 0, squash = 1, tilt = 0, bulge = 0;
};

/// The curves along the spine; on a ring they meet at the seam.
class Curves {
 public:
  Curves(const LoftParams& params, bool ring) : params_(params), ring_(ring) {}

  Along at(double share) const {
    Along along;
    along.twist = geometry::valueAt(params_.twist, share, 0);
    along.squash = valueAt(params_.squash, share, 1);
    along.tilt = valueAt(params_.tilt, share, 0);
    along.bulge = valueAt(params_.bulge, share, 0);
    if (ring_) {
      const double gone = geometry::valueAt(params_.twist, 1, 0) - geometry::valueAt(params_.twist, 0, 0);
      along.twist -= share * std::remainder(gone, 2 * std::numbers::pi);
    }
    return along;
  }

  /// How much of the mean of both ends counts at this place of a ring.
  static double seam(double share) {
    constexpr double kReach = 0.15;  // share of the length on either side of the seam
    const double t = std::clamp(share / kReach, 0.0, 1.0);
    return 1 - t * t * (3 - 2 * t);
  }

 private:
  double valueAt(const geometry::AlongCurve& curve, double share, double fallback) const {
    const double value = geometry::valueAt(curve, share, fallback);
    if (!ring_ || curve.empty()) return value;
    const double first = geometry::valueAt(curve, 0, fallback);
    const double last = geometry::valueAt(curve, 1, fallback), mean = (first + last) / 2;
    return value + (mean - first) * seam(share) + (mean - last) * seam(1 - share);
  }

  const LoftParams& params_;
  bool ring_;
};

/// How much happens along the spine, summed up: one unit is one more section's worth. `sum` is memory.
class Change {
 public:
  Change(const StationMaker& maker, std::vector<double>& sum) : sum_(sum) {
    constexpr std::size_t kGrid = 1024;
    constexpr double kAngle = 8 * std::numbers::pi / 180, kShare = 0.08;
    const Curves curves(maker.params, maker.ring());
    sum_.assign(kGrid + 1, 0.0);
    Along last = curves.at(0);
    double section = maker.track.progress(0);
    ModelPoint travel = maker.moved() ? maker.spine->posed.front().tangent : ModelPoint{};
    for (std::size_t i = 1; i <= kGrid; ++i) {
      const double share = static_cast<double>(i) / kGrid;
      const Along next = curves.at(share);
      double step = std::abs(next.twist - last.twist) / kAngle +
                    std::abs(std::log(next.squash / last.squash)) / kShare +
                    std::abs(std::tan(next.tilt) - std::tan(last.tilt)) / (2 * kShare) +
                    std::abs(next.bulge - last.bulge) / kShare;
      const double shape = maker.track.progress(share);
      step += std::min(std::abs(shape - section), 12.0);
      if (maker.moved()) {
        const auto& frames = maker.spine->posed;
        const ModelPoint tangent =
            frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))].tangent;
        step += std::acos(std::clamp(dot(tangent, travel), -1.0, 1.0)) / kAngle;
        travel = tangent;
      }
      sum_[i] = sum_[i - 1] + step;
      last = next;
      section = shape;
    }
  }

  double at(double share) const {
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(sum_.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), sum_.size() - 2);
    return sum_[i] + (sum_[i + 1] - sum_[i]) * (at - static_cast<double>(i));
  }

  /// The place in from…to where the sum has reached `wanted`.
  double placeOf(double wanted, double from, double to) const {
    for (int round = 0; round < 30; ++round) {
      const double middle = (from + to) / 2;
      (at(middle) < wanted ? from : to) = middle;
    }
    return (from + to) / 2;
  }

 private:
  std::vector<double>& sum_;
};

/// `stations` with more of them where much happens between two.
void refine(const std::vector<Flat>& stations, const Change& change, std::size_t points, std::vector<Flat>& out) {
  constexpr double kMostVertices = 400000;
  const double total = change.at(1);
  const double room = std::max(
      0.0, std::min(2000.0, kMostVertices / static_cast<double>(points)) - static_cast<double>(stations.size()));
  const double unit = total > room ? total / std::max(1.0, room) : 1;
  out.clear();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0 && stations[i].chord.at > stations[i - 1].chord.at) {
      const Flat a = stations[i - 1], b = stations[i];
      const double from = change.at(a.chord.at), to = change.at(b.chord.at);
      const int steps = static_cast<int>(std::ceil((to - from) / unit - 0.01));
      for (int k = 1; k < steps; ++k) {
        const double at = change.placeOf(from + (to - from) * k / steps, a.chord.at, b.chord.at);
        const double t = (at - a.chord.at) / (b.chord.at - a.chord.at);
        out.push_back({{lerp(a.chord.left, b.chord.left, t), lerp(a.chord.right, b.chord.right, t), at},
                       a.depth + (b.depth - a.depth) * t});
      }
    }
    out.push_back(stations[i]);
  }
}

/// Sizes near the seam of a ring meet halfway; the last station goes when it stands on the first.
void joinSeam(std::vector<Flat>& stations, const PosedSpine& spine) {
  struct Local {
    ModelPoint left, right;
    double depth;
  };
  const auto frame = [&](double at) {
    const double place = at * static_cast<double>(spine.rest.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), spine.rest.size() - 2);
    return geometry::between(spine.rest[i], spine.rest[i + 1], place - static_cast<double>(i));
  };
  const auto local = [&](const Flat& flat) {
    const geometry::Frame f = frame(flat.chord.at);
    const auto in = [&](PicturePoint p) {
      const ModelPoint off = ModelPoint{p.x, -p.y, 0} - f.at;
      return ModelPoint{dot(off, f.tangent), dot(off, f.across), 0};
    };
    return Local{in(flat.chord.left), in(flat.chord.right), flat.depth};
  };
  const Local first = local(stations.front()), last = local(stations.back());
  for (Flat& flat : stations) {
    const double a = Curves::seam(flat.chord.at) / 2, b = Curves::seam(1 - flat.chord.at) / 2;
    const geometry::Frame f = frame(flat.chord.at);
    const auto moved = [&](PicturePoint& p, ModelPoint Local::* end) {
      const ModelPoint by = (last.*end - first.*end) * (a - b);
      const ModelPoint step = f.tangent * by.x + f.across * by.y;
      p += PicturePoint{step.x, -step.y};
    };
    moved(flat.chord.left, &Local::left);
    moved(flat.chord.right, &Local::right);
    flat.depth += (last.depth - first.depth) * (a - b);
  }
  constexpr double kOneRound = 1 - 1e-6;
  if (stations.back().chord.at - stations.front().chord.at > kOneRound) stations.pop_back();
}

/// The section at one place, bulged, squashed and turned.
void appendShape(const SectionTrack& track, double share, const Along& along, std::vector<SectionPoint>& shapes) {
  const std::size_t first = shapes.size();
  track.appendShape(share, shapes);
  const double front = std::max(kLeastSide, 1 + along.bulge) * along.squash;
  const double back = std::max(kLeastSide, 1 - along.bulge) * along.squash;
  const double c = std::cos(along.twist), s = std::sin(along.twist);
  for (SectionPoint& p : std::span(shapes).subspan(first)) {
    p.y *= p.y > 0 ? front : back;
    if (along.twist != 0) p = {p.x * c - p.y * s, p.x * s + p.y * c};
  }
}

Station stationOf(const Flat& flat, const Along& along, const PosedSpine* spine) {
  const PicturePoint middle = flat.chord.middle(), half = flat.chord.across() / 2;
  const PicturePoint forward = normalized(forwardOf(half));
  const PicturePoint sheared = middle + forward * (flat.depth * std::tan(along.tilt));
  Station station;
  station.middle = middle;
  station.half = half;
  if (spine == nullptr) {
    station.centre = {middle.x, -middle.y, 0};
    station.across = {half.x, -half.y, 0};
    station.depth = {sheared.x - middle.x, middle.y - sheared.y, flat.depth};
    return station;
  }
  const double at = flat.chord.at;
  station.centre = carried(*spine, at, middle);
  station.across = carried(*spine, at, middle + half) - station.centre;
  station.depth = carried(*spine, at, sheared, flat.depth) - station.centre;
  return station;
}

/// Curvature of the posed line at each station.
void addBends(std::vector<Station>& stations, const std::vector<Flat>& flat, const PosedSpine& spine) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    constexpr double kReach = 0.01;  // share of the length over which the bend is taken
    const std::size_t n = spine.posed.size() - 1;
    const auto index = [&](double share) {
      return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(n)));
    };
    const std::size_t a = index(flat[i].chord.at - kReach), b = index(flat[i].chord.at + kReach);
    double length = 0;
    for (std::size_t k = a; k < b; ++k) length += distance(spine.posed[k].at, spine.posed[k + 1].at);
    if (length > 0) stations[i].bend = (spine.posed[b].tangent - spine.posed[a].tangent) / length;
  }
}

}  // namespace

void CentreLine::follow(const Outline& outline, double reach) {
  middles.clear();
  middles.reserve(outline.chords.size() + 2);
  if (outline.startTip) middles.push_back(*outline.startTip);
  for (const Chord& chord : outline.chords) middles.push_back(chord.middle());
  if (outline.endTip) middles.push_back(*outline.endTip);
  const std::size_t n = middles.size();
  const double sigma = std::max(reach, 0.25);
  weights.clear();
  for (double k = 1; k <= std::max(1.0, std::ceil(3 * sigma)); ++k) {
    weights.push_back(k * std::exp((1 - k * k) / (2 * sigma * sigma)));
  }
  travel.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    PicturePoint sum;
    for (std::size_t k = 1; k <= weights.size(); ++k) {
      sum += weights[k - 1] * (middles[std::min(i + k, n - 1)] - middles[i > k ? i - k : 0]);
    }
    travel[i] = normalized(sum);
  }
}

bool StationMaker::changes() const {
  return moved() || track.varies() || !params.twist.empty() || !params.squash.empty() || !params.tilt.empty() ||
         !params.bulge.empty();
}

void StationMaker::sweep(const Outline& outline, StationMemory& memory, Sweep& sweep) const {
  sweep.shapes.clear();
  sweep.stations.clear();
  sweep.joined = false;
  sweep.sizes.assign(track.sizes().begin(), track.sizes().end());
  sweep.startOpen = outline.startOpen;
  sweep.endOpen = outline.endOpen;
  const PosedSpine* carrier = moved() ? spine : nullptr;
  flatStations(outline, params.centring, memory);
  std::vector<Flat>& flat = memory.flat;
  if (changes()) {
    refine(flat, Change(*this, memory.changes), track.count(), memory.refined);
    flat.swap(memory.refined);
  }
  constexpr std::size_t kLeastRing = 3;
  if (ring() && flat.size() > kLeastRing) {
    joinSeam(flat, *spine);
    sweep.joined = true;
  }
  const auto tip = [&](const std::optional<PicturePoint>& p, double at) -> std::optional<Tip> {
    if (!p) return std::nullopt;
    return Tip{carrier ? carried(*carrier, at, *p) : ModelPoint{p->x, -p->y, 0}, *p};
  };
  sweep.startTip = tip(outline.startTip, flat.front().chord.at);
  sweep.endTip = tip(outline.endTip, flat.back().chord.at);
  const Curves curves(params, ring());
  const bool oneShape = !track.varies() && params.twist.empty() && params.squash.empty() && params.bulge.empty();
  sweep.stations.reserve(flat.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Along along = curves.at(flat[i].chord.at);
    if (i == 0 || !oneShape) appendShape(track, flat[i].chord.at, along, sweep.shapes);
    sweep.stations.push_back(stationOf(flat[i], along, carrier));
    sweep.stations.back().shape = oneShape ? 0 : i;
  }
  if (carrier != nullptr) addBends(sweep.stations, flat, *carrier);
}

}  // namespace spineloft::loft
