// The fast edge search against its definitions, written down plainly and slowly.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "engine/base/rng.h"
#include "engine/vision/edges.h"
#include "engine/vision/thresholds.h"

using namespace spineloft;
using namespace spineloft::image;

namespace {

std::size_t indexOf(const EdgeMap& map, int x, int y) {
  x = std::clamp(x, 0, map.width - 1), y = std::clamp(y, 0, map.height - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x);
}

/// Soft blobs of random colours on a random ground, with noise, and partly see-through.
Picture blobPicture(int width, int height, std::uint64_t seed, double noise) {
  Rng rng(seed);
  Image image{width, height, {}};
  image.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  struct Blob {
    double x, y, radius;
    std::array<double, 4> colour;
  };
  std::vector<Blob> blobs;
  for (int i = 0; i < 7; ++i) {
    Blob blob{rng.uniform(0, width), rng.uniform(0, height), rng.uniform(3, 0.4 * width), {}};
    for (double& c : blob.colour) c = rng.uniform(0, 255);
    blobs.push_back(blob);
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<double, 4> colour = {120, 150, 90, 255};
      for (const Blob& blob : blobs) {
        const double cover = std::clamp(blob.radius - std::hypot(x - blob.x, y - blob.y) + 0.5, 0.0, 1.0);
        for (std::size_t c = 0; c < 4; ++c) colour[c] += cover * (blob.colour[c] - colour[c]);
      }
      for (std::size_t c = 0; c < 4; ++c) {
        const double value = colour[c] + (c < 3 ? rng.uniform(-noise, noise) : 0);
        image.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) +
                     c] = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
      }
    }
  }
  return makePicture(image);
}

using Lab = std::array<double, 3>;

// Half of the step in which a map holds colours, and nearness.
constexpr double kLabStep = 0.5 / PixelFeature::kLab, kNearStep = 1e-5 + 0.5 / PixelFeature::kNear;

Lab plainLab(const std::uint8_t* pixel) {
  std::array<double, 3> linear{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int onPaper = (pixel[c] * pixel[3] + 255 * (255 - pixel[3]) + 127) / 255;
    const double v = onPaper / 255.0;
    linear[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  const auto f = [&](double r, double g, double b) {
    const double t = r * linear[0] + g * linear[1] + b * linear[2];
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x = f(0.433953, 0.376219, 0.189828), y = f(0.212671, 0.715160, 0.072169),
               z = f(0.017758, 0.109477, 0.872765);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

std::vector<Lab> plainSmooth(const Image& image, const EdgeMap& map, double sigma) {
  std::vector<Lab> raw;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    raw.push_back(plainLab(image.pixels.data() + i));
  }
  if (sigma <= 0) return raw;
  const int radius = static_cast<int>(8 * sigma + 1.5) / 2;
  std::vector<Lab> smooth(raw.size());
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      Lab sum{};
      double weights = 0;
      for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
          const double weight = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
          weights += weight;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * raw[indexOf(map, x + u, y + v)][c];
        }
      }
      for (std::size_t c = 0; c < 3; ++c) smooth[indexOf(map, x, y)][c] = sum[c] / weights;
    }
  }
  return smooth;
}

struct Slopes {
  Lab x{}, y{};
};
Slopes plainSobel(const EdgeMap& map, const std::vector<Lab>& lab, int x, int y) {
  Slopes slopes;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto at = [&](int u, int v) { return lab[indexOf(map, x + u, y + v)][c]; };
    slopes.x[c] = (at(1, -1) - at(-1, -1) + 2 * at(1, 0) - 2 * at(-1, 0) + at(1, 1) - at(-1, 1)) / 8;
    slopes.y[c] = (at(-1, 1) - at(-1, -1) + 2 * at(0, 1) - 2 * at(0, -1) + at(1, 1) - at(1, -1)) / 8;
  }
  return slopes;
}

