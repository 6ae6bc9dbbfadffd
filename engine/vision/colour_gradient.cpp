#include "engine/vision/colour_gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/image/lab.h"

namespace spineloft::vision {
namespace {

constexpr std::size_t kChannels = 3;
/// Where lightness changes by less than this share of the whole, its sign says nothing.
constexpr float kLevel = 0.1f;

/// The half of a Gaussian that sums to 1, from the middle outwards.
std::vector<float> gaussianHalf(double sigma) {
  const int size = sigma > 0 ? static_cast<int>(std::lround(8 * sigma + 1)) | 1 : 1;
  std::vector<double> half(static_cast<std::size_t>(size / 2 + 1), 1.0);
  double sum = 1;
  for (std::size_t i = 1; i < half.size(); ++i) {
    const double at = static_cast<double>(i) / sigma;
    half[i] = std::exp(-at * at / 2);
    sum += 2 * half[i];
  }
  std::vector<float> out;
  for (const double weight : half) out.push_back(static_cast<float>(weight / sum));
  return out;
}

/// out = weight · in.
void scaled(const float* in, float weight, std::size_t count, float* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = weight * in[i];
}

/// Two entries on either side of a filter's middle, and their weight.
struct Pair {
  const float* before;
  const float* after;
  float weight;
};
void addPair(const Pair& p, std::size_t count, float* __restrict out) {
  const float *a = p.before, *b = p.after;
  const float weight = p.weight;
  for (std::size_t i = 0; i < count; ++i) out[i] += weight * (a[i] + b[i]);
}
/// Two pairs at once: half as many trips to the cache.
void addPairs(const Pair& p, const Pair& q, std::size_t count, float* __restrict out) {
  const float *a = p.before, *b = p.after, *c = q.before, *d = q.after;
  const float inner = p.weight, outer = q.weight;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] += inner * (a[i] + b[i]) + outer * (c[i] + d[i]);
  }
}

/// A symmetric filter around `middle`; `entry(k)` is the pair at distance k.
template <class PairAt>
void filter(const float* middle, const std::vector<float>& half, std::size_t count, const PairAt& entry, float* out) {
  scaled(middle, half[0], count, out);
  std::size_t k = 1;
  for (; k + 1 < half.size(); k += 2) addPairs(entry(k), entry(k + 1), count, out);
  if (k < half.size()) addPair(entry(k), count, out);
}

/// Repeats the first and last of `count` values `margin` times on either side.
void extend(float* values, std::size_t count, std::size_t margin) {
  std::fill_n(values - margin, margin, values[0]);
  std::fill_n(values + count, margin, values[count - 1]);
}

/// Makes the rows of the smoothed picture in order. A row holds its three channels one after the
/// other, each with one more value on either side, which repeats the border.
class SmoothRows {
 public:
  SmoothRows(image::ImageView copy, double sigma)
      : copy_(copy),
        half_(gaussianHalf(sigma)),
        width_(static_cast<std::size_t>(copy.width)),
        stride_(width_ + 2),
        raw_(kChannels * (width_ + 2 * radius())),
        ring_((2 * radius() + 1) * rowLength()) {}

  std::size_t rowLength() const { return kChannels * stride_; }
  std::size_t stride() const { return stride_; }

  /// Row y, which must not be less than that of the call before.
  void make(int y, float* out) {
    const int reach = static_cast<int>(radius()), last = copy_.height - 1;
    for (const int need = std::min(y + reach, last); made_ <= need; ++made_) addRow(made_);
    const auto row = [&](int at) -> const float* { return slot(std::clamp(at, 0, last)); };
    const auto pair = [&](std::size_t k) {
      const int step = static_cast<int>(k);
      return Pair{row(y - step), row(y + step), half_[k]};
    };
    filter(row(y), half_, rowLength(), pair, out);
    for (std::size_t c = 0; c < kChannels; ++c) extend(out + c * stride_ + 1, width_, 1);
  }

 private:
  std::size_t radius() const { return half_.size() - 1; }
  float* slot(int y) { return ring_.data() + static_cast<std::size_t>(y) % (2 * radius() + 1) * rowLength(); }
  /// Lab of row y, filtered along the row.
  void addRow(int y) {
    const std::size_t margin = radius(), length = width_ + 2 * margin;
    float* first = raw_.data() + margin;
    image::labRow(copy_.pixels.subspan(4 * width_ * static_cast<std::size_t>(y), 4 * width_),
                  {first, first + length, first + 2 * length});
    for (std::size_t c = 0; c < kChannels; ++c) {
      float* in = first + c * length;
      extend(in, width_, margin);
      const auto pair = [&](std::size_t k) { return Pair{in - k, in + k, half_[k]}; };
      filter(in, half_, width_, pair, slot(y) + c * stride_ + 1);
    }
  }

  image::ImageView copy_;
  std::vector<float> half_;
  std::size_t width_, stride_;
  std::vector<float> raw_;   ///< one row before smoothing, each channel with its margins
  std::vector<float> ring_;  ///< the rows that the column filter still needs
  int made_ = 0;
};

/// Three smoothed rows, each pointing at column 0 of one channel.
struct ThreeRows {
  const float *up, *here, *down;
};

