#include "engine/stack/passage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "engine/geometry/bend.h"
#include "engine/geometry/hermite.h"
#include "engine/geometry/polygon.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<SectionPoint>;

/// Points of a curve about the centre of its outer one, turned.
void appendRing(const Network& network, std::size_t curve, double angle, Points& out) {
  const Drawn& drawn = network.curves[curve];
  for (const SectionPoint p : drawn.ring) out.push_back(rotated(p - drawn.centre, angle));
}

/// A neighbour of a curve one or two sheets away: what turns its points to that of the curve, and the way to it.
struct Neighbour {
  std::size_t curve = kNone;
  double angle = 0, turn = 0, length = 0;
};
std::optional<Neighbour> neighbourOf(const Network& network, std::size_t curve, bool up) {
  const Drawn& drawn = network.curves[curve];
  const std::size_t next = up ? drawn.up : drawn.down;
  const Link* link = up ? network.above(drawn.outer) : network.below(drawn.outer);
  if (next == kNone || link == nullptr) return std::nullopt;
  return Neighbour{next, up ? -link->total() : link->total(), up ? link->turn : -link->turn, link->length};
}

/// The derivative by length of what `value` says of a curve and of its neighbours; `value` takes a neighbour's curve
/// and the angle that turns it here, and how much it turned on the way.
template <class Value>
auto slopeOf(const Network& network, std::size_t curve, const Value& value) {
  const auto here = value(Neighbour{curve});
  const auto before = neighbourOf(network, curve, false), after = neighbourOf(network, curve, true);
  if (before && after) {
    return geometry::parabolaSlope(value(*before), here, value(*after), before->length, after->length);
  }
  const bool up = after.has_value();
  const Neighbour first = up ? *after : *before;
  const double way = up ? 1 : -1;
  std::optional<Neighbour> second = neighbourOf(network, first.curve, up);
  if (!second || second->curve == curve) return (value(first) - here) * (way / first.length);
  second->angle += first.angle;
  second->turn += first.turn;
  return geometry::parabolaEndSlope(here, value(first), value(*second), first.length, second->length) * way;
}

}  // namespace

ModelPoint Passage::Section::at(SectionPoint p) const {
  const ModelPoint off = x * p.x + y * p.y;
  return centre + (bend == ModelPoint{} ? off : off + geometry::heldBack(off, bend));
}

Passage::Passage(const Sheets& sheets, const Network& network, const Link& link)
    : sheets_(sheets), from_{link.from}, to_{link.to}, length_(link.length), turn_(link.turn) {
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    const Drawn& curve = network.curves[i];
    if (!curve.hole || curve.outer != link.from || curve.up == kNone) continue;
    from_.push_back(i);
    to_.push_back(curve.up);
  }
  for (std::size_t i = 0; i < from_.size(); ++i) {
    appendRing(network, from_[i], 0, start_);
    appendRing(network, to_[i], -link.total(), end_);
    sizes_.push_back(network.curves[from_[i]].ring.size());
  }
  const Drawn &from = network.curves[link.from], &to = network.curves[link.to];
  const Sheet &a = sheets.all[from.sheet], &b = sheets.all[to.sheet];
  blend_ = a.blend;
  a_ = carriedBy(sheets, a, from.centre);
  b_ = carriedBy(sheets, b, to.centre);
  fromAt_ = a.at;
  toAt_ = b.at > a.at ? b.at : b.at + 1;
  flows_ = blend_.kind == sections::BlendKind::Flow;
  if (flows_) addFlow(network, link);
}

