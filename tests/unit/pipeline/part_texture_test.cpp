#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/pipeline/derive.h"
#include "engine/surface/atlas.h"
#include "tests/support/front_view.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::document;
using spineloft::testing::requireLawful;

namespace {

constexpr int kWidth = 320, kHeight = 240;

double middleAt(int x) { return 120 + 22 * std::sin(x / 60.0); }
double halfAt(int x) { return 30 + 14 * std::cos(x / 45.0); }
bool isThing(int x, int y) { return x >= 30 && x <= 290 && std::abs(y - middleAt(x)) <= halfAt(x); }

/// A tapering, curved thing with soft stripes on a ground of one loud colour; its outline is mixed
/// with the ground as a camera mixes it, over so many pixels.
image::Picture stripedPicture(std::array<double, 3> ground, double mixed = 1) {
  image::Image out{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double inside = std::clamp((halfAt(x) - std::abs(y - middleAt(x))) / mixed + 0.5, 0.0, 1.0) *
                            std::clamp(std::min(x - 30.0, 290.0 - x) / mixed + 0.5, 0.0, 1.0);
      const double stripe = 0.5 + 0.5 * std::sin(x / 9.0 + y / 17.0);
      const std::array<double, 3> thing = {40 + 60 * stripe, 120 + 80 * stripe, 40 + 20 * stripe};
      for (std::size_t c = 0; c < 3; ++c) {
        out.pixels.push_back(std::uint8_t(std::lround(ground[c] + inside * (thing[c] - ground[c]))));
      }
      out.pixels.push_back(255);
    }
  }
  return image::makePicture(std::move(out));
}

std::vector<PicturePoint> middleStroke() {
  std::vector<PicturePoint> stroke;
  for (int x = 36; x <= 284; x += 4) stroke.push_back({double(x), middleAt(x)});
  return stroke;
}

Document stripedDocument(std::array<double, 3> ground) {
  const auto picture = std::make_shared<const image::Picture>(stripedPicture(ground));
  Document document = update({}, AddPicture{"striped", picture}).value();
  return update(document, DrawSpine{PictureId{1}, middleStroke()}).value();
}

std::shared_ptr<const pipeline::PartShape> shapeOf(const Document& document) {
  pipeline::Cache cache;
  return pipeline::deriveWithEdges(document, cache, {}).value().parts[0].shape;
}

testing::ColourAt wearing(const surface::PartTexture& texture) {
  return [&texture](double u, double v) {
    const surface::UvArea& a = texture.area;
    return testing::sampled(texture.pixels, (u - a.left) / (a.right - a.left), (v - a.top) / (a.bottom - a.top));
  };
}

}  // namespace

TEST_CASE("seen from the front a part looks as its picture does, to 30 dB") {
  const Document document = stripedDocument({200, 190, 180});
  const auto shape = shapeOf(document);
  REQUIRE(shape);
  REQUIRE(shape->texture);
  requireLawful(shape->mesh);
  auto seen = testing::frontView(shape->mesh, {kWidth, kHeight}, wearing(*shape->texture));
  // Its round ends reach over the thing's flat ones: the ground there is not the part's.
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!isThing(int(i % kWidth), int(i / kWidth))) seen[i].reset();
  }
  CHECK(std::ranges::count_if(seen, [](const auto& p) { return p.has_value(); }) > 12000);
  const double found = testing::psnr(seen, document.pictures[0]->picture->working);
  MESSAGE("front view: " << found << " dB");
  CHECK(found >= 30);
}

