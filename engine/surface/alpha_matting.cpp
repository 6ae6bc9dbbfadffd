#include "engine/surface/alpha_matting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/surface/edge_padding.h"

namespace spineloft::surface {
namespace {

/// A share of the ground that shows; and how far apart two colours are, of 255 a channel, that one is told from the
/// other by.
constexpr float kShows = 0.07f, kAlike = 40;

using Triple = std::array<float, 3>;
/// Symmetric: xx, xy, xz, yy, yz, zz.
using Spread = std::array<float, 6>;

float along(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple times(const Spread& m, const Triple& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}
/// Of a positive definite one.
Spread inverse(const Spread& m) {
  const float xx = m[3] * m[5] - m[4] * m[4], xy = m[2] * m[4] - m[1] * m[5], xz = m[1] * m[4] - m[2] * m[3];
  const float by = 1 / (m[0] * xx + m[1] * xy + m[2] * xz);
  return {xx * by,
          xy * by,
          xz * by,
          (m[0] * m[5] - m[2] * m[2]) * by,
          (m[1] * m[2] - m[0] * m[4]) * by,
          (m[0] * m[3] - m[1] * m[1]) * by};
}
/// a · s + b · t + noise.
Spread mixed(const Spread& a, float s, const Spread& b, float t) {
  constexpr float kNoise = 9;  // of a camera, squared
  Spread out;
  for (std::size_t k = 0; k < 6; ++k) out[k] = a[k] * s + b[k] * t;
  for (const std::size_t k : {0, 3, 5}) out[k] += kNoise;
  return out;
}

/// Colours of some pixels, summed up.
struct Sum {
  float count = 0;
  Triple colour{};
  Spread square{};
  void add(const std::uint8_t* p) {
    const Triple c = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
    count += 1;
    for (std::size_t k = 0; k < 3; ++k) colour[k] += c[k];
    std::size_t at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = k; l < 3; ++l) square[at++] += c[k] * c[l];
    }
  }
  void add(const Sum& other) {
    count += other.count;
    for (std::size_t k = 0; k < 3; ++k) colour[k] += other.colour[k];
    for (std::size_t k = 0; k < 6; ++k) square[k] += other.square[k];
  }
  /// Covariance; a wide one where few were counted.
  Spread spread() const {
    constexpr float kFew = 12, kWide = 900;
    Spread out{};
    const float all = std::max(count, 1.0f);
    std::size_t at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = k; l < 3; ++l, ++at) out[at] = square[at] / all - colour[k] * colour[l] / (all * all);
    }
    for (const std::size_t k : {0, 3, 5}) out[k] = std::max(out[k], 0.0f) + kWide * kFew / (kFew + count);
    return out;
  }
};

/// Squares of pixels, four times as wide as a crisp rim is deep.
struct Tiles {
  int half, side, width, height, columns, rows;
  Tiles(const image::Mask& mask, double margin)
      : half(static_cast<int>(2 * margin)),
        side(2 * half),
        width(mask.width),
        height(mask.height),
        columns((width + side - 1) / side),
        rows((height + side - 1) / side) {}
  std::size_t count() const { return indexOf(0, rows); }
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  int columnOf(std::size_t tile) const { return static_cast<int>(tile % static_cast<std::size_t>(columns)); }
  int rowOf(std::size_t tile) const { return static_cast<int>(tile / static_cast<std::size_t>(columns)); }
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  /// Places of its pixels, every `step`th each way.
  template <class Visit>
  void forPixels(std::size_t tile, int step, const Visit& visit) const {
    const int left = columnOf(tile) * side, top = rowOf(tile) * side;
    for (int y = top; y < std::min(top + side, height); y += step) {
      for (int x = left; x < std::min(left + side, width); x += step) visit(pixel(x, y));
    }
  }
  /// Those up to `far` away from one, itself too.
  template <class Visit>
  void forNear(std::size_t tile, int far, const Visit& visit) const {
    const int column = columnOf(tile), row = rowOf(tile);
    for (int y = std::max(0, row - far); y <= std::min(rows - 1, row + far); ++y) {
      for (int x = std::max(0, column - far); x <= std::min(columns - 1, column + far); ++x) visit(indexOf(x, y));
    }
  }
};
/// Tiles that count as one stretch of the rim with the one in their middle, to either side.
constexpr int kNear = 2;

