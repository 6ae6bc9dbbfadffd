#include "engine/image/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/base/limits.h"

namespace spineloft::image {
namespace {

/// Which source pixels one target pixel covers along an axis, and by how much, in whole parts of a
/// source pixel (there are as many parts as make all borders fall between two of them).
struct Span {
  int first = 0, last = 0;  ///< inclusive
  std::uint32_t firstParts = 1, lastParts = 1;
};
struct Axis {
  std::vector<Span> spans;   ///< one for each target pixel
  std::uint32_t inside = 1;  ///< parts of a source pixel
  std::uint32_t total = 1;   ///< parts of a target pixel
  std::uint32_t partsOf(const Span& span, int i) const {
    return i == span.first ? span.firstParts : i == span.last ? span.lastParts : inside;
  }
};

Axis axisOf(int source, int target) {
  const int common = std::gcd(source, target);
  Axis axis{{}, static_cast<std::uint32_t>(target / common), static_cast<std::uint32_t>(source / common)};
  axis.spans.reserve(static_cast<std::size_t>(target));
  const long long inside = axis.inside, total = axis.total;
  for (long long i = 0; i < target; ++i) {
    const long long low = i * total, high = low + total, first = low / inside, last = (high - 1) / inside;
    axis.spans.push_back({static_cast<int>(first), static_cast<int>(last),
                          static_cast<std::uint32_t>(std::min(high, (first + 1) * inside) - low),
                          static_cast<std::uint32_t>(first == last ? high - low : high - last * inside)});
  }
  return axis;
}

bool isOpaque(const std::uint8_t* row, std::size_t width) {
  std::uint8_t all = 255;
  for (std::size_t x = 0; x < width; ++x) all &= row[4 * x + 3];
  return all == 255;
}

/// One target row, summed exactly in whole numbers: first down the columns of the source, where
/// rows lie one after the other for SIMD, then along them.
class RowSums {
 public:
  /// `widest` source columns.
  explicit RowSums(std::size_t widest) : sums_(4 * widest), weighted_(4 * widest) {}

  /// Red, green and blue, times alpha unless all that is added is opaque, and alpha times 255.
  void clear(bool opaque) {
    opaque_ = opaque;
    std::fill(sums_.begin(), sums_.end(), 0u);
  }
  void add(const std::uint8_t* row, std::uint32_t parts) {
    const std::size_t count = sums_.size();
    std::uint32_t* __restrict sums = sums_.data();
    const std::uint16_t weight = static_cast<std::uint16_t>(parts);
    if (opaque_) {
      for (std::size_t i = 0; i < count; ++i) sums[i] += static_cast<std::uint32_t>(weight) * row[i];
      return;
    }
    std::uint16_t* __restrict weighted = weighted_.data();
    for (std::size_t i = 0; i < count; i += 4) {
      const std::uint32_t alpha = row[i + 3];
      for (std::size_t c = 0; c < 3; ++c) {
        weighted[i + c] = static_cast<std::uint16_t>(alpha * row[i + c]);
      }
      weighted[i + 3] = static_cast<std::uint16_t>(255 * alpha);
    }
    for (std::size_t i = 0; i < count; ++i) {
      sums[i] += static_cast<std::uint32_t>(weight) * weighted[i];
    }
  }
  /// `area` is that of a target pixel in parts.
  void write(const Axis& columns, double area, std::uint8_t* out) const {
    for (const Span& span : columns.spans) {
      std::array<std::uint64_t, 4> sum{};
      for (int x = span.first; x <= span.last; ++x) {
        const std::uint64_t parts = columns.partsOf(span, x);
        const std::uint32_t* pixel = sums_.data() + 4 * static_cast<std::size_t>(x);
        for (std::size_t c = 0; c < 4; ++c) sum[c] += parts * pixel[c];
      }
      writePixel(sum, area, out);
      out += 4;
    }
  }

 private:
  static std::uint8_t toByte(double value) { return static_cast<std::uint8_t>(value + 0.5); }
  void writePixel(const std::array<std::uint64_t, 4>& sum, double area, std::uint8_t* out) const {
    // Sums stay below 2⁵³, so they are exact as doubles.
    const double alpha = static_cast<double>(sum[3]) / 255;
    const double scale = opaque_ ? 1 / area : alpha > 0 ? 1 / alpha : 0;
    for (std::size_t c = 0; c < 3; ++c) out[c] = toByte(static_cast<double>(sum[c]) * scale);
    out[3] = opaque_ ? std::uint8_t{255} : toByte(alpha / area);
  }

