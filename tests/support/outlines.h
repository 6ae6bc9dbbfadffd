// Outlines of known shape for tests of regions, in picture pixels.
#pragma once

#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/region.h"

namespace spineloft::testing {

using Outline = std::vector<PicturePoint>;

inline Outline ellipse(PicturePoint centre, double rx, double ry, int points) {
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double a = 6.283185307179586 * i / points;
    outline.push_back({centre.x + rx * std::cos(a), centre.y + ry * std::sin(a)});
  }
  return outline;
}
inline Outline rectangle(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}
/// A closed curve with `lobes` waves of random sizes round a centre; simple.
inline Outline blob(Rng& rng, PicturePoint centre, double radius, int points) {
  double wave[5], phase[5];
  for (int k = 0; k < 5; ++k) {
    wave[k] = rng.uniform(0, 0.12);
    phase[k] = rng.uniform(0, 6.28);
  }
  Outline outline;
  for (int i = 0; i < points; ++i) {
    const double a = 6.283185307179586 * i / points;
    double r = 1;
    for (int k = 0; k < 5; ++k) r += wave[k] * std::sin((k + 2) * a + phase[k]);
    outline.push_back({centre.x + radius * r * std::cos(a), centre.y + radius * r * std::sin(a)});
  }
  return outline;
}

}  // namespace spineloft::testing