/// Of each pixel the common part of what `join` makes of it with each of the four beside it, and `corner` with each
/// of the four aslant; beyond the borders all is as at them.
template <class Join, class Corner>
void joinBeside(const image::Mask& from, std::vector<std::uint8_t>& to, const Join& join, const Corner& corner) {
  const auto width = static_cast<std::size_t>(from.width), height = static_cast<std::size_t>(from.height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* row = from.pixels.data() + y * width;
    const std::uint8_t* above = y > 0 ? row - width : row;
    const std::uint8_t* below = y + 1 < height ? row + width : row;
    std::uint8_t* out = to.data() + y * width;
    const auto at = [&](std::size_t x, std::size_t before, std::size_t after) {
      const int own = row[x];
      const int straight = join(own, row[before]) & join(own, row[after]) & join(own, above[x]) & join(own, below[x]);
      const int aslant = corner(own, above[before]) & corner(own, above[after]) & corner(own, below[before]) &
                         corner(own, below[after]);
      out[x] = static_cast<std::uint8_t>(straight & aslant);
    };
    at(0, 0, std::min<std::size_t>(1, width - 1));
    for (std::size_t x = 1; x + 1 < width; ++x) at(x, x - 1, x + 1);
    if (width > 1) at(width - 1, width - 2, width - 1);
  }
}

/// How deep each pixel is inside the mask, whole px: 0 at the outline, at most `most`; outside −1 and less, as far.
std::vector<std::int8_t> depthsOf(const image::Mask& mask, int most) {
  std::vector<std::int8_t> depths(mask.pixels.size());
  std::vector<std::uint8_t> to(mask.pixels.size());
  if (to.empty()) return depths;
  // Away from the outline, on both sides of it at once: from the second step on they are apart.
  image::Mask away = mask;
  const auto same = [](int a, int b) { return ~(a ^ b); };
  const auto both = [](int a, int b) { return a & b; };
  const auto all = [](int, int) { return 255; };
  for (int k = 0; k < most; ++k) {
    // By turns the four and the eight pixels around: about as far in all directions.
    if (k == 0) {
      joinBeside(away, to, same, all);
    } else if (k % 2 == 0) {
      joinBeside(away, to, both, all);
    } else {
      joinBeside(away, to, both, both);
    }
    away.pixels.swap(to);
    for (std::size_t i = 0; i < depths.size(); ++i)
      depths[i] = static_cast<std::int8_t>(depths[i] + (away.pixels[i] & 1));
  }
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (mask.pixels[i] == 0) depths[i] = static_cast<std::int8_t>(-1 - depths[i]);
  }
  return depths;
}

/// The colours on one side of the rim: a mean that changes from tile to tile, and how they scatter.
class Side {
 public:
  /// Of the pixels of `allowed`: `far` px and more from the rim, or half as far as any is near by. `depthOf`: of a
  /// pixel, px from the rim. Only those of the tiles that are `wanted` are looked at.
  template <class DepthOf>
  Side(const image::Image& shown, const Tiles& tiles, const std::vector<bool>& wanted, const image::Mask& allowed,
       int far, const DepthOf& depthOf)
      : tiles_(tiles), sums_(tiles.count()) {
    constexpr int kStep = 2;
    constexpr float kFew = 4;
    std::vector<int> farthest(tiles.count());
    for (std::size_t t = 0; t < sums_.size(); ++t) {
      if (wanted[t])
        tiles.forPixels(t, kStep, [&](std::size_t i) { farthest[t] = std::max<int>(farthest[t], depthOf(i)); });
    }
    image::Image means{tiles.columns, tiles.rows, {}};
    image::Mask known{tiles.columns, tiles.rows, {}};
    for (std::size_t t = 0; t < sums_.size(); ++t) {
      if (wanted[t]) {
        int most = 0;
        tiles.forNear(t, kNear, [&](std::size_t other) { most = std::max(most, farthest[other]); });
        const int least = std::max(1, std::min(far, most / 2));
        tiles.forPixels(t, kStep, [&](std::size_t i) {
          const std::uint8_t* p = &shown.pixels[4 * i];
          if (depthOf(i) >= least && allowed.pixels[i] != 0 && p[3] >= 128) sums_[t].add(p);
        });
      }
      const float all = std::max(sums_[t].count, 1.0f);
      for (const float c : sums_[t].colour) means.pixels.push_back(static_cast<std::uint8_t>(c / all + 0.5f));
      means.pixels.push_back(255);
      known.pixels.push_back(sums_[t].count >= kFew ? 255 : 0);
    }
    means = padEdges(means, known);
    for (std::size_t i = 0; i < means.pixels.size(); i += 4) {
      const auto c = [&](std::size_t k) { return static_cast<float>(means.pixels[i + k]); };
      means_.push_back({c(0), c(1), c(2)});
    }
  }
  bool empty() const { return means_.empty(); }
  const Triple& mean(std::size_t tile) const { return means_[tile]; }
  Spread spread(std::size_t tile) const {
    Sum sum;
    tiles_.forNear(tile, kNear, [&](std::size_t other) { sum.add(sums_[other]); });
    return sum.spread();
  }