TEST_CASE("the ends of a thing show their own colours, whatever they are") {
  // A blue foot, where ribs may reach beyond the thing.
  image::Picture picture = stripedPicture({200, 190, 180});
  const auto isFoot = [](int x, int y) { return x >= 268 && isThing(x, y); };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::uint8_t* p = picture.working.pixels.data() + 4 * (std::size_t(y) * kWidth + std::size_t(x));
      if (isFoot(x, y)) p[0] = 30, p[1] = 40, p[2] = 160;
    }
  }
  const auto shared = std::make_shared<const image::Picture>(picture);
  Document document = update({}, AddPicture{"foot", shared}).value();
  document = update(document, DrawSpine{PictureId{1}, middleStroke()}).value();
  const auto shape = shapeOf(document);
  REQUIRE(shape);
  REQUIRE(shape->texture);
  auto seen = testing::frontView(shape->mesh, {kWidth, kHeight}, wearing(*shape->texture));
  int looked = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t i = std::size_t(y) * kWidth + std::size_t(x);
      const bool inner = isFoot(x - 2, y - 2) && isFoot(x + 2, y + 2) && isFoot(x - 2, y + 2) && isFoot(x + 2, y - 2);
      if (!inner || !seen[i]) seen[i].reset();
      looked += seen[i] ? 1 : 0;
    }
  }
  CHECK(looked > 300);
  CHECK(testing::psnr(seen, picture.working) >= 30);
}

TEST_CASE("a loud ground leaves no trace on the part, on its rim neither") {
  const auto shape = shapeOf(stripedDocument({255, 0, 255}));
  REQUIRE(shape);
  REQUIRE(shape->texture);
  const auto colour = wearing(*shape->texture);
  // The thing itself is green: its green is the largest of the three everywhere.
  const auto isClean = [&](double u, double v) {
    const auto [r, g, b] = colour(u, v);
    return g > r + 5 && g > b + 5;
  };
  const mesh::TriMesh& mesh = shape->mesh;
  int soiled = 0;
  for (const auto& uv : mesh.uv) soiled += isClean(uv[0], uv[1]) ? 0 : 1;
  for (const auto& t : mesh.triangles) {
    for (const double w : {0.2, 0.5, 0.8}) {
      const auto mixed = [&](std::size_t k) {
        return mesh.uv[t[0]][k] * w + mesh.uv[t[1]][k] * (1 - w) / 2 + mesh.uv[t[2]][k] * (1 - w) / 2;
      };
      soiled += isClean(mixed(0), mixed(1)) ? 0 : 1;
    }
  }
  CHECK(soiled == 0);
}

namespace {

/// The thing's outline, so many pixels outside it.
Region outlineOf(double off) {
  std::vector<PicturePoint> line;
  for (int x = 30; x <= 290; x += 2) line.push_back({double(x), middleAt(x) - halfAt(x) - off});
  for (int x = 290; x >= 30; x -= 2) line.push_back({double(x), middleAt(x) + halfAt(x) + off});
  return {PictureId{1}, {line}, 0};
}

/// Of what of a part is turned away by more than 60 degrees from the front and the back, the share that is not green;
/// its ends, where a stroke may reach over the thing's, apart.
double shareSoiled(const pipeline::PartShape& shape) {
  const auto colour = wearing(*shape.texture);
  const mesh::TriMesh& mesh = shape.mesh;
  double whole = 0, soiled = 0;
  for (const auto& t : mesh.triangles) {
    const auto side = [&](std::size_t k) {
      const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[k]];
      return Vec3<ModelSpace>{double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2]};
    };
    const auto across = cross(side(1), side(2));
    if (std::abs(across.z) > 0.5 * norm(across)) continue;
    for (const double w : {0.2, 0.5, 0.8}) {
      const auto mixed = [&](std::size_t k) {
        return mesh.uv[t[0]][k] * w + mesh.uv[t[1]][k] * (1 - w) / 2 + mesh.uv[t[2]][k] * (1 - w) / 2;
      };
      if (mixed(0) * kWidth < 45 || mixed(0) * kWidth > 275) continue;
      const auto [r, g, b] = colour(mixed(0), mixed(1));
      whole += norm(across);
      // Where no ground is mixed in, red is at most half the green.
      soiled += r > 0.65 * g ? norm(across) : 0;
    }
  }
  REQUIRE(whole > 0);
  return soiled / whole;
}

}  // namespace