void Passage::addFlow(const Network& network, const Link& link) {
  const auto centreOf = [&](const Neighbour& n) {
    const Drawn& curve = network.curves[n.curve];
    return carriedBy(sheets_, sheets_.all[curve.sheet], curve.centre).centre;
  };
  const auto normalOf = [&](const Neighbour& n) {
    const Drawn& curve = network.curves[n.curve];
    return carriedBy(sheets_, sheets_.all[curve.sheet], curve.centre).normal;
  };
  const auto turnOf = [](const Neighbour& n) { return n.turn; };
  const auto flowAt = [&](std::size_t outer, const std::vector<std::size_t>& curves, double angle) {
    Flow flow;
    flow.normal = slopeOf(network, outer, normalOf) * length_;
    flow.turn = slopeOf(network, outer, turnOf) * length_;
    const Drawn& drawn = network.curves[outer];
    const bool ends = drawn.up == kNone || drawn.down == kNone;
    // Beyond an end nothing says where the way comes from but the sheet itself.
    flow.centre = (ends && !sheets_.alongRail ? normalOf({outer}) : slopeOf(network, outer, centreOf)) * length_;
    for (const std::size_t curve : curves) {
      const Drawn& own = network.curves[curve];
      for (std::size_t k = 0; k < own.ring.size(); ++k) {
        const SectionPoint slope = slopeOf(network, curve, [&](const Neighbour& n) {
          const Drawn& other = network.curves[n.curve];
          return rotated(other.ring[k] - other.centre, n.angle);
        });
        flow.figure.push_back(rotated(slope * length_, angle));
      }
    }
    return flow;
  };
  leave_ = flowAt(link.from, from_, 0);
  arrive_ = flowAt(link.to, to_, -link.total());
  constexpr int kProbes = 16, kPulls = 3;
  Points probe;
  const auto sound = [&] {
    for (int i = 1; i < kProbes; ++i) {
      figure(static_cast<double>(i) / kProbes, 0, probe);
      if (!isSound(probe)) return false;
    }
    return true;
  };
  for (int i = 0; i < kPulls && !sound(); ++i) pull_ /= 2;
  if (pull_ < 1 && !sound()) {
    flows_ = false;  // straight from one to the other, as far as that is sound
    blend_.kind = sections::BlendKind::Linear;
  }
}

void Passage::figure(double t, double g, Points& out) const {
  out.resize(start_.size());
  for (std::size_t i = 0; i < start_.size(); ++i) {
    out[i] = flows_ ? geometry::hermite(start_[i], end_[i], leave_.figure[i] * pull_, arrive_.figure[i] * pull_, t)
                    : lerp(start_[i], end_[i], g);
  }
}

bool Passage::isSound(const Points& figure) const {
  if (!geometry::areSimple(figure, sizes_)) return false;
  std::size_t first = 0;
  for (const std::size_t size : sizes_) {
    constexpr double kLeast = 1e-3;  // of the areas at the ends
    const auto area = [&](const Points& of) {
      return geometry::signedArea(std::span<const SectionPoint>(of).subspan(first, size));
    };
    if (!(area(figure) > kLeast * std::min(area(start_), area(end_)))) return false;
    first += size;
  }
  return true;
}

/// The nearest share at which the section between is sound, and that section.
double Passage::soundBlend(double t, double g, Points& out) const {
  figure(t, g, out);
  if (flows_ || isSound(out)) return g;
  constexpr int kSteps = 48;
  const double nearest = std::clamp(g, 0.0, 1.0);
  for (int k = 0; k <= kSteps; ++k) {
    const double step = static_cast<double>(k) / kSteps;
    const bool up = nearest >= 0.5;
    for (const double f : {up ? nearest + step : nearest - step, up ? nearest - step : nearest + step}) {
      if (f < 0 || f > 1) continue;
      figure(t, f, out);
      if (isSound(out)) return f;
    }
  }
  const double end = nearest < 0.5 ? 0 : 1;
  figure(t, end, out);
  return end;
}

