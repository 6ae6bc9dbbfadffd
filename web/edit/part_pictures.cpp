#include "web/edit/part_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/hash.h"
#include "engine/mesh/laws.h"

namespace spineloft::app {
namespace {

constexpr int kFine = 2;  // pixels that become one, each way

struct Corner {
  double x = 0, y = 0, z = 0, u = 0, v = 0;
};

using Colour = std::array<double, 3>;  // 0…255

/// What a point of the surface has as its colour, without the light.
class Surface {
 public:
  Surface(const pipeline::PartShape& shape, const document::Look& look, const image::Image* pixels)
      : look_(look), bounds_(mesh::boundsOf(shape.mesh)) {
    if (!look.textured || shape.mesh.uv.empty()) return;
    if (shape.texture) {
      image_ = &shape.texture->pixels;
      area_ = shape.texture->area;
    } else if (pixels != nullptr && !pixels->empty()) {
      image_ = pixels;
    }
  }

  Colour at(const Corner& p, double height) const {
    if (image_ == nullptr) {
      const double middle = (bounds_.low[1] + bounds_.high[1]) / 2;
      const bool below = look_.paint == surface::Paint::TwoTone && !look_.textured && height < middle;
      const auto& c = below ? look_.second : look_.colour;
      return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
    }
    const double u = (p.u - area_.left) / (area_.right - area_.left);
    const double v = (p.v - area_.top) / (area_.bottom - area_.top);
    const auto index = [](double share, int count) {
      return std::clamp(static_cast<int>(std::floor(share * count)), 0, count - 1);
    };
    const auto first =
        4 * (static_cast<std::size_t>(index(v, image_->height)) * static_cast<std::size_t>(image_->width) +
             static_cast<std::size_t>(index(u, image_->width)));
    const std::uint8_t* texel = image_->pixels.data() + first;
    return {static_cast<double>(texel[0]), static_cast<double>(texel[1]), static_cast<double>(texel[2])};
  }

 private:
  const document::Look& look_;
  mesh::Bounds bounds_;
  const image::Image* image_ = nullptr;
  surface::UvArea area_;
};

/// Pixels with the depth of what is in front.
class Canvas {
 public:
  explicit Canvas(int side) : side_(side), depth_(pixels(), -std::numeric_limits<double>::infinity()) {
    image_ = {side, side, std::vector<std::uint8_t>(4 * pixels(), 0)};
  }

  /// `colour(corner)` of the points inside; corners in pixels, larger z in front.
  template <class ColourOf>
  void fill(const std::array<Corner, 3>& t, const ColourOf& colour) {
    const auto [low, high] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, foot] = std::minmax({t[0].y, t[1].y, t[2].y});
    const double twice = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
    if (twice == 0 || !std::isfinite(twice)) return;
    const auto first = [&](double v) { return std::clamp(static_cast<int>(std::ceil(v - 0.5)), 0, side_); };
    for (int y = first(top); y < first(foot + 1) && y + 0.5 <= foot; ++y) {
      for (int x = first(low); x < first(high + 1) && x + 0.5 <= high; ++x) put(t, twice, x, y, colour);
    }
  }

  image::Image take() { return std::move(image_); }

 private:
  std::size_t pixels() const { return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }

  template <class ColourOf>
  void put(const std::array<Corner, 3>& t, double twice, int x, int y, const ColourOf& colour) {
    const double px = x + 0.5, py = y + 0.5;
    const auto share = [&](const Corner& a, const Corner& b) {
      return ((a.x - px) * (b.y - py) - (b.x - px) * (a.y - py)) / twice;
    };
    const std::array<double, 3> w{share(t[1], t[2]), share(t[2], t[0]), share(t[0], t[1])};
    if (w[0] < 0 || w[1] < 0 || w[2] < 0) return;
    const auto mix = [&](double Corner::* of) { return w[0] * t[0].*of + w[1] * t[1].*of + w[2] * t[2].*of; };
    const double z = mix(&Corner::z);
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
    if (z <= depth_[at]) return;
    depth_[at] = z;
    const Colour c = colour({px, py, z, mix(&Corner::u), mix(&Corner::v)});
    for (std::size_t i = 0; i < 3; ++i) {
      image_.pixels[4 * at + i] = static_cast<std::uint8_t>(std::lround(std::clamp(c[i], 0., 255.)));
    }
    image_.pixels[4 * at + 3] = 255;
  }