TEST_CASE(
    "the sides of a loft, a puff and a flat piece keep clean of a ground that is mixed in deeper than a rim, or "
    "outlined with them") {
  const auto picture = std::make_shared<const image::Picture>(stripedPicture({255, 0, 255}, 4));
  const Document document = update({}, AddPicture{"mixed", picture}).value();
  struct Made {
    std::string what;
    double off;
    Document with;
  };
  std::vector<Made> made = {{"loft", 0, update(document, DrawSpine{PictureId{1}, middleStroke()}).value()}};
  for (const double off : {0.0, 1.0, 2.0}) {
    made.push_back({"puff", off, update(document, DrawRegion{outlineOf(off), inflate::InflateParams{}}).value()});
    made.push_back({"flat piece", off, update(document, DrawRegion{outlineOf(off), extrude::ExtrudeParams{}}).value()});
  }
  for (const auto& [what, off, with] : made) {
    CAPTURE(what);
    CAPTURE(off);
    const auto shape = shapeOf(with);
    REQUIRE(shape);
    REQUIRE(shape->texture);
    requireLawful(shape->mesh);
    const double share = shareSoiled(*shape);
    MESSAGE(what << ", outlined " << off << " px outside: " << 100 * share << " % of the sides");
    CHECK(share < 0.02);
  }
}

TEST_CASE("what stands before a part does not colour it where its ends were bridged") {
  // A red post before the lower half of the thing.
  image::Picture picture = stripedPicture({200, 190, 180});
  for (int y = 126; y < kHeight; ++y) {
    for (int x = 150; x < 172; ++x) {
      std::uint8_t* p = picture.working.pixels.data() + 4 * (std::size_t(y) * kWidth + std::size_t(x));
      p[0] = 230, p[1] = 20, p[2] = 20;
    }
  }
  const auto shared = std::make_shared<const image::Picture>(picture);
  Document document = update({}, AddPicture{"post", shared}).value();
  document = update(document, DrawSpine{PictureId{1}, middleStroke()}).value();
  const auto shape = shapeOf(document);
  REQUIRE(shape);
  REQUIRE(shape->texture);
  // Wherever a rib end over the post was bridged or guessed, its own colour is not the post's.
  int looked = 0, red = 0;
  for (const ribs::Rib& rib : shape->ribs.ribs) {
    for (const bool left : {true, false}) {
      const ribs::RibState state = left ? rib.leftState : rib.rightState;
      const PicturePoint end = left ? rib.left : rib.right;
      if (state != ribs::RibState::Bridged && state != ribs::RibState::Guessed) continue;
      if (end.x < 152 || end.x > 169 || end.y < 126) continue;
      const auto [r, g, b] = wearing(*shape->texture)((end.x + 0.5) / kWidth, (end.y + 0.5) / kHeight);
      red += g > r ? 0 : 1;
      ++looked;
    }
  }
  CHECK(looked > 0);
  CHECK(red == 0);
}

namespace {

constexpr PicturePoint kSpot{160, 128};
constexpr double kSpotRadius = 12;

/// The thing with a red spot of another thing in its middle, where no rib end can tell.
Document spottedDocument() {
  image::Picture picture = stripedPicture({200, 190, 180});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::uint8_t* p = picture.working.pixels.data() + 4 * (std::size_t(y) * kWidth + std::size_t(x));
      if (distance(kSpot, {double(x), double(y)}) <= kSpotRadius) p[0] = 230, p[1] = 20, p[2] = 20;
    }
  }
  const auto shared = std::make_shared<const image::Picture>(std::move(picture));
  return update({}, AddPicture{"spot", shared}).value();
}

/// Red pixels of what a part shows, and those that differ from another texture of the same size.
int reds(const image::Image& pixels) {
  int count = 0;
  for (std::size_t i = 0; i + 3 < pixels.pixels.size(); i += 4)
    count += pixels.pixels[i] > pixels.pixels[i + 1] + 40 ? 1 : 0;
  return count;
}

