// How well a box cuts things out of real photos, where the data folder is at hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/io/json_values.h"
#include "engine/io/picture_file.h"
#include "engine/vision/cut_out.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using namespace spineloft::vision;

namespace {

namespace fs = std::filesystem;

/// 255: the thing; 128: it does not matter.
struct Truth {
  image::Image mask;
  int at(int x, int y) const {
    return mask
        .pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x))];
  }
};

/// Shared by both over covered by either, of the pixels that matter.
double overlapOf(const Truth& truth, const CutContours& contours) {
  double both = 0, either = 0;
  for (int y = 0; y < truth.mask.height; ++y) {
    // Where the row crosses the outlines.
    std::vector<double> cuts;
    for (const auto& contour : contours) {
      for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
        const PicturePoint a = contour[j], b = contour[i];
        if ((a.y > y) != (b.y > y)) cuts.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
    std::ranges::sort(cuts);
    for (int x = 0; x < truth.mask.width; ++x) {
      const int value = truth.at(x, y);
      if (value == 128) continue;
      const bool in = (std::ranges::upper_bound(cuts, x) - cuts.begin()) % 2 == 1, is = value > 200;
      both += in && is;
      either += in || is;
    }
  }
  return either > 0 ? both / either : 0;
}

struct Photo {
  std::string name;
  image::Picture picture;
  Truth truth;
  std::vector<PicturePoint> stroke;  ///< a careful one along the thing
};

/// The public photos, or the drawings.
std::vector<Photo> photos(std::string_view kind = "photo_") {
  std::vector<Photo> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(testing::dataFolder())) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kind)) continue;
    fs::path image = entry.path() / "image.jpg";
    if (!fs::exists(image)) image = entry.path() / "image.png";
    fs::path mask = entry.path() / "mask_visible.png";
    if (!fs::exists(mask)) mask = entry.path() / "mask.png";
    auto picture = io::decodePicture(testing::bytesOf(image), {});
    auto shown = io::decodeImage(testing::bytesOf(mask), 1 << 26);
    const auto text = testing::bytesOf(entry.path() / "case.json");
    const auto read = io::readBenchCase({reinterpret_cast<const char*>(text.data()), text.size()});
    REQUIRE(picture.ok());
    REQUIRE(shown.ok());
    REQUIRE(read.ok());
    const auto& strokes = read.value().strokes;
    auto stroke = std::ranges::find(strokes, "careful", [](const auto& one) { return one.first; });
    if (stroke == strokes.end()) stroke = strokes.begin();
    out.push_back({name, std::move(picture).value(), {std::move(shown).value()}, stroke->second});
  }
  REQUIRE(out.size() >= 5);
  return out;
}

double overlapOf(const Photo& photo, const CutHints& hints) {
  const auto found = cutOut(photo.picture, hints);
  return found.ok() ? overlapOf(photo.truth, found.value()) : 0;
}

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

TEST_CASE("a box round the thing cuts it out of the public photos, most of it in most of them" *
          doctest::test_suite("data")) {
  std::vector<double> overlaps;
  std::string said;
  for (const Photo& photo : photos()) {
    const Truth& truth = photo.truth;
    CutHints hints;
    hints.box = {{1e9, 1e9}, {-1e9, -1e9}};
    for (int y = 0; y < truth.mask.height; ++y) {
      for (int x = 0; x < truth.mask.width; ++x) {
        if (truth.at(x, y) < 200) continue;
        auto& [low, high] = *hints.box;
        low = {std::min(low.x, double(x)), std::min(low.y, double(y))};
        high = {std::max(high.x, double(x)), std::max(high.y, double(y))};
      }
    }
    // As a hand draws it: a little larger.
    const double room = 0.02 * std::max(truth.mask.width, truth.mask.height);
    hints.box->low = hints.box->low - PicturePoint{room, room};
    hints.box->high = hints.box->high + PicturePoint{room, room};
    overlaps.push_back(overlapOf(photo, hints));
    said += photo.name + " " + std::to_string(overlaps.back()).substr(0, 5) + "  ";
  }
  if (overlaps.empty()) return;
  const double median = medianOf(overlaps);
  MESSAGE("overlap of a box cut-out, median " << median << " of " << overlaps.size() << " photos: " << said);
  CHECK(median > 0.7);
}

TEST_CASE("a scribble along the thing cuts more of it out of the public photos than a tap on its middle" *
          doctest::test_suite("data")) {
  std::vector<double> taps, scribbles;
  std::string said;
  for (const Photo& photo : photos()) {
    CutHints tap, scribble;
    scribble.inside = photo.stroke;
    tap.inside = {photo.stroke[photo.stroke.size() / 2]};
    taps.push_back(overlapOf(photo, tap));
    scribbles.push_back(overlapOf(photo, scribble));
    said += photo.name + " " + std::to_string(taps.back()).substr(0, 5) + " → " +
            std::to_string(scribbles.back()).substr(0, 5) + "  ";
  }
  if (taps.empty()) return;
  MESSAGE("overlap of a tap and of a scribble: " << said);
  CHECK(medianOf(scribbles) > medianOf(taps));
}

TEST_CASE("a tap on the middle of a drawn thing cuts it out, most of it in most of the public drawings" *
          doctest::test_suite("data")) {
  std::vector<double> overlaps;
  std::string said;
  for (const Photo& drawing : photos("sketch_")) {
    CutHints tap;
    tap.inside = {drawing.stroke[drawing.stroke.size() / 2]};
    overlaps.push_back(overlapOf(drawing, tap));
    said += drawing.name + " " + std::to_string(overlaps.back()).substr(0, 5) + "  ";
  }
  if (overlaps.empty()) return;
  MESSAGE("overlap of a tap on drawings: " << said);
  CHECK(medianOf(overlaps) > 0.8);
}
