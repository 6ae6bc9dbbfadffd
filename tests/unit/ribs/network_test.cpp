#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/base/rng.h"
#include "engine/ribs/learned/likelihood.h"
#include "engine/ribs/search/rib_search.h"
#include "tests/support/test_files.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

float number(Rng& rng) { return static_cast<float>(rng.uniform(-1, 1)); }
int whole(Rng& rng, double least, double most) { return static_cast<int>(std::lround(rng.uniform(least, most))); }

Plane randomPlane(Rng& rng, int rows, int columns, int channels) {
  Plane plane;
  plane.shape(rows, columns, channels);
  plane.unit = 1 / Plane::kMost;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (int c = 0; c < channels; ++c) plane.at(y, x)[c] = static_cast<std::int16_t>(whole(rng, -32767, 32767));
    }
  }
  return plane;
}
double valueAt(const Plane& plane, int row, int column, int channel) {
  return static_cast<double>(plane.at(row, column)[channel]) * static_cast<double>(plane.unit);
}

Convolution randomLayer(Rng& rng, Convolution layer) {
  for (std::size_t i = 0; i < layer.weightCount(); ++i)
    layer.weights.push_back(static_cast<std::int16_t>(whole(rng, -128, 127)));
  for (int i = 0; i < layer.outputs; ++i) {
    layer.scales.push_back(static_cast<float>(rng.uniform(0.001, 0.01)));
    layer.biases.push_back(number(rng));
  }
  return layer;
}

// A convolution as the definition has it, with nothing beyond the plane.
double plainSum(const Convolution& layer, const Plane& in, int row, int column, int output) {
  double sum = 0;
  for (int i = 0; i < layer.side; ++i) {
    for (int j = 0; j < layer.side; ++j) {
      const int y = row * layer.rowStep + (i - layer.side / 2) * layer.apart;
      const int x = column * layer.columnStep + (j - layer.side / 2) * layer.apart;
      if (y < 0 || x < 0 || y >= in.rows || x >= in.columns) continue;
      for (int c = 0; c < in.channels; ++c)
        sum += layer.weights[layer.at(i * layer.side + j, c, output)] * valueAt(in, y, x, c);
    }
  }
  const auto o = static_cast<std::size_t>(output);
  return sum * static_cast<double>(layer.scales[o]) + static_cast<double>(layer.biases[o]);
}

double farthest(const std::vector<float>& a, const std::vector<float>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, static_cast<double>(std::abs(a[i] - b[i])));
  return most;
}

StripChannels randomStrip(Rng& rng, int rows, int levels) {
  StripChannels strip;
  strip.rows = rows;
  strip.levels = levels;
  for (Plane& side : strip.planes) side = randomPlane(rng, rows, levels, kChannels);
  return strip;
}

const RibNetwork& network() {
  REQUIRE(builtInNetwork() != nullptr);
  return *builtInNetwork();
}

// The scores of a dark bar on a light ground.
std::vector<float> scoresOfBar(const std::vector<PicturePoint>& points, CurveLayout& layout) {
  constexpr image::Size kPicture{240, 160};
  const image::EdgeMap map = fixtures::mapOf(
      kPicture, [](PicturePoint p) { return p.x > 30 && p.x < 210 && std::abs(p.y - 80) < 20 + p.x / 20; });
  RibWorkspace memory;
  Search& s = memory.search();
  REQUIRE(beginSearch(Spine{points}, {map, kPicture}, {}, s).ok());
  unwrapImage(s.curves, map, nullptr, s.strip);
  sortColours(s.curves, s.strip, s.boundary.scratch.colours);
  layout = s.curves.layout;
  std::vector<float> scores;
  learnedScores(network(), s.curves, s.strip, s.boundary.scratch, scores);
  return scores;
}

}  // namespace

TEST_SUITE_BEGIN("unit/ribs");

TEST_CASE("a layer is the sum that its definition says, for every shape, step and distance of the taps") {
  Rng rng(1);
  const Convolution shapes[] = {{.side = 3, .inputs = 16, .outputs = 12, .columnStep = 2},
                                {.side = 3, .inputs = 12, .outputs = 24, .rowStep = 2, .columnStep = 2},
                                {.side = 3, .inputs = 8, .outputs = 24, .apart = 4},
                                {.side = 3, .inputs = 6, .outputs = 16, .apart = 2},
                                {.side = 1, .inputs = 72, .outputs = 24},
                                {.side = 1, .inputs = 12, .outputs = 4}};
  for (const Convolution& shape : shapes) {
    const Convolution layer = randomLayer(rng, shape);
    const Planes in{randomPlane(rng, 6, 14, layer.inputs), randomPlane(rng, 6, 14, layer.inputs)};
    Planes added;
    for (Plane& side : added) side = randomPlane(rng, 6 / layer.rowStep, 14 / layer.columnStep, layer.outputs);
    for (const After after : {After::Nothing, After::Rectified, After::AddedAndRectified}) {
      FloatPlanes out;
      convolve(layer, in, after, after == After::AddedAndRectified ? &added : nullptr, out);
      double most = 0;
      for (const std::size_t side : {0u, 1u}) {
        for (int y = 0; y < out[side].rows; ++y) {
          for (int x = 0; x < out[side].columns; ++x) {
            for (int o = 0; o < layer.outputs; ++o) {
              double expected = plainSum(layer, in[side], y, x, o);
              if (after == After::AddedAndRectified) expected += valueAt(added[side], y, x, o);
              if (after != After::Nothing) expected = std::max(0.0, expected);
              most = std::max(most, std::abs(expected - static_cast<double>(out[side].at(y, x)[o])));
            }
          }
        }
      }
      CHECK(most < 1e-4);
    }
  }
}

