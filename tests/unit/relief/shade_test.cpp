// Heights from shading: of rendered surfaces what is finer than the coarse shape comes back.
#include "engine/relief/shade.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/rng.h"
#include "engine/base/vec.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::relief;

namespace {

constexpr double kRadius = 0.92;  // of the dome, in half sizes

using Surface = std::function<double(double x, double y)>;  // in half sizes, towards the viewer

double dome(double x, double y) { return 0.55 * std::sqrt(std::max(0.0, kRadius * kRadius - x * x - y * y)); }

Surface bumps(Rng& rng) {
  struct Bump {
    double x, y, radius, height;
  };
  std::vector<Bump> all;
  while (all.size() < 24) {
    const Bump one{rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8), rng.uniform(0.05, 0.09), rng.uniform(0.02, 0.04)};
    all.push_back(one);
  }
  return [all](double x, double y) {
    double z = 0;
    for (const Bump& b : all)
      z += b.height * std::exp(-((x - b.x) * (x - b.x) + (y - b.y) * (y - b.y)) / (2 * b.radius * b.radius));
    return z;
  };
}

// Rows of round scales, each lying over those of the next row.
Surface scales(Rng& rng) {
  const double size = rng.uniform(0.2, 0.26), shift = rng.uniform(0, 1);
  return [size, shift](double x, double y) {
    const double v = y / size + shift, row = std::floor(v);
    const double u = x / size + shift + (std::fmod(std::abs(row), 2) == 1 ? 0.5 : 0.0);
    const double across = u - std::floor(u) - 0.5, along = v - row;
    return 0.035 * std::cos(std::numbers::pi * across) * std::pow(std::sin(std::numbers::pi * std::pow(along, 1.6)), 2);
  };
}

Surface ring(Rng& rng) {
  const double x0 = rng.uniform(-0.1, 0.1), y0 = rng.uniform(-0.1, 0.1), radius = rng.uniform(0.4, 0.5);
  return [=](double x, double y) {
    const double off = (std::hypot(x - x0, y - y0) - radius) / 0.06;
    return 0.04 * std::exp(-off * off / 2);
  };
}

Surface smoothNoise(Rng& rng) {
  struct Wave {
    double kx, ky, phase;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < 40; ++i) {
    const double k = rng.uniform(12, 30), angle = rng.uniform(0, 2 * std::numbers::pi);
    waves.push_back({k * std::cos(angle), k * std::sin(angle), rng.uniform(0, 2 * std::numbers::pi)});
  }
  return [waves](double x, double y) {
    double z = 0;
    for (const Wave& w : waves) z += std::cos(w.kx * x + w.ky * y + w.phase);
    return 0.0025 * z;
  };
}

Surface flat(Rng&) {
  return [](double, double) { return 0.0; };
}

struct Lamp {
  ModelPoint to;
  double ambient = 0.2, shine = 0, noise = 0;
};
const Lamp kSide{{-0.7, -0.4, 0.6}}, kFront{{0.05, -0.1, 1}}, kShiny{{-0.7, -0.4, 0.6}, 0.2, 0.35, 0.01};

// A picture of a relief on a dome, and what is known of it.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::array<float, 3>> colour;
  std::vector<std::uint8_t> inside;
  std::vector<float> z, truth;  // cells

  Shading shading() const { return {width, height, colour, inside, z}; }
};

using Paint = std::function<std::array<double, 3>(double x, double y)>;

std::array<double, 3> grey(double, double) { return {0.7, 0.7, 0.7}; }

