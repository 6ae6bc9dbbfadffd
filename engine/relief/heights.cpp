#include "engine/relief/heights.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/image/lab.h"
#include "engine/image/srgb.h"
#include "engine/relief/shade.h"

namespace spineloft::relief {
namespace {

Values lightness(const Shown& shown) {
  Values values(shown.colour.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto byte = [&](int c) { return static_cast<std::uint8_t>(std::lround(255 * shown.colour[i][c])); };
    if (shown.counts[i]) values[i] = image::labOf(byte(0), byte(1), byte(2))[0] / 100;
  }
  return values;
}

// The threshold that parts values 0 … 1 best into two classes (Otsu 1979).
double threshold(const Values& values, const Cells& counts) {
  constexpr int kBins = 256;
  std::array<double, kBins> histogram{};
  double count = 0, sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!counts[i]) continue;
    const int bin = std::clamp(static_cast<int>(values[i] * kBins), 0, kBins - 1);
    histogram[bin] += 1;
    count += 1;
    sum += bin;
  }
  double below = 0, belowSum = 0, best = 0, at = 0;
  for (int bin = 0; bin + 1 < kBins; ++bin) {
    below += histogram[bin];
    belowSum += bin * histogram[bin];
    if (below == 0 || below == count) continue;
    const double apart = belowSum / below - (sum - belowSum) / (count - below);
    const double between = below * (count - below) * apart * apart;
    if (between > best) {
      best = between;
      at = (bin + 1.0) / kBins;
    }
  }
  return at;
}

double smoothStep(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Values so that 2.5 times what they are in the mean is 1, cut off at ±1; where that is less than `least`, by `least`.
void normalise(Values& values, const Cells& counts, double least) {
  constexpr double kMost = 2.5;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!counts[i]) continue;
    sum += values[i] * values[i];
    count += 1;
  }
  const auto most = static_cast<float>(std::max(least, kMost * std::sqrt(sum / std::max(count, 1.0))));
  for (float& value : values) value = std::clamp(value / most, -1.0F, 1.0F);
}

// Grooves where strokes are darker than the brightest near them: −1 in a stroke, 0 on paper.
Values inkHeights(const Front& front, const Shown& shown) {
  constexpr double kPaper = 0.08;     // of the part: paper is as bright as the brightest so near
  constexpr double kFaintest = 0.12;  // of the paper's lightness: what is less dark is no ink
  constexpr double kEdge = 0.5;       // of the threshold: between that much less and more a groove has its wall
  const Grid& grid = front.grid;
  const int reach = std::max(2, static_cast<int>(std::lround(kPaper * grid.side())));
  const Values light = lightness(shown);
  const Values paper = blurred(grid, largestNear(grid, light, shown.counts, reach), shown.counts, reach / 2.0);
  Values dark(grid.size());
  for (std::size_t i = 0; i < dark.size(); ++i) {
    if (shown.counts[i] && paper[i] > 0) dark[i] = std::clamp((paper[i] - light[i]) / paper[i], 0.0F, 1.0F);
  }
  const double limit = std::max(kFaintest, threshold(dark, shown.counts));
  for (float& value : dark) value = static_cast<float>(-smoothStep((1 - kEdge) * limit, (1 + kEdge) * limit, value));
  return dark;
}

// Brightness (CIE L*) without what is broader than a tenth of the part.
Values brightHeights(const Front& front, const Shown& shown) {
  constexpr double kBroad = 0.1;  // of the part
  constexpr double kFlat = 0.03;  // of lightness: noise of a flat picture
  Values light = lightness(shown);
  const Values broad = blurred(front.grid, light, shown.counts, kBroad * front.grid.side());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = shown.counts[i] ? light[i] - broad[i] : 0;
  normalise(light, shown.counts, kFlat);
  return light;
}

// As light and shadow are looked for: over the part as it is, or over one that is round where a picture is laid on it.
Shading shadingOf(const Front& front, const Shown& shown, const std::vector<std::array<float, 3>>& linear,
                  bool isLaid) {
  return {front.grid.width, front.grid.height, linear, shown.counts, isLaid ? std::span<const float>{} : front.z};
}

std::vector<std::array<float, 3>> linearOf(const std::vector<std::array<float, 3>>& colours) {
  std::vector<std::array<float, 3>> linear(colours.size());
  std::ranges::transform(colours, linear.begin(), [](const std::array<float, 3>& colour) {
    std::array<float, 3> out;
    std::ranges::transform(colour, out.begin(), [](float c) { return static_cast<float>(image::linearOfSrgb(c)); });
    return out;
  });
  return linear;
}

}  // namespace

struct HeightSteps::State {
  Relief relief;
  std::shared_ptr<const image::Picture> pixels;
  std::optional<Front> front;
  Shown shown;
  std::optional<ShadeSteps> shade;
  Heights made;

  bool begin();
  bool finish(Mode mode, Values values);
};

// Whether there is more to do.
bool HeightSteps::State::begin() {
  if (!front || !pixels) return false;
  shown = shownOn(*front, relief, *pixels);
  if (relief.mode != Mode::Shade) {
    return finish(relief.mode, relief.mode == Mode::Ink ? inkHeights(*front, shown) : brightHeights(*front, shown));
  }
  shade.emplace(shadingOf(*front, shown, linearOf(shown.colour), relief.laid.has_value()));
  return true;
}

bool HeightSteps::State::finish(Mode mode, Values values) {
  made.front = std::move(*front);
  made.counts = std::move(shown.counts);
  made.values = std::move(values);
  made.mode = mode;
  return false;
}

HeightSteps::HeightSteps(const Surface& surface, const Relief& relief, std::shared_ptr<const image::Picture> pixels)
    : state_(std::make_unique<State>(State{relief, std::move(pixels), frontOf(surface), {}, {}, {}})) {}
HeightSteps::~HeightSteps() = default;

bool HeightSteps::step() {
  constexpr double kFlat = 0.3;  // cells: less is noise of a flat picture
  State& state = *state_;
  if (!state.shade) return state.begin();
  if (state.shade->step()) return true;
  Shaded shaded = state.shade->take();
  state.made.explained = shaded.explained;
  if (shaded.explained < kLeastExplained) return state.finish(Mode::Ink, inkHeights(*state.front, state.shown));
  normalise(shaded.height, state.shown.counts, kFlat);
  return state.finish(Mode::Shade, std::move(shaded.height));
}

Heights HeightSteps::take() { return std::move(state_->made); }

Heights heightsOf(const Surface& surface, const Relief& relief, std::shared_ptr<const image::Picture> pixels) {
  HeightSteps steps(surface, relief, std::move(pixels));
  while (steps.step()) {
  }
  return steps.take();
}

Values finished(const Heights& heights, double smooth) {
  constexpr double kSmooth = 0.03, kFade = 0.03;  // of the part
  const Grid& grid = heights.front.grid;
  Values values = blurred(grid, heights.values, heights.counts, smooth * kSmooth * grid.side());
  const Values depth = depthWithin(grid, heights.counts);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= static_cast<float>(smoothStep(0, std::max(2.0, kFade * grid.side()), depth[i] - 1));
  }
  return values;
}

std::size_t bytesOf(const Heights& heights) {
  const Front& front = heights.front;
  return sizeof(heights) + heights.counts.size() + front.seen.size() +
         sizeof(float) * (heights.values.size() + front.z.size() + front.firstBack.size() + 3 * front.backs.size());
}

}  // namespace spineloft::relief