/// Sobel's weights sum to 8: an eighth makes Lab units a pixel.
void sobelRow(const ThreeRows& rows, std::size_t count, float* __restrict dx, float* __restrict dy) {
  const float *u = rows.up, *m = rows.here, *d = rows.down;
  // Signed, for column −1 is read.
  for (std::ptrdiff_t x = 0; x < static_cast<std::ptrdiff_t>(count); ++x) {
    dx[x] = 0.125f * (u[x + 1] - u[x - 1] + 2 * (m[x + 1] - m[x - 1]) + d[x + 1] - d[x - 1]);
    dy[x] = 0.125f * (d[x - 1] - u[x - 1] + 2 * (d[x] - u[x]) + d[x + 1] - u[x + 1]);
  }
}

/// The derivatives of the three channels along one row, and where the gradient goes.
struct Derivatives {
  std::array<const float*, kChannels> dx, dy;
};
void dominantRow(const Derivatives& row, std::size_t count, float* __restrict gradientX, float* __restrict gradientY) {
  const float *lx = row.dx[0], *ax = row.dx[1], *bx = row.dx[2];
  const float *ly = row.dy[0], *ay = row.dy[1], *by = row.dy[2];
  for (std::size_t i = 0; i < count; ++i) {
    const float e = lx[i] * lx[i] + ax[i] * ax[i] + bx[i] * bx[i];
    const float f = lx[i] * ly[i] + ax[i] * ay[i] + bx[i] * by[i];
    const float g = ly[i] * ly[i] + ay[i] * ay[i] + by[i] * by[i];
    const float root = std::sqrt((e - g) * (e - g) + 4 * f * f);
    const float strongest = 0.5f * (e + g + root);  // the larger eigenvalue of (e f; f g)
    // Its eigenvector, from the row that does not vanish.
    const float major = 0.5f * (std::abs(e - g) + root);
    float x = e >= g ? major : f, y = e >= g ? f : major;
    float squared = x * x + y * y;
    // Level in all directions: any direction will do.
    const bool round = !(squared > 0);
    x = round ? 1.0f : x;
    squared = round ? 1.0f : squared;
    const float scale = std::sqrt(strongest / squared);
    x *= scale;
    y *= scale;
    const float onL = lx[i] * x + ly[i] * y, onA = ax[i] * x + ay[i] * y, onB = bx[i] * x + by[i] * y;
    float most = std::abs(onA) > std::abs(onL) ? onA : onL;
    most = std::abs(onB) > std::abs(most) ? onB : most;
    const float along = std::abs(onL) <= kLevel * strongest ? most : onL;
    gradientX[i] = along < 0 ? -x : x;
    gradientY[i] = along < 0 ? -y : y;
  }
}

void interleave(const float* planes, std::size_t stride, std::span<image::PixelFeature> out) {
  const float *l = planes, *a = planes + stride, *b = planes + 2 * stride;
  // No colour of a picture is beyond what a look holds.
  const auto fixed = [](float value) {
    const float units = value * image::PixelFeature::kLab;
    return static_cast<std::int16_t>(static_cast<std::int32_t>(units + (units < 0 ? -0.5f : 0.5f)));
  };
  for (std::size_t x = 0; x < out.size(); ++x) out[x].fixed = {fixed(l[x]), fixed(a[x]), fixed(b[x]), 0};
}

}  // namespace

void smoothColourAndGradient(image::ImageView copy, double sigma, image::EdgeMap& map) {
  const std::size_t width = static_cast<std::size_t>(copy.width);
  const std::size_t count = width * static_cast<std::size_t>(copy.height);
  // Rows are made at hand and then appended: a plane that is filled with zeros first goes through memory twice.
  const auto append = [count](auto& plane, const auto& row) {
    plane.reserve(count);
    plane.insert(plane.end(), row.begin(), row.end());
  };
  map.look.clear();
  map.gradientX.clear();
  map.gradientY.clear();
  std::vector<image::PixelFeature> look(width);
  std::vector<float> gradientX(width), gradientY(width);
  SmoothRows smooth(copy, sigma);
  const std::size_t stride = smooth.stride();
  std::vector<float> kept(3 * smooth.rowLength()), derivatives(2 * kChannels * width);
  const auto rowAt = [&](int y) { return kept.data() + static_cast<std::size_t>(y) % 3 * smooth.rowLength(); };
  Derivatives row{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    row.dx[c] = derivatives.data() + c * width;
    row.dy[c] = derivatives.data() + (kChannels + c) * width;
  }
  smooth.make(0, rowAt(0));
  for (int y = 0; y < copy.height; ++y) {
    const int below = std::min(y + 1, copy.height - 1);
    if (below > y) smooth.make(below, rowAt(below));
    const float *up = rowAt(std::max(0, y - 1)), *here = rowAt(y), *down = rowAt(below);
    interleave(here + 1, stride, look);
    append(map.look, look);
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t at = c * stride + 1;
      sobelRow({up + at, here + at, down + at}, width, derivatives.data() + c * width,
               derivatives.data() + (kChannels + c) * width);
    }
    dominantRow(row, width, gradientX.data(), gradientY.data());
    append(map.gradientX, gradientX);
    append(map.gradientY, gradientY);
  }
}

}  // namespace spineloft::vision