// Lambert, ambient and Phong with the normals of the fine surface; y points down, towards the viewer is z.
Picture rendered(int size, const Surface& relief, const Lamp& lamp, Rng& rng, const Paint& paint = grey) {
  Picture out{size, size, {}, {}, {}, {}};
  const ModelPoint to = normalized(lamp.to);
  const auto fine = [&](double x, double y) { return dome(x, y) + relief(x, y); };
  const double half = size / 2.0, step = 1e-4;
  for (int v = 0; v < size; ++v) {
    for (int u = 0; u < size; ++u) {
      const double x = (u + 0.5) / half - 1, y = (v + 0.5) / half - 1;
      const bool in = std::hypot(x, y) < kRadius;
      const ModelPoint n = normalized(ModelPoint{(fine(x - step, y) - fine(x + step, y)) / (2 * step),
                                                 (fine(x, y - step) - fine(x, y + step)) / (2 * step), 1});
      const double facing = std::max(0.0, dot(n, to));
      const double mirrored = std::max(0.0, 2 * facing * n.z - to.z);  // to the viewer, (0, 0, 1)
      const double lit = lamp.ambient + (1 - lamp.ambient) * facing;
      const double shine = facing > 0 ? lamp.shine * std::pow(mirrored, 20) : 0.0;
      std::array<float, 3> shown{};
      const std::array<double, 3> albedo = paint(x, y);
      for (std::size_t k = 0; k < 3; ++k) {
        const double noise =
            std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * std::numbers::pi * rng.uniform());
        shown[k] = static_cast<float>(std::clamp(albedo[k] * lit + shine + lamp.noise * noise, 0.0, 1.0));
      }
      out.colour.push_back(shown);
      out.inside.push_back(in);
      out.z.push_back(static_cast<float>(in ? half * dome(x, y) : 0));
      out.truth.push_back(static_cast<float>(in ? half * relief(x, y) : 0));
    }
  }
  return out;
}

// Of what is finer than 6 cells of 96, away from the rim.
std::pair<std::vector<double>, std::vector<double>> highPassed(const Picture& picture,
                                                               const std::vector<float>& height) {
  const double sigma = 6.0 * picture.width / 96;
  const int reach = static_cast<int>(3 * sigma);
  std::vector<double> kernel;
  for (int k = -reach; k <= reach; ++k) kernel.push_back(std::exp(-k * k / (2 * sigma * sigma)));
  const auto blurred = [&](std::vector<double> values) {
    for (const bool down : {false, true}) {
      std::vector<double> next(values.size(), 0.0);
      for (int v = 0; v < picture.height; ++v) {
        for (int u = 0; u < picture.width; ++u) {
          for (int k = -reach; k <= reach; ++k) {
            const int x = down ? u : u + k, y = down ? v + k : v;
            if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
            next[static_cast<std::size_t>(v * picture.width + u)] +=
                kernel[static_cast<std::size_t>(k + reach)] * values[static_cast<std::size_t>(y * picture.width + x)];
          }
        }
      }
      values = next;
    }
    return values;
  };
  const std::vector<double> share = blurred({picture.inside.begin(), picture.inside.end()});
  std::pair<std::vector<double>, std::vector<double>> out;
  for (const bool truth : {false, true}) {
    std::vector<double> values;
    for (std::size_t i = 0; i < share.size(); ++i)
      values.push_back(picture.inside[i] ? (truth ? picture.truth : height)[i] : 0.0);
    const std::vector<double> low = blurred(values);
    for (int v = 0; v < picture.height; ++v) {
      for (int u = 0; u < picture.width; ++u) {
        const auto i = static_cast<std::size_t>(v * picture.width + u);
        const double x = (2 * u + 1.0) / picture.width - 1, y = (2 * v + 1.0) / picture.height - 1;
        if (std::hypot(x, y) < kRadius - 0.08)
          (truth ? out.second : out.first).push_back(values[i] - low[i] / share[i]);
      }
    }
  }
  return out;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ma += a[i] / static_cast<double>(a.size());
    mb += b[i] / static_cast<double>(a.size());
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
    ab += (a[i] - ma) * (b[i] - mb);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

double likeness(const Picture& picture, const std::vector<float>& height) {
  const auto [found, truth] = highPassed(picture, height);
  return correlation(found, truth);
}

constexpr std::array<Surface (*)(Rng&), 4> kReliefs{bumps, scales, ring, smoothNoise};

Picture pictureOf(std::size_t relief, std::uint64_t seed, const Lamp& lamp, int size = 96, const Paint& paint = grey) {
  Rng rng(seed);
  const Surface surface = kReliefs[relief](rng);
  return rendered(size, surface, lamp, rng, paint);
}

std::array<double, 3> striped(double x, double y) {
  return std::abs(0.8 * x + 0.6 * y) < 0.2 ? std::array{0.7, 0.25, 0.2} : std::array{0.7, 0.7, 0.65};
}

// Each cell the mean of 2 × 2: mixed colours at edges, as in a photo.
Picture halved(const Picture& fine) {
  Picture out{fine.width / 2, fine.height / 2, {}, {}, {}, {}};
  for (int v = 0; v < out.height; ++v) {
    for (int u = 0; u < out.width; ++u) {
      std::array<float, 3> colour{};
      float z = 0, truth = 0;
      bool in = true;
      for (int k = 0; k < 4; ++k) {
        const auto i = static_cast<std::size_t>((2 * v + k / 2) * fine.width + 2 * u + k % 2);
        for (std::size_t c = 0; c < 3; ++c) colour[c] += fine.colour[i][c] / 4;
        z += fine.z[i] / 8;
        truth += fine.truth[i] / 8;
        in = in && fine.inside[i];
      }
      out.colour.push_back(colour);
      out.inside.push_back(in);
      out.z.push_back(z);
      out.truth.push_back(truth);
    }
  }
  return out;
}

// Dark pen strokes on a white disc: its outline, and arcs within.
Picture drawing(std::uint64_t seed) {
  Rng rng(seed);
  Picture out = rendered(96, flat(rng), kSide, rng);
  std::ranges::fill(out.colour, std::array{0.95f, 0.95f, 0.95f});
  struct Stroke {
    double x, y, radius, from, to;
  };
  const double width = rng.uniform(0.02, 0.04);
  std::vector<Stroke> strokes{{0, 0, kRadius - width, -4, 4}};
  for (int k = 0; k < 12; ++k) {
    const double from = rng.uniform(-3, 2);
    strokes.push_back({rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), rng.uniform(0.1, 0.6), from, from + 1});
  }
  for (int v = 0; v < 96; ++v) {
    for (int u = 0; u < 96; ++u) {
      const double x = (u + 0.5) / 48 - 1, y = (v + 0.5) / 48 - 1;
      for (const Stroke& s : strokes) {
        const double angle = std::atan2(y - s.y, x - s.x);
        if (std::abs(std::hypot(x - s.x, y - s.y) - s.radius) < width && angle > s.from && angle < s.to)
          out.colour[static_cast<std::size_t>(v * 96 + u)] = {0.05f, 0.05f, 0.08f};
      }
    }
  }
  return out;
}

