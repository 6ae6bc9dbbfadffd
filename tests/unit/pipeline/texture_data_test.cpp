// How true the picture on a part is on real pictures, where the data folder is at hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/pipeline/derive.h"
#include "engine/surface/edge_padding.h"
#include "tests/support/front_view.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using namespace spineloft::document;

namespace {

namespace fs = std::filesystem;

fs::path firstOf(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return {};
}

/// Inside the silhouette of the part and the true one at once: all of it, without its rim, and all of it where each
/// pixel counts by how much of it is the thing. Decibels.
struct Front {
  double whole = -1, within = -1, counted = -1;
};
constexpr int kRim = 1;  // pixels: those through which the outline goes show the thing and what is behind it

using Seen = std::vector<std::optional<std::array<double, 3>>>;
Seen awayFromRim(const Seen& seen, int width, int height) {
  Seen left = seen;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      bool inner = x >= kRim && y >= kRim && x + kRim < width && y + kRim < height;
      for (int dy = -kRim; inner && dy <= kRim; ++dy) {
        for (int dx = -kRim; inner && dx <= kRim; ++dx) {
          inner = seen[static_cast<std::size_t>(y + dy) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x + dx)]
                      .has_value();
        }
      }
      if (!inner)
        left[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)].reset();
    }
  }
  return left;
}

image::Image maskOf(const fs::path& file) {
  const auto mask = io::decodeImage(testing::bytesOf(file), 1 << 26);
  REQUIRE(mask.ok());
  return mask.value();
}

/// What can be seen of the thing of a case, without so many pixels along its outline.
image::Image seenOf(const fs::path& folder, double without) {
  image::Image out = maskOf(firstOf(folder, {"mask_visible.png", "mask.png"}));
  image::Mask mask{out.width, out.height, {}};
  for (std::size_t i = 0; i < out.pixels.size(); i += 4) mask.pixels.push_back(out.pixels[i] >= 200 ? 255 : 0);
  const image::Mask left = surface::inset(mask, without);
  for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
    if (mask.pixels[i] != left.pixels[i]) out.pixels[4 * i] = 128;  // neither thing nor ground
  }
  return out;
}

/// The longest outline of a mask: the middles of its outermost pixels, in turn.
std::vector<PicturePoint> trueOutline(const image::Image& mask) {
  const auto inside = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return false;
    return mask.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                            static_cast<std::size_t>(x))] >= 200;
  };
  constexpr std::array<std::array<int, 2>, 8> kAround = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::set<std::array<int, 2>> seen;
  std::vector<PicturePoint> longest;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (!inside(x, y) || inside(x - 1, y) || seen.contains({x, y})) continue;
      std::vector<PicturePoint> outline;
      std::array<int, 2> at = {x, y};
      std::size_t from = 4;  // what is left of it is outside
      do {
        outline.push_back({double(at[0]), double(at[1])});
        seen.insert(at);
        std::size_t turn = 1;
        while (turn <= 8 && !inside(at[0] + kAround[(from + turn) % 8][0], at[1] + kAround[(from + turn) % 8][1]))
          ++turn;
        if (turn > 8) break;
        const std::size_t to = (from + turn) % 8;
        at = {at[0] + kAround[to][0], at[1] + kAround[to][1]};
        from = (to + (to % 2 == 0 ? 6 : 5)) % 8;
      } while (at != std::array<int, 2>{x, y} && outline.size() < mask.pixels.size());
      if (outline.size() > longest.size()) longest = outline;
    }
  }
  return longest;
}

/// The picture of a case, and what a stroke makes of it, or a puff or a flat piece of the true outline, so many pixels
/// further in.
struct Made {
  std::shared_ptr<const image::Picture> picture;
  std::shared_ptr<const pipeline::PartShape> shape;
};
Made madeOf(const fs::path& folder, const std::string& kind, double without = 0) {
  const auto picture = io::decodePicture(testing::bytesOf(firstOf(folder, {"image.jpg", "image.png"})), {});
  REQUIRE(picture.ok());
  const auto shared = std::make_shared<const image::Picture>(picture.value());
  Document document = update({}, AddPicture{"photo", shared}).value();
  if (kind == "puff" || kind == "flat") {
    const Region region{PictureId{1}, {trueOutline(seenOf(folder, without))}, 0};
    const RegionSolid solid =
        kind == "puff" ? RegionSolid{inflate::InflateParams{}} : RegionSolid{extrude::ExtrudeParams{}};
    document = update(document, DrawRegion{region, solid}).value();
  } else {
    const auto text = testing::bytesOf(folder / "case.json");
    const auto truth = nlohmann::json::parse(text.begin(), text.end());
    std::vector<PicturePoint> stroke;
    for (const auto& p : truth["spines"][kind]) stroke.push_back({p[0].get<double>(), p[1].get<double>()});
    document = update(document, DrawSpine{PictureId{1}, stroke}).value();
  }
  pipeline::Cache cache;
  const auto shape = pipeline::deriveWithEdges(document, cache, {}).value().parts[0].shape;
  REQUIRE(shape);
  testing::requireLawful(shape->mesh);
  return {shared, shape};
}

