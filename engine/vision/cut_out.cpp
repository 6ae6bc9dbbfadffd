#include "engine/vision/cut_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/vision/colour_gradient.h"
#include "engine/vision/enclosed.h"
#include "engine/vision/masks.h"
#include "engine/vision/one_thread.h"

namespace spineloft::vision {
namespace {

constexpr int kRounds = 4;
/// Colours this near to the one under a hint may belong to the thing: units of L, and of a and b.
constexpr float kNearLight = 22 / 2.55f, kNearColour = 22;
/// Smooths the grain away before colours are compared, in pixels of the copy.
constexpr double kCalm = 1.2;
/// A hint is a disc of this radius, share of the copy's longer side; around it the thing is likely.
constexpr double kHintRadius = 0.012, kLikelyRadius = 0.09;
/// What is smaller or larger than these shares of the picture is no thing.
constexpr double kLeastShare = 0.0008, kMostShare = 0.92;
/// Holes and pieces below this share of the picture are noise.
constexpr double kNoiseShare = 0.0004;
constexpr int kSmoothing = 3;  ///< steps of an outline on either side that smooth it

/// A box and what is round it are cut by themselves: what lies farther away says less about the ground
/// than it costs. Share of the box's longer side.
constexpr double kRoundBox = 0.1;
/// Where a box gives nothing, only this ellipse in its middle is likely at first: share of its axes,
/// squared.
constexpr double kCore = 0.35;

/// Longer side of the copy on which drawn lines are looked for: a pen's line is two pixels wide there.
constexpr int kDrawnSide = 640;

/// The copy that is cut, how many original pixels one of its pixels is, and where it begins.
struct Copy {
  cv::Mat bgr;
  double scaleX = 1, scaleY = 1;
  PicturePoint corner;  ///< of its first pixel's outer edge
  cv::Point at(PicturePoint p) const {
    return {static_cast<int>(std::lround((p.x - corner.x) / scaleX - 0.5)),
            static_cast<int>(std::lround((p.y - corner.y) / scaleY - 0.5))};
  }
  bool holds(cv::Point p) const { return p.x >= 0 && p.y >= 0 && p.x < bgr.cols && p.y < bgr.rows; }
  PicturePoint back(double x, double y) const { return {(x + 0.5) * scaleX + corner.x, (y + 0.5) * scaleY + corner.y}; }
};

/// What of the working pixels is cut: all, or the box with the marks and some ground round it.
cv::Rect frameOf(const image::Picture& picture, const CutHints& hints) {
  const image::Image& working = picture.working;
  const cv::Rect all(0, 0, working.width, working.height);
  if (!hints.box) return all;
  PicturePoint low = hints.box->low, high = hints.box->high;
  const double room = kRoundBox * std::max(high.x - low.x, high.y - low.y);
  for (const CutMark& mark : hints.marks) {
    for (const PicturePoint p : mark.line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double toX = static_cast<double>(working.width) / picture.width;
  const double toY = static_cast<double>(working.height) / picture.height;
  const auto whole = [](double v, int most) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(most))); };
  const cv::Point from(whole(std::floor((low.x - room) * toX), working.width),
                       whole(std::floor((low.y - room) * toY), working.height));
  const cv::Point to(whole(std::ceil((high.x + room) * toX), working.width),
                     whole(std::ceil((high.y + room) * toY), working.height));
  const cv::Rect frame(from, to);
  return frame.width > 4 && frame.height > 4 ? frame : all;
}

image::Image cropped(const image::Image& whole, const cv::Rect& frame) {
  if (frame.width == whole.width && frame.height == whole.height) return whole;
  image::Image part{frame.width, frame.height, {}};
  part.pixels.reserve(4 * static_cast<std::size_t>(frame.area()));
  for (int y = frame.y; y < frame.y + frame.height; ++y) {
    const auto row = whole.pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * whole.width + frame.x);
    part.pixels.insert(part.pixels.end(), row, row + 4 * static_cast<std::ptrdiff_t>(frame.width));
  }
  return part;
}