// Left and right swapped.
template <typename Value>
std::vector<Value> mirrored(std::vector<Value> values, int width) {
  for (auto row = values.begin(); row != values.end(); row += width) std::reverse(row, row + width);
  return values;
}

double largest(const std::vector<float>& height) {
  double most = 0;
  for (const float h : height) most = std::max(most, static_cast<double>(std::abs(h)));
  return most;
}

bool allFinite(const Shaded& shaded) {
  return std::isfinite(shaded.explained) &&
         std::ranges::all_of(shaded.height, [](float h) { return std::isfinite(h); });
}

}  // namespace

TEST_SUITE_BEGIN("unit/relief/shade");

TEST_CASE("reliefs on a dome come back from the side, from the front, and with shine and noise") {
  double sum = 0;
  int count = 0;
  for (const Lamp& lamp : {kSide, kFront, kShiny}) {
    CAPTURE(lamp.to.x);
    CAPTURE(lamp.shine);
    for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
      CAPTURE(relief);
      const Picture picture = pictureOf(relief, 101 + relief, lamp);
      const Shaded shaded = shade(picture.shading());
      const double alike = likeness(picture, shaded.height);
      CAPTURE(shaded.explained);
      CHECK(alike >= 0.7);
      CHECK(shaded.explained > 0.4);
      sum += alike;
      ++count;
    }
  }
  CHECK(sum / count >= 0.85);
}