  int side_;
  std::vector<double> depth_;
  image::Image image_;
};

}  // namespace

image::Image partPicture(const pipeline::PartShape& shape, const document::Look& look, const image::Image* pixels) {
  const mesh::TriMesh& mesh = shape.mesh;
  const mesh::Bounds box = mesh::boundsOf(mesh);
  const double extent = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  if (!(extent > 0) || !std::isfinite(extent)) return {};
  const int side = kFine * kPartPictureSide;
  const double scale = (side - 2.) / extent;
  const double middleX = (box.low[0] + box.high[0]) / 2, middleY = (box.low[1] + box.high[1]) / 2;
  const auto corner = [&](std::uint32_t i) {
    const auto& p = mesh.positions[i];
    Corner out{side / 2. + (p[0] - middleX) * scale, side / 2. - (p[1] - middleY) * scale, p[2], 0, 0};
    if (!mesh.uv.empty()) {
      out.u = mesh.uv[i][0];
      out.v = mesh.uv[i][1];
    }
    return out;
  };
  const Surface surface(shape, look, pixels);
  Canvas canvas(side);
  for (const auto& t : mesh.triangles) {
    const std::array<Corner, 3> at{corner(t[0]), corner(t[1]), corner(t[2])};
    // The z of the unit normal; what looks away is behind what looks here.
    const double ax = at[1].x - at[0].x, ay = at[0].y - at[1].y, az = (at[1].z - at[0].z) * scale;
    const double bx = at[2].x - at[0].x, by = at[0].y - at[2].y, bz = (at[2].z - at[0].z) * scale;
    const double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0) || nz <= 0) continue;
    const double light = 0.6 + 0.4 * (nz + std::max(0., 0.5 * ny)) / (1.12 * length);
    canvas.fill(at, [&](const Corner& p) {
      Colour c = surface.at(p, middleY - (p.y - side / 2.) / scale);
      for (double& value : c) value *= std::min(1., light);
      return c;
    });
  }
  return image::shrink(canvas.take(), kPartPictureSide, kPartPictureSide);
}

const gl::SceneTexture* PartPictures::of(const document::Document& document, const pipeline::Derived& derived,
                                         const document::Part& part) {
  const auto at = std::ranges::find(derived.parts, part.id, &pipeline::DerivedPart::id);
  if (at == derived.parts.end() || !at->shape) return nullptr;
  const pipeline::PartShape& shape = *at->shape;
  const document::Look& look = part.look;
  Hasher hasher;
  hasher.text("part picture")
      .number(shape.key.hash)
      .number(look.textured ? shape.textureKey.hash : 0)
      .number(look.textured);
  hasher.number(look.paint);
  for (const auto& colour : {look.colour, look.second}) {
    for (const std::uint8_t value : colour) hasher.number(value);
  }
  const gl::TextureKey key{hasher.value()};
  const auto known = std::ranges::find_if(slots_, [&](const auto& slot) { return slot->texture.key == key; });
  if (known != slots_.end()) {
    (*known)->used = true;
    return (*known)->image.empty() ? nullptr : &(*known)->texture;
  }
  const image::Picture* pixels = pipeline::pixelsOf(document, derived, document::pictureOf(part));
  auto slot = std::make_unique<Slot>();
  slot->image = partPicture(shape, look, pixels ? &pixels->working : nullptr);
  slot->texture.key = key;
  slot->texture.image = &slot->image;
  slots_.push_back(std::move(slot));
  return slots_.back()->image.empty() ? nullptr : &slots_.back()->texture;
}

void PartPictures::forgetUnused() {
  std::erase_if(slots_, [](const auto& slot) { return !slot->used; });
  for (const auto& slot : slots_) slot->used = false;
}

}  // namespace spineloft::app