Copy copyOf(const image::Picture& picture, const cv::Rect& frame, int side) {
  const double shrink = std::min(1.0, static_cast<double>(side) / std::max(frame.width, frame.height));
  const int width = std::max(2, static_cast<int>(std::lround(frame.width * shrink)));
  const int height = std::max(2, static_cast<int>(std::lround(frame.height * shrink)));
  const image::Image small = image::shrink(cropped(picture.working, frame), width, height);
  Copy copy;
  if (small.empty()) return copy;
  copy.bgr.create(small.height, small.width, CV_8UC3);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const std::size_t i =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) + static_cast<std::size_t>(x));
      copy.bgr.at<cv::Vec3b>(y, x) = {small.pixels[i + 2], small.pixels[i + 1], small.pixels[i]};
    }
  }
  const double perX = static_cast<double>(picture.width) / picture.working.width;
  const double perY = static_cast<double>(picture.height) / picture.working.height;
  copy.scaleX = perX * frame.width / small.width;
  copy.scaleY = perY * frame.height / small.height;
  copy.corner = {frame.x * perX - 0.5, frame.y * perY - 0.5};
  return copy;
}

/// What a mark covers.
void paintMark(const Copy& copy, const CutMark& mark, int value, cv::Mat& mask) {
  const double side = std::max(copy.bgr.cols, copy.bgr.rows);
  const double radius = std::max(mark.radius / std::max(copy.scaleX, copy.scaleY), kLeastMark * side);
  const int thick = std::max(2, static_cast<int>(std::lround(radius)));
  const cv::Scalar colour(value);
  for (std::size_t i = 0; i < mark.line.size(); ++i) {
    const cv::Point at = copy.at(mark.line[i]);
    cv::circle(mask, at, thick, colour, cv::FILLED);
    if (i > 0) cv::line(mask, copy.at(mark.line[i - 1]), at, colour, 2 * thick + 1);
  }
}

/// Where marks say so it is certain; round a mark beyond the box it becomes possible.
void addMarks(const Copy& copy, const CutHints& hints, cv::Mat& mask) {
  const double side = std::max(copy.bgr.cols, copy.bgr.rows);
  for (const CutMark& mark : hints.marks) {
    if (mark.inside) {
      CutMark wide = mark;
      wide.radius += kLikelyRadius * side * std::max(copy.scaleX, copy.scaleY);
      cv::Mat near = plainMask(mask.size());
      paintMark(copy, wide, 255, near);
      const auto turns = [&](int pixel) { return near.data[pixel] != 0 && mask.data[pixel] == cv::GC_BGD; };
      mask.setTo(cv::Scalar(cv::GC_PR_BGD), maskWhere(mask.size(), turns));
    }
    paintMark(copy, mark, mark.inside ? cv::GC_FGD : cv::GC_BGD, mask);
  }
  // What became possible round a mark stays impossible where another one says so.
  for (const CutMark& mark : hints.marks) {
    paintMark(copy, mark, mark.inside ? cv::GC_FGD : cv::GC_BGD, mask);
  }
}

/// The pixels that marks of one kind cover and no later one takes back.
cv::Mat markedAs(const Copy& copy, const CutHints& hints, bool inside) {
  cv::Mat marked = plainMask(copy.bgr.size());
  for (const CutMark& mark : hints.marks) paintMark(copy, mark, mark.inside == inside ? 255 : 0, marked);
  return marked;
}

/// What has the colour under a hint and hangs together with it.
struct Flood {
  cv::Point at;
  cv::Mat mask;
  int area = 0;
};

image::Image imageOf(const Copy& copy) {
  image::Image pixels{copy.bgr.cols, copy.bgr.rows, {}};
  pixels.pixels.reserve(4 * copy.bgr.total());
  for (const cv::Vec3b& bgr : cv::Mat_<cv::Vec3b>(copy.bgr)) {
    pixels.pixels.insert(pixels.pixels.end(), {bgr[2], bgr[1], bgr[0], 255});
  }
  return pixels;
}

