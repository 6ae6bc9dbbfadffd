#include "engine/surface/part_texture.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "engine/surface/alpha_matting.h"
#include "engine/surface/background_mask.h"
#include "engine/surface/edge_padding.h"
#include "engine/surface/occluder_mask.h"
#include "engine/surface/raster.h"

namespace spineloft::surface {
namespace {

/// Pixels around what is covered: of the texture, room for filters; and while colours are judged,
/// what the part stands before, beyond the clearance.
constexpr int kBorder = 8, kAround = 24;

/// Whole pixels of a picture, the last ones excluded.
struct Cut {
  int left = 0, top = 0, right = 0, bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// Picture UV, without border.
std::optional<UvArea> areaOf(const Wrapped& surface) {
  UvArea area{1, 1, 0, 0};
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle) {
      const double x = static_cast<double>(surface.uv[v][0]), y = static_cast<double>(surface.uv[v][1]);
      if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) continue;
      area.left = std::min(area.left, x), area.right = std::max(area.right, x);
      area.top = std::min(area.top, y), area.bottom = std::max(area.bottom, y);
    }
  }
  if (!(area.left <= area.right && area.top <= area.bottom)) return std::nullopt;
  return area;
}

/// The pixels of an area and of a border around it, as far as there are any.
Cut cutOf(const UvArea& area, image::Size picture, int border) {
  const auto low = [&](double share, int side) {
    return std::max(0, static_cast<int>(std::floor(share * side)) - border);
  };
  const auto high = [&](double share, int side) {
    return std::min(side, static_cast<int>(std::ceil(share * side)) + border);
  };
  return {low(area.left, picture.width), low(area.top, picture.height), high(area.right, picture.width),
          high(area.bottom, picture.height)};
}

/// Of an image or a mask.
template <class Pixels>
Pixels cutOut(const Pixels& picture, const Cut& cut) {
  constexpr std::ptrdiff_t kBytes = std::is_same_v<Pixels, image::Image> ? 4 : 1;
  Pixels out{cut.width(), cut.height(), {}};
  const std::ptrdiff_t row = kBytes * cut.width();
  out.pixels.reserve(static_cast<std::size_t>(row) * static_cast<std::size_t>(cut.height()));
  for (int y = cut.top; y < cut.bottom; ++y) {
    const auto first = picture.pixels.begin() + kBytes * (static_cast<std::ptrdiff_t>(y) * picture.width + cut.left);
    out.pixels.insert(out.pixels.end(), first, first + row);
  }
  return out;
}

/// From the picture's UV to pixels of the texture, centres at integers.
class ToTexture {
 public:
  ToTexture(const UvArea& area, image::Size texture)
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

image::Mask emptyMask(image::Size size) {
  image::Mask mask{size.width, size.height, {}};
  mask.pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 0);
  return mask;
}

image::Mask coverOf(const Wrapped& surface, const UvArea& area, image::Size size) {
  image::Mask mask = emptyMask(size);
  const ToTexture toTexture(area, size);
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

/// What polygons cover, each by a fan.
image::Mask filled(std::span<const std::vector<PicturePoint>> polygons, const UvArea& area, image::Size size) {
  image::Mask mask = emptyMask(size);
  const ToTexture toTexture(area, size);
  for (const std::vector<PicturePoint>& polygon : polygons) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array<PicturePoint, 3> corners = {toTexture(polygon[0].x, polygon[0].y),
                                                   toTexture(polygon[i - 1].x, polygon[i - 1].y),
                                                   toTexture(polygon[i].x, polygon[i].y)};
      if (isFinite(corners[0]) && isFinite(corners[1]) && isFinite(corners[2])) {
        coverTriangle(corners, mask);
      }
    }
  }
  return mask;
}

/// `a` where `b` is inside too.
image::Mask common(image::Mask a, const image::Mask& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (b.pixels[i] == 0) a.pixels[i] = 0;
  }
  return a;
}

/// `a`, and what `b` and `c` have in common.
void addIntersection(image::Mask& a, const image::Mask& b, const image::Mask& c) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    a.pixels[i] = static_cast<std::uint8_t>(a.pixels[i] | (b.pixels[i] & c.pixels[i]));
}

/// How a part lies on its picture.
struct Lie {
  image::Mask covered, sure, hidden;
  double margin = 0;     ///< of the rim, px
  double clearance = 0;  ///< around the part, px
};

/// What a part keeps of its picture.
struct KeptPixels {
  image::Mask inner;  ///< and carries on to where it keeps nothing
  image::Mask rim;    ///< and shows as it is: a little of what is behind may be mixed into it
};

