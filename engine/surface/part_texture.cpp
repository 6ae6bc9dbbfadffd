#include "engine/surface/part_texture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/surface/bleed.h"
#include "engine/surface/raster.h"

namespace spineloft::surface {
namespace {

/// Pixels around what is covered: what the part stands before, and room for filters.
constexpr int kBorder = 24;

/// Whole pixels of a picture, the last ones excluded.
struct Cut {
  int left = 0, top = 0, right = 0, bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

std::optional<Cut> cutOf(const image::Image& picture, const Wrapped& surface) {
  double left = 1, top = 1, right = 0, bottom = 0;
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle) {
      const double x = static_cast<double>(surface.uv[v][0]), y = static_cast<double>(surface.uv[v][1]);
      if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  if (!(left <= right && top <= bottom)) return std::nullopt;
  const auto low = [](double share, int side) {
    return std::max(0, static_cast<int>(std::floor(share * side)) - kBorder);
  };
  const auto high = [](double share, int side) {
    return std::min(side, static_cast<int>(std::ceil(share * side)) + kBorder);
  };
  return Cut{low(left, picture.width), low(top, picture.height), high(right, picture.width),
             high(bottom, picture.height)};
}

image::Image cutOut(const image::Image& picture, const Cut& cut) {
  image::Image out{cut.width(), cut.height(), {}};
  const auto row = static_cast<std::ptrdiff_t>(4) * cut.width();
  out.pixels.reserve(static_cast<std::size_t>(row) * static_cast<std::size_t>(cut.height()));
  for (int y = cut.top; y < cut.bottom; ++y) {
    const auto first =
        picture.pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * picture.width + cut.left);
    out.pixels.insert(out.pixels.end(), first, first + row);
  }
  return out;
}

/// From the picture's UV to pixels of the texture, centres at integers.
class ToTexture {
 public:
  ToTexture(const UvArea& area, const image::Image& texture)
      : area_(area),
        perU_(texture.width / (area.right - area.left)),
        perV_(texture.height / (area.bottom - area.top)) {}
  PicturePoint operator()(double u, double v) const {
    return {(u - area_.left) * perU_ - 0.5, (v - area_.top) * perV_ - 0.5};
  }

 private:
  UvArea area_;
  double perU_, perV_;
};

image::Mask emptyMask(const image::Image& like) {
  image::Mask mask{like.width, like.height, {}};
  mask.pixels.assign(like.pixels.size() / 4, 0);
  return mask;
}

image::Mask coverOf(const Wrapped& surface, const ToTexture& toTexture, const image::Image& texture) {
  image::Mask mask = emptyMask(texture);
  const auto at = [&](std::uint32_t v) {
    return toTexture(static_cast<double>(surface.uv[v][0]), static_cast<double>(surface.uv[v][1]));
  };
  for (const auto& t : surface.triangles) {
    const std::array<PicturePoint, 3> corners = {at(t[0]), at(t[1]), at(t[2])};
    if (isFinite(corners[0]) && isFinite(corners[1]) && isFinite(corners[2])) {
      coverTriangle(corners, mask);
    }
  }
  if (std::ranges::find(mask.pixels, std::uint8_t{255}) != mask.pixels.end()) return mask;
  // Thinner than the raster: then the pixels that it passes.
  for (const auto& t : surface.triangles) {
    for (const std::uint32_t v : t) {
      const PicturePoint p = at(v);
      if (!isFinite(p)) continue;
      const auto x = static_cast<std::size_t>(std::clamp(p.x + 0.5, 0.0, mask.width - 1.0));
      const auto y = static_cast<std::size_t>(std::clamp(p.y + 0.5, 0.0, mask.height - 1.0));
      mask.pixels[y * static_cast<std::size_t>(mask.width) + x] = 255;
    }
  }
  return mask;
}

/// Where the part is sure. A fan covers each polygon.
image::Mask sureOf(const Wrapped& surface, const ToTexture& toTexture, const image::Image& texture) {
  image::Mask sure = emptyMask(texture);
  for (const std::vector<PicturePoint>& polygon : surface.sure) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array<PicturePoint, 3> corners = {toTexture(polygon[0].x, polygon[0].y),
                                                   toTexture(polygon[i - 1].x, polygon[i - 1].y),
                                                   toTexture(polygon[i].x, polygon[i].y)};
      if (isFinite(corners[0]) && isFinite(corners[1]) && isFinite(corners[2])) {
        coverTriangle(corners, sure);
      }
    }
  }
  return sure;
}