/// The copy's colours as Lab, without their grain.
std::vector<image::PixelFeature> calmColours(const Copy& copy) {
  const image::Image pixels = imageOf(copy);
  image::EdgeMap map;
  map.width = pixels.width;
  map.height = pixels.height;
  smoothColourAndGradient(pixels, kCalm, map);
  return std::move(map.look);
}

/// What has the colour under `at` and hangs together with it.
Flood floodFrom(const std::vector<image::PixelFeature>& colours, cv::Size size, cv::Point at) {
  Flood out{at, plainMask(size)};
  const int from = at.y * size.width + at.x;
  const image::PixelFeature mine = colours[static_cast<std::size_t>(from)];
  out.area = flood(size, from, [&](int pixel) {
    const image::PixelFeature& other = colours[static_cast<std::size_t>(pixel)];
    const auto near = [&](std::size_t channel, float most) { return std::abs(other[channel] - mine[channel]) <= most; };
    if (out.mask.data[pixel] != 0 || !near(0, kNearLight) || !near(1, kNearColour) || !near(2, kNearColour)) {
      return false;
    }
    out.mask.data[pixel] = 255;
    return true;
  });
  return out;
}

/// Those of the hints on the picture. A scribble may slip off a thin thing: of many hints those count as slips whose
/// flood is far larger than that of most, and no small share of the picture.
std::vector<Flood> floodsOf(const Copy& copy, const CutHints& hints) {
  constexpr std::size_t kMany = 5;
  constexpr int kFar = 4, kNoSmallShare = 30;  // times the median; one of so many pixels of the picture
  if (hints.inside.empty()) return {};
  const std::vector<image::PixelFeature> colours = calmColours(copy);
  std::vector<Flood> floods;
  for (const PicturePoint hint : hints.inside) {
    const cv::Point at = copy.at(hint);
    if (copy.holds(at)) floods.push_back(floodFrom(colours, copy.bgr.size(), at));
  }
  if (floods.size() < kMany) return floods;
  std::vector<int> areas;
  for (const Flood& flood : floods) areas.push_back(flood.area);
  const auto half = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::ranges::nth_element(areas, half);
  const int most = std::max(kFar * *half, copy.bgr.rows * copy.bgr.cols / kNoSmallShare);
  std::erase_if(floods, [&](const Flood& flood) { return flood.area > most; });
  return floods;
}

/// What is likely before any cut: within the box, or what has the colour under a hint and hangs
/// together with it.
cv::Mat firstGuess(const Copy& copy, const CutHints& hints, bool coreOnly) {
  const int side = std::max(copy.bgr.cols, copy.bgr.rows);
  cv::Mat mask(copy.bgr.size(), CV_8UC1, cv::Scalar(cv::GC_PR_BGD));
  if (hints.box) {
    mask.setTo(cv::Scalar(cv::GC_BGD));
    const cv::Point a = copy.at(hints.box->low), b = copy.at(hints.box->high);
    const cv::Rect rect = cv::Rect(a, b) & cv::Rect(0, 0, mask.cols, mask.rows);
    mask(rect).setTo(cv::Scalar(coreOnly ? cv::GC_PR_BGD : cv::GC_PR_FGD));
    if (coreOnly) {
      const double share = std::sqrt(kCore) / 2;
      const cv::Size axes(std::max(1, static_cast<int>(rect.width * share)),
                          std::max(1, static_cast<int>(rect.height * share)));
      const cv::Point middle(rect.x + rect.width / 2, rect.y + rect.height / 2);
      cv::ellipse(mask, middle, axes, 0, 0, 360, cv::Scalar(cv::GC_PR_FGD), cv::FILLED);
    }
  }
  const std::vector<Flood> floods = floodsOf(copy, hints);
  for (const Flood& flood : floods) {
    if (hints.box) break;
    mask.setTo(cv::Scalar(cv::GC_PR_FGD), flood.mask);
    cv::circle(mask, flood.at, std::max(2, static_cast<int>(kLikelyRadius * side)), cv::Scalar(cv::GC_PR_FGD),
               cv::FILLED);
  }
  const int dot = std::max(1, static_cast<int>(kHintRadius * side));
  for (const Flood& flood : floods) cv::circle(mask, flood.at, dot, cv::Scalar(cv::GC_FGD), cv::FILLED);
  for (const PicturePoint hint : hints.outside) {
    if (copy.holds(copy.at(hint))) cv::circle(mask, copy.at(hint), dot, cv::Scalar(cv::GC_BGD), cv::FILLED);
  }
  addMarks(copy, hints, mask);
  return mask;
}