 private:
  const Tiles& tiles_;
  std::vector<Sum> sums_;
  std::vector<Triple> means_;
};

/// How a tile tells the part from the ground: share = along(w, colour) − offset.
struct Telling {
  Triple w{};
  float offset = 0;
  float certainty = 0;  ///< 1 / variance of the share; 0 where nothing tells
  Spread in{}, out{};
};

/// What is known of a piece of the rim.
struct Stretch {
  static constexpr int kMost = 32;                 // px to either side of the outline
  std::array<float, 2 * kMost> share{}, weight{};  ///< of the ground at each depth, inside from kMost on
  float squares = 0, cubes = 0;                    ///< of how fast the share sinks, per px

  static std::size_t index(int depth) { return static_cast<std::size_t>(depth + kMost); }
  void addShare(int depth, float what, float certainty) {
    const std::size_t k = index(depth);
    share[k] += what * certainty, weight[k] += certainty;
  }
  void addSlope(float slope, float certainty) {
    squares += certainty * slope * slope, cubes += certainty * slope * slope * slope;
  }
  void add(const Stretch& other, int reach) {
    for (std::size_t k = index(-reach); k < index(reach); ++k) share[k] += other.share[k], weight[k] += other.weight[k];
    squares += other.squares, cubes += other.cubes;
  }
  /// Mean share of the ground; not a number where nothing tells.
  float at(int depth) const {
    const std::size_t k = index(depth);
    return weight[k] > 0 ? share[k] / weight[k] : std::numeric_limits<float>::quiet_NaN();
  }
  /// Over how many pixels the ground goes over into the part where it does so fastest, about. Shade and shine
  /// well inside, and an outline that is a little off, hardly count.
  float width() const { return cubes > 0 ? squares / cubes : 0; }
  /// How deep the ground is mixed in, px: to where its share is next to nothing, and about as far within the
  /// middle of the change as without. 0 when it does not sink so.
  float depth(int reach) const {
    constexpr float kMostly = 0.85f, kHalf = 0.5f, kLittle = 0.15f, kRise = 0.03f;
    int out = 1;
    while (out < reach && !(at(-out) >= kMostly)) ++out;
    int middle = -out;
    while (middle < reach / 2 && !(at(middle) < kHalf)) ++middle;
    int end = middle;
    while (end + 1 < reach && at(end) > kShows && (end == middle || at(end) <= at(end - 1) + kRise)) ++end;
    return at(end) <= kLittle ? static_cast<float>(std::min(end, 2 * middle + out)) : 0;
  }
  /// How deep a crisp rim is mixed, px: to where the share goes on as further in, for a thing may be shaded towards its
  /// rim; and not deeper within the middle of the change than without, for what mixes reaches as far to both sides.
  float crispDepth(int reach) const {
    constexpr float kMostly = 0.85f, kHalf = 0.5f, kMore = 0.03f;
    int out = 1;
    while (out < reach && !(at(-out) >= kMostly)) ++out;
    int middle = 1 - out;
    while (middle < reach / 2 && !(at(middle) < kHalf)) ++middle;
    if (out == reach || middle == reach / 2) return 0;
    const int most = std::min(2 * middle + out, reach - 1);
    int end = std::max(middle, 0);
    while (end < most && at(end) - ownAt(end, reach) > kMore) ++end;
    return static_cast<float>(end);
  }
  /// The share at a depth if it goes on to there as it does a little further in.
  float ownAt(int depth, int reach) const {
    constexpr int kPast = 2, kOver = 3;
    const int first = std::min(depth + kPast, reach - 2), last = std::min(first + kOver, reach - 1);
    const float slope = (at(first) - at(last)) / static_cast<float>(last - first);
    return at(first) + std::max(0.0f, slope) * static_cast<float>(first - depth);
  }
};