int apartness(const std::uint8_t* a, const std::uint8_t* b) {
  int apart = 0;
  for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(a[c] - b[c]));
  return apart;
}

/// 0 where what is around the part goes on within it: from its outline inwards over pixels that are not
/// `sure`, do not look like the part there (`in`: its colours carried on), and differ little from one
/// to the next. 255 elsewhere. Channels that differ most decide, of 255.
image::Mask familiarOf(const image::Image& shown, const image::Mask& covered, const image::Mask& sure,
                       const image::Image& in) {
  constexpr int kUnlike = 56, kAlike = 28;
  const int width = shown.width, height = shown.height;
  image::Mask familiar = covered;
  std::ranges::fill(familiar.pixels, std::uint8_t{255});
  std::vector<std::size_t> front, next;
  const auto look = [&](std::size_t from, std::vector<std::size_t>& to) {
    const int x = static_cast<int>(from % static_cast<std::size_t>(width));
    const int y = static_cast<int>(from / static_cast<std::size_t>(width));
    const auto visit = [&](bool exists, std::size_t at) {
      if (!exists || covered.pixels[at] == 0 || sure.pixels[at] != 0 || familiar.pixels[at] == 0) return;
      const std::uint8_t* pixel = &shown.pixels[4 * at];
      if (apartness(pixel, &shown.pixels[4 * from]) > kAlike) return;
      if (apartness(pixel, &in.pixels[4 * at]) <= kUnlike) return;
      familiar.pixels[at] = 0;
      to.push_back(at);
    };
    visit(x > 0, from - 1);
    visit(x + 1 < width, from + 1);
    visit(y > 0, from - static_cast<std::size_t>(width));
    visit(y + 1 < height, from + static_cast<std::size_t>(width));
  };
  for (std::size_t i = 0; i < covered.pixels.size(); ++i) {
    if (covered.pixels[i] == 0) look(i, front);
  }
  while (!front.empty()) {
    next.clear();
    for (const std::size_t i : front) look(i, next);
    std::swap(front, next);
  }
  return familiar;
}

/// `a` where `b` is inside too.
image::Mask common(image::Mask a, const image::Mask& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (b.pixels[i] == 0) a.pixels[i] = 0;
  }
  return a;
}

/// The texture's pixels; empty when nothing can be seen.
image::Image paint(const image::Image& shown, const image::Mask& covered, const image::Mask& sure,
                   double margin) {
  const image::Mask inner = trusted(covered, margin);
  if (inner == common(inner, sure)) {
    image::Image filled = bleed(shown, inner);
    return filled.empty() ? bleed(shown, covered) : filled;
  }
  const image::Image in = bleed(shown, common(inner, sure));
  if (in.empty()) return paint(shown, covered, covered, margin);
  // What is mixed with the foreign pixels goes with them.
  const image::Mask familiar = inset(familiarOf(shown, covered, sure, in), margin);
  return bleed(shown, common(inner, familiar));
}

}  // namespace

std::optional<PartTexture> partTexture(const image::Image& picture, const Wrapped& surface) {
  if (picture.empty()) return std::nullopt;
  const std::optional<Cut> cut = cutOf(picture, surface);
  if (!cut) return std::nullopt;
  image::Image shown = cutOut(picture, *cut);
  const image::Size size = image::fitSize({shown.width, shown.height}, kTexturePixels, 4096);
  if (size != image::Size{shown.width, shown.height}) {
    shown = image::shrink(shown, size.width, size.height);
  }
  const double width = picture.width, height = picture.height;
  PartTexture out;
  out.area = {cut->left / width, cut->top / height, cut->right / width, cut->bottom / height};
  const ToTexture toTexture(out.area, shown);
  const image::Mask covered = coverOf(surface, toTexture, shown);
  image::Mask sure = covered;
  if (!surface.sure.empty()) sure = sureOf(surface, toTexture, shown);
  out.pixels = paint(shown, covered, sure, rimMargin(std::max(picture.width, picture.height)));
  if (out.pixels.empty()) return std::nullopt;
  return out;
}

}  // namespace spineloft::surface