/// Where the mask says that the thing is, certainly or likely.
cv::Mat thingOf(const cv::Mat& mask) {
  return maskWhere(mask.size(), [&](int pixel) { return (mask.data[pixel] & 1) != 0; });
}

/// The pieces with a hint or a mark in them, or the largest.
cv::Mat wantedPieces(const cv::Mat& thing, const Copy& copy, const CutHints& hints, const cv::Mat& marked) {
  const Pieces pieces(thing);
  std::vector<bool> keep = pieces.touched(marked);
  for (const PicturePoint hint : hints.inside) {
    const cv::Point at = copy.at(hint);
    if (copy.holds(at)) keep[static_cast<std::size_t>(pieces.of(at.y * thing.cols + at.x))] = true;
  }
  keep[0] = false;  // the ground
  if (std::ranges::none_of(keep, [](bool kept) { return kept; }) && pieces.count() > 1) {
    keep[static_cast<std::size_t>(std::ranges::max_element(pieces.area) - pieces.area.begin())] = true;
  }
  return maskWhere(thing.size(), [&](int pixel) { return keep[static_cast<std::size_t>(pieces.of(pixel))]; });
}

/// Which things of a drawing the hints mean: those under a hint or a mark, as wide as a finger, or those within the
/// box.
cv::Mat meantThings(const Drawing& drawing, const Copy& copy, const CutHints& hints) {
  const Pieces pieces(drawing.things);
  cv::Mat hinted = markedAs(copy, hints, true);
  const int dot = static_cast<int>(kHintRadius * std::max(hinted.cols, hinted.rows));
  for (const PicturePoint hint : hints.inside) cv::circle(hinted, copy.at(hint), dot, cv::Scalar(255), cv::FILLED);
  std::vector<bool> meant = pieces.touched(hinted);
  if (hints.box) {
    cv::Mat beyond = plainMask(copy.bgr.size(), 255);
    const cv::Point low = copy.at(hints.box->low), high = copy.at(hints.box->high);
    beyond(cv::Rect(low, high) & cv::Rect({0, 0}, beyond.size())).setTo(cv::Scalar(0));
    const std::vector<bool> reaches = pieces.touched(beyond);
    for (std::size_t i = 0; i < meant.size(); ++i) meant[i] = meant[i] || !reaches[i];
  }
  meant[0] = false;
  return maskWhere(copy.bgr.size(), [&](int pixel) { return meant[static_cast<std::size_t>(pieces.of(pixel))]; });
}

/// Pieces of `mask` below the size of noise become `value`, but for those with a marked pixel.
void dropNoise(cv::Mat& mask, const cv::Mat& of, const cv::Mat& marked, int value) {
  const double noise = kNoiseShare * static_cast<double>(of.total());
  const Pieces pieces(of);
  std::vector<bool> keep = pieces.touched(marked);
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = keep[i] || i == 0 || pieces.area[i] >= noise;
  const auto drops = [&](int pixel) { return !keep[static_cast<std::size_t>(pieces.of(pixel))]; };
  mask.setTo(cv::Scalar(value), maskWhere(mask.size(), drops));
}

