// Changing a drawing by its points.
#include <algorithm>

#include "engine/sections/curve.h"
#include "engine/sections/drawing.h"
#include "engine/sections/symmetry.h"

namespace spineloft::sections {
namespace {

/// Points nearer than this are images of each other, section units: turns are rounded.
constexpr double kSame = 1e-6;

bool same(SectionPoint a, SectionPoint b) { return distance(a, b) < kSame; }

bool exists(const Drawing& drawing, PointRef ref) {
  return ref.curve < drawing.size() && ref.point < drawing[ref.curve].points.size();
}

std::optional<PointRef> pointAt(const Drawing& drawing, SectionPoint p) {
  for (std::size_t c = 0; c < drawing.size(); ++c) {
    const auto& points = drawing[c].points;
    const auto hit = std::ranges::find_if(points, [&](const DrawnPoint& q) { return same(q.at, p); });
    if (hit != points.end()) return PointRef{c, static_cast<std::size_t>(hit - points.begin())};
  }
  return std::nullopt;
}

/// `p` brought to where every motion that leaves `anchor` in place leaves it too.
SectionPoint heldBy(const std::vector<Motion>& motions, SectionPoint anchor, SectionPoint p) {
  SectionPoint sum;
  double count = 0;
  for (const Motion& motion : motions) {
    if (!same(motion(anchor), anchor)) continue;
    sum += motion(p);
    ++count;
  }
  return sum / count;
}

/// A point and its images that are there, each with the motion to it. The point itself comes first.
struct Image {
  PointRef ref;
  Motion motion;
};
std::vector<Image> imagesIn(const Drawing& drawing, PointRef ref, const Symmetry& symmetry) {
  std::vector<Image> out;
  const SectionPoint anchor = drawing[ref.curve].points[ref.point].at;
  for (const Motion& motion : groupOf(symmetry).motions()) {
    const std::optional<PointRef> at = out.empty() ? ref : pointAt(drawing, motion(anchor));
    const bool known = at && std::ranges::any_of(out, [&](const Image& i) { return i.ref == *at; });
    if (at && !known) out.push_back({*at, motion});
  }
  return out;
}

}  // namespace

void movePoint(Drawing& drawing, PointRef ref, SectionPoint to, const Symmetry& symmetry) {
  if (!exists(drawing, ref)) return;
  const SectionPoint anchor = drawing[ref.curve].points[ref.point].at;
  const SectionPoint held = heldBy(groupOf(symmetry).motions(), anchor, to);
  for (const Image& image : imagesIn(drawing, ref, symmetry)) {
    drawing[image.ref.curve].points[image.ref.point].at = image.motion(held);
  }
}

void setCorner(Drawing& drawing, PointRef ref, bool corner, const Symmetry& symmetry) {
  if (!exists(drawing, ref)) return;
  for (const Image& image : imagesIn(drawing, ref, symmetry)) {
    drawing[image.ref.curve].points[image.ref.point].corner = corner;
  }
}

void removePoint(Drawing& drawing, PointRef ref, const Symmetry& symmetry) {
  if (!exists(drawing, ref)) return;
  std::vector<Image> gone = imagesIn(drawing, ref, symmetry);
  std::ranges::sort(gone, [](const Image& a, const Image& b) { return a.ref.point > b.ref.point; });
  for (const Image& image : gone) {
    auto& points = drawing[image.ref.curve].points;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(image.ref.point));
  }
  std::erase_if(drawing, [](const DrawnCurve& curve) { return curve.points.size() < 3; });
}

PointRef addPoint(Drawing& drawing, PointRef ref, SectionPoint at, const Symmetry& symmetry) {
  if (!exists(drawing, ref)) return ref;
  const auto endsOf = [&](PointRef r) {
    const auto& points = drawing[r.curve].points;
    return std::pair{points[r.point].at, points[(r.point + 1) % points.size()].at};
  };
  const auto [from, to] = endsOf(ref);
  const std::vector<Motion> motions = groupOf(symmetry).motions();
  // A stretch that lies across a mirror is its own image: its one new point stays on the mirror.
  SectionPoint sum;
  double count = 0;
  for (const Motion& motion : motions) {
    const SectionPoint a = motion(from), b = motion(to);
    if ((same(a, from) && same(b, to)) || (same(a, to) && same(b, from))) {
      sum += motion(at);
      ++count;
    }
  }
  const SectionPoint held = sum / count;
  std::vector<Image> fresh{{ref, motions.front()}};
  for (std::size_t m = 1; m < motions.size(); ++m) {
    const SectionPoint a = motions[m](from), b = motions[m](to);
    for (std::size_t c = 0; c < drawing.size(); ++c) {
      for (std::size_t i = 0; i < drawing[c].points.size(); ++i) {
        const auto [p, q] = endsOf({c, i});
        if (!(same(p, a) && same(q, b)) && !(same(p, b) && same(q, a))) continue;
        const PointRef stretch{c, i};
        if (std::ranges::none_of(fresh, [&](const Image& f) { return f.ref == stretch; })) {
          fresh.push_back({stretch, motions[m]});
        }
      }
    }
  }
  PointRef own{ref.curve, ref.point + 1};
  for (const Image& image : fresh) {
    if (image.ref.curve == ref.curve && image.ref.point < ref.point) ++own.point;
  }
  std::ranges::sort(fresh, [](const Image& a, const Image& b) { return a.ref.point > b.ref.point; });
  for (const Image& image : fresh) {
    auto& points = drawing[image.ref.curve].points;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(image.ref.point) + 1, {image.motion(held), false});
  }
  return own;
}

}  // namespace spineloft::sections
