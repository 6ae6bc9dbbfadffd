#include "engine/ribs/learned/channels.h"

#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"

namespace spineloft::ribs {
namespace {

// Rows along the ribs, for every 128 levels. With more than twice as many ribs, one for every two: what a row shows is
// then the same on a long stroke as on a short one.
constexpr int kRows = 52, kRowLevels = 128;
// The median colour of the spine is taken over this share of the rows and so many labels.
constexpr int kOwnShare = 8, kOwnLabels = 3;
// Differences at which the planes are at one half, Lab units: of colours, and of mean colours.
constexpr float kColourHalf = 25, kStepHalf = 15;
// What counts as strong: this percentile of the differences; and a little, so that noise is not strong.
constexpr double kStrongShare = 0.93;
constexpr float kStrongest = 0.5f, kNoise = 1.5f;
constexpr int kWide = 3;
constexpr float kJustOutside = 1.3f;
constexpr float kLogDistance = 1.f / 6, kLogSlope = 1.f / 4, kLogUnits = 1.f / 5, kLogOdds = 0.5f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

int halfFan(const CurveLayout& layout) { return (layout.fan + 1) / 2; }

float squashed(float d, float half) { return d / (std::abs(d) + half); }
float held(float v) { return std::clamp(v, -1.f, 1.f); }

// The rows of one side.
void listRows(const CurveLayout& layout, bool leftSide, const StripChannels& channels, std::vector<StripRow>& rows) {
  const bool reversed = channels.reversed;
  const int half = halfFan(layout), along = channels.rows - 2 * half, last = layout.ribs - 1;
  const float step = static_cast<float>(layout.ribs) / static_cast<float>(along);
  rows.clear();
  const auto fan = [&](bool ofStart, int fromSide) {
    const int i = leftSide ? fromSide : layout.fan - 1 - fromSide;
    const int curve = ofStart ? layout.startFan(i) : layout.endFan(i);
    rows.push_back({curve, curve, 0, true});
  };
  const auto curveOf = [&](int i) { return layout.sideOf(reversed ? last - i : i, leftSide); };
  for (int i = half - 1; i >= 0; --i) fan(!reversed, i);
  for (int r = 0; r < along; ++r) {
    const float at = std::clamp((static_cast<float>(r) + 0.5f) * step - 0.5f, 0.f, static_cast<float>(last));
    const int first = std::min(static_cast<int>(at), last), second = std::min(first + 1, last);
    rows.push_back({curveOf(first), curveOf(second), at - static_cast<float>(first), false});
  }
  for (int i = 0; i < half; ++i) fan(reversed, i);
}

// Which way the rows run: from the darker half of the strip to the lighter one. Sums over pairs of ribs that change
// places with the direction give exactly the opposite.
bool runsBackwards(const CurveLayout& layout, const GradientCurves& curves, const UnwrappedImage& strip) {
  const auto lightness = [&](int rib) {
    float sum[2] = {0, 0};
    for (const bool leftSide : {true, false}) {
      const int curve = layout.sideOf(rib, leftSide);
      for (int k = 0; k < curves.reached[index(curve)]; k += 4)
        sum[leftSide ? 0 : 1] += strip.lab[curves.at(curve, k)][0];
    }
    return sum[0] + sum[1];
  };
  float difference = 0;
  for (int i = 0; 2 * i < layout.ribs - 1; ++i) difference += lightness(layout.ribs - 1 - i) - lightness(i);
  return difference < 0;
}

class Filler {
 public:
  Filler(const GradientCurves& curves, const UnwrappedImage& strip, const std::vector<float>& logOdds,
         ChannelScratch& scratch, StripChannels& channels)
      : curves_(curves), strip_(strip), logOdds_(logOdds), s_(scratch), c_(channels), levels_(curves.levels) {}

  void run() {
    for (const int side : {0, 1}) gather(side);
    ownColours();
    for (const int side : {0, 1}) {
      c_.planes[index(side)].assign(index(c_.rows) * index(c_.levels) * kChannels, 0.f);
      for (int r = 0; r < c_.rows; ++r) fillRow(side, r);
    }
    relate();
  }

 private:
  std::size_t cell(int row, int level) const { return index(row) * index(levels_) + index(level); }

  // The means of the curves of every row.
  void gather(int side) {
    auto& colours = s_.colours[index(side)];
    auto &along = s_.along[index(side)], &logOdds = s_.logOdds[index(side)];
    auto& reached = s_.reached[index(side)];
    const std::size_t size = index(c_.rows) * index(levels_);
    colours.resize(size);
    along.resize(size);
    logOdds.resize(size);
    reached.resize(index(c_.rows));
    for (int r = 0; r < c_.rows; ++r) {
      const StripRow& row = c_.sources[index(side)][index(r)];
      const std::size_t a = curves_.at(row.first, 0), b = curves_.at(row.second, 0), to = cell(r, 0);
      const int both = std::min(curves_.reached[index(row.first)], curves_.reached[index(row.second)]);
      reached[index(r)] = both;
      for (std::size_t k = 0; k < index(both); ++k) {
        Float4 look = load4(strip_.lab[a + k].data());
        look[3] = strip_.proximity[a + k];
        Float4 other = load4(strip_.lab[b + k].data());
        other[3] = strip_.proximity[b + k];
        store4(look + row.share * (other - look), colours[to + k].data());
        along[to + k] = curves_.along[a + k] + row.share * (curves_.along[b + k] - curves_.along[a + k]);
        logOdds[to + k] = logOdds_[a + k] + row.share * (logOdds_[b + k] - logOdds_[a + k]);
      }
    }
  }

