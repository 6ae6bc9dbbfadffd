// How true the picture on a part is on real pictures, where the data folder is at hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/pipeline/derive.h"
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

/// Inside the silhouette of the part and the true one at once: all of it, and without its rim. Decibels.
struct Front {
  double whole = -1, within = -1;
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
          inner = seen[static_cast<std::size_t>(y + dy) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x + dx)].has_value();
        }
      }
      if (!inner) left[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)].reset();
    }
  }
  return left;
}

image::Image maskOf(const fs::path& file) {
  const auto mask = io::decodeImage(testing::bytesOf(file), 1 << 26);
  REQUIRE(mask.ok());
  return mask.value();
}

/// The picture of a case, and the part that a stroke makes of it seen from the front; nothing without a texture.
struct Look {
  std::shared_ptr<const image::Picture> picture;
  Seen seen;
};
Look lookOf(const fs::path& folder, const std::string& kind) {
  const auto picture = io::decodePicture(testing::bytesOf(firstOf(folder, {"image.jpg", "image.png"})), {});
  REQUIRE(picture.ok());
  const auto text = testing::bytesOf(folder / "case.json");
  const auto truth = nlohmann::json::parse(text.begin(), text.end());
  std::vector<PicturePoint> stroke;
  for (const auto& p : truth["spines"][kind]) stroke.push_back({p[0].get<double>(), p[1].get<double>()});
  const auto shared = std::make_shared<const image::Picture>(picture.value());
  Document document = update({}, AddPicture{"photo", shared}).value();
  document = update(document, DrawSpine{PictureId{1}, stroke}).value();
  pipeline::Cache cache;
  const auto shape = pipeline::deriveWithEdges(document, cache, {}).value().parts[0].shape;
  REQUIRE(shape);
  testing::requireLawful(shape->mesh);
  if (!shape->texture || shared->working.width != shared->width) return {shared, {}};
  const surface::PartTexture& texture = *shape->texture;
  return {shared, testing::frontView(shape->mesh, {shared->width, shared->height}, [&](double u, double v) {
            const surface::UvArea& a = texture.area;
            return testing::sampled(texture.pixels, (u - a.left) / (a.right - a.left), (v - a.top) / (a.bottom - a.top));
          })};
}

Front frontOf(const fs::path& folder) {
  const image::Image mask = maskOf(firstOf(folder, {"mask_visible.png", "mask.png"}));
  auto [picture, seen] = lookOf(folder, "careful");
  if (seen.empty()) return {};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (mask.pixels[4 * i] < 200) seen[i].reset();
  }
  const Seen inner = awayFromRim(seen, picture->width, picture->height);
  return {testing::psnr(seen, picture->working), testing::psnr(inner, picture->working)};
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
    for (std::size_t c = 0; c < 3; ++c) apart = std::max(apart, std::abs((*seen[i])[c] - picture->working.pixels[4 * i + c]));
    ++hidden;
    worn += apart < kAlike ? 1 : 0;
  }
  REQUIRE(hidden > 1000);
  return double(worn) / hidden;
}

}  // namespace

TEST_CASE("of the parts of the public pictures all look as the pictures do wherever a pixel is wholly inside, to 30 dB, and most do on their rims too") {
  const auto folder = testing::dataFolder();
  if (!folder) return;
  int within = 0, whole = 0, looked = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(*folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("photo_") && !name.starts_with("render_")) continue;
    const Front front = frontOf(entry.path());
    if (front.whole < 0) continue;
    MESSAGE(name << ": " << front.whole << " dB, wholly inside " << front.within << " dB");
    ++looked;
    within += front.within >= 30 ? 1 : 0;
    whole += front.whole >= 30 ? 1 : 0;
    CHECK(front.whole >= 24);
  }
  CHECK(looked >= 13);
  CHECK(within == looked);
  CHECK(whole >= looked - 2);
}

TEST_CASE("a thumb and a mug that reach over the outline of a part are not worn by it") {
  const auto folder = testing::dataFolder();
  if (!folder) return;
  for (const std::string name : {"photo_zucchini_hand", "render_banana_occluded"}) {
    for (const std::string kind : {"careful", "offcentre"}) {
      CAPTURE(kind);
      const double share = shareWorn(*folder / name, kind);
      MESSAGE(name << ", " << kind << ": " << 100 * share << " % of what is hidden is worn");
      CHECK(share < 0.05);
    }
  }
}
