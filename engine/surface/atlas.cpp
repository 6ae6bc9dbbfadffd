#include "engine/surface/atlas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spineloft::surface {
namespace {

/// A picture of the atlas: its size as packed and the corner where it lies, without padding.
struct Tile {
  const image::Image* picture = nullptr;
  image::Size size;
  int x = 0, y = 0;
};

int padded(int side) { return side + 2 * kAtlasPadding; }

/// Puts the tiles, tallest first, on shelves of this width; returns the height that they take.
int shelve(std::vector<Tile>& tiles, int width) {
  int x = 0, y = 0, tallest = 0;
  for (Tile& tile : tiles) {
    if (x > 0 && x + padded(tile.size.width) > width) {
      y += tallest;
      x = tallest = 0;
    }
    tile.x = x + kAtlasPadding;
    tile.y = y + kAtlasPadding;
    x += padded(tile.size.width);
    tallest = std::max(tallest, padded(tile.size.height));
  }
  return y + tallest;
}

/// Sizes and places at this scale; the atlas' size, or none when that is too large.
std::optional<image::Size> arrange(std::vector<Tile>& tiles, double scale, int mostSide) {
  double area = 0;
  int widest = 0;
  for (Tile& tile : tiles) {
    const auto scaled = [&](int side) { return std::clamp(static_cast<int>(std::lround(side * scale)), 1, side); };
    tile.size = {scaled(tile.picture->width), scaled(tile.picture->height)};
    area += static_cast<double>(padded(tile.size.width)) * padded(tile.size.height);
    widest = std::max(widest, padded(tile.size.width));
  }
  std::ranges::stable_sort(tiles, [](const Tile& a, const Tile& b) {
    return a.size.height != b.size.height ? a.size.height > b.size.height : a.size.width > b.size.width;
  });
  if (widest > mostSide || area > static_cast<double>(mostSide) * mostSide) return std::nullopt;
  for (int width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(area))));;) {
    width = std::min(width, mostSide);
    const int height = shelve(tiles, width);
    if (height <= mostSide && (height <= 2 * width || width == mostSide)) {
      const auto even = [&](int side) { return std::min(mostSide, (side + kAtlasStep - 1) / kAtlasStep * kAtlasStep); };
      return image::Size{even(width), even(height)};
    }
    if (width == mostSide) return std::nullopt;
    width += width / 4 + 1;
  }
}

/// Copies the tile with its edge repeated around it.
void draw(const Tile& tile, image::Image& atlas) {
  const image::Size own{tile.picture->width, tile.picture->height};
  image::Image shrunk;
  if (tile.size != own) shrunk = image::shrink(*tile.picture, tile.size.width, tile.size.height);
  const image::Image& from = tile.size != own ? shrunk : *tile.picture;
  for (int y = -kAtlasPadding; y < tile.size.height + kAtlasPadding; ++y) {
    for (int x = -kAtlasPadding; x < tile.size.width + kAtlasPadding; ++x) {
      const auto fx = static_cast<std::ptrdiff_t>(std::clamp(x, 0, tile.size.width - 1));
      const auto fy = static_cast<std::ptrdiff_t>(std::clamp(y, 0, tile.size.height - 1));
      const auto source = from.pixels.begin() + 4 * (fy * tile.size.width + fx);
      const auto target =
          atlas.pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(tile.y + y) * atlas.width + (tile.x + x));
      std::copy(source, source + 4, target);
    }
  }
}

}  // namespace

std::optional<Atlas> packAtlas(std::span<const image::Image* const> pictures, int mostSide) {
  std::vector<Tile> tiles;
  for (const image::Image* picture : pictures) {
    if (picture == nullptr || picture->empty()) return std::nullopt;
    if (std::ranges::find(tiles, picture, &Tile::picture) == tiles.end()) tiles.push_back({picture, {}, 0, 0});
  }
  if (tiles.empty()) return std::nullopt;
  std::optional<image::Size> size;
  constexpr double kStep = 0.92, kSmallest = 1e-4;
  for (double scale = 1; !size && scale > kSmallest; scale *= kStep) size = arrange(tiles, scale, mostSide);
  if (!size) return std::nullopt;
  Atlas out;
  out.pixels.width = size->width;
  out.pixels.height = size->height;
  out.pixels.pixels.assign(4 * static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height), 255);
  for (const Tile& tile : tiles) draw(tile, out.pixels);
  const double width = size->width, height = size->height;
  for (const image::Image* picture : pictures) {
    const Tile& tile = *std::ranges::find(tiles, picture, &Tile::picture);
    out.places.push_back(
        {tile.x / width, tile.y / height, (tile.x + tile.size.width) / width, (tile.y + tile.size.height) / height});
  }
  return out;
}

}  // namespace spineloft::surface
