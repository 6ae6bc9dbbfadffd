#include "engine/vision/enclosed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include "engine/vision/colour_gradient.h"
#include "engine/vision/masks.h"

namespace spineloft::vision {
namespace {

constexpr double kCalm = 0.8;  ///< smooths the grain away, pixels
/// Paper is looked for in blocks of so many pixels, over so many blocks to each side.
constexpr int kBlock = 8, kReach = 10;
/// Ink is darker than paper by these units of L, and by this share of the mean of what is.
constexpr float kLeastInk = 9, kInkShare = 0.4f;
/// In a drawing it covers at most this share of the picture, and paper is at most this share as dark: photos have all
/// shades.
constexpr double kMostInk = 0.3, kMostGrain = 0.14;
constexpr int kSpeck = 12;  ///< pixels; fewer are no stroke
/// A way is narrow below this share of the smaller room's width.
constexpr float kNarrow = 0.3f;
/// Thicker than this many times the usual stroke is no line.
constexpr float kThick = 1.3f;
/// Colours of one paper, with its shadows: units of L, and of a and b.
constexpr float kSameLight = 25, kSameColour = 15;
constexpr double kPlain = 0.8;        ///< share of a paper that has its colour
constexpr double kLeastPaper = 0.35;  ///< share of a thing that is no ink
constexpr double kMostShare = 0.85;   ///< of the picture; a larger thing is a frame

using Colours = std::vector<image::PixelFeature>;

/// The lightest, or the least light, of the entries up to `reach` before and after each one.
template <class Better>
void rankedAlong(std::vector<float>& values, cv::Size size, Better better) {
  std::vector<float> out(values.size());
  for (const bool down : {false, true}) {
    const int stride = down ? size.width : 1, count = down ? size.height : size.width;
    for (int pixel = 0; pixel < size.area(); ++pixel) {
      const int at = down ? pixel / size.width : pixel % size.width;
      float best = values[static_cast<std::size_t>(pixel)];
      for (int k = -std::min(kReach, at); k <= std::min(kReach, count - 1 - at); ++k) {
        best = better(best, values[static_cast<std::size_t>(pixel + k * stride)]);
      }
      out[static_cast<std::size_t>(pixel)] = best;
    }
    values.swap(out);
  }
}

/// How much darker each pixel is than the paper round it, in units of L.
std::vector<float> darkness(const Colours& colours, cv::Size size) {
  const cv::Size blocks((size.width + kBlock - 1) / kBlock, (size.height + kBlock - 1) / kBlock);
  const auto blockOf = [&](int pixel) {
    return static_cast<std::size_t>(pixel / size.width / kBlock * blocks.width + pixel % size.width / kBlock);
  };
  std::vector<float> paper(static_cast<std::size_t>(blocks.area()), 0), dark(colours.size());
  for (int pixel = 0; pixel < size.area(); ++pixel) {
    paper[blockOf(pixel)] = std::max(paper[blockOf(pixel)], colours[static_cast<std::size_t>(pixel)][0]);
  }
  rankedAlong(paper, blocks, [](float a, float b) { return std::max(a, b); });
  rankedAlong(paper, blocks, [](float a, float b) { return std::min(a, b); });
  for (int pixel = 0; pixel < size.area(); ++pixel) {
    dark[static_cast<std::size_t>(pixel)] = paper[blockOf(pixel)] - colours[static_cast<std::size_t>(pixel)][0];
  }
  return dark;
}

/// Empty where it is not much darker than what is not ink, or covers too much.
cv::Mat inkOf(const Colours& colours, cv::Size size) {
  const std::vector<float> dark = darkness(colours, size);
  const auto shareAndMean = [&](auto counts) {
    double sum = 0;
    int count = 0;
    for (const float value : dark) {
      if (!counts(value)) continue;
      sum += static_cast<double>(value);
      ++count;
    }
    return std::array{static_cast<double>(count) / size.area(), sum / std::max(1, count)};
  };
  const auto darker = shareAndMean([](float value) { return value > kLeastInk; });
  const float least = std::max(kLeastInk, kInkShare * static_cast<float>(darker[1]));
  const auto [inked, inkDark] = shareAndMean([least](float value) { return value > least; });
  const double paperDark = shareAndMean([least](float value) { return value <= least; })[1];
  if (inked > kMostInk || paperDark > kMostGrain * inkDark) return plainMask(size);
  cv::Mat ink = maskWhere(size, [&](int pixel) { return dark[static_cast<std::size_t>(pixel)] > least; });
  const Pieces strokes(ink);
  return maskWhere(size,
                   [&](int pixel) { return strokes.area[static_cast<std::size_t>(strokes.of(pixel))] >= kSpeck; });
}

/// Distance of each pixel to the nearest one that is `value` in the mask; the exact one (Felzenszwalb and
/// Huttenlocher 2012). Without such a pixel it is larger than the picture.
std::vector<float> distanceTo(const cv::Mat& mask, int value) {
  const int most = std::max(mask.cols, mask.rows);
  const float far = 4.0f * static_cast<float>(most) * static_cast<float>(most);
  std::vector<float> squared(mask.total());
  for (std::size_t i = 0; i < squared.size(); ++i) squared[i] = mask.data[i] == value ? 0 : far;
  std::vector<float> line(static_cast<std::size_t>(most)), from(line.size() + 1);
  std::vector<int> lowest(line.size());
  const auto sweep = [&](std::size_t first, std::size_t stride, int count) {
    for (int i = 0; i < count; ++i)
      line[static_cast<std::size_t>(i)] = squared[first + static_cast<std::size_t>(i) * stride];
    const auto height = [&](int i) {
      return line[static_cast<std::size_t>(i)] + static_cast<float>(i) * static_cast<float>(i);
    };
    std::size_t top = 0;
    lowest[0] = 0;
    from[0] = -std::numeric_limits<float>::infinity();
    for (int i = 1; i < count; ++i) {
      float meet = 0;
      while ((meet = (height(i) - height(lowest[top])) / static_cast<float>(2 * (i - lowest[top]))) <= from[top]) --top;
      lowest[++top] = i;
      from[top] = meet;
    }
    from[top + 1] = std::numeric_limits<float>::infinity();
    top = 0;
    for (int i = 0; i < count; ++i) {
      while (from[top + 1] < static_cast<float>(i)) ++top;
      const auto away = static_cast<float>(i - lowest[top]);
      squared[first + static_cast<std::size_t>(i) * stride] = away * away + line[static_cast<std::size_t>(lowest[top])];
    }
  };
  const auto width = static_cast<std::size_t>(mask.cols);
  for (std::size_t x = 0; x < width; ++x) sweep(x, width, mask.rows);
  for (std::size_t y = 0; y < static_cast<std::size_t>(mask.rows); ++y) sweep(y * width, 1, mask.cols);
  for (float& value2 : squared) value2 = std::sqrt(value2);
  return squared;
}

/// What of the paper hangs together.
struct Rooms {
  std::vector<int> room;                ///< of each pixel, from 1; 0 is ink that is thicker than lines
  std::vector<std::vector<int>> paper;  ///< by room: its pixels without ink
};

/// Pixels with the way from each to the room it belongs to.
class Basins {
 public:
  explicit Basins(std::size_t pixels) : up_(pixels, -1), radius_(pixels, 0) {}
  bool known(int pixel) const { return up_[static_cast<std::size_t>(pixel)] >= 0; }
  int of(int pixel) {
    int& up = up_[static_cast<std::size_t>(pixel)];
    while (up != up_[static_cast<std::size_t>(up)]) up = up_[static_cast<std::size_t>(up)];
    return up;
  }
  float radius(int basin) const { return radius_[static_cast<std::size_t>(basin)]; }
  void begin(int pixel, float radius) {
    up_[static_cast<std::size_t>(pixel)] = pixel;
    radius_[static_cast<std::size_t>(pixel)] = radius;
  }
  void join(int pixel, int basin) { up_[static_cast<std::size_t>(pixel)] = basin; }
  /// Two that meet where the way is `half` wide to each side.
  void meet(int a, int b, float half) {
    if (a == b || half <= kNarrow * std::min(radius(a), radius(b))) return;
    if (radius(a) < radius(b)) std::swap(a, b);
    join(b, a);
  }