TEST_CASE("paint is not taken for relief, whether its edges are hard or soft") {
  const Paint quarters = [](double x, double y) {
    if (x > 0) return y > 0 ? std::array{0.7, 0.2, 0.2} : std::array{0.2, 0.6, 0.2};
    return y > 0 ? std::array{0.8, 0.8, 0.8} : std::array{0.2, 0.3, 0.7};
  };
  const Paint passing = [](double x, double y) { return std::array{0.7, 0.5 + 0.2 * x, 0.5 - 0.2 * x + 0.1 * y}; };
  for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
    CAPTURE(relief);
    for (const Paint& paint : {Paint(striped), quarters, passing}) {
      const Picture picture = pictureOf(relief, 111 + relief, kSide, 96, paint);
      CHECK(likeness(picture, shade(picture.shading()).height) >= 0.8);
    }
    const Picture soft = halved(pictureOf(relief, 111 + relief, kSide, 192, striped));
    CHECK(likeness(soft, shade(soft.shading()).height) >= 0.8);
  }
}

TEST_CASE("what rises stays what rises with the light from the right, from below and from above") {
  for (const ModelPoint to : {ModelPoint{0.7, 0.3, 0.6}, {0.1, 0.8, 0.5}, {0, -0.8, 0.5}}) {
    CAPTURE(to.x);
    CAPTURE(to.y);
    for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
      const Picture picture = pictureOf(relief, 121 + relief, {to});
      CHECK(likeness(picture, shade(picture.shading()).height) > 0.75);
    }
  }
}

TEST_CASE("a coarse shape that is not known, or only roughly, does") {
  for (const Lamp& lamp : {kSide, kFront}) {
    for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
      CAPTURE(relief);
      Picture picture = pictureOf(relief, 131 + relief, lamp);
      for (float& z : picture.z) z *= 0.6f;
      CHECK(likeness(picture, shade(picture.shading()).height) > 0.7);
      picture.z.clear();
      CHECK(likeness(picture, shade(picture.shading()).height) > 0.7);
    }
  }
}

TEST_CASE("a plain dome has no relief, and one of a single grey neither relief nor light") {
  Rng rng(141);
  const double relief = largest(shade(pictureOf(0, 141, kSide).shading()).height);
  for (const Lamp& lamp : {kSide, kFront}) {
    const Picture plain = rendered(96, flat(rng), lamp, rng);
    const Shaded shaded = shade(plain.shading());
    CHECK(largest(shaded.height) < 0.1 * relief);
    CHECK(shaded.explained > 0.95);
  }
  Picture same = rendered(96, flat(rng), kSide, rng);
  for (const float level : {0.0f, 0.5f, 1.0f}) {
    std::ranges::fill(same.colour, std::array{level, level, level});
    const Shaded shaded = shade(same.shading());
    CHECK(largest(shaded.height) < 0.01 * relief);
    CHECK(shaded.explained == 0);
  }
}

TEST_CASE("a line drawing is not explained by light") {
  for (std::uint64_t seed = 151; seed < 159; ++seed) {
    CAPTURE(seed);
    Picture picture = drawing(seed);
    CHECK(shade(picture.shading()).explained < 0.1);
    picture.z.clear();
    CHECK(shade(picture.shading()).explained < 0.1);
  }
}

TEST_CASE("half as bright is the same relief") {
  for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
    Picture picture = pictureOf(relief, 161 + relief, kShiny, 64, striped);
    const Shaded whole = shade(picture.shading());
    for (auto& colour : picture.colour)
      for (float& c : colour) c *= 0.5f;
    const Shaded half = shade(picture.shading());
    CHECK(correlation({whole.height.begin(), whole.height.end()}, {half.height.begin(), half.height.end()}) >= 0.999);
    CHECK(half.explained == doctest::Approx(whole.explained).epsilon(0.001));
  }
}

TEST_CASE("a mirrored picture is a mirrored relief") {
  for (std::size_t relief = 0; relief < kReliefs.size(); ++relief) {
    CAPTURE(relief);
    for (const bool known : {true, false}) {
      CAPTURE(known);
      Picture picture = pictureOf(relief, 171 + relief, kSide, 64, striped);
      if (!known) picture.z.clear();
      const std::vector<float> straight = mirrored(shade(picture.shading()).height, 64);
      picture.colour = mirrored(picture.colour, 64);
      picture.inside = mirrored(picture.inside, 64);
      if (known) picture.z = mirrored(picture.z, 64);
      const std::vector<float> other = shade(picture.shading()).height;
      double off = 0;
      for (std::size_t i = 0; i < other.size(); ++i)
        off = std::max(off, static_cast<double>(std::abs(straight[i] - other[i])));
      const auto [low, high] = std::ranges::minmax(straight);
      CHECK(off < 1e-3 * (high - low));
    }
  }
}