  bool opaque_ = true;
  std::vector<std::uint32_t> sums_;
  std::vector<std::uint16_t> weighted_;  ///< one row times its alpha
};

bool hasAllPixels(ImageView image) {
  return image.width > 0 && image.height > 0 &&
         image.pixels.size() >= 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

}  // namespace

Image shrink(ImageView source, int width, int height) {
  if (!hasAllPixels(source) || width < 1 || height < 1 || width > source.width || height > source.height) {
    return {};
  }
  Image out{width, height, {}};
  const std::size_t sourceRow = 4 * static_cast<std::size_t>(source.width);
  if (width == source.width && height == source.height) {
    const std::size_t count = sourceRow * static_cast<std::size_t>(height);
    out.pixels.assign(source.pixels.begin(), source.pixels.begin() + static_cast<std::ptrdiff_t>(count));
    return out;
  }
  const std::size_t targetRow = 4 * static_cast<std::size_t>(width);
  out.pixels.resize(targetRow * static_cast<std::size_t>(height));
  const Axis columns = axisOf(source.width, width), rows = axisOf(source.height, height);
  const double area = static_cast<double>(columns.total) * rows.total;
  RowSums sums(static_cast<std::size_t>(source.width));
  std::uint8_t* target = out.pixels.data();
  for (const Span& span : rows.spans) {
    const auto rowAt = [&](int y) { return source.pixels.data() + sourceRow * static_cast<std::size_t>(y); };
    bool opaque = true;
    for (int y = span.first; y <= span.last && opaque; ++y) {
      opaque = isOpaque(rowAt(y), static_cast<std::size_t>(source.width));
    }
    sums.clear(opaque);
    for (int y = span.first; y <= span.last; ++y) sums.add(rowAt(y), rows.partsOf(span, y));
    sums.write(columns, area, target);
    target += targetRow;
  }
  return out;
}

Size fitSize(Size original, long long maxPixels, int maxSide) {
  if (original.width < 1 || original.height < 1) return {0, 0};
  const double w = original.width, h = original.height;
  const double pixels = static_cast<double>(std::max(1LL, maxPixels));
  const double scale = std::min({1.0, std::max(1, maxSide) / std::max(w, h), std::sqrt(pixels / (w * h))});
  Size fit{std::max(1, static_cast<int>(std::lround(w * scale))),
           std::max(1, static_cast<int>(std::lround(h * scale)))};
  // A side that had to become 1 leaves less for the other; rounding up may be a row too many.
  if (static_cast<double>(fit.width) * fit.height > pixels) {
    if (fit.width == 1 || fit.height == 1) {
      const int side = static_cast<int>(std::min(pixels, 1.0 * std::max(fit.width, fit.height)));
      (fit.width == 1 ? fit.height : fit.width) = side;
    } else {
      fit = {static_cast<int>(w * scale), static_cast<int>(h * scale)};
    }
  }
  return fit;
}

Image orient(Image stored, int exifOrientation) {
  if (exifOrientation < 2 || exifOrientation > 8 || !hasAllPixels(stored)) return stored;
  const bool swapped = exifOrientation >= 5;
  const int w = stored.width, h = stored.height;
  Image out{swapped ? h : w, swapped ? w : h, std::vector<std::uint8_t>(stored.pixels.size())};
  // EXIF 2.3, tag 0x112: which side of the scene the stored row 0 and column 0 are.
  const bool mirrorX = exifOrientation == 2 || exifOrientation == 3 || exifOrientation == 7 || exifOrientation == 8;
  const bool mirrorY = exifOrientation == 3 || exifOrientation == 4 || exifOrientation == 6 || exifOrientation == 7;
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int u = swapped ? y : x, v = swapped ? x : y;
      const int sx = mirrorX ? w - 1 - u : u, sy = mirrorY ? h - 1 - v : v;
      const auto index = [](int column, int row, int width) {
        return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
      };
      std::copy_n(stored.pixels.data() + index(sx, sy, w), 4, out.pixels.data() + index(x, y, out.width));
    }
  }
  return out;
}

Picture makePicture(Image decoded) {
  const Size size{decoded.width, decoded.height};
  const Size fit = fitSize(size, kWorkingPixels, kMaxPictureSide);
  if (fit != size || !hasAllPixels(decoded)) return makePicture(ImageView(decoded), 1);
  return {std::move(decoded), size.width, size.height};
}

Picture makePicture(ImageView decoded, int exifOrientation) {
  if (!hasAllPixels(decoded)) return {};
  const Size fit = fitSize({decoded.width, decoded.height}, kWorkingPixels, kMaxPictureSide);
  Picture picture{orient(shrink(decoded, fit.width, fit.height), exifOrientation), decoded.width, decoded.height};
  if (exifOrientation >= 5 && exifOrientation <= 8) std::swap(picture.width, picture.height);
  return picture;
}

}  // namespace spineloft::image
