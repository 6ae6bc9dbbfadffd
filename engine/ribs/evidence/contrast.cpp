// Contrast across the level sets that goes on along them.
#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/ribs/evidence/evidence.h"

namespace spineloft::ribs {
namespace {

using Lab = std::array<float, 4>;

constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Lab difference over ± reach of arc length at every level of one curve; 0 where not reached, and
// where the stretch touches what is ignored. `out` has one entry more than there are levels: 0 too.
void differences(const GradientCurves& curves, const UnwrappedImage& strip, float reach, int curve, Lab* out) {
  const int reached = curves.reached[index(curve)];
  const std::size_t row = curves.at(curve, 0);
  const float* along = &curves.along[row];
  const Lab* lab = &strip.lab[row];
  out[0] = {};
  std::fill(out + reached, out + strip.levels + 1, Lab{});
  int low = 0, high = 0, lastIgnored = -1;
  for (int k = 1; k < reached; ++k) {
    while (low < k - 1 && along[low] < along[k] - reach) ++low;
    const int before = std::max(high, k - 1);
    high = std::max(high, k);
    while (high < reached - 1 && along[high] < along[k] + reach) ++high;
    if (!strip.ignored.empty()) {
      for (int q = before; q <= high; ++q) {
        if (strip.isIgnored(row + index(q))) lastIgnored = q;
      }
    }
    const Float4 change = load4(lab[high].data()) - load4(lab[low].data());
    store4(lastIgnored >= low ? all4(0) : change, out[k].data());
  }
}

// The slants of the contour that are tried: so many to either side, and none.
constexpr std::size_t kSteep = 2, kSlanted = 2 * kSteep, kSlants = kSlanted + 1;

// Which levels of a neighbouring curve lie on a contour of each slant through the levels of a curve;
// where that one has none, an entry that is 0. [slant][level]: one way and the other, the gentlest first. On
// the contour without a slant it is the same level.
struct Contours {
  const float *x, *y, *step;     // points of the curve, and the distance to the one before
  const float *otherX, *otherY;  // points of the neighbour
  int reached, otherReached, levels;
  float slant;  // rise of the first slant towards the neighbour
};
void follow(const Contours& c, std::vector<float>& rises, std::int32_t* out) {
  const auto levels = index(c.levels);
  const int both = std::min(c.reached, c.otherReached);
  const auto none = static_cast<std::int32_t>(c.levels);
  rises.resize(levels);
  float* __restrict rise = rises.data();
  for (int k = 0; k < both; ++k) {
    const float dx = c.otherX[k] - c.x[k], dy = c.otherY[k] - c.y[k];
    rise[k] = c.slant * std::sqrt(dx * dx + dy * dy) / c.step[k];
  }
  for (std::size_t s = 0; s < kSteep; ++s) {
    std::int32_t* __restrict down = out + 2 * s * levels;
    std::int32_t* __restrict up = down + levels;
    const auto steps = static_cast<float>(s + 1);
    for (int k = 0; k < both; ++k) {
      const float moved = rise[k] * steps;
      const auto shift = static_cast<std::int32_t>(moved + (moved < 0 ? -0.5f : 0.5f));
      const std::int32_t low = k - shift, high = k + shift;
      down[k] = low < 0 ? 0 : (low > none ? none : low);
      up[k] = high < 0 ? 0 : (high > none ? none : high);
    }
    for (int k = both; k < c.reached; ++k) down[k] = up[k] = none;
  }
}

float squared(Float4 v) {
  const Float4 s = v * v;
  return s[0] + s[1] + s[2];
}

// The largest square of a colour difference among all slants: four of them side by side, and one.
static_assert(kSlants == 5);
float mostSquared(const Float4* sums) {
  const Float4 ab = __builtin_shufflevector(sums[0], sums[1], 0, 4, 1, 5),
               cd = __builtin_shufflevector(sums[2], sums[3], 0, 4, 1, 5),
               abLast = __builtin_shufflevector(sums[0], sums[1], 2, 6, 3, 7),
               cdLast = __builtin_shufflevector(sums[2], sums[3], 2, 6, 3, 7);
  const Float4 l = __builtin_shufflevector(ab, cd, 0, 1, 4, 5), a = __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
               b = __builtin_shufflevector(abLast, cdLast, 0, 1, 4, 5);
  Float4 most = most4(l * l + a * a + b * b, all4(squared(sums[4])));
  most = most4(most, __builtin_shufflevector(most, most, 2, 3, 0, 1));
  return most4(most, __builtin_shufflevector(most, most, 1, 0, 3, 2))[0];
}

}  // namespace

void contourContrast(const GradientCurves& curves, const UnwrappedImage& strip, const ContrastParams& params,
                     EvidenceScratch& scratch, std::vector<float>& contrast) {
  const auto levels = index(strip.levels), stride = levels + 1;
  scratch.differences.resize(index(strip.curves) * stride);
  for (int c = 0; c < strip.curves; ++c) {
    differences(curves, strip, static_cast<float>(params.reach), c, &scratch.differences[index(c) * stride]);
  }
  contrast.resize(curves.x.size());
  std::fill(contrast.begin(), contrast.end(), 0.f);
  // Neighbours on both sides; the curve itself needs no following.
  const int count = 2 * params.neighbours;
  scratch.rows.resize(index(count));
  scratch.shifted.resize(index(count) * kSlanted * levels);
  scratch.sums.resize(levels);
  const float share = 1 / static_cast<float>(count + 1);
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const int reached = curves.reached[index(c)];
    const float* along = &curves.along[row];
    float* steps = scratch.sums.data();
    steps[0] = 1;
    for (int k = 1; k < reached; ++k) {
      const float step = along[k] - along[k - 1];
      steps[k] = step > 1 ? step : 1.f;
    }
    for (int j = 0; j < count; ++j) {
      const bool before = j < params.neighbours;
      const int away = before ? j - params.neighbours : j - params.neighbours + 1;
      const int other = ((c + away) % strip.curves + strip.curves) % strip.curves;
      const std::size_t at = curves.at(other, 0);
      scratch.rows[index(j)] = &scratch.differences[index(other) * stride];
      follow({&curves.x[row], &curves.y[row], steps, &curves.x[at], &curves.y[at], reached,
              curves.reached[index(other)], strip.levels, static_cast<float>(before ? -params.slant : params.slant)},
             scratch.window, &scratch.shifted[index(j) * kSlanted * levels]);
    }
    for (std::size_t k = 1; k < index(reached); ++k) {
      if (strip.isIgnored(row + k)) continue;
      const Float4 own = load4(scratch.differences[index(c) * stride + k].data());
      Float4 sums[kSlants] = {own, own, own, own, own};
      const std::int32_t* at = &scratch.shifted[k];
      for (const Lab* difference : scratch.rows) {
        for (std::size_t s = 0; s < kSlanted; ++s, at += levels) sums[s] += load4(difference[*at].data());
        sums[kSlanted] += load4(difference[k].data());
      }
      contrast[row + k] = std::sqrt(mostSquared(sums)) * share;
    }
  }
}

}  // namespace spineloft::ribs