 private:
  std::vector<int> up_;
  std::vector<float> radius_;
};

template <class Visit>
void forNeighbours(cv::Size size, int pixel, Visit visit) {
  const int x = pixel % size.width, y = pixel / size.width;
  if (x > 0) visit(pixel - 1);
  if (x + 1 < size.width) visit(pixel + 1);
  if (y > 0) visit(pixel - size.width);
  if (y + 1 < size.height) visit(pixel + size.width);
}

Rooms roomsOf(const cv::Mat& ink) {
  const cv::Size size = ink.size();
  std::vector<float> height = distanceTo(ink, 255), depths;
  const std::vector<float> depth = distanceTo(ink, 0);
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (ink.data[i] == 0) continue;
    height[i] = -depth[i];
    depths.push_back(depth[i]);
  }
  // The pixels of a line are as often nearer to its side than half its half width as they are not.
  float thick = 0;
  if (!depths.empty()) {
    const auto half = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::ranges::nth_element(depths, half);
    thick = kThick * (2 * *half);
  }
  std::vector<int> order(height.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int pixel) { return height[static_cast<std::size_t>(pixel)]; };
  std::ranges::sort(order, [&](int a, int b) { return at(a) != at(b) ? at(a) > at(b) : a < b; });
  Basins basins(height.size());
  for (const int pixel : order) {
    if (at(pixel) < -thick) break;
    int mine = -1;
    forNeighbours(size, pixel, [&](int other) {
      if (!basins.known(other)) return;
      const int theirs = basins.of(other);
      if (mine < 0) {
        basins.join(pixel, mine = theirs);
      } else if (at(pixel) > 0) {
        basins.meet(mine, theirs, at(pixel));
        mine = basins.of(mine);
      }
    });
    if (mine < 0 && at(pixel) > 0) basins.begin(pixel, at(pixel));
  }
  Rooms rooms{std::vector<int>(height.size(), 0), {{}}};
  std::map<int, int> ids;
  for (int pixel = 0; pixel < size.area(); ++pixel) {
    if (!basins.known(pixel)) continue;
    const int basin = basins.of(pixel);
    const auto [found, fresh] = ids.try_emplace(basin, static_cast<int>(rooms.paper.size()));
    if (fresh) rooms.paper.emplace_back();
    rooms.room[static_cast<std::size_t>(pixel)] = found->second;
    if (at(pixel) > 0) rooms.paper[static_cast<std::size_t>(found->second)].push_back(pixel);
  }
  return rooms;
}

using Colour = std::array<float, 3>;

Colour medianOf(const Colours& colours, const std::vector<int>& pixels) {
  Colour out{};
  std::vector<float> values(pixels.size());
  for (std::size_t channel = 0; channel < 3 && !pixels.empty(); ++channel) {
    std::ranges::transform(pixels, values.begin(),
                           [&](int pixel) { return colours[static_cast<std::size_t>(pixel)][channel]; });
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, half);
    out[channel] = *half;
  }
  return out;
}