/// What lies in a texture beyond the mark is as it was without it.
void requireEqualBeyond(const surface::PartTexture& with, const surface::PartTexture& without, double reach) {
  REQUIRE(with.area == without.area);
  REQUIRE(with.pixels.width == without.pixels.width);
  REQUIRE(with.pixels.height == without.pixels.height);
  for (int y = 0; y < with.pixels.height; ++y) {
    for (int x = 0; x < with.pixels.width; ++x) {
      const surface::UvArea& a = with.area;
      const PicturePoint at{(a.left + (a.right - a.left) * (x + 0.5) / with.pixels.width) * kWidth - 0.5,
                            (a.top + (a.bottom - a.top) * (y + 0.5) / with.pixels.height) * kHeight - 0.5};
      const std::size_t i = 4 * (std::size_t(y) * std::size_t(with.pixels.width) + std::size_t(x));
      // Well within the thing and the puff.
      const bool within = std::abs(at.x - 160) < 36 && std::abs(at.y - 129) < 17 &&
                          std::abs(at.y - middleAt(int(at.x))) < halfAt(int(at.x)) - 4;
      if (!within || distance(at, kSpot) <= reach) continue;
      REQUIRE(std::equal(&with.pixels.pixels[i], &with.pixels.pixels[i] + 4, &without.pixels.pixels[i]));
    }
  }
}

}  // namespace

TEST_CASE("under a mark that covers a part shows its own colours, and elsewhere what it showed, whatever its kind") {
  const Document empty = spottedDocument();
  const std::vector<PicturePoint> round = {{120, 108}, {200, 108}, {200, 150}, {120, 150}};
  DrawRegion inflate{};
  inflate.region = {PictureId{1}, {round}, 0};
  inflate.solid = inflate::InflateParams{};
  const ribs::IgnoreMark covers{{kSpot + PicturePoint{-1, 0}, kSpot + PicturePoint{1, 0}}, kSpotRadius + 1, true};
  for (const bool loft : {true, false}) {
    CAPTURE(loft);
    const Document document =
        loft ? update(empty, DrawSpine{PictureId{1}, middleStroke()}).value() : update(empty, inflate).value();
    const auto plain = shapeOf(document);
    REQUIRE((plain && plain->texture));
    CHECK(reds(plain->texture->pixels) > 300);
    ribs::IgnoreMark only = covers;
    only.covers = false;
    const auto ignored = shapeOf(update(document, IgnoreForPicture{PictureId{1}, {only}}).value());
    CHECK(reds(ignored->texture->pixels) > 300);
    const auto covered = shapeOf(update(document, IgnoreForPicture{PictureId{1}, {covers}}).value());
    REQUIRE((covered && covered->texture));
    CHECK(covered->key != plain->key);
    CHECK(reds(covered->texture->pixels) == 0);
    CHECK(covered->mesh.positions.size() == ignored->mesh.positions.size());
    // The mark, the rim around it, and a pixel of its corners.
    requireEqualBeyond(*covered->texture, *ignored->texture, kSpotRadius + 6);
    if (!loft) continue;
    const auto own = shapeOf(update(document, IgnoreForPart{PartId{1}, {covers}}).value());
    CHECK(*own->texture == *covered->texture);
    // All of it under a mark: then the picture is believed after all.
    const auto all = shapeOf(update(document, IgnoreForPart{PartId{1}, {{{{0, 120}, {320, 120}}, 200, true}}}).value());
    CHECK((all && all->texture));
  }
}

TEST_CASE("a texture depends on nothing but the shape and what it shows") {
  const Document document = stripedDocument({200, 190, 180});
  const auto a = shapeOf(document), b = shapeOf(update(document, SetLook{PartId{1}, {false, {1, 2, 3}}}).value());
  REQUIRE((a && a->texture && b && b->texture));
  CHECK(*a->texture == *b->texture);
  CHECK(a->texture->pixels.pixels.size() % 4 == 0);
  for (const auto& uv : a->mesh.uv) {
    CHECK(double(uv[0]) >= a->texture->area.left - 1e-6);
    CHECK(double(uv[0]) <= a->texture->area.right + 1e-6);
    CHECK(double(uv[1]) >= a->texture->area.top - 1e-6);
    CHECK(double(uv[1]) <= a->texture->area.bottom + 1e-6);
  }
}