double dot(const Lab& a, const Lab& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The gradient must be as long as the strongest colour change, lie along it and point where
/// lightness grows, all within `tolerance` Lab units.
void checkGradient(const Slopes& slopes, double x, double y, double tolerance) {
  const double e = dot(slopes.x, slopes.x), f = dot(slopes.x, slopes.y), g = dot(slopes.y, slopes.y);
  const double size = std::sqrt((e + g + std::hypot(e - g, 2 * f)) / 2), length = std::hypot(x, y);
  REQUIRE(std::abs(length - size) <= tolerance);
  if (size < 0.1) return;
  x /= length, y /= length;
  Lab change{};
  for (std::size_t c = 0; c < 3; ++c) change[c] = slopes.x[c] * x + slopes.y[c] * y;
  REQUIRE(std::sqrt(dot(change, change)) >= size - tolerance);
  if (std::abs(change[0]) > 0.1 * size + tolerance) {
    REQUIRE(change[0] > 0);
  } else if (std::abs(change[0]) < 0.1 * size - tolerance) {
    const double most =
        *std::max_element(change.begin(), change.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double opposite = *std::max_element(change.begin(), change.end(), [](double a, double b) { return a < b; });
    // Where two channels change as much in opposite senses, either may lead.
    REQUIRE((most > 0 || std::abs(std::abs(most) - opposite) <= tolerance));
  }
}

/// Canny's thinning on whole steps of 1/128 Lab unit; 0, 1 weak, 2 strong.
std::vector<int> plainCrests(const EdgeMap& map, const vision::Thresholds& thresholds) {
  const auto steps = [&](const std::vector<float>& plane, int x, int y) {
    return static_cast<long long>(std::nearbyint(128.0 * plane[indexOf(map, x, y)]));
  };
  const auto squared = [&](int x, int y) -> long long {
    if (x < 0 || y < 0 || x >= map.width || y >= map.height) return 0;
    const long long gx = steps(map.gradientX, x, y), gy = steps(map.gradientY, x, y);
    return gx * gx + gy * gy;
  };
  std::vector<int> crests(map.gradientX.size());
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const long long here = squared(x, y);
      const double size = std::sqrt(static_cast<double>(here)) / 128;
      if (size <= thresholds.low) continue;
      const double gx = static_cast<double>(steps(map.gradientX, x, y)),
                   gy = static_cast<double>(steps(map.gradientY, x, y));
      const double tan22 = 13573.0 / 32768, tan67 = tan22 + 2;
      bool crest = false;
      if (std::abs(gy) < tan22 * std::abs(gx)) {
        crest = here > squared(x - 1, y) && here >= squared(x + 1, y);
      } else if (std::abs(gy) > tan67 * std::abs(gx)) {
        crest = here > squared(x, y - 1) && here >= squared(x, y + 1);
      } else {
        const int side = (gx < 0) != (gy < 0) ? -1 : 1;
        crest = here > squared(x - side, y - 1) && here > squared(x + side, y + 1);
      }
      if (crest) crests[indexOf(map, x, y)] = size > thresholds.high ? 2 : 1;
    }
  }
  return crests;
}

/// Contours by spreading labels until nothing changes, then those that are strong and no noise.
std::vector<std::uint8_t> plainEdges(const EdgeMap& map) {
  const auto thresholds = vision::chooseThresholds(map.gradientX, map.gradientY);
  const std::vector<int> crests = plainCrests(map, thresholds);
  std::vector<std::size_t> label(crests.size());
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        const std::size_t at = indexOf(map, x, y);
        if (crests[at] == 0) continue;
        for (int k = 0; k < 9; ++k) {
          const std::size_t other = indexOf(map, x + k % 3 - 1, y + k / 3 - 1);
          if (crests[other] == 0 || label[other] >= label[at]) continue;
          label[at] = label[other];
          changed = true;
        }
      }
    }
  }
  std::vector<double> sums(label.size());
  std::vector<int> sizes(label.size()), strong(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (crests[i] == 0) continue;
    sums[label[i]] += std::hypot(map.gradientX[i], map.gradientY[i]);
    ++sizes[label[i]];
    strong[label[i]] += crests[i] == 2;
  }
  std::vector<std::uint8_t> edges(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    const std::size_t l = label[i];
    const bool kept = crests[i] != 0 && strong[l] > 0 && vision::isContour(sums[l], sizes[l], thresholds.noise);
    edges[i] = kept ? 255 : 0;
  }
  return edges;
}

