#include "engine/image/image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/limits.h"

namespace spineloft::image {
namespace {

/// Which source pixels one target pixel covers along an axis, and by how much.
struct Span {
  int first = 0, last = 0;             ///< inclusive
  double firstPart = 1, lastPart = 1;  ///< share of the first and last that is covered, (0, 1]
  double weight(int i) const { return i == first ? firstPart : i == last ? lastPart : 1.0; }
};

std::vector<Span> spansOf(int source, int target) {
  std::vector<Span> spans(static_cast<std::size_t>(target));
  const double step = static_cast<double>(source) / target;
  for (int i = 0; i < target; ++i) {
    const double low = i * step, high = std::min<double>((i + 1) * step, source);
    Span& span = spans[static_cast<std::size_t>(i)];
    span.first = std::clamp(static_cast<int>(std::floor(low)), 0, source - 1);
    span.last = std::clamp(static_cast<int>(std::ceil(high)) - 1, span.first, source - 1);
    if (span.first == span.last) {
      span.firstPart = high - low;
    } else {
      span.firstPart = span.first + 1 - low;
      span.lastPart = high - span.last;
    }
  }
  return spans;
}

std::uint8_t toByte(double value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

/// Sums of one target row: for each target pixel, alpha-weighted red, green, blue, and alpha.
struct RowSums {
  std::vector<double> sums;
  explicit RowSums(int width) : sums(4 * static_cast<std::size_t>(width)) {}
  void clear() { std::fill(sums.begin(), sums.end(), 0.0); }
  void add(const std::uint8_t* row, const std::vector<Span>& columns, double rowWeight) {
    double* out = sums.data();
    for (const Span& column : columns) {
      double r = 0, g = 0, b = 0, a = 0;
      for (int x = column.first; x <= column.last; ++x) {
        const std::uint8_t* pixel = row + 4 * static_cast<std::size_t>(x);
        const double alpha = column.weight(x) * pixel[3];
        r += alpha * pixel[0];
        g += alpha * pixel[1];
        b += alpha * pixel[2];
        a += alpha;
      }
      out[0] += rowWeight * r;
      out[1] += rowWeight * g;
      out[2] += rowWeight * b;
      out[3] += rowWeight * a;
      out += 4;
    }
  }
  void write(std::uint8_t* row, double pixelArea) const {
    for (std::size_t i = 0; i < sums.size(); i += 4) {
      const double alpha = sums[i + 3];
      for (std::size_t c = 0; c < 3; ++c) row[i + c] = alpha > 0 ? toByte(sums[i + c] / alpha) : 0;
      row[i + 3] = toByte(alpha / pixelArea);
    }
  }
};

bool hasAllPixels(ImageView image) {
  return image.width > 0 && image.height > 0 &&
         image.pixels.size() >=
             4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

}  // namespace

Image shrink(ImageView source, int width, int height) {
  if (!hasAllPixels(source) || width < 1 || height < 1 || width > source.width ||
      height > source.height) {
    return {};
  }
  Image out{width, height, {}};
  const std::size_t sourceRow = 4 * static_cast<std::size_t>(source.width);
  if (width == source.width && height == source.height) {
    const std::size_t count = sourceRow * static_cast<std::size_t>(height);
    out.pixels.assign(source.pixels.begin(),
                      source.pixels.begin() + static_cast<std::ptrdiff_t>(count));
    return out;
  }
  const std::size_t targetRow = 4 * static_cast<std::size_t>(width);
  out.pixels.resize(targetRow * static_cast<std::size_t>(height));
  const std::vector<Span> columns = spansOf(source.width, width);
  const std::vector<Span> rows = spansOf(source.height, height);
  const double pixelArea =
      (static_cast<double>(source.width) / width) * (static_cast<double>(source.height) / height);
  RowSums sums(width);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    sums.clear();
    for (int sy = rows[y].first; sy <= rows[y].last; ++sy) {
      sums.add(source.pixels.data() + sourceRow * static_cast<std::size_t>(sy), columns,
               rows[y].weight(sy));
    }
    sums.write(out.pixels.data() + targetRow * y, pixelArea);
  }
  return out;
}

Size fitSize(Size original, long long maxPixels, int maxSide) {
  if (original.width < 1 || original.height < 1) return {0, 0};
  const double w = original.width, h = original.height;
  const double pixels = static_cast<double>(std::max(1LL, maxPixels));
  const double scale =
      std::min({1.0, std::max(1, maxSide) / std::max(w, h), std::sqrt(pixels / (w * h))});
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
  const bool mirrorX =
      exifOrientation == 2 || exifOrientation == 3 || exifOrientation == 7 || exifOrientation == 8;
  const bool mirrorY =
      exifOrientation == 3 || exifOrientation == 4 || exifOrientation == 6 || exifOrientation == 7;
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int u = swapped ? y : x, v = swapped ? x : y;
      const int sx = mirrorX ? w - 1 - u : u, sy = mirrorY ? h - 1 - v : v;
      const auto index = [](int column, int row, int width) {
        return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column));
      };
      std::copy_n(stored.pixels.data() + index(sx, sy, w), 4,
                  out.pixels.data() + index(x, y, out.width));
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
  Picture picture{orient(shrink(decoded, fit.width, fit.height), exifOrientation), decoded.width,
                  decoded.height};
  if (exifOrientation >= 5 && exifOrientation <= 8) std::swap(picture.width, picture.height);
  return picture;
}

}  // namespace spineloft::image