  bool isIgnored(int side, int row, int level) const {
    const StripRow& source = c_.sources[index(side)][index(row)];
    return strip_.isIgnored(curves_.at(source.first, level)) || strip_.isIgnored(curves_.at(source.second, level));
  }

  // The median colour close to the spine around every row.
  void ownColours() {
    const int half = std::max(1, c_.rows / kOwnShare);
    s_.own.resize(index(c_.rows));
    for (int r = 0; r < c_.rows; ++r) {
      const int low = std::max(0, r - half), high = std::min(c_.rows - 1, r + half);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        s_.samples.clear();
        for (const int side : {0, 1}) {
          for (int q = low; q <= high; ++q) {
            for (int k = 0; k < std::min(kOwnLabels, s_.reached[index(side)][index(q)]); ++k)
              s_.samples.push_back(s_.colours[index(side)][cell(q, k)][channel]);
          }
        }
        const auto middle = s_.samples.begin() + static_cast<std::ptrdiff_t>(s_.samples.size() / 2);
        std::nth_element(s_.samples.begin(), middle, s_.samples.end());
        s_.own[index(r)][channel] = *middle;
      }
    }
  }

  static float apart(const std::array<float, 4>& a, const std::array<float, 4>& b) {
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  void fillRow(int side, int r) {
    const int reached = s_.reached[index(side)][index(r)];
    const std::array<float, 4>* colours = &s_.colours[index(side)][cell(r, 0)];
    const float *along = &s_.along[index(side)][cell(r, 0)], *logOdds = &s_.logOdds[index(side)][cell(r, 0)];
    const std::array<float, 3>& own = s_.own[index(r)];
    float* out = &c_.planes[index(side)][c_.at(r, 0)];
    const auto put = [&](int k, Channel channel, float value) {
      out[index(k) * kChannels + static_cast<std::size_t>(channel)] = value;
    };
    const int above = std::max(0, r - 1), below = std::min(c_.rows - 1, r + 1);
    const int reachedAbove = s_.reached[index(side)][index(above)],
              reachedBelow = s_.reached[index(side)][index(below)];
    const std::array<float, 4>* before = &s_.colours[index(side)][cell(above, 0)];
    const std::array<float, 4>* after = &s_.colours[index(side)][cell(below, 0)];
    const auto last = reached - 1;
    for (int k = 0; k < reached; ++k) {
      for (std::size_t channel = 0; channel < 3; ++channel)
        put(k, static_cast<Channel>(channel), squashed(colours[k][channel] - own[channel], kColourHalf));
      const float across = apart(colours[std::min(k + 1, last)], colours[std::max(k - 1, 0)]);
      put(k, Channel::Across, across);
      put(k, Channel::AcrossWide, apart(colours[std::min(k + kWide, last)], colours[std::max(k - kWide, 0)]));
      put(k, Channel::AcrossUnits, held(kLogUnits * quickLog(1 + across)));
      put(k, Channel::Along,
          apart(k < reachedBelow ? after[k] : colours[k], k < reachedAbove ? before[k] : colours[k]));
      put(k, Channel::Near, colours[k][3]);
      put(k, Channel::LogOdds, kLogOdds * logOdds[k]);
      put(k, Channel::Reached, 1);
      put(k, Channel::Fan, c_.sources[index(side)][index(r)].fan ? 1.f : 0.f);
    }
    fillGeometry(side, r, out);
    fillMeans(colours, along, logOdds, reached, out);
    for (int k = 0; k < reached && !strip_.ignored.empty(); ++k) {
      if (isIgnored(side, r, k)) std::fill_n(out + index(k) * kChannels, kChannels, 0.f);
    }
  }

  PicturePoint pointOf(const StripRow& row, int k) const {
    return lerp(curves_.point(row.first, k), curves_.point(row.second, k), static_cast<double>(row.share));
  }

  void fillGeometry(int side, int r, float* out) const {
    const int reached = s_.reached[index(side)][index(r)];
    const float* along = &s_.along[index(side)][cell(r, 0)];
    const StripRow& row = c_.sources[index(side)][index(r)];
    const int near = std::clamp(r + (r + 1 < c_.rows ? 1 : -1), 0, c_.rows - 1);
    const StripRow& next = c_.sources[index(side)][index(near)];
    const int both = std::min(reached, s_.reached[index(side)][index(near)]);
    float slope = 0;
    for (int k = 0; k < reached; ++k) {
      const float step = k > 0 ? along[k] - along[k - 1] : along[std::min(1, reached - 1)];
      if (k < both) {
        const PicturePoint apart = pointOf(row, k) - pointOf(next, k);
        const auto dx = static_cast<float>(apart.x), dy = static_cast<float>(apart.y);
        slope = quickLog(std::max(step, 1e-3f) / std::max(std::sqrt(dx * dx + dy * dy), 1e-3f));
      }
      float* to = out + index(k) * kChannels;
      to[static_cast<std::size_t>(Channel::Slope)] = held(kLogSlope * slope);
      to[static_cast<std::size_t>(Channel::Distance)] =
          held(1 + kLogDistance * quickLog(std::max(along[k], 1e-2f) / length_));
    }
  }

  // What depends on means between the spine and a label, and from there on.
  void fillMeans(const std::array<float, 4>* colours, const float* along, const float* logOdds, int reached,
                 float* out) {
    sums_.resize(index(reached));
    Float4 sum = all4(0);
    for (int k = 0; k < reached; ++k) {
      const float run = k > 0 ? along[k] - along[k - 1] : 0.f;
      Float4 look = load4(colours[k].data());
      look[3] = logOdds[k];
      sum += run * look;
      store4(sum, sums_[index(k)].data());
    }
    int far = 0;
    for (int k = 1; k < reached; ++k) {
      const float until = kJustOutside * along[k] + 2 * static_cast<float>(strip_.pixel);
      far = std::max(far, k);
      while (far + 1 < reached && along[far + 1] <= until) ++far;
      if (far == k && far + 1 < reached) ++far;
      float* to = out + index(k) * kChannels;
      const Float4 here = load4(sums_[index(k)].data());
      const Float4 inside = here / std::max(along[k], 1e-3f);
      to[static_cast<std::size_t>(Channel::Inside)] = kLogOdds * inside[3];
      if (far == k) continue;
      const Float4 outside = (load4(sums_[index(far)].data()) - here) / std::max(along[far] - along[k], 1e-3f);
      to[static_cast<std::size_t>(Channel::Outside)] = kLogOdds * outside[3];
      const Float4 d = inside - outside;
      to[static_cast<std::size_t>(Channel::Step)] =
          squashed(std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), kStepHalf);
    }
  }