/// The picture of a part: what it keeps, and its colours carried on over the rest. Empty when it keeps
/// nothing.
image::Image coloursOf(const image::Image& shown, const KeptPixels& kept) {
  image::Image out = padEdges(shown, kept.inner);
  if (out.empty()) return out;
  for (std::size_t i = 0; i < kept.rim.pixels.size(); ++i) {
    const std::uint8_t* p = shown.pixels.data() + 4 * i;
    if (kept.rim.pixels[i] != 0 && p[3] >= 128) std::copy(p, p + 3, out.pixels.data() + 4 * i);
  }
  return out;
}

/// Mean depth of a surface, pixels of the picture, about.
double depthOf(const Wrapped& surface, const UvArea& area, image::Size picture) {
  const Cut cut = cutOf(area, picture, 0);
  constexpr int kMostSide = 128;
  const image::Size size = image::fitSize({cut.width(), cut.height()}, kMostSide * kMostSide, kMostSide);
  if (size.width <= 0) return 0;
  return meanDepth(coverOf(surface, area, size)) * cut.width() / size.width;
}

UvArea uvOf(const Cut& cut, image::Size picture) {
  const double width = picture.width, height = picture.height;
  return {cut.left / width, cut.top / height, cut.right / width, cut.bottom / height};
}

/// As far as a texture of size `own` at the same scale would have to be.
image::Image shrunkLike(image::Image image, image::Size own) {
  const image::Size fit = image::fitSize(own, kTexturePixels, kTextureSide);
  if (fit == own) return image;
  const auto side = [](int pixels, int to, int from) {
    return std::max(1, static_cast<int>(static_cast<long long>(pixels) * to / from));
  };
  return image::shrink(image, side(image.width, fit.width, own.width), side(image.height, fit.height, own.height));
}

}  // namespace

struct TextureSteps::State {
  using Step = void (State::*)();

  State(const image::Image& of, const Wrapped& wrapped) : picture(of), surface(wrapped) {}

  const image::Image& picture;
  Wrapped surface;
  Step next = &State::begin;  ///< null: it is made
  Cut cut, wide;              ///< of the picture: what the texture shows, and what is judged with it
  image::Image shown;         ///< the wide one, as large as the texture's pixels are
  Lie lie;
  image::Mask inner;     ///< what can be kept where the part is sure
  image::Mask familiar;  ///< what is not background
  KeptPixels kept;
  Untold untold;
  std::size_t crossed = 0;          ///< of the crossings that were looked at
  std::optional<ColourPyramid> in;  ///< the part's colours, from what it keeps
  std::optional<RimUnmixing> unmixing;
  std::optional<PartTexture> made;

  image::Size whole() const { return {picture.width, picture.height}; }
  image::Size size() const { return {shown.width, shown.height}; }

  void begin();
  void trust();
  void uncover();
  void judge();
  void settle();
  void lookAtRim();
  void unmix();
  void relearn();
  void cleanRim();
  void finish();
};

void TextureSteps::State::begin() {
  next = nullptr;
  if (picture.empty()) return;
  const std::optional<UvArea> area = areaOf(surface);
  if (!area) return;
  lie.margin = rimMargin(std::max(picture.width, picture.height));
  if (!surface.sure.empty()) lie.clearance = clearanceOf(depthOf(surface, *area, whole()));
  cut = cutOf(*area, whole(), kBorder);
  wide = cutOf(*area, whole(), kAround + static_cast<int>(std::ceil(lie.clearance)));
  shown = shrunkLike(cutOut(picture, wide), {cut.width(), cut.height()});
  const UvArea around = uvOf(wide, whole());
  lie.covered = coverOf(surface, around, size());
  lie.sure = surface.sure.empty() ? lie.covered : filled(surface.sure, around, size());
  lie.hidden = filled(surface.hidden, around, size());
  next = &State::trust;
}

/// What can be seen well inside the outline, and what of that is sure.
void TextureSteps::State::trust() {
  inner = trusted(lie.covered, lie.margin);
  kept.rim = lie.covered;
  if (!surface.hidden.empty()) {
    const image::Mask seen = opposite(lie.hidden);
    inner = common(std::move(inner), inset(seen, lie.margin));
    kept.rim = common(std::move(kept.rim), seen);
  }
  kept.inner = common(inner, lie.sure);
  in.emplace(shown, kept.inner);
  next = surface.occludedStretches.empty() ? &State::judge : &State::uncover;
}

