// The texture of a part: its picture, cut out, without the surroundings.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/limits.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::surface {

/// A rectangle of a picture in its UV (0…1, v down).
struct UvArea {
  double left = 0, top = 0, right = 1, bottom = 1;
  bool operator==(const UvArea&) const = default;
};

/// Opaque pixels that lie over `area` of the picture: the UV (u, v) of the picture is at
/// ((u − left) / (right − left), (v − top) / (bottom − top)) of them.
struct PartTexture {
  image::Image pixels;
  UvArea area;
  bool operator==(const PartTexture&) const = default;
};

/// Most pixels of one part's texture: as many as a picture's working copy has, so that a part is as sharp as that.
inline constexpr long long kTexturePixels = kWorkingPixels;
/// Most pixels on a side of it: what an atlas holds without shrinking it. Larger cut-outs are averaged down.
inline constexpr int kTextureSide = 4080;

/// A stretch of the outline of a part that may be hidden by an occluder, which may go on over the part. Polygons as
/// those of Wrapped.
struct OccludedOutline {
  std::vector<std::vector<PicturePoint>> outside;    ///< beside the stretch
  std::vector<std::vector<PicturePoint>> threshold;  ///< along it, in the part
  std::vector<std::vector<PicturePoint>> reach;      ///< all across the part, there and a little further
};

/// A surface over the picture. Spans must outlive the call.
struct Wrapped {
  std::span<const std::array<float, 2>> uv;                 ///< in the picture, 0…1
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< of indices into uv
  /// Polygons (picture UV, convex or nearly so) in which the picture certainly shows the part;
  /// empty: everywhere. Elsewhere the background or an occluder may show.
  std::span<const std::vector<PicturePoint>> sure;
  /// Polygons (the same) in which the picture certainly shows an occluder. May overlap.
  std::span<const std::vector<PicturePoint>> hidden;
  std::span<const OccludedOutline> occludedStretches = {};
};

/// Cuts out what the triangles cover of the picture's working copy. Where the picture shows the part, its pixels stay
/// as they are. Colours are extended from there (edge_padding.h)
/// - over the rim, where and as deep as the background is mixed into it, but not where the background looks as the
///   part does (alpha_matting.h);
/// - over transparent pixels, beyond the outline, over what is hidden, over occluders at a crossing
///   (occluder_mask.h), and over background where the part is not sure (background_mask.h).
/// From a soft rim the background is removed (alpha_matting.h). If nothing would be left, the rim is trusted after
/// all, and what is hidden too. None when no covered pixel can be seen, or nothing is covered. Linear in the pixels
/// of the cut-out and the rows of the triangles.
std::optional<PartTexture> partTexture(const image::Image& picture, const Wrapped& surface);

/// The same in steps, the longest about a quarter of the whole: for a page that is drawn in between.
class TextureSteps {
 public:
  /// The picture, and what the surface's spans show, must outlive it.
  TextureSteps(const image::Image& picture, const Wrapped& surface);
  ~TextureSteps();
  TextureSteps(const TextureSteps&) = delete;
  TextureSteps& operator=(const TextureSteps&) = delete;
  /// The next one. False: it was the last, and `take` has what partTexture gives.
  bool step();
  /// Once.
  std::optional<PartTexture> take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace spineloft::surface