/// A closed outline of whole pixels with its steps evened out: each point is a mean of those around it.
std::vector<PicturePoint> smoothOutline(const std::vector<cv::Point>& pixels, const Copy& copy) {
  const int count = static_cast<int>(pixels.size());
  std::vector<PicturePoint> outline;
  for (int i = 0; i < count; ++i) {
    double x = 0, y = 0, weights = 0;
    for (int k = -kSmoothing; k <= kSmoothing; ++k) {
      const double weight = kSmoothing + 1 - std::abs(k);
      const cv::Point& p = pixels[static_cast<std::size_t>(((i + k) % count + count) % count)];
      x += weight * p.x;
      y += weight * p.y;
      weights += weight;
    }
    outline.push_back(copy.back(x / weights, y / weights));
  }
  return outline;
}

/// Outlines between pixels: the mask is traced at twice its size, so that the thing keeps its width.
CutContours outlinesOf(const cv::Mat& thing, const Copy& copy) {
  std::vector<std::vector<cv::Point>> traced;
  cv::findContours(doubled(thing), traced, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Copy fine = copy;
  fine.scaleX /= 2;
  fine.scaleY /= 2;
  CutContours contours;
  for (auto& pixels : traced) {
    if (pixels.size() < 8) continue;
    for (cv::Point& p : pixels) p -= cv::Point(1, 1);
    contours.push_back(smoothOutline(pixels, fine));
  }
  return contours;
}

bool isUsable(const CutHints& hints, const Copy& copy) {
  const auto onPicture = [&](PicturePoint p) { return isFinite(p) && std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; };
  if (!std::ranges::all_of(hints.inside, onPicture) || !std::ranges::all_of(hints.outside, onPicture)) {
    return false;
  }
  for (const CutMark& mark : hints.marks) {
    if (!std::isfinite(mark.radius) || std::abs(mark.radius) > 1e6) return false;
    if (!std::ranges::all_of(mark.line, onPicture)) return false;
  }
  if (hints.box) {
    if (!onPicture(hints.box->low) || !onPicture(hints.box->high)) return false;
    const cv::Rect rect =
        cv::Rect(copy.at(hints.box->low), copy.at(hints.box->high)) & cv::Rect(0, 0, copy.bgr.cols, copy.bgr.rows);
    return rect.width > 2 && rect.height > 2;
  }
  const auto holds = [&](PicturePoint p) { return copy.holds(copy.at(p)); };
  return std::ranges::any_of(hints.inside, holds) || std::ranges::any_of(hints.marks, [&](const CutMark& mark) {
           return mark.inside && std::ranges::any_of(mark.line, holds);
         });
}

}  // namespace

struct CutOutSearch::State {
  Copy copy;
  CutHints hints;
  cv::Mat mask, inside, outside;  ///< the mask and the two colour models of GrabCut
  int round = 0, rounds = kRounds;
  bool failed = false;

  bool findDrawn(const image::Picture& picture);
  CutContours outlines() const;
};

/// Whether the picture is a drawing whose lines say what the thing is, or that there is only paper: then there are no
/// rounds.
bool CutOutSearch::State::findDrawn(const image::Picture& picture) {
  const Copy fine = copyOf(picture, {0, 0, picture.working.width, picture.working.height}, kDrawnSide);
  if (fine.bgr.empty() || !isUsable(hints, fine)) return false;
  const Drawing drawing = findEnclosed(imageOf(fine));
  if (!drawing.any) return false;
  const cv::Mat meant = meantThings(drawing, fine, hints);
  const auto isPaper = [&](PicturePoint hint) {
    const cv::Point at = fine.at(hint);
    return fine.holds(at) && drawing.paper.at<std::uint8_t>(at) != 0;
  };
  if (cv::countNonZero(meant) == 0 && std::ranges::none_of(hints.inside, isPaper)) return false;
  copy = fine;
  mask = plainMask(meant.size(), cv::GC_BGD);
  mask.setTo(cv::Scalar(cv::GC_FGD), meant);
  round = rounds;
  return true;
}

