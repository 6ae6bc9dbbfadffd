#include "engine/ribs/learned/channels.h"

#include <algorithm>
#include <cmath>

#include "engine/base/shared_loop.h"
#include "engine/base/short_lanes.h"

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

// Four rows of a 4 × 4 matrix to its columns.
void transpose(Int4 (&m)[4]) {
  const Int4 a = __builtin_shufflevector(m[0], m[1], 0, 4, 1, 5), b = __builtin_shufflevector(m[2], m[3], 0, 4, 1, 5),
             c = __builtin_shufflevector(m[0], m[1], 2, 6, 3, 7), d = __builtin_shufflevector(m[2], m[3], 2, 6, 3, 7);
  m[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
  m[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
  m[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
  m[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

// `kChannels` rows of `levels` values within ±1 each, one after the other, to 16 bits and the channels of a label next
// to each other.
void interleave(const float* rows, std::size_t levels, std::int16_t* to) {
  constexpr std::size_t kGroups = kChannels / 4;
  for (std::size_t k = 0; k < levels; k += 4) {
    Int4 labels[kGroups][4];
    for (std::size_t g = 0; g < kGroups; ++g) {
      for (std::size_t c = 0; c < 4; ++c)
        labels[g][c] = nearest4(Plane::kMost * load4(rows + (4 * g + c) * levels + k));
      transpose(labels[g]);
    }
    for (std::size_t i = 0; i < 4; ++i, to += kChannels) {
      for (std::size_t g = 0; g < kGroups; g += 2) storeShort8(labels[g][i], labels[g + 1][i], to + 4 * g);
    }
  }
}

class Filler {
 public:
  Filler(const GradientCurves& curves, const UnwrappedImage& strip, const std::vector<float>& logOdds,
         ChannelScratch& scratch, StripChannels& channels)
      : curves_(curves), strip_(strip), logOdds_(logOdds), s_(scratch), c_(channels), levels_(index(channels.levels)) {}

  void run() {
    for (const int side : {0, 1}) makeRoom(s_.sides[index(side)], c_.planes[index(side)]);
    for (RowScratch& scratch : s_.rows) {
      scratch.channels.resize(kChannels * levels_);
      scratch.sums.resize(levels_);
    }
    ofRows([this](int side, int row, int) { gather(side, row); });
    ownColours();
    ofRows([this](int side, int row, int) { findDifferences(s_.sides[index(side)], row); });
    findStrong();
    ofRows([this](int side, int row, int who) {
      RowScratch& scratch = s_.rows[index(who)];
      fillRow(side, row, scratch);
      interleave(scratch.channels.data(), levels_, c_.planes[index(side)].at(row, 0));
    });
  }

 private:
  using Side = ChannelScratch::Side;
  using RowScratch = ChannelScratch::Row;

  std::size_t cell(int row) const { return index(row) * levels_; }
  float* channel(RowScratch& scratch, Channel which) {
    return &scratch.channels[static_cast<std::size_t>(which) * levels_];
  }

  // work(side, row, who) for all rows of both sides; `who` as of LoopShare.
  template <class Work>
  void ofRows(const Work& work) {
    sharedLoop(2 * c_.rows, [&](LoopShare of) {
      for (int i = of.first; i < of.end; ++i) work(i / c_.rows, i % c_.rows, of.who);
    });
  }

  void makeRoom(Side& side, Plane& out) {
    const std::size_t size = cell(c_.rows);
    side.colours.resize(size);
    for (auto* plane : {&side.lightness, &side.red, &side.blue, &side.near, &side.along, &side.x, &side.y, &side.across,
                        &side.acrossWide, &side.beside})
      plane->resize(size);
    side.reached.resize(index(c_.rows));
    out.shape(c_.rows, c_.levels, kChannels);
    out.unit = 1 / Plane::kMost;
  }

  // The means of the curves of a row.
  void gather(int which, int r) {
    Side& side = s_.sides[index(which)];
    const StripRow& row = c_.sources[index(which)][index(r)];
    const std::size_t a = curves_.at(row.first, 0), b = curves_.at(row.second, 0), to = cell(r);
    const int both = std::min(curves_.reached[index(row.first)], curves_.reached[index(row.second)]);
    side.reached[index(r)] = both;
    for (std::size_t k = 0; k < index(both); ++k) {
      Float4 look = load4(strip_.lab[a + k].data()), other = load4(strip_.lab[b + k].data());
      look[3] = logOdds_[a + k];
      other[3] = logOdds_[b + k];
      const Float4 mean = look + row.share * (other - look);
      store4(mean, side.colours[to + k].data());
      side.lightness[to + k] = mean[0];
      side.red[to + k] = mean[1];
      side.blue[to + k] = mean[2];
    }
    const auto mean = [&](const std::vector<float>& from, std::vector<float>& into) {
      const float *first = &from[a], *second = &from[b];
      float* out = &into[to];
      for (std::size_t k = 0; k < index(both); ++k) out[k] = first[k] + row.share * (second[k] - first[k]);
    };
    mean(strip_.proximity, side.near);
    mean(curves_.along, side.along);
    mean(curves_.x, side.x);
    mean(curves_.y, side.y);
  }

  bool isIgnored(int side, int row, int level) const {
    if (strip_.ignored.empty()) return false;
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
        for (const Side& side : s_.sides) {
          for (int q = low; q <= high; ++q) {
            for (int k = 0; k < std::min(kOwnLabels, side.reached[index(q)]); ++k)
              s_.samples.push_back(side.colours[cell(q) + index(k)][channel]);
          }
        }
        const auto middle = s_.samples.begin() + static_cast<std::ptrdiff_t>(s_.samples.size() / 2);
        std::nth_element(s_.samples.begin(), middle, s_.samples.end());
        s_.own[index(r)][channel] = *middle;
      }
    }
  }

  // Lab differences of `count` pairs of entries.
  static void apart(const Side& side, std::size_t a, std::size_t b, std::size_t count, float* out) {
    const float *l = &side.lightness[a], *m = &side.lightness[b], *p = &side.red[a], *q = &side.red[b],
                *u = &side.blue[a], *v = &side.blue[b];
    for (std::size_t k = 0; k < count; ++k) {
      const float x = l[k] - m[k], y = p[k] - q[k], z = u[k] - v[k];
      out[k] = std::sqrt(x * x + y * y + z * z);
    }
  }

  // Over ± `reach` labels, as far as they exist.
  static void apartAlong(const Side& side, std::size_t row, std::size_t reached, std::size_t reach, float* out) {
    const std::size_t inner = std::min(reach, reached), last = reached - 1;
    const auto one = [&](std::size_t k) {
      apart(side, row + std::min(k + reach, last), row + (k > reach ? k - reach : 0), 1, out + k);
    };
    for (std::size_t k = 0; k < inner; ++k) one(k);
    const std::size_t end = std::max(inner, reached - inner);
    if (end > inner) apart(side, row + 2 * reach, row, end - inner, out + inner);
    for (std::size_t k = end; k < reached; ++k) one(k);
  }

  void findDifferences(Side& side, int r) {
    const std::size_t reached = index(side.reached[index(r)]), row = cell(r);
    apartAlong(side, row, reached, 1, &side.across[row]);
    apartAlong(side, row, reached, kWide, &side.acrossWide[row]);
    // Between the rows on either side, or from here where one of them does not reach.
    const int above = std::max(0, r - 1), below = std::min(c_.rows - 1, r + 1);
    const std::size_t a = index(side.reached[index(above)]), b = index(side.reached[index(below)]);
    const std::size_t both = std::min({a, b, reached}), one = std::min(std::max(a, b), reached);
    apart(side, cell(below), cell(above), both, &side.beside[row]);
    const std::size_t from = (b > a ? cell(below) : row) + both, to = (b > a ? row : cell(above)) + both;
    if (one > both) apart(side, from, to, one - both, &side.beside[row + both]);
    std::fill(&side.beside[row] + one, &side.beside[row] + reached, 0.f);
  }

  // What is strong in this strip.
  void findStrong() {
    for (auto plane : {&Side::across, &Side::acrossWide, &Side::beside}) {
      s_.samples.clear();
      for (const int side : {0, 1}) {
        for (int r = 0; r < c_.rows; ++r) {
          const float* row = &(s_.sides[index(side)].*plane)[cell(r)];
          for (int k = r % 2; k < s_.sides[index(side)].reached[index(r)]; k += 2)
            s_.samples.push_back(isIgnored(side, r, k) ? 0.f : row[k]);
        }
      }
      const auto at =
          s_.samples.begin() + static_cast<std::ptrdiff_t>(kStrongShare * static_cast<double>(s_.samples.size() - 1));
      std::nth_element(s_.samples.begin(), at, s_.samples.end());
      const float half = kStrongest * *at + kNoise;
      (plane == &Side::across ? strong_ : plane == &Side::acrossWide ? strongWide_ : strongBeside_) = half;
    }
  }

  void fillRow(int which, int r, RowScratch& scratch) {
    const Side& side = s_.sides[index(which)];
    const std::size_t row = cell(r), reached = index(side.reached[index(r)]);
    const auto relative = [&](Channel to, const std::vector<float>& plane, float half) {
      const float* from = &plane[row];
      float* out = channel(scratch, to);
      for (std::size_t k = 0; k < reached; ++k) out[k] = from[k] / (from[k] + half);
    };
    relative(Channel::Across, side.across, strong_);
    relative(Channel::AcrossWide, side.acrossWide, strongWide_);
    relative(Channel::Along, side.beside, strongBeside_);
    const auto unlike = [&](Channel to, const std::vector<float>& plane, float own) {
      const float* from = &plane[row];
      float* out = channel(scratch, to);
      for (std::size_t k = 0; k < reached; ++k) out[k] = squashed(from[k] - own, kColourHalf);
    };
    const std::array<float, 3>& own = s_.own[index(r)];
    unlike(Channel::Lightness, side.lightness, own[0]);
    unlike(Channel::Red, side.red, own[1]);
    unlike(Channel::Blue, side.blue, own[2]);
    float *units = channel(scratch, Channel::AcrossUnits), *logOdds = channel(scratch, Channel::LogOdds);
    const float* across = &side.across[row];
    for (std::size_t k = 0; k < reached; ++k) units[k] = held(kLogUnits * quickLog(1 + across[k]));
    for (std::size_t k = 0; k < reached; ++k) logOdds[k] = kLogOdds * side.colours[row + k][3];
    std::copy_n(&side.near[row], reached, channel(scratch, Channel::Near));
    std::fill_n(channel(scratch, Channel::Reached), reached, 1.f);
    std::fill_n(channel(scratch, Channel::Fan), reached, c_.sources[index(which)][index(r)].fan ? 1.f : 0.f);
    fillGeometry(side, r, scratch);
    fillMeans(side, row, reached, scratch);
    for (std::size_t c = 0; c < kChannels; ++c)
      std::fill(&scratch.channels[c * levels_] + reached, &scratch.channels[c * levels_] + levels_, 0.f);
    for (std::size_t k = 0; k < reached && !strip_.ignored.empty(); ++k) {
      if (!isIgnored(which, r, static_cast<int>(k))) continue;
      for (std::size_t c = 0; c < kChannels; ++c) scratch.channels[c * levels_ + k] = 0;
    }
  }

  void fillGeometry(const Side& side, int r, RowScratch& scratch) {
    const std::size_t row = cell(r), reached = index(side.reached[index(r)]);
    const int near = std::clamp(r + (r + 1 < c_.rows ? 1 : -1), 0, c_.rows - 1);
    const std::size_t next = cell(near), both = std::min(reached, index(side.reached[index(near)]));
    const float *along = &side.along[row], *x = &side.x[row], *y = &side.y[row], *nextX = &side.x[next],
                *nextY = &side.y[next];
    float *slope = channel(scratch, Channel::Slope), *away = channel(scratch, Channel::Distance);
    const auto slopeAt = [&](std::size_t k, float step) {
      const float dx = x[k] - nextX[k], dy = y[k] - nextY[k], apart = std::sqrt(dx * dx + dy * dy);
      const float ratio = (step < 1e-3f ? 1e-3f : step) / (apart < 1e-3f ? 1e-3f : apart);
      slope[k] = held(kLogSlope * quickLog(ratio));
    };
    slopeAt(0, along[std::min<std::size_t>(1, reached - 1)]);
    for (std::size_t k = 1; k < both; ++k) slopeAt(k, along[k] - along[k - 1]);
    std::fill(slope + both, slope + reached, slope[both - 1]);
    for (std::size_t k = 0; k < reached; ++k)
      away[k] = held(1 + kLogDistance * quickLog((along[k] < 1e-2f ? 1e-2f : along[k]) / length_));
  }

  // What depends on means between the spine and a label, and from there on.
  void fillMeans(const Side& side, std::size_t row, std::size_t reached, RowScratch& scratch) {
    const float* along = &side.along[row];
    float *inner = channel(scratch, Channel::Inside), *outer = channel(scratch, Channel::Outside),
          *steps = channel(scratch, Channel::Step);
    auto& sums = scratch.sums;
    Float4 sum = all4(0);
    for (std::size_t k = 0; k < reached; ++k) {
      const float run = k > 0 ? along[k] - along[k - 1] : 0.f;
      sum += run * load4(side.colours[row + k].data());
      store4(sum, sums[k].data());
    }
    inner[0] = outer[0] = steps[0] = 0;
    std::size_t far = 0;
    for (std::size_t k = 1; k < reached; ++k) {
      const float until = kJustOutside * along[k] + 2 * static_cast<float>(strip_.pixel);
      far = std::max(far, k);
      while (far + 1 < reached && along[far + 1] <= until) ++far;
      if (far == k && far + 1 < reached) ++far;
      const Float4 here = load4(sums[k].data());
      const Float4 inside = here / std::max(along[k], 1e-3f);
      inner[k] = kLogOdds * inside[3];
      outer[k] = steps[k] = 0;
      if (far == k) continue;
      const Float4 outside = (load4(sums[far].data()) - here) / std::max(along[far] - along[k], 1e-3f);
      outer[k] = kLogOdds * outside[3];
      const Float4 d = inside - outside;
      steps[k] = squashed(std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), kStepHalf);
    }
  }

  const GradientCurves& curves_;
  const UnwrappedImage& strip_;
  const std::vector<float>& logOdds_;
  ChannelScratch& s_;
  StripChannels& c_;
  const std::size_t levels_;
  // Differences that count for one half.
  float strong_ = 1, strongWide_ = 1, strongBeside_ = 1;
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