template <class A, class B>
bool alike(const A& a, const B& b) {
  return std::abs(a[0] - b[0]) <= kSameLight && std::abs(a[1] - b[1]) <= kSameColour &&
         std::abs(a[2] - b[2]) <= kSameColour;
}

/// The rooms that are paper, and what is left of the picture.
class Sheet {
 public:
  Sheet(const Colours& colours, cv::Size size)
      : colours_(colours), size_(size), rooms_(roomsOf(inkOf(colours, size))), ground_(rooms_.paper.size(), false) {
    for (int pixel = 0; pixel < size.area(); ++pixel) {
      const int x = pixel % size.width, y = pixel / size.width;
      if (x == 0 || y == 0 || x + 1 == size.width || y + 1 == size.height) ground_[roomAt(pixel)] = true;
    }
    ground_[0] = false;
  }

  Drawing find() {
    while (true) {
      const Pieces pieces(maskWhere(size_, [&](int pixel) { return !ground_[roomAt(pixel)]; }));
      const std::vector<Within> within = lookInto(pieces);
      std::vector<bool> isThing(within.size(), false), isPaper(ground_.size(), false);
      bool changed = false;
      for (std::size_t piece = 1; piece < within.size(); ++piece) {
        const Within& found = within[piece];
        if (found.largest == 0) continue;
        isThing[piece] = isDrawn(found, pieces.area[piece]);
        if (isThing[piece]) {
          isPaper[found.around] = true;
        } else {
          ground_[found.largest] = changed = true;
        }
      }
      if (changed) continue;
      const auto thing = [&](int pixel) { return isThing[static_cast<std::size_t>(pieces.of(pixel))]; };
      const auto paper = [&](int pixel) { return !thing(pixel) && isPaper[roomAt(pixel)]; };
      return {maskWhere(size_, thing), maskWhere(size_, paper), std::ranges::count(isThing, true) > 0};
    }
  }