TEST_CASE("a finer picture is the same relief in more cells") {
  const Picture coarse = pictureOf(0, 181, kSide, 64), fine = pictureOf(0, 181, kSide, 128);
  const auto most = [](const Picture& picture) { return largest(shade(picture.shading()).height); };
  CHECK(most(fine) == doctest::Approx(2 * most(coarse)).epsilon(0.15));
  CHECK(likeness(fine, shade(fine.shading()).height) > 0.8);
}

TEST_CASE("the rim and what is outside stay where they are, and of the outside nothing is read") {
  Picture picture = pictureOf(3, 191, kSide);
  const Shaded before = shade(picture.shading());
  for (std::size_t i = 0; i < picture.inside.size(); ++i) {
    if (picture.inside[i]) continue;
    CHECK(before.height[i] == 0);
    picture.colour[i] = {std::nanf(""), 1e30f, -1.0f};
    picture.z[i] = std::nanf("");
  }
  CHECK(shade(picture.shading()).height == before.height);
  for (int u = 1; u + 1 < picture.width; ++u) {
    for (int v = 1; v + 1 < picture.height; ++v) {
      const auto i = static_cast<std::size_t>(v * picture.width + u);
      if (picture.inside[i] && !(picture.inside[i - 1] && picture.inside[i + 1])) CHECK(before.height[i] == 0);
    }
  }
}

TEST_CASE("steps are many, may outlive what they were given, and end as all at once") {
  Picture picture = pictureOf(1, 201, kSide, 64);
  const Shaded once = shade(picture.shading());
  ShadeSteps steps(picture.shading());
  picture = {};
  int count = 1;
  while (steps.step()) ++count;
  CHECK(count > 20);
  CHECK(!steps.step());
  const Shaded shaded = steps.take();
  CHECK(shaded.height == once.height);
  CHECK(shaded.explained == once.explained);
}

TEST_CASE("nothing, noise and shapes without an inside give finite heights") {
  Rng rng(211);
  for (int round = 0; round < testing::rounds(40); ++round) {
    CAPTURE(round);
    Picture picture{static_cast<int>(2 + rng.below(40)), static_cast<int>(2 + rng.below(40)), {}, {}, {}, {}};
    const auto cells = static_cast<std::size_t>(picture.width * picture.height);
    const double filled = rng.below(4) / 3.0, rough = rng.below(2) == 0 ? 0.5 : 1e6;
    const bool known = rng.below(2) == 0, blackOrFull = rng.below(2) == 0;
    for (std::size_t i = 0; i < cells; ++i) {
      picture.inside.push_back(rng.uniform() < filled);
      picture.colour.push_back({});
      for (float& c : picture.colour.back())
        c = blackOrFull ? static_cast<float>(rng.below(2)) : static_cast<float>(rng.uniform());
      if (known) picture.z.push_back(static_cast<float>(rng.uniform(-rough, rough)));
    }
    const Shaded shaded = shade(picture.shading());
    REQUIRE(shaded.height.size() == cells);
    CHECK(allFinite(shaded));
    CHECK(shaded.explained >= 0);
    CHECK(shaded.explained <= 1);
    CHECK(largest(shaded.height) < 40);
    if (filled == 0) CHECK(largest(shaded.height) == 0);
  }
}

TEST_CASE("a size or spans that cannot be give no heights") {
  const Picture picture = pictureOf(0, 221, kSide, 16);
  Shading wrong = picture.shading();
  wrong.colour = wrong.colour.first(10);
  CHECK(largest(shade(wrong).height) == 0);
  wrong = picture.shading();
  wrong.width = 0;
  CHECK(shade(wrong).height.empty());
  wrong.width = 1000;
  CHECK(shade(wrong).height.empty());
}

TEST_SUITE_END();