struct RimPixel {
  std::size_t at, tile;
  int x, y, depth;         ///< px from the outline, inside from 0 on
  float share, certainty;  ///< of the ground; 1 / variance
};

class SoftRim {
 public:
  SoftRim(const image::Image& shown, const image::Mask& region, const image::Mask& inner, double margin, double reach)
      : margin_(static_cast<float>(margin)),
        reach_(std::min(static_cast<int>(reach), Stretch::kMost)),
        tiles_(region, margin),
        depths_(depthsOf(region, reach_)),
        rimTiles_(tiles_.count()),
        near_(nearRim()),
        in_(shown, tiles_, near_, inner, reach_, [&](std::size_t i) { return depths_[i]; }),
        out_(shown, tiles_, near_, opposite(region), reach_, [&](std::size_t i) { return -1 - depths_[i]; }) {
    if (!in_.empty() && !out_.empty()) learn();
  }
  SoftRim(const SoftRim&) = delete;  // its sides know its tiles
  SoftRim& operator=(const SoftRim&) = delete;

  bool change(image::Image& shown, image::Mask& inner) {
    if (in_.empty() || out_.empty()) return false;
    shares_.assign(depths_.size(), std::numeric_limits<float>::quiet_NaN());
    forRimTiles([&](std::size_t tile) { survey(shown, tile); });
    addSlopes();
    gather();
    bool any = false;
    for (const RimPixel& p : rim_) {
      if (p.depth < 0) continue;
      if (static_cast<float>(p.depth) < soft_[p.tile]) {
        any = purify(p, shown, inner) || any;
      } else if (static_cast<float>(p.depth) < crisp_[p.tile] && inner.pixels[p.at] != 0) {
        inner.pixels[p.at] = 0, any = true;
      }
    }
    return any;
  }
  Untold untold(const image::Image& shown) const {
    const auto areAlike = [](const Triple& a, const Triple& b) {
      const Triple step = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      return along(step, step) < kAlike * kAlike;
    };
    Untold out{{tiles_.width, tiles_.height, std::vector<std::uint8_t>(depths_.size())}, {}};
    out.drawn = out.alike;
    for (const RimPixel& p : rim_) {
      if (p.depth < 0) continue;
      const Triple own = meanAt(in_, p);
      if (!areAlike(own, meanAt(out_, p))) continue;
      const std::uint8_t* pixel = &shown.pixels[4 * p.at];
      const Triple colour = {static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2])};
      out.alike.pixels[p.at] = 255;
      out.drawn.pixels[p.at] = areAlike(own, colour) ? 0 : 255;
    }
    return out;
  }

 private:
  static constexpr float kUnknown = -1;

  bool isRim(std::size_t i) const { return depths_[i] < reach_ && depths_[i] >= -reach_; }
  template <class Visit>
  void forRimTiles(const Visit& visit) const {
    for (std::size_t t = 0; t < rimTiles_.size(); ++t) {
      if (rimTiles_[t]) visit(t);
    }
  }
  /// The tiles of the rim, and all where its colours may be learnt.
  std::vector<bool> nearRim() {
    slots_.resize(tiles_.count());
    std::size_t pixels = 0;
    for (std::size_t t = 0; t < tiles_.count(); ++t) {
      const std::size_t before = pixels;
      tiles_.forPixels(t, 1, [&](std::size_t i) { pixels += isRim(i) ? 1 : 0; });
      if (pixels == before) continue;
      rimTiles_[t] = true;
      slots_[t] = stretches_.size();
      stretches_.emplace_back();
    }
    rim_.reserve(pixels);
    std::vector<bool> near(tiles_.count());
    forRimTiles(
        [&](std::size_t tile) { tiles_.forNear(tile, kNear + 1, [&](std::size_t other) { near[other] = true; }); });
    return near;
  }

  /// How the tiles of the rim, and those beside them, tell the part from the ground.
  void learn() {
    constexpr float kLeast = 4, kMost = 100;
    tellings_.resize(tiles_.count());
    std::vector<bool> wanted(tiles_.count());
    forRimTiles([&](std::size_t tile) { tiles_.forNear(tile, 1, [&](std::size_t other) { wanted[other] = true; }); });
    for (std::size_t t = 0; t < tellings_.size(); ++t) {
      if (!wanted[t]) continue;
      Telling& telling = tellings_[t];
      Triple step;
      for (std::size_t k = 0; k < 3; ++k) step[k] = out_.mean(t)[k] - in_.mean(t)[k];
      if (along(step, step) < kAlike * kAlike) continue;
      telling.in = in_.spread(t), telling.out = out_.spread(t);
      telling.w = times(inverse(mixed(telling.in, 0.5f, telling.out, 0.5f)), step);
      const float certainty = along(step, telling.w);
      if (!(certainty >= kLeast)) continue;
      for (float& w : telling.w) w /= certainty;
      telling.offset = along(telling.w, in_.mean(t));
      telling.certainty = std::min(certainty, kMost);
    }
  }

  /// Of four tiles whose middles are around a quarter of a tile, and the place of its first pixel between them.
  struct Quarter {
    std::array<std::size_t, 4> tiles;  ///< upper left, upper right, lower left, lower right
    float x, y;                        ///< 0…1
  };
  Quarter quarterOf(std::size_t tile, bool right, bool lower) const {
    const int column = tiles_.columnOf(tile), row = tiles_.rowOf(tile);
    const int x0 = std::max(0, column - (right ? 0 : 1)), x1 = std::min(tiles_.columns - 1, column + (right ? 1 : 0));
    const int y0 = std::max(0, row - (lower ? 0 : 1)), y1 = std::min(tiles_.rows - 1, row + (lower ? 1 : 0));
    const float first = 0.5f / static_cast<float>(tiles_.side);
    return {{tiles_.indexOf(x0, y0), tiles_.indexOf(x1, y0), tiles_.indexOf(x0, y1), tiles_.indexOf(x1, y1)},
            first + (right ? 0 : 0.5f),
            first + (lower ? 0 : 0.5f)};
  }
  /// Of each pixel of a tile that is near the outline its share of the ground.
  void survey(const image::Image& shown, std::size_t tile) {
    constexpr float kOver = 0.5f;
    const float each = 1 / static_cast<float>(tiles_.side);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const bool right = quarter % 2 == 1, lower = quarter / 2 == 1;
      const Quarter q = quarterOf(tile, right, lower);
      const std::array<const Telling*, 4> four = {&tellings_[q.tiles[0]], &tellings_[q.tiles[1]],
                                                  &tellings_[q.tiles[2]], &tellings_[q.tiles[3]]};
      const float certainty =
          std::min({four[0]->certainty, four[1]->certainty, four[2]->certainty, four[3]->certainty});
      const int left = tiles_.columnOf(tile) * tiles_.side + (right ? tiles_.half : 0);
      const int top = tiles_.rowOf(tile) * tiles_.side + (lower ? tiles_.half : 0);
      for (int dy = 0; dy < tiles_.half && top + dy < tiles_.height; ++dy) {
        const float fy = q.y + each * static_cast<float>(dy);
        for (int dx = 0; dx < tiles_.half && left + dx < tiles_.width; ++dx) {
          const std::size_t i = tiles_.pixel(left + dx, top + dy);
          const std::uint8_t* pixel = &shown.pixels[4 * i];
          if (!isRim(i) || pixel[3] < 128) continue;
          RimPixel p{i, tile, left + dx, top + dy, depths_[i], 0, certainty};
          if (certainty > 0) {
            const float fx = q.x + each * static_cast<float>(dx);
            const auto shareBy = [&](const Telling& t) {
              return t.w[0] * static_cast<float>(pixel[0]) + t.w[1] * static_cast<float>(pixel[1]) +
                     t.w[2] * static_cast<float>(pixel[2]) - t.offset;
            };
            const float upper = shareBy(*four[0]) * (1 - fx) + shareBy(*four[1]) * fx;
            const float under = shareBy(*four[2]) * (1 - fx) + shareBy(*four[3]) * fx;
            shares_[i] = p.share = std::clamp(upper * (1 - fy) + under * fy, -kOver, 1 + kOver);
            stretches_[slots_[tile]].addShare(p.depth, p.share, certainty);
          }
          rim_.push_back(p);
        }
      }
    }
  }

  /// How fast the share sinks across the outline.
  void addSlopes() {
    const auto row = static_cast<std::ptrdiff_t>(tiles_.width);
    for (const RimPixel& p : rim_) {
      if (p.certainty == 0 || p.depth > reach_ / 2 || p.depth < -reach_ / 2) continue;
      if (p.x == 0 || p.y == 0 || p.x + 1 >= tiles_.width || p.y + 1 >= tiles_.height) continue;
      const float* s = &shares_[p.at];
      const std::int8_t* d = &depths_[p.at];
      const float nx = static_cast<float>(d[1] - d[-1]), ny = static_cast<float>(d[row] - d[-row]);
      const float gx = (s[1 - row] + 2 * s[1] + s[1 + row] - s[-1 - row] - 2 * s[-1] - s[-1 + row]) / 8;
      const float gy = (s[row - 1] + 2 * s[row] + s[row + 1] - s[-row - 1] - 2 * s[-row] - s[-row + 1]) / 8;
      const float slope = -(gx * nx + gy * ny) / std::sqrt(nx * nx + ny * ny);
      if (slope > 0) stretches_[slots_[p.tile]].addSlope(slope, p.certainty);  // not where it is no number
    }
  }

  /// What is known around each tile of the rim, and how deep its ground is mixed in there.
  void gather() {
    // The least width of a soft rim in margins, and the most in reaches: beyond that it is no rim. How deep a crisp one
    // is at most, in margins, and of how deep the part is there.
    constexpr float kSoft = 3, kNoRim = 1.5f, kCrisp = 2, kOfPart = 0.5f;
    around_.resize(stretches_.size());
    deepest_.assign(tiles_.count(), 0);
    std::vector<float> found(tiles_.count(), kUnknown), crisp = found;
    for (const RimPixel& p : rim_) {
      deepest_[p.tile] = std::max(deepest_[p.tile], static_cast<float>(p.depth));
      if (p.depth == 0) found[p.tile] = crisp[p.tile] = 0;
    }
    forRimTiles([&](std::size_t tile) {
      Stretch& around = around_[slots_[tile]];
      tiles_.forNear(tile, kNear, [&](std::size_t other) {
        if (rimTiles_[other]) around.add(stretches_[slots_[other]], reach_);
      });
      const float width = around.width();
      const bool soft = width >= kSoft * margin_ && width <= kNoRim * static_cast<float>(reach_);
      if (soft && found[tile] == 0) found[tile] = around.depth(reach_);
      if (crisp[tile] == 0)
        crisp[tile] = std::min({around.crispDepth(reach_), kOfPart * deepestNear(tile), kCrisp * margin_});
    });
    soft_ = usualNear(found, margin_);
    crisp_ = usualNear(crisp, 0);
  }
  /// How deep the part is near a tile, px, at most the reach.
  float deepestNear(std::size_t tile) const {
    float most = 0;
    tiles_.forNear(tile, 1, [&](std::size_t other) { most = std::max(most, deepest_[other]); });
    return most;
  }
  /// The median of the tiles on the outline near by; 0 where that is not more than `least`.
  std::vector<float> usualNear(const std::vector<float>& found, float least) const {
    std::vector<float> out(tiles_.count()), some;
    forRimTiles([&](std::size_t tile) {
      some.clear();
      tiles_.forNear(tile, kNear, [&](std::size_t other) {
        if (found[other] != kUnknown) some.push_back(found[other]);
      });
      if (some.empty()) return;
      const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
      std::ranges::nth_element(some, middle);
      if (*middle > least) out[tile] = *middle;
    });
    return out;
  }

  /// Whether anything was changed.
  bool purify(const RimPixel& p, image::Image& shown, image::Mask& inner) {
    // Of the shares at one depth of a stretch, about; and from where on a pixel is better made up than unmixed.
    constexpr float kVariance = 0.04f, kMostly = 0.6f;
    const float usual = around_[slots_[p.tile]].at(p.depth);
    const float prior = std::isnan(usual) ? 0 : 1 / kVariance, known = prior + p.certainty;
    if (!(known > 0)) return false;
    const float share = std::clamp(((prior > 0 ? usual * prior : 0) + p.share * p.certainty) / known, 0.0f, 1.0f);
    const bool believed = share <= kMostly, same = (inner.pixels[p.at] != 0) == believed;
    inner.pixels[p.at] = believed ? 255 : 0;
    const Telling& telling = tellings_[p.tile];
    if (share < kShows || !believed || telling.certainty == 0) return !same;
    const Triple own = meanAt(in_, p), behind = meanAt(out_, p);
    const float rest = 1 - share;
    std::uint8_t* pixel = &shown.pixels[4 * p.at];
    Triple off;
    for (std::size_t k = 0; k < 3; ++k) off[k] = static_cast<float>(pixel[k]) - rest * own[k] - share * behind[k];
    const Triple likely =
        times(telling.in, times(inverse(mixed(telling.in, rest * rest, telling.out, share * share)), off));
    for (std::size_t k = 0; k < 3; ++k)
      pixel[k] = static_cast<std::uint8_t>(std::clamp(own[k] + rest * likely[k] + 0.5f, 0.0f, 255.0f));
    return true;
  }
  Triple meanAt(const Side& side, const RimPixel& p) const {
    const int dx = p.x % tiles_.side, dy = p.y % tiles_.side;
    const bool right = dx >= tiles_.half, lower = dy >= tiles_.half;
    const Quarter q = quarterOf(p.tile, right, lower);
    const float each = 1 / static_cast<float>(tiles_.side);
    const float fx = q.x + each * static_cast<float>(right ? dx - tiles_.half : dx),
                fy = q.y + each * static_cast<float>(lower ? dy - tiles_.half : dy);
    Triple out;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto c = [&](std::size_t corner) { return side.mean(q.tiles[corner])[k]; };
      out[k] = (c(0) * (1 - fx) + c(1) * fx) * (1 - fy) + (c(2) * (1 - fx) + c(3) * fx) * fy;
    }
    return out;
  }

  float margin_;
  int reach_;
  Tiles tiles_;
  std::vector<std::int8_t> depths_;
  std::vector<Stretch> stretches_, around_;  ///< of the tiles of the rim alone, and with those near them
  std::vector<std::size_t> slots_;           ///< of a tile of the rim among them
  std::vector<RimPixel> rim_;                ///< and what is just outside
  std::vector<bool> rimTiles_, near_;
  Side in_, out_;
  std::vector<Telling> tellings_;
  std::vector<float> shares_;                  ///< of pixels
  std::vector<float> deepest_, soft_, crisp_;  ///< of tiles: how deep the part is, and its soft and its crisp rim
};

}  // namespace

double softReach(double margin, double clearance) { return std::clamp(0.5 * clearance, 4 * margin, 5 * margin); }

struct RimUnmixing::State {
  image::Image& shown;
  image::Mask& inner;
  SoftRim rim;
};

RimUnmixing::RimUnmixing(image::Image& shown, const image::Mask& region, image::Mask& inner, double margin,
                         double reach)
    : state_(new State{shown, inner, SoftRim(shown, region, inner, margin, reach)}) {}
RimUnmixing::~RimUnmixing() = default;

bool RimUnmixing::change() { return state_->rim.change(state_->shown, state_->inner); }
Untold RimUnmixing::untold() const { return state_->rim.untold(state_->shown); }

}  // namespace spineloft::surface