/// What an occluder hides is neither seen nor sure; one stretch a step.
void TextureSteps::State::uncover() {
  constexpr double kSpread = 2;  // in rims: its edge is soft, and most files spread colours further than brightness
  const OccludedOutline& crossing = surface.occludedStretches[crossed++];
  next = crossed < surface.occludedStretches.size() ? &State::uncover : &State::judge;
  const UvArea around = uvOf(wide, whole());
  const image::Mask outside = filled(crossing.outside, around, size());
  const image::Mask threshold = filled(crossing.threshold, around, size()),
                    reach = filled(crossing.reach, around, size());
  const image::Mask found = occluderMask({shown, lie.covered, inner, outside, threshold, reach});
  if (found.pixels.empty()) return;
  const image::Mask seen = inset(opposite(found), kSpread * lie.margin);
  inner = common(std::move(inner), seen);
  kept.rim = common(std::move(kept.rim), seen);
  kept.inner = common(inner, lie.sure);
  in.emplace(shown, kept.inner);
}

/// What is not sure, by its colours.
void TextureSteps::State::judge() {
  next = &State::lookAtRim;
  if (in->empty()) {  // nothing is sure, or nothing but the rim seen
    kept.inner = inner;
    in.emplace(shown, kept.inner);
  } else if (kept.inner != inner) {
    familiar = ownPixels({shown, lie.covered, lie.sure, kept.inner, *in}, lie.clearance);
    next = &State::settle;
  }
}

/// What is mixed with pixels of the background goes with them.
void TextureSteps::State::settle() {
  kept.rim = common(std::move(kept.rim), familiar);
  kept.inner = common(inner, inset(familiar, lie.margin));
  in.emplace(shown, kept.inner);
  next = &State::lookAtRim;
}

void TextureSteps::State::lookAtRim() {
  next = in->empty() ? &State::cleanRim : &State::unmix;
  if (!in->empty()) unmixing.emplace(shown, kept.rim, kept.inner, lie.margin, softReach(lie.margin, lie.clearance));
}

/// Where the rim is soft, what is behind goes out of it.
void TextureSteps::State::unmix() {
  next = &State::cleanRim;
  if (unmixing->change()) next = &State::relearn;
  untold = unmixing->untold();
  unmixing.reset();
}

void TextureSteps::State::relearn() {
  next = &State::cleanRim;
  in.emplace(shown, kept.inner);
}

void TextureSteps::State::cleanRim() {
  next = &State::finish;
  if (in->empty()) {
    kept = {lie.covered, emptyMask(size())};
    return;
  }
  const image::Mask beyond = inset(opposite(kept.rim), lie.margin);
  const ColourPyramid out(shown, beyond);
  const image::Mask rim = std::move(kept.rim);
  kept.rim = out.empty() ? emptyMask(size()) : withCleanRim(shown, kept.inner, rim, *in, out);
  if (untold.alike.pixels.empty()) return;
  addIntersection(kept.rim, untold.alike, rim);
  addIntersection(kept.inner, untold.drawn, rim);
}

void TextureSteps::State::finish() {
  next = nullptr;
  // Of these pixels those within the cut.
  const auto first = [](int from, int side, int pixels) {
    return static_cast<int>((static_cast<long long>(from) * pixels + side - 1) / side);
  };
  const auto last = [](int to, int side, int pixels) {
    return static_cast<int>(static_cast<long long>(to) * pixels / side);
  };
  const Cut own{
      first(cut.left - wide.left, wide.width(), shown.width), first(cut.top - wide.top, wide.height(), shown.height),
      last(cut.right - wide.left, wide.width(), shown.width), last(cut.bottom - wide.top, wide.height(), shown.height)};
  const UvArea around = uvOf(wide, whole()), share = uvOf(own, size());
  const double width = around.right - around.left, height = around.bottom - around.top;
  image::Image pixels = coloursOf(cutOut(shown, own), {cutOut(kept.inner, own), cutOut(kept.rim, own)});
  if (pixels.empty()) return;
  made = PartTexture{std::move(pixels),
                     {around.left + share.left * width, around.top + share.top * height,
                      around.left + share.right * width, around.top + share.bottom * height}};
}

TextureSteps::TextureSteps(const image::Image& picture, const Wrapped& surface)
    : state_(std::make_unique<State>(picture, surface)) {}
TextureSteps::~TextureSteps() = default;

bool TextureSteps::step() {
  if (state_->next != nullptr) (state_.get()->*state_->next)();
  return state_->next != nullptr;
}

std::optional<PartTexture> TextureSteps::take() { return std::move(state_->made); }

std::optional<PartTexture> partTexture(const image::Image& picture, const Wrapped& surface) {
  TextureSteps steps(picture, surface);
  while (steps.step()) {
  }
  return steps.take();
}

}  // namespace spineloft::surface