TEST_CASE("the largest sums that a layer can have do not leave 32 bits") {
  Convolution layer{.side = 3, .inputs = Convolution::kMostTerms / 9 / 2 * 2, .outputs = 4};
  layer.weights.assign(layer.weightCount(), -128);
  layer.scales.assign(4, 1);
  layer.biases.assign(4, 0);
  Planes in;
  for (Plane& side : in) {
    side.shape(3, 4, layer.inputs);
    for (int y = 0; y < 3; ++y) std::fill_n(side.at(y, 0), side.columns * side.channels, std::int16_t{32767});
  }
  FloatPlanes out;
  convolve(layer, in, After::Nothing, nullptr, out);
  const double expected = -128.0 * 32767 * 9 * layer.inputs;
  CHECK(static_cast<double>(out[0].at(1, 1)[0]) == doctest::Approx(expected).epsilon(1e-6));
}

TEST_CASE("results come to 16 bits with one unit for both sides, and are off by half a unit at most") {
  Rng rng(5);
  FloatPlanes from;
  float most = 0;
  for (FloatPlane& side : from) {
    side.shape(3, 5, 4);
    for (float& value : side.values) most = std::max(most, std::abs(value = 40 * number(rng)));
  }
  Planes to;
  toFixed(from, to);
  CHECK(to[0].unit == to[1].unit);
  CHECK(to[0].unit * Plane::kMost == doctest::Approx(most));
  for (const std::size_t side : {0u, 1u}) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 5; ++x) {
        for (int c = 0; c < 4; ++c)
          CHECK(std::abs(valueAt(to[side], y, x, c) - static_cast<double>(from[side].at(y, x)[c])) <
                0.501 * static_cast<double>(to[side].unit));
      }
    }
  }
  for (FloatPlane& side : from) std::ranges::fill(side.values, 0.f);
  toFixed(from, to);
  CHECK(*to[1].at(2, 4) == 0);
}

TEST_CASE("joined sides hold one side, the other, and the mean of both along the columns") {
  Rng rng(2);
  const Planes sides{randomPlane(rng, 5, 3, 2), randomPlane(rng, 5, 3, 2)};
  Planes joined;
  std::vector<std::int32_t> memory;
  joinSides(sides, memory, joined);
  for (const std::size_t side : {0u, 1u}) {
    for (int x = 0; x < 3; ++x) {
      for (int c = 0; c < 2; ++c) {
        double sum = 0;
        for (int y = 0; y < 5; ++y) sum += sides[0].at(y, x)[c] + sides[1].at(y, x)[c];
        for (int y = 0; y < 5; ++y) {
          CHECK(joined[side].at(y, x)[c] == sides[side].at(y, x)[c]);
          CHECK(joined[side].at(y, x)[2 + c] == sides[1 - side].at(y, x)[c]);
          CHECK(std::abs(joined[side].at(y, x)[4 + c] - sum / 10) <= 0.5);
        }
      }
    }
  }
}

TEST_CASE("a coarse plane is added to the two rows and two columns that its values stand for, and rectified") {
  Rng rng(6);
  const Planes fine{randomPlane(rng, 4, 6, 4), randomPlane(rng, 4, 6, 4)};
  FloatPlanes coarse, out;
  for (FloatPlane& side : coarse) {
    side.shape(2, 3, 4);
    for (float& value : side.values) value = number(rng);
  }
  addCoarse(coarse, fine, out);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) {
      for (int c = 0; c < 4; ++c) {
        const double sum = valueAt(fine[1], y, x, c) + static_cast<double>(coarse[1].at(y / 2, x / 2)[c]);
        CHECK(static_cast<double>(out[1].at(y, x)[c]) == doctest::Approx(std::max(0.0, sum)).epsilon(1e-5));
      }
    }
  }
}