testing::ColourAt wearing(const surface::PartTexture& texture) {
  return [&texture](double u, double v) {
    const surface::UvArea& a = texture.area;
    return testing::sampled(texture.pixels, (u - a.left) / (a.right - a.left), (v - a.top) / (a.bottom - a.top));
  };
}

/// The same seen from the front; nothing without a texture.
struct Look {
  std::shared_ptr<const image::Picture> picture;
  Seen seen;
};
Look lookOf(const fs::path& folder, const std::string& kind, double without = 0) {
  const auto [shared, shape] = madeOf(folder, kind, without);
  if (!shape->texture || shared->working.width != shared->width) return {shared, {}};
  return {shared, testing::frontView(shape->mesh, {shared->width, shared->height}, wearing(*shape->texture))};
}

std::array<double, 3> pixelOf(const image::Image& image, std::size_t i) {
  const std::uint8_t* p = &image.pixels[4 * i];
  return {double(p[0]), double(p[1]), double(p[2])};
}

/// How far on the way from one colour to another a third lies, 0…1; nothing where they are alike.
std::optional<double> shareOfWay(const surface::Colour& from, const surface::Colour& to,
                                 const std::array<double, 3>& at, double alike) {
  double way = 0, gone = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double step = double(to[c]) - from[c];
    way += step * step, gone += step * (at[c] - from[c]);
  }
  if (way < alike * alike) return std::nullopt;
  return std::clamp(gone / way, 0.0, 1.0);
}

/// What a picture shows well inside the true outline, and well outside.
class Surroundings {
 public:
  Surroundings(const image::Image& shown, const image::Image& truth) : shown_(shown) {
    image::Mask within{truth.width, truth.height, {}}, without = within;
    for (std::size_t i = 0; i < truth.pixels.size(); i += 4) {
      within.pixels.push_back(truth.pixels[i] >= 200 ? 255 : 0);
      without.pixels.push_back(truth.pixels[i] == 0 ? 255 : 0);
    }
    within_ = surface::trusted(within, kAway), without_ = surface::inset(without, kAway);
  }
  /// Whether a colour that is shown from pixel (x, y) is unlike all of the thing there, and more like the ground.
  bool isGround(const std::array<double, 3>& colour, int x, int y) const {
    constexpr int kFar = 26, kStep = 2;
    constexpr double kUnlike = 16;
    double own = 1e9, ground = 1e9;
    for (int py = std::max(0, y - kFar); py < std::min(shown_.height, y + kFar + 1); py += kStep) {
      for (int px = std::max(0, x - kFar); px < std::min(shown_.width, x + kFar + 1); px += kStep) {
        const std::size_t i =
            static_cast<std::size_t>(py) * static_cast<std::size_t>(shown_.width) + static_cast<std::size_t>(px);
        double apart = 0;
        for (std::size_t c = 0; c < 3; ++c) apart += std::pow(colour[c] - shown_.pixels[4 * i + c], 2);
        if (within_.pixels[i] != 0) own = std::min(own, apart);
        if (without_.pixels[i] != 0) ground = std::min(ground, apart);
      }
    }
    return own < 1e9 && ground < own && own > kUnlike * kUnlike;
  }
  /// How like the picture what is seen is, each pixel counted by its share of the thing: where on the way between
  /// the colours further in and out it lies.
  double countedPsnr(const Seen& seen) const {
    constexpr double kAlike = 30;
    const surface::ColourPyramid in(shown_, within_), out(shown_, without_);
    REQUIRE_FALSE((in.empty() || out.empty()));
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!seen[i]) continue;
      const double own = 1 - shareOfWay(in.at(i), out.at(i), pixelOf(shown_, i), kAlike).value_or(0);
      for (std::size_t c = 0; c < 3; ++c) sum += own * std::pow((*seen[i])[c] - shown_.pixels[4 * i + c], 2);
      count += 3 * own;
    }
    return 10 * std::log10(255.0 * 255.0 / std::max(1e-9, sum / count));
  }

 private:
  static constexpr double kAway = 8;
  const image::Image& shown_;
  image::Mask within_, without_;
};