 private:
  /// Of a piece: its largest room and the ground that most of its sides touch (0: none), and how much is paper.
  struct Within {
    std::size_t largest = 0, around = 0;
    int paper = 0;
    std::map<std::size_t, int> sides;
  };

  std::size_t roomAt(int pixel) const { return static_cast<std::size_t>(rooms_.room[static_cast<std::size_t>(pixel)]); }

  std::vector<Within> lookInto(const Pieces& pieces) const {
    std::vector<Within> out(pieces.area.size());
    std::vector<bool> seen(rooms_.paper.size(), false);
    for (int pixel = 0; pixel < size_.area(); ++pixel) {
      if (pieces.of(pixel) == 0) continue;
      Within& piece = out[static_cast<std::size_t>(pieces.of(pixel))];
      const std::size_t room = roomAt(pixel), area = rooms_.paper[room].size();
      if (area > rooms_.paper[piece.largest].size()) piece.largest = room;
      if (!seen[room]) piece.paper += static_cast<int>(area);
      seen[room] = true;
      forNeighbours(size_, pixel, [&](int other) {
        if (pieces.of(other) == 0) ++piece.sides[roomAt(other)];
      });
    }
    for (Within& piece : out) {
      const auto most = std::ranges::max_element(piece.sides, {}, [](const auto& side) { return side.second; });
      if (most != piece.sides.end()) piece.around = most->first;
    }
    return out;
  }

  /// Whether a piece is the same plain paper as what is round it, with lines on it.
  bool isDrawn(const Within& piece, int area) const {
    if (area > kMostShare * size_.area() || piece.paper < kLeastPaper * area) return false;
    const std::vector<int>& around = rooms_.paper[piece.around];
    const Colour paper = medianOf(colours_, around);
    if (!alike(medianOf(colours_, rooms_.paper[piece.largest]), paper)) return false;
    const auto isPaper = [&](int pixel) { return alike(colours_[static_cast<std::size_t>(pixel)], paper); };
    return static_cast<double>(std::ranges::count_if(around, isPaper)) >= kPlain * static_cast<double>(around.size());
  }

  const Colours& colours_;
  cv::Size size_;
  Rooms rooms_;
  std::vector<bool> ground_;
};

}  // namespace

Drawing findEnclosed(const image::Image& copy) {
  image::EdgeMap map;
  map.width = copy.width;
  map.height = copy.height;
  smoothColourAndGradient(copy, kCalm, map);
  return Sheet(map.look, {copy.width, copy.height}).find();
}

}  // namespace spineloft::vision
