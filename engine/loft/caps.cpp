#include "engine/loft/caps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/through_points.h"

namespace spineloft::loft {
namespace {

/// Where the fan is farthest out: its middle.
PicturePoint middleOf(std::span<const PicturePoint> fan) {
  const std::size_t half = fan.size() / 2;
  return fan.size() % 2 == 1 ? fan[half] : (fan[half - 1] + fan[half]) / 2;
}

/// Takes a chord that may follow the last one, if need be a hair farther out.
void admit(Chord chord, const CapSite& site, const ChordLimits& limits, Cap& cap) {
  if (chord.width() < limits.width) return;
  chord.at = site.last.at;
  const Chord& last = cap.chords.empty() ? site.last : cap.chords.back();
  if (distance(last.left, chord.left) < limits.spacing && distance(last.right, chord.right) < limits.spacing) {
    return;
  }
  if (!follows(last, chord, limits)) {
    if (chord.width() > last.width()) return;  // it would lie on what leads to it
    const PicturePoint hair = normalized(forwardOf(last.across())) * (1.5 * limits.spacing);
    chord.left += hair;
    chord.right += hair;
    if (!follows(last, chord, limits)) return;
  }
  cap.chords.push_back(chord);
}

/// Closes the cap at `tip`, brought to lie ahead of its last chord.
void closeAt(PicturePoint tip, const CapSite& site, const ChordLimits& limits, Cap& cap) {
  const Chord& last = cap.chords.empty() ? site.last : cap.chords.back();
  const PicturePoint forward = normalized(forwardOf(last.across()));
  const double lead = dot(tip - last.middle(), forward);
  if (lead < 2 * limits.spacing) tip += forward * (2 * limits.spacing - lead);
  cap.tip = tip;
}

/// Fan points that can be used: those that differ from their predecessor and from the rib's ends.
void usableFan(const CapSite& site, const ChordLimits& limits, std::vector<PicturePoint>& fan) {
  fan.clear();
  PicturePoint last = site.last.left;
  for (const PicturePoint& p : site.fan) {
    if (!isFinite(p) || distance(p, last) < limits.spacing || distance(p, site.last.right) < limits.spacing) {
      continue;
    }
    fan.push_back(p);
    last = p;
  }
  if (fan.empty()) return;
  const PicturePoint forward = normalized(forwardOf(site.last.across()));
  const double lead = dot(middleOf(fan) - site.last.middle(), forward);
  if (lead < 2 * limits.spacing) fan.clear();  // it does not lie beyond the end
}

/// One side of an end as a line on which it runs on.
struct SideLine {
  PicturePoint from, along;
  /// How far a point lies beyond it, the part being where `inside` is.
  double beyond(PicturePoint p, PicturePoint inside) const {
    const double at = cross(along, p - from);
    return cross(along, inside - from) > 0 ? -at : at;
  }
  /// Where the way from `inside` to `p` leaves it; `p` when it does not.
  PicturePoint kept(PicturePoint p, PicturePoint inside) const {
    const double at = beyond(p, inside), here = beyond(inside, inside);
    return at <= 0 || here == 0 ? p : lerp(inside, p, here / (here - at));
  }
};

/// Where the way from `inside`, within the circle, to `p` leaves it; `p` when it does not.
PicturePoint keptInCircle(PicturePoint p, PicturePoint inside, PicturePoint centre, double radius) {
  if (distance(p, centre) <= radius) return p;
  const PicturePoint way = p - inside, from = inside - centre;
  const double a = dot(way, way), b = dot(way, from), c = dot(from, from) - radius * radius;
  return inside + way * ((std::sqrt(std::max(0.0, b * b - a * c)) - b) / a);
}

/// A cap goes on as the sides run: a fan that is broader than an end that closes would sit on it as a
/// knob, for which there is no rib. Of one that hardly is, what lies beyond the run of a closing side is
/// brought back to it; of a broad one everything is brought within the arc that meets both sides smoothly.
void keepWithinSides(const CapSite& site, std::vector<PicturePoint>& fan) {
  constexpr double kClosing = 0.6;                    // sine of the angle between the sides: less is a mere taper
  constexpr double kSlightly = 0.05, kBroadly = 0.3;  // beyond a side, as shares of the half width
  const PicturePoint left = normalized(site.last.left - site.shoulder.left),
                     right = normalized(site.last.right - site.shoulder.right);
  const double opening = cross(left, right) * (cross(site.travel, site.last.across()) < 0 ? -1 : 1);
  if (!(opening < -kClosing)) return;
  const PicturePoint inside = site.last.middle();
  const SideLine sides[2] = {{site.last.left, left}, {site.last.right, right}};
  const double half = site.last.width() / 2;
  double most = 0;
  for (const PicturePoint& p : fan) {
    for (const SideLine& side : sides) most = std::max(most, side.beyond(p, inside));
  }
  const double knob = std::clamp((most / half - kSlightly) / (kBroadly - kSlightly), 0.0, 1.0);
  // The circle through both ends of the last chord that runs on from the sides: half the angle between them is the
  // one between its radii there and the chord.
  const double halfAngle = std::acos(std::clamp(dot(left, right), -1.0, 1.0)) / 2;
  const double radius = half / std::cos(std::min(halfAngle, 1.4));
  const PicturePoint centre = inside - site.travel * std::sqrt(std::max(0.0, radius * radius - half * half));
  for (PicturePoint& p : fan) {
    const PicturePoint run = sides[1].kept(sides[0].kept(p, inside), inside);
    p = lerp(run, keptInCircle(run, inside, centre, radius), knob);
  }
}

/// A cap round the fan in `memory`.
void fanCap(const CapSite& site, const CapPlan& plan, CapMemory& memory, Cap& cap) {
  const std::vector<PicturePoint>& fan = memory.fan;
  // An even number of pieces in all makes the middle of the outline one of its points: the tip.
  const std::size_t gaps = fan.size() + 1, wanted = 2 * static_cast<std::size_t>(plan.rings);
  std::size_t steps = std::max<std::size_t>(1, (wanted + gaps - 1) / gaps);
  if (steps * gaps % 2 == 1) ++steps;
  std::vector<PicturePoint>& frame = memory.frame;
  frame.assign({site.before.left, site.last.left});
  frame.insert(frame.end(), fan.begin(), fan.end());
  frame.push_back(site.last.right);
  frame.push_back(site.before.right);
  std::vector<PicturePoint>& outline = memory.outline;
  geometry::throughPoints(frame, steps, outline);
  const std::size_t half = outline.size() / 2;
  for (std::size_t k = 1; k < half; ++k) {
    admit({outline[k], outline[outline.size() - 1 - k]}, site, plan.limits, cap);
  }
  closeAt(outline[half], site, plan.limits, cap);
}

void dome(const CapSite& site, double height, const CapPlan& plan, Cap& cap) {
  const PicturePoint middle = site.last.middle(), half = site.last.across() / 2;
  for (int ring = 1; ring <= plan.rings; ++ring) {
    const double angle = std::numbers::pi / 2 * ring / (plan.rings + 1);
    const PicturePoint at = middle + site.travel * (height * std::sin(angle));
    admit({at - half * std::cos(angle), at + half * std::cos(angle)}, site, plan.limits, cap);
  }
  closeAt(middle + site.travel * height, site, plan.limits, cap);
}

}  // namespace

void planCap(const CapSite& site, const CapPlan& plan, CapMemory& memory, Cap& cap) {
  cap.chords.clear();
  cap.tip.reset();
  if (plan.style != sections::CapStyle::Round && plan.style != sections::CapStyle::Pointed) return;
  usableFan(site, plan.limits, memory.fan);
  std::vector<PicturePoint>& fan = memory.fan;
  if (plan.style == sections::CapStyle::Round) keepWithinSides(site, fan);
  const double halfWidth = std::abs(cross(site.last.across(), site.travel)) / 2;
  if (plan.style == sections::CapStyle::Pointed) {
    const PicturePoint point = site.last.middle() + site.travel * (sections::kPointLength * halfWidth);
    closeAt(fan.empty() ? point : middleOf(fan), site, plan.limits, cap);
  } else if (!fan.empty()) {
    fanCap(site, plan, memory, cap);
  } else if (site.fan.empty()) {
    // Where a fan was found, but not beyond the last rib, the part ends there.
    dome(site, sections::kDomeHeight * halfWidth, plan, cap);
  }
}

}  // namespace spineloft::loft