Front frontOf(const fs::path& folder, const std::string& kind, double without = 0) {
  const image::Image mask = seenOf(folder, without);
  auto [picture, seen] = lookOf(folder, kind, without);
  if (seen.empty()) return {};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (mask.pixels[4 * i] < 200) seen[i].reset();
  }
  const Seen inner = awayFromRim(seen, picture->width, picture->height);
  const double counted = Surroundings(picture->working, mask).countedPsnr(seen);
  return {testing::psnr(seen, picture->working), testing::psnr(inner, picture->working), counted};
}

/// Of what another thing hides of a part, the share in which the part looks as that thing does.
double shareWorn(const fs::path& folder, const std::string& kind) {
  constexpr double kAlike = 16;
  const image::Image whole = maskOf(folder / "mask.png"), visible = maskOf(folder / "mask_visible.png");
  const auto [picture, seen] = lookOf(folder, kind);
  int hidden = 0, worn = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i] || whole.pixels[4 * i] < 200 || visible.pixels[4 * i] >= 200) continue;
    double apart = 0;
    for (std::size_t c = 0; c < 3; ++c)
      apart = std::max(apart, std::abs((*seen[i])[c] - picture->working.pixels[4 * i + c]));
    ++hidden;
    worn += apart < kAlike ? 1 : 0;
  }
  REQUIRE(hidden > 1000);
  return double(worn) / hidden;
}

/// Along the edge of what another thing hides of a part, the mean share of that thing in what the part shows.
double shareAlongEdge(const fs::path& folder, const std::string& kind) {
  constexpr double kBeside = 6, kAlike = 40;
  const image::Image whole = maskOf(folder / "mask.png"), visible = maskOf(folder / "mask_visible.png");
  const auto [picture, seen] = lookOf(folder, kind);
  image::Mask hidden{whole.width, whole.height, {}}, own = hidden;
  for (std::size_t i = 0; i < whole.pixels.size(); i += 4) {
    own.pixels.push_back(visible.pixels[i] >= 200 ? 255 : 0);
    hidden.pixels.push_back(whole.pixels[i] >= 200 && own.pixels.back() == 0 ? 255 : 0);
  }
  const image::Mask core = surface::inset(hidden, kBeside), beyond = surface::inset(surface::opposite(hidden), kBeside);
  const image::Mask clear = surface::inset(surface::opposite(hidden), kBeside + 4);
  own = surface::inset(own, 4);
  for (std::size_t i = 0; i < own.pixels.size(); ++i) own.pixels[i] &= clear.pixels[i];
  const surface::ColourPyramid of(picture->working, own), hiding(picture->working, core);
  REQUIRE_FALSE((of.empty() || hiding.empty()));
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i] || whole.pixels[4 * i] < 200 || beyond.pixels[i] != 0 || core.pixels[i] != 0) continue;
    const auto share = shareOfWay(of.at(i), hiding.at(i), *seen[i], kAlike);
    if (!share) continue;
    sum += *share;
    ++count;
  }
  REQUIRE(count > 500);
  return sum / count;
}

/// Of what of a part is turned away by more than 60° from the front, and by less from the back's middle, the share
/// that shows colours of the ground.
double shareOfGroundOnSides(const fs::path& folder, const std::string& kind) {
  const auto [picture, shape] = madeOf(folder, kind);
  REQUIRE(shape->texture);
  const Surroundings around(picture->working, maskOf(folder / "mask.png"));
  const auto colour = wearing(*shape->texture);
  const mesh::TriMesh& mesh = shape->mesh;
  double whole = 0, ground = 0;
  for (const auto& t : mesh.triangles) {
    const auto side = [&](std::size_t k) {
      const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[k]];
      return Vec3<ModelSpace>{double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2]};
    };
    const auto across = cross(side(1), side(2));
    const double size = norm(across);
    if (!(size > 0) || std::abs(across.z) > 0.5 * size) continue;
    for (const double share : {0.2, 0.4, 0.6}) {
      const auto mixed = [&](std::size_t k) {
        return share * mesh.uv[t[0]][k] + (0.8 - share) * mesh.uv[t[1]][k] + 0.2 * mesh.uv[t[2]][k];
      };
      const double u = mixed(0), v = mixed(1);
      whole += size;
      ground += around.isGround(colour(u, v), int(u * picture->width), int(v * picture->height)) ? size : 0;
    }
  }
  REQUIRE(whole > 0);
  return ground / whole;
}

}  // namespace

