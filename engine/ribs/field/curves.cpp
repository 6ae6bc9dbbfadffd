#include "engine/ribs/field/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/lanes.h"
#include "engine/base/shared_loop.h"

namespace spineloft::ribs {
namespace {

using Point = PicturePoint;

// Error of one step that is accepted, picture pixels.
constexpr double kStepTolerance = 0.02;
// Steps a curve may take, rejected ones included.
constexpr int kMaxSteps = 96;
// A level set further than this many times its ρ away means a saddle of d2 is near: stop there.
constexpr double kMaxStretch = 12;

// dρ-derivative of Σ I along a curve: Σ I = 2 atan(A / 2ρ) / ρ.
struct RadiusLaw {
  double length;
  struct At {
    double value, slope;
  };
  // As near as the field's own sums: an exact arctangent takes longer than all else of a law.
  At at(double radius) const {
    const double q = length / (2 * radius), angle = quickArctan(q);
    return {2 * angle / radius, -2 * (angle + q / (1 + q * q)) / (radius * radius)};
  }
  // The ρ of a level set. π/ρ − 4/A is below Σ I, which is convex: Newton's steps from there only go outwards.
  double radiusOf(double value) const {
    double radius = std::numbers::pi / (value + 4 / length);
    for (int i = 0; i < 12; ++i) {
      const At here = at(radius);
      const double step = (value - here.value) / here.slope;
      radius += step;
      if (std::abs(step) < 1e-7 * radius) break;
    }
    return radius;
  }
};

// The flow x' = (dI/dρ) ∇I / |∇I|² of one field.
struct Flow {
  const D2Field& field;
  RadiusLaw law;
  Point velocity(Point x, RadiusLaw::At wanted) const { return velocity(field.quickIntegral(x), wanted); }
  Point velocity(const D2Integral& at, RadiusLaw::At wanted) const {
    const Point g{static_cast<double>(at.gradientX), static_cast<double>(at.gradientY)};
    const double g2 = dot(g, g);
    return g2 > 0 ? g * (wanted.slope / g2) : Point{};
  }
  // One Newton step along the gradient onto the wanted level set.
  Point onto(Point x, const D2Integral& at, RadiusLaw::At wanted) const {
    const Point g{static_cast<double>(at.gradientX), static_cast<double>(at.gradientY)};
    const double g2 = dot(g, g);
    return g2 > 0 ? x + g * ((wanted.value - static_cast<double>(at.value)) / g2) : x;
  }
};

struct Step {
  Point to;
  std::array<Point, 7> k;
  double error = 0;  // picture pixels
};

// One Dormand–Prince 5(4) step; k[0] is the velocity at x.
Step advance(const Flow& flow, Point x, Point k0, double t, double h) {
  Step s;
  auto& k = s.k;
  const RadiusLaw& law = flow.law;
  const RadiusLaw::At wanted = law.at(t + h);
  k[0] = k0;
  k[1] = flow.velocity(x + k[0] * (h / 5), law.at(t + h / 5));
  k[2] = flow.velocity(x + (k[0] * (3. / 40) + k[1] * (9. / 40)) * h, law.at(t + h * 0.3));
  k[3] = flow.velocity(x + (k[0] * (44. / 45) + k[1] * (-56. / 15) + k[2] * (32. / 9)) * h, law.at(t + h * 0.8));
  k[4] = flow.velocity(
      x + (k[0] * (19372. / 6561) + k[1] * (-25360. / 2187) + k[2] * (64448. / 6561) + k[3] * (-212. / 729)) * h,
      law.at(t + h * (8. / 9)));
  k[5] = flow.velocity(x + (k[0] * (9017. / 3168) + k[1] * (-355. / 33) + k[2] * (46732. / 5247) + k[3] * (49. / 176) +
                            k[4] * (-5103. / 18656)) *
                               h,
                       wanted);
  s.to = x + (k[0] * (35. / 384) + k[2] * (500. / 1113) + k[3] * (125. / 192) + k[4] * (-2187. / 6784) +
              k[5] * (11. / 84)) *
                 h;
  const D2Integral end = flow.field.quickIntegral(s.to);
  k[6] = flow.velocity(end, wanted);
  const Point error = (k[0] * (71. / 57600) + k[2] * (-71. / 16695) + k[3] * (71. / 1920) + k[4] * (-17253. / 339200) +
                       k[5] * (22. / 525) + k[6] * (-1. / 40)) *
                      h;
  s.error = norm(error);
  s.to = flow.onto(s.to, end, wanted);
  return s;
}

// Cubic Hermite between the ends of a step: of fourth order, ample between labels.
Point between(Point x, const Step& s, double h, double share) {
  const double u = share, u2 = u * u, u3 = u2 * u;
  return x * (2 * u3 - 3 * u2 + 1) + s.k[0] * (h * (u3 - 2 * u2 + u)) + s.to * (3 * u2 - 2 * u3) +
         s.k[6] * (h * (u3 - u2));
}

bool inFrame(Point p, image::Size picture) {
  return p.x >= -0.5 && p.y >= -0.5 && p.x <= picture.width - 0.5 && p.y <= picture.height - 0.5;
}

// Where a curve's points go, and what counts its steps.
struct CurveOut {
  float *x, *y;
  std::size_t* steps;
};

// One curve: from `seeds[0]` on the spine through `seeds[1]` outwards. Writes points, returns their number.
int traceOne(const Flow& flow, const Levels& levels, image::Size picture, const std::array<Point, 2>& seeds,
             const CurveOut& out) {
  const auto [base, seed] = seeds;
  const int count = static_cast<int>(levels.size());
  const auto put = [&](int k, Point p) {
    out.x[k] = static_cast<float>(p.x);
    out.y[k] = static_cast<float>(p.y);
  };
  put(0, base);
  int k = 1;
  const D2Integral start = flow.field.quickIntegral(seed);
  double t = flow.law.radiusOf(static_cast<double>(start.value));
  for (; k < count && levels.radius[static_cast<std::size_t>(k)] <= t; ++k) {
    const Point p = lerp(base, seed, levels.radius[static_cast<std::size_t>(k)] / t);
    if (!inFrame(p, picture)) return k;
    put(k, p);
  }
  Point x = seed, slope = flow.velocity(start, flow.law.at(t));
  double h = t;
  for (int step = 0; step < kMaxSteps && k < count; ++step) {
    h = std::min(h, levels.radius.back() - t);
    ++*out.steps;
    const Step s = advance(flow, x, slope, t, h);
    const double ratio = s.error / kStepTolerance;
    const float root = quickExp(-0.2f * quickLog(static_cast<float>(std::max(ratio, 1e-8))));
    const double scale = std::clamp(0.9 * static_cast<double>(root), 0.2, 4.0);
    if (!(ratio <= 1) && h > 1e-3 * t) {
      h *= std::isfinite(scale) ? scale : 0.2;
      continue;
    }
    for (; k < count && levels.radius[static_cast<std::size_t>(k)] <= t + h * (1 + 1e-12); ++k) {
      const Point p = between(x, s, h, (levels.radius[static_cast<std::size_t>(k)] - t) / h);
      if (!inFrame(p, picture)) return k;
      put(k, p);
    }
    if (norm(s.k[6]) > kMaxStretch) return k;
    x = s.to;
    slope = s.k[6];
    t += h;
    h *= scale;
  }
  return k;
}

// Unit normal to the left of the drawing direction as seen on the screen (y down).
Point leftNormal(const std::vector<Point>& p, std::size_t i) {
  const std::size_t n = p.size();
  const Point before = i > 0 ? normalized(p[i] - p[i - 1]) : normalized(p[1] - p[0]);
  const Point after = i + 1 < n ? normalized(p[i + 1] - p[i]) : before;
  Point t = normalized(before + after);
  if (t == Point{}) t = before;
  return {t.y, -t.x};
}

void placeSeeds(const Spine& spine, GradientCurves& curves) {
  const CurveLayout& layout = curves.layout;
  const auto& p = spine.points;
  double spacing = distance(p[0], p[1]);
  for (std::size_t i = 1; i + 1 < p.size(); ++i) spacing = std::min(spacing, distance(p[i], p[i + 1]));
  const double offset = 0.5 * spacing;
  auto& seeds = curves.seeds;
  seeds.resize(static_cast<std::size_t>(layout.total()));
  for (int i = 0; i < layout.ribs; ++i) {
    const auto s = static_cast<std::size_t>(i);
    const Point n = leftNormal(p, s) * offset;
    seeds[static_cast<std::size_t>(layout.left(i))] = {p[s], p[s] + n};
    seeds[static_cast<std::size_t>(layout.right(i))] = {p[s], p[s] - n};
  }
  // Around an end: from the left normal over the outward direction to the right normal.
  const Point startLeft = leftNormal(p, 0), endLeft = leftNormal(p, p.size() - 1);
  for (int i = 0; i < layout.fan; ++i) {
    const double angle = std::numbers::pi * (i + 1) / (layout.fan + 1);
    const auto turned = [angle](Point n, Point out) { return n * std::cos(angle) + out * std::sin(angle); };
    const Point endOut{-endLeft.y, endLeft.x}, startOut{startLeft.y, -startLeft.x};
    seeds[static_cast<std::size_t>(layout.endFan(i))] = {p.back(), p.back() + turned(endLeft, endOut) * offset};
    seeds[static_cast<std::size_t>(layout.startFan(i))] = {p.front(), p.front() + turned(startLeft, startOut) * offset};
  }
}

void allocate(const Spine& spine, const Levels& levels, int fan, GradientCurves& curves) {
  curves.layout = {static_cast<int>(spine.points.size()), fan};
  curves.levels = static_cast<int>(levels.size());
  const std::size_t total = static_cast<std::size_t>(curves.layout.total());
  for (auto* plane : {&curves.x, &curves.y, &curves.along}) plane->resize(total * levels.size());
  curves.reached.resize(total);
}

// Returns how many steps were taken.
std::size_t traceSome(const Flow& flow, const Levels& levels, image::Size picture, LoopShare of,
                      GradientCurves& curves) {
  std::size_t steps = 0;
  for (auto c = static_cast<std::size_t>(of.first); c < static_cast<std::size_t>(of.end); ++c) {
    float* x = &curves.x[c * levels.size()];
    float* y = &curves.y[c * levels.size()];
    float* along = &curves.along[c * levels.size()];
    curves.reached[c] = traceOne(flow, levels, picture, curves.seeds[c], {x, y, &steps});
    along[0] = 0;
    for (int k = 1; k < curves.reached[c]; ++k) {
      const float dx = x[k] - x[k - 1], dy = y[k] - y[k - 1];
      along[k] = along[k - 1] + std::sqrt(dx * dx + dy * dy);
    }
  }
  return steps;
}

}  // namespace

Levels makeLevels(int count, double step, double farthest, double length) {
  Levels levels;
  makeLevels(count, step, farthest, length, levels);
  return levels;
}

void makeLevels(int count, double step, double farthest, double length, Levels& levels) {
  const double last = static_cast<double>(count - 1);
  // Solves sinh(r · last) / r = farthest / step for r; even spacing where no widening is needed.
  double rate = 0;
  if (step * last < farthest) {
    double low = 0, high = 8;
    for (int i = 0; i < 60; ++i) {
      rate = 0.5 * (low + high);
      const double reach = rate * last < 1e-9 ? last : std::sinh(std::min(rate * last, 600.0)) / rate;
      (reach < farthest / step ? low : high) = rate;
    }
  }
  levels.radius.resize(static_cast<std::size_t>(count));
  levels.d2.resize(static_cast<std::size_t>(count));
  levels.radius[0] = levels.d2[0] = 0;
  for (std::size_t k = 1; k < levels.size(); ++k) {
    const double share = static_cast<double>(k);
    levels.radius[k] = rate > 0 ? step * std::sinh(rate * share) / rate : farthest * share / last;
    levels.d2[k] = d2OfRadius(levels.radius[k], length);
  }
}

void traceCurves(const Spine& spine, const D2Field& field, const Levels& levels, int fan, image::Size picture,
                 GradientCurves& curves) {
  allocate(spine, levels, fan, curves);
  placeSeeds(spine, curves);
  const Flow flow{field, {field.length()}};
  std::array<std::size_t, 2> steps{};
  sharedLoop(curves.layout.total(), [&](LoopShare of) {
    steps[static_cast<std::size_t>(of.who)] += traceSome(flow, levels, picture, of, curves);
  });
  curves.steps = steps[0] + steps[1];
}

PicturePoint GradientCurves::pointAlong(int curve, double length) const {
  const int last = reached[static_cast<std::size_t>(curve)] - 1;
  if (last < 1) return point(curve, 0);
  const float* arcs = &along[at(curve, 0)];
  const auto beyond = std::upper_bound(arcs + 1, arcs + last, static_cast<float>(length));
  int k = static_cast<int>(beyond - arcs) - 1;
  return pointAlong(curve, length, k);
}

}  // namespace spineloft::ribs