CutContours CutOutSearch::State::outlines() const {
  const cv::Mat in = markedAs(copy, hints, true), out = markedAs(copy, hints, false);
  cv::Mat thing = wantedPieces(thingOf(mask), copy, hints, in);
  thing = grown(grown(thing, 0), 255);  // without what is thinner than three pixels
  const double share = static_cast<double>(cv::countNonZero(thing)) / static_cast<double>(thing.total());
  if (hints.marks.empty() && (share < kLeastShare || share > kMostShare)) return {};
  thing.setTo(cv::Scalar(255), in);
  thing.setTo(cv::Scalar(0), out);
  dropNoise(thing, thing.clone(), in, 0);
  dropNoise(thing, maskWhere(thing.size(), [&](int pixel) { return thing.data[pixel] == 0; }), out, 255);
  return outlinesOf(thing, copy);
}

CutOutSearch::CutOutSearch(std::unique_ptr<State> state) : state_(std::move(state)) {}
CutOutSearch::CutOutSearch(CutOutSearch&&) noexcept = default;
CutOutSearch& CutOutSearch::operator=(CutOutSearch&&) noexcept = default;
CutOutSearch::~CutOutSearch() = default;

Result<CutOutSearch> CutOutSearch::begin(const image::Picture& picture, const CutHints& hints) {
  try {
    if (picture.working.empty()) return Error::PictureEmpty;
    useOneThread();
    auto state = std::make_unique<State>();
    state->copy = copyOf(picture, frameOf(picture, hints), kCutSide);
    state->hints = hints;
    if (state->copy.bgr.empty()) return Error::PictureEmpty;
    if (!isUsable(hints, state->copy)) return {Error::ValueOutOfRange, "hint"};
    if (state->findDrawn(picture)) return CutOutSearch(std::move(state));
    state->mask = firstGuess(state->copy, hints, false);
    const int likely = cv::countNonZero(thingOf(state->mask));
    if (likely == 0 || likely == static_cast<int>(state->mask.total())) return Error::NothingCutOut;
    return CutOutSearch(std::move(state));
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  } catch (const cv::Exception&) {
    return Error::NothingCutOut;
  }
}

bool CutOutSearch::step() {
  State& s = *state_;
  if (s.failed || s.round >= s.rounds) return false;
  try {
    cv::setRNGSeed(1);  // GrabCut begins with k-means, which begins by chance
    cv::grabCut(s.copy.bgr, s.mask, {}, s.inside, s.outside, 1,
                s.round % kRounds == 0 ? cv::GC_INIT_WITH_MASK : cv::GC_EVAL);
    ++s.round;
    // Where thing and ground are alike, a whole box of "likely" is taken away as a whole.
    const bool again = s.round == kRounds && s.rounds == kRounds && s.hints.box && s.outlines().empty();
    if (again) {
      s.rounds = 2 * kRounds;
      s.mask = firstGuess(s.copy, s.hints, true);
    }
  } catch (const std::bad_alloc&) {
    s.failed = true;
  } catch (const cv::Exception&) {
    s.failed = true;
  }
  return !s.failed && s.round < s.rounds;
}

double CutOutSearch::done() const { return state_->failed ? 1 : static_cast<double>(state_->round) / state_->rounds; }

Result<CutContours> CutOutSearch::outlines() const {
  try {
    if (state_->failed) return Error::NothingCutOut;
    CutContours contours = state_->outlines();
    if (contours.empty()) return Error::NothingCutOut;
    return contours;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  } catch (const cv::Exception&) {
    return Error::NothingCutOut;
  }
}

Result<CutContours> cutOut(const image::Picture& picture, const CutHints& hints) {
  Result<CutOutSearch> search = CutOutSearch::begin(picture, hints);
  if (!search) return search.failure();
  while (search.value().step()) {
  }
  return search.value().outlines();
}

}  // namespace spineloft::vision