TEST_CASE("the sides of a tail of fur do not show the meadow behind it" * doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  for (const std::string kind : {"careful", "sloppy", "offcentre"}) {
    CAPTURE(kind);
    const double share = shareOfGroundOnSides(folder / "photo_lemur_tail", kind);
    MESSAGE(kind << ": " << 100 * share << " % of the sides look like the ground");
    CHECK(share < 0.025);
  }
}

TEST_CASE("the sides of things with a crisp rim do not show what is mixed into it, whatever is made of them" *
          doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  struct Case {
    std::string name, kind;
    double most;
  };
  for (const auto& [name, kind, most] :
       {Case{"photo_zucchini_hand", "careful", 0.065}, Case{"render_palm_noise", "puff", 0.035},
        Case{"render_palm_noise", "flat", 0.03}}) {
    CAPTURE(name);
    const double share = shareOfGroundOnSides(folder / name, kind);
    MESSAGE(name << ", " << kind << ": " << 100 * share << " % of the sides look like the ground");
    CHECK(share < most);
  }
}

TEST_CASE(
    "of the parts of the public pictures nearly all look as the pictures do wherever a pixel is wholly inside, and "
    "with their "
    "rims as far as those are theirs, to 30 dB, and most on all of their rims too" *
    doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  int within = 0, whole = 0, counted = 0, looked = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("photo_") && !name.starts_with("render_")) continue;
    const Front front = frontOf(entry.path(), "careful");
    if (front.whole < 0) continue;
    MESSAGE(name << ": " << front.whole << " dB, wholly inside " << front.within << " dB, each pixel by its share "
                 << front.counted << " dB");
    ++looked;
    counted += front.counted >= 30 ? 1 : 0;
    within += front.within >= 30 ? 1 : 0;
    whole += front.whole >= 30 ? 1 : 0;
    CHECK(front.whole >= 21);
  }
  CHECK(looked >= 13);
  // The outlines of a pale vase and of a noisy palm are not found exactly: what is taken for ground is partly theirs.
  CHECK(within >= looked - 2);
  CHECK(counted >= looked - 2);
  // Of the outermost pixels of the palm, the dutar and the bottle a good part is ground.
  CHECK(whole >= looked - 3);
}

TEST_CASE(
    "puffs and flat pieces of the public photos, renderings and sketches look as the pictures do to 30 dB wholly "
    "inside, and with their rims as far as those are theirs" *
    doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  // The true outlines of a blurred palm and of a dinosaur beside its ink take in up to three pixels of ground, which
  // come off.
  constexpr double kTakenIn = 2;
  int looked = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("photo_") && !name.starts_with("render_") && !name.starts_with("sketch_")) continue;
    const bool takesInGround = name == "render_palm_noise" || name == "sketch_dino_tail";
    for (const std::string kind : {"puff", "flat"}) {
      const Front front = frontOf(entry.path(), kind), further = frontOf(entry.path(), kind, kTakenIn);
      if (front.whole < 0) continue;
      ++looked;
      MESSAGE(name << ", " << kind << ": " << front.whole << " dB, wholly inside " << front.within
                   << " dB, each pixel by its share " << front.counted << " dB, wholly inside an outline further in "
                   << further.within << " dB");
      CHECK(front.within >= (takesInGround ? 24 : 30));
      CHECK(front.counted >= (takesInGround ? 24 : 30));
      CHECK(further.within >= 30);
    }
  }
  CHECK(looked >= 36);
}

TEST_CASE("a thumb and a mug that reach over the outline of a part are not shown on it" * doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  for (const std::string name : {"photo_zucchini_hand", "render_banana_occluded"}) {
    for (const std::string kind : {"careful", "sloppy", "offcentre"}) {
      CAPTURE(kind);
      const double share = shareWorn(folder / name, kind);
      MESSAGE(name << ", " << kind << ": " << 100 * share << " % of what is hidden is shown");
      CHECK(share < 0.05);
    }
  }
}

TEST_CASE("where a thumb and a mug were no seam of their colour is left" * doctest::test_suite("data")) {
  const auto folder = testing::dataFolder();
  for (const std::string name : {"photo_zucchini_hand", "render_banana_occluded"}) {
    const double share = shareAlongEdge(folder / name, "careful");
    MESSAGE(name << ": " << 100 * share << " % along the edge");
    CHECK(share < 0.0075);
  }
}