TEST_CASE("a texture made in steps is the one made at once, and a step is never the whole of it") {
  for (const bool marked : {false, true}) {
    Document document = stripedDocument({200, 190, 180});
    const ribs::IgnoreMark mark{{{100, 110}, {140, 120}}, 9, true};
    if (marked) document = update(document, IgnoreForPart{PartId{1}, {mark}}).value();
    pipeline::Cache cache;
    REQUIRE(pipeline::deriveWithEdges(document, cache, {}).ok());
    const auto whole = shapeOf(document);
    pipeline::Cache later;
    later.keepEdges(document.pictures[0]->contentHash, cache.edges(document.pictures[0]->contentHash));
    const pipeline::Derived derived = pipeline::derive(document, later, {}, pipeline::Finish::Later);
    REQUIRE(derived.wantedTextures == std::vector{PartId{1}});
    CHECK(derived.parts[0].shape->texture == nullptr);
    const auto making = pipeline::makeTexture(document, derived, PartId{1});
    REQUIRE(making);
    CHECK(making->texture() == nullptr);
    int steps = 1;
    while (making->step()) ++steps;
    CHECK(steps >= 5);
    REQUIRE((making->texture() && whole->texture));
    CHECK(*making->texture() == *whole->texture);
    CHECK_FALSE(making->step());
    const auto textured = later.assignTexture(making->key(), making->texture());
    REQUIRE(textured);
    CHECK(isTextureKnown(*textured));
    const pipeline::Derived again = pipeline::derive(document, later, {}, pipeline::Finish::Later);
    CHECK(again.wantedTextures.empty());
    CHECK(again.parts[0].shape == textured);
    CHECK(later.assignTexture(TextureKey{12345}, nullptr) == nullptr);
  }
  CHECK(pipeline::makeTexture({}, {}, PartId{1}) == nullptr);
}

TEST_CASE("a part that fills a large picture is as sharp as the picture, and a very long one as an atlas can be") {
  const auto fineGrained = [](int width, int height) {
    Rng rng(3);
    image::Image out{width, height, {}};
    out.pixels.reserve(4 * std::size_t(width) * std::size_t(height));
    for (int i = 0; i < width * height; ++i) {
      const auto grey = std::uint8_t(60 + int(120 * rng.uniform()));
      out.pixels.insert(out.pixels.end(), {grey, grey, grey, 255});
    }
    return out;
  };
  const std::vector<std::array<float, 2>> corners = {{0.02f, 0.02f}, {0.98f, 0.02f}, {0.98f, 0.98f}, {0.02f, 0.98f}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto worn = [&](const image::Image& picture) {
    const auto texture = surface::partTexture(picture, {corners, triangles, {}, {}});
    REQUIRE(texture);
    return *texture;
  };
  const image::Image large = fineGrained(2000, 1200);  // more than two million
  const surface::PartTexture texture = worn(large);
  const int left = int(std::lround(texture.area.left * large.width)),
            top = int(std::lround(texture.area.top * large.height));
  CHECK(texture.pixels.width == int(std::lround(texture.area.right * large.width)) - left);
  int differing = 0;
  for (int y = 100; y < 1100; ++y) {
    for (int x = 100; x < 1900; ++x) {
      const std::uint8_t* own =
          &texture.pixels
               .pixels[4 * (std::size_t(y - top) * std::size_t(texture.pixels.width) + std::size_t(x - left))];
      differing += *own != large.pixels[4 * (std::size_t(y) * std::size_t(large.width) + std::size_t(x))] ? 1 : 0;
    }
  }
  CHECK(differing == 0);
  const surface::PartTexture longest = worn(fineGrained(5000, 60));
  const std::array<const image::Image*, 1> alone = {&longest.pixels};
  const auto atlas = surface::packAtlas(alone);
  REQUIRE(atlas);
  CHECK(longest.pixels.width >= surface::kTextureSide - 1);
  CHECK((atlas->places[0].right - atlas->places[0].left) * atlas->pixels.width ==
        doctest::Approx(longest.pixels.width));
}