  // Differences relative to the strong ones of the strip.
  void relate() {
    for (const Channel channel : {Channel::Across, Channel::AcrossWide, Channel::Along}) {
      s_.samples.clear();
      for (const int side : {0, 1}) {
        const std::vector<float>& planes = c_.planes[index(side)];
        for (int r = 0; r < c_.rows; ++r) {
          const int reached = s_.reached[index(side)][index(r)];
          for (int k = r % 2; k < reached; k += 2)
            s_.samples.push_back(planes[c_.at(r, k) + static_cast<std::size_t>(channel)]);
        }
      }
      const auto at =
          s_.samples.begin() + static_cast<std::ptrdiff_t>(kStrongShare * static_cast<double>(s_.samples.size() - 1));
      std::nth_element(s_.samples.begin(), at, s_.samples.end());
      const float half = kStrongest * *at + kNoise;
      for (const int side : {0, 1}) {
        std::vector<float>& planes = c_.planes[index(side)];
        for (std::size_t i = static_cast<std::size_t>(channel); i < planes.size(); i += kChannels)
          planes[i] = planes[i] / (planes[i] + half);
      }
    }
  }

  const GradientCurves& curves_;
  const UnwrappedImage& strip_;
  const std::vector<float>& logOdds_;
  ChannelScratch& s_;
  StripChannels& c_;
  const int levels_;
  std::vector<std::array<float, 4>>& sums_ = s_.sums;
  float length_ = spineLength();

  float spineLength() const {
    double length = 0;
    for (int i = 1; i < curves_.layout.ribs; ++i)
      length += distance(curves_.seeds[index(i)][0], curves_.seeds[index(i - 1)][0]);
    return static_cast<float>(std::max(1.0, length));
  }
};

}  // namespace

int stripRows(int ribs, int levels) {
  const int usual = kRows * levels / kRowLevels / 2 * 2;
  return std::max({2, usual, usual * ribs / (4 * kRows) * 2});
}

void fillChannels(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours,
                  std::vector<float>& logOdds, ChannelScratch& scratch, StripChannels& channels) {
  spineLogOdds(curves, strip, {}, colours, logOdds);
  channels.rows = stripRows(curves.layout.ribs, curves.levels) + 2 * halfFan(curves.layout);
  channels.levels = (curves.levels + 3) / 4 * 4;
  channels.reversed = runsBackwards(curves.layout, curves, strip);
  for (const int side : {0, 1}) {
    listRows(curves.layout, side == 0, channels, channels.sources[index(side)]);
  }
  Filler(curves, strip, logOdds, scratch, channels).run();
}

}  // namespace spineloft::ribs