void checkProximity(const EdgeMap& map) {
  std::vector<std::array<int, 2>> edges;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (map.edges[indexOf(map, x, y)] != 0) edges.push_back({x, y});
    }
  }
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      double nearest = 1e9;
      for (const auto& edge : edges) {
        nearest = std::min(nearest, std::hypot(edge[0] - x, edge[1] - y));
      }
      REQUIRE(std::abs(map.nearness(indexOf(map, x, y)) - std::max(0.0, 1 - nearest / map.reach)) <= kNearStep);
    }
  }
}

EdgeMap edgesOf(const Picture& picture, const vision::EdgeParams& params) {
  const auto edges = vision::detectEdges(picture, params, Progress());
  REQUIRE(edges.ok());
  return edges.value();
}

}  // namespace

TEST_CASE("colour and gradient are those of the definition, up to rounding") {
  std::uint64_t seed = 1;
  for (const auto& [width, height] : {std::array{67, 41}, std::array{16, 16}, std::array{33, 90}}) {
    for (const double sigma : {0.0, 0.7, 1.2, 4.9}) {
      CAPTURE(width);
      CAPTURE(sigma);
      const Picture picture = blobPicture(width, height, seed++, 30);
      const EdgeMap map = edgesOf(picture, {1024, sigma, 0.01});
      const std::vector<Lab> lab = plainSmooth(picture.working, map, sigma);
      const double tolerance = (sigma > 0 ? 0.002 : 0.004) + kLabStep;
      for (std::size_t i = 0; i < lab.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          REQUIRE(std::abs(map.look[i][c] - lab[i][c]) <= tolerance);
        }
      }
      for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
          const std::size_t at = indexOf(map, x, y);
          checkGradient(plainSobel(map, lab, x, y), map.gradientX[at], map.gradientY[at], tolerance);
        }
      }
    }
  }
}

TEST_CASE("edges are Canny's with whole contours judged, pixel for pixel") {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double noise = 3.0 * static_cast<double>(seed % 4);
    const EdgeMap map = edgesOf(blobPicture(90, 70, seed, noise), {1024, 1.2, 0.05});
    REQUIRE(map.edges == plainEdges(map));
    found += static_cast<std::size_t>(std::count(map.edges.begin(), map.edges.end(), 255));
  }
  CHECK(found > 12 * 100);
}

TEST_CASE("proximity falls with the true distance to the nearest edge, at short and long reach") {
  for (const auto& [width, share] :
       {std::pair{60, 0.001}, std::pair{90, 0.03}, std::pair{120, 0.1}, std::pair{630, 0.1}, std::pair{660, 0.1}}) {
    CAPTURE(width);
    const EdgeMap map = edgesOf(blobPicture(width, 40, 5, 2), {1024, 1.2, share});
    REQUIRE(std::count(map.edges.begin(), map.edges.end(), 255) > 0);
    checkProximity(map);
  }
}

TEST_CASE("a picture of one colour has no edges and is near to none") {
  Image image{40, 30, std::vector<std::uint8_t>(4 * 40 * 30, 200)};
  const EdgeMap map = edgesOf(makePicture(image), {});
  CHECK(std::count(map.edges.begin(), map.edges.end(), 0) == 40 * 30);
  CHECK(std::ranges::all_of(map.look, [](const auto& look) { return look[3] == 0; }));
}