TEST_CASE("the network gives the scores that the program which trained it gives") {
  const std::vector<std::uint8_t> file = testing::testFile("golden/ribs-net.fixture");
  std::uint32_t rows = 0, levels = 0;
  std::memcpy(&rows, file.data(), 4);
  std::memcpy(&levels, file.data() + 4, 4);
  StripChannels strip;
  strip.rows = static_cast<int>(rows);
  strip.levels = static_cast<int>(levels);
  const std::size_t cells = std::size_t{rows} * levels, inputs = cells * kChannels;
  REQUIRE(file.size() == 8 + 2 * inputs + 2 * 4 * cells);
  const std::uint8_t* from = file.data() + 8;
  for (Plane& side : strip.planes) {
    side.shape(strip.rows, strip.levels, kChannels);
    side.unit = 1 / Plane::kMost;
    for (int r = 0; r < strip.rows; ++r) {
      for (std::size_t i = 0; i < inputs / rows; ++i)
        side.at(r, 0)[i] =
            static_cast<std::int16_t>(std::lround(Plane::kMost * static_cast<std::int8_t>(*from++) / 127));
    }
  }
  NetworkScratch scratch;
  std::array<std::vector<float>, 2> scores;
  network().run(strip, scratch, scores);
  for (const std::vector<float>& side : scores) {
    std::vector<float> expected(cells);
    std::memcpy(expected.data(), from, 4 * cells);
    from += 4 * cells;
    // Planes have 16 bits of their greatest value.
    const float greatest = *std::ranges::max_element(expected, {}, [](float score) { return std::abs(score); });
    CHECK(farthest(side, expected) < 1e-4 * std::abs(greatest));
  }
}

TEST_CASE("swapping the sides of a strip swaps the network's scores, exactly, whatever ran before") {
  Rng rng(3);
  NetworkScratch scratch;
  std::array<std::vector<float>, 2> scores, swapped, again;
  StripChannels strip = randomStrip(rng, 24, 56);
  network().run(strip, scratch, scores);
  std::swap(strip.planes[0], strip.planes[1]);
  network().run(strip, scratch, swapped);
  CHECK(swapped[0] == scores[1]);
  CHECK(swapped[1] == scores[0]);
  network().run(randomStrip(rng, 64, 128), scratch, again);
  network().run(strip, scratch, again);
  CHECK(again == swapped);
}

TEST_CASE("the scores of a stroke that is drawn backwards are those of the stroke, with the sides swapped") {
  std::vector<PicturePoint> points;
  for (int i = 0; i < 70; ++i) points.push_back({45.0 + 2.1 * i, 82 + 4 * std::sin(0.05 * i)});
  CurveLayout layout;
  const std::vector<float> forward = scoresOfBar(points, layout);
  std::ranges::reverse(points);
  const std::vector<float> backward = scoresOfBar(points, layout);
  const std::size_t levels = forward.size() / static_cast<std::size_t>(layout.total());
  double most = 0;
  for (int i = 0; i < layout.ribs; ++i) {
    for (const bool left : {true, false}) {
      const std::size_t a = static_cast<std::size_t>(layout.sideOf(i, left)) * levels;
      const std::size_t b = static_cast<std::size_t>(layout.sideOf(layout.ribs - 1 - i, !left)) * levels;
      for (std::size_t k = 0; k < levels; ++k)
        most = std::max(most, static_cast<double>(std::abs(forward[a + k] - backward[b + k])));
    }
  }
  // The scores span some twenty; sums are taken in another order.
  CHECK(most < 0.3);
}

TEST_CASE("a weights file that is damaged is refused with a sentence that says so") {
  const std::span<const std::uint8_t> good = builtInWeights();
  REQUIRE(RibNetwork::read(good).ok());
  const auto refused = [](std::vector<std::uint8_t> file, std::string_view why) {
    const Result<RibNetwork> read = RibNetwork::read(file);
    REQUIRE_FALSE(read.ok());
    CHECK(read.error() == Error::FileUnreadable);
    CHECK(read.failure().detail.find(why) != std::string::npos);
  };
  const std::vector<std::uint8_t> file(good.begin(), good.end());
  refused({}, "no weights file");
  for (const std::size_t size : {std::size_t{3}, std::size_t{12}, file.size() / 2, file.size() - 1}) {
    std::vector<std::uint8_t> cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    REQUIRE_FALSE(RibNetwork::read(cut).ok());
  }
  Rng rng(4);
  for (int i = 0; i < 50; ++i) {
    std::vector<std::uint8_t> flipped = file;
    const auto at = static_cast<std::size_t>(rng.uniform(12, static_cast<double>(file.size() - 1)));
    flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ (1u << (i % 8)));
    refused(std::move(flipped), "the checksum is wrong");
  }
  std::vector<std::uint8_t> other = file;
  other[4] = 2;
  refused(std::move(other), "another version");
}

TEST_SUITE_END();