Passage::Section Passage::section(double t) const {
  Section s;
  const double g = soundBlend(t, sections::blendAt(blend_, t), s.figure);
  double turned = g * turn_;
  ModelPoint normal, centre;
  if (flows_) {
    turned = geometry::hermite(0.0, turn_, leave_.turn, arrive_.turn, t);
    normal = normalized(geometry::hermite(a_.normal, b_.normal, leave_.normal, arrive_.normal, t));
    centre = geometry::hermite(a_.centre, b_.centre, leave_.centre, arrive_.centre, t);
  } else {
    const ModelPoint axis = cross(a_.normal, b_.normal);
    const double angle = std::atan2(norm(axis), dot(a_.normal, b_.normal)) * t;
    normal = a_.normal * std::cos(angle) + cross(normalized(axis), a_.normal) * std::sin(angle);
    const bool straight =
        sheets_.alongRail || blend_.kind == sections::BlendKind::Linear || blend_.kind == sections::BlendKind::Hold;
    centre = straight ? lerp(a_.centre, b_.centre, sheets_.alongRail ? g : t)
                      : geometry::hermite(a_.centre, b_.centre, a_.normal * length_, b_.normal * length_, t);
  }
  const ModelPoint x = leastTurned(a_.x, a_.normal, normal), y = cross(normal, x);
  const double c = std::cos(turned), sine = std::sin(turned);
  s.x = x * c + y * sine;
  s.y = y * c - x * sine;
  s.centre = centre;
  if (!sheets_.alongRail) return s;
  const double share = fromAt_ + (toAt_ - fromAt_) * t;
  const geometry::Frame frame = sheets_.rail->at(share);
  const ModelPoint third = cross(frame.across, frame.depth);
  const auto out = [&](ModelPoint v) { return frame.across * v.x + frame.depth * v.y + third * v.z; };
  s.centre = frame.at + out(s.centre);
  s.x = out(s.x);
  s.y = out(s.y);
  s.bend = sheets_.rail->bend(share);
  constexpr double kStraight = 1e-9;  // radians along the whole rail
  if (norm(s.bend) * sheets_.rail->length() < kStraight) s.bend = {};
  return s;
}

std::vector<double> Passage::rows(int most, int least) const {
  const bool holds = blend_.kind == sections::BlendKind::Hold;
  const double end = holds ? sections::kHeld : 1;
  const int steps = std::clamp(std::max(stepsTo(end), least), 1, most);
  std::vector<double> out;
  for (int i = 1; i <= steps; ++i) out.push_back(end * i / steps);
  if (holds) out.push_back(1);
  return out;
}

/// How many even steps it takes from the start to `end`.
int Passage::stepsTo(double end) const {
  constexpr int kProbes = 8;
  constexpr double kMost = 1e5;
  constexpr double kTolerance = 2e-4;  // of the size
  constexpr double kAngle = 2 * std::numbers::pi / 128;
  double size = 0, off = 0;
  for (const SectionPoint p : start_) size = std::max(size, norm(p));
  for (const SectionPoint p : end_) size = std::max(size, norm(p));
  std::vector<std::vector<ModelPoint>> rows;
  for (int i = 0; i <= kProbes; ++i) {
    constexpr double kNearEnd = 1e-6;
    const Section s = section(end * std::clamp(static_cast<double>(i) / kProbes, kNearEnd, 1 - kNearEnd));
    std::vector<ModelPoint>& row = rows.emplace_back();
    for (const SectionPoint p : s.figure) row.push_back(s.at(p));
  }
  for (int i = 1; i < kProbes; ++i) {
    for (std::size_t k = 0; k < start_.size(); ++k) {
      const ModelPoint straight = lerp(rows.front()[k], rows.back()[k], static_cast<double>(i) / kProbes);
      off = std::max(off, distance(straight, rows[static_cast<std::size_t>(i)][k]));
    }
  }
  double turned = 0;
  if (sheets_.alongRail) {
    ModelPoint last = sheets_.rail->at(fromAt_).tangent;
    for (int i = 1; i <= 32; ++i) {
      const ModelPoint next = sheets_.rail->at(fromAt_ + (toAt_ - fromAt_) * i / 32).tangent;
      turned += std::atan2(norm(cross(last, next)), dot(last, next));
      last = next;
    }
  }
  const double wanted = std::max(std::sqrt(off / (kTolerance * size)), turned / kAngle);
  return static_cast<int>(std::clamp(std::ceil(wanted - 1e-6), 1.0, kMost));
}

}  // namespace spineloft::stack
