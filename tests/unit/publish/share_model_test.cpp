#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/document/update.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/through_points.h"
#include "engine/io/share_text.h"
#include "engine/publish/share_copies.h"
#include "engine/publish/share_model.h"
#include "engine/ribs/edit/rib_frame.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/photo_copies.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::publish;
using spineloft::testing::ellipsePicture;

namespace {

pipeline::Derived derivedOf(const Document& document) {
  pipeline::Cache cache;
  return pipeline::deriveWithEdges(document, cache, {}).value();
}

Document onPhoto(int ribs) {
  Document document = update({}, AddPicture{"e", ellipsePicture(1000, 700)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{200, 350}, {500, 360}, {800, 350}}}).value();
  Part part = document.parts[0].get();
  loftOf(part)->spine.ribs = ribs;
  document.parts[0] = part;
  return document;
}

/// A picture of dark limbs on a light ground in so many cells, bent and thick and thin in various ways, and a stroke as
/// a hand draws it through each.
struct Limbs {
  std::shared_ptr<image::Picture> picture = std::make_shared<image::Picture>();
  std::vector<std::vector<PicturePoint>> strokes;
};

Limbs limbs(int count) {
  constexpr int kWidth = 1024, kHeight = 768, kColumns = 4;
  const int columns = std::min(count, kColumns), rows = (count + columns - 1) / columns;
  const double wide = static_cast<double>(kWidth) / columns, high = static_cast<double>(kHeight) / rows;
  Limbs made;
  image::Image& image = made.picture->working;
  made.picture->width = image.width = kWidth;
  made.picture->height = image.height = kHeight;
  image.pixels.assign(std::size_t{4} * kWidth * kHeight, 232);
  for (int k = 0; k < count; ++k) {
    const double bend = 0.16 * std::sin(1.7 * k + 1), phase = 0.9 * k;
    const PicturePoint corner{wide * (k % columns), high * (k / columns)};
    const auto middle = [&](double t) {
      return corner + PicturePoint{wide * (0.14 + 0.72 * t), high * (0.5 + bend * std::sin(3.1 * t + phase))};
    };
    const auto half = [&](double t) {
      return std::min(wide, high) * (0.07 + 0.04 * std::sin(5 * t + phase) + 0.03 * std::sin(11 * t));
    };
    for (int i = 0; i <= 600; ++i) {
      const double t = i / 600.0, r = half(t);
      const PicturePoint at = middle(t);
      for (int y = static_cast<int>(at.y - r); y <= at.y + r; ++y) {
        for (int x = static_cast<int>(at.x - r); x <= at.x + r; ++x) {
          if (distance({static_cast<double>(x), static_cast<double>(y)}, at) > r) continue;
          for (std::size_t c = 0; c < 3; ++c)
            image.pixels[4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) + c] = 70;
        }
      }
    }
    std::vector<PicturePoint> stroke;
    for (int i = 0; i <= 80; ++i) {
      const double t = i / 80.0;
      stroke.push_back(middle(t) + PicturePoint{0.8 * std::sin(2.3 * i), 1.2 * std::cos(1.9 * i + k)});
    }
    made.strokes.push_back(std::move(stroke));
  }
  return made;
}

Document ofLimbs(int count, int ribs) {
  const Limbs made = limbs(count);
  Document document = update({}, AddPicture{"limbs.jpg", made.picture}).value();
  for (const auto& stroke : made.strokes) document = update(document, DrawSpine{PictureId{1}, stroke}).value();
  for (Box<Part>& box : document.parts) {
    Part part = box.get();
    loftOf(part)->spine.ribs = ribs;
    box = std::move(part);
  }
  return document;
}

double worstEnd(const pipeline::Derived& was, const pipeline::Derived& is) {
  double most = 0;
  for (std::size_t k = 0; k < was.parts.size(); ++k) {
    const auto& a = was.parts[k].shape->ribs.ribs;
    const auto& b = is.parts[k].shape->ribs.ribs;
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      most = std::max({most, distance(a[i].left, b[i].left), distance(a[i].right, b[i].right)});
      // So is what the ends are measured from.
      CHECK(distance(a[i].center, b[i].center) <= 0.26);
    }
  }
  return most;
}

double toTriangle(ModelPoint p, const std::array<ModelPoint, 3>& corners) {
  const auto [a, b, c] = corners;
  const ModelPoint normal = normalized(cross(b - a, c - a));
  const auto isLeftOf = [&](ModelPoint from, ModelPoint to) { return dot(cross(to - from, p - from), normal) >= 0; };
  if (norm(normal) > 0 && isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a)) return std::abs(dot(p - a, normal));
  return std::min({geometry::distanceToSegment(p, a, b), geometry::distanceToSegment(p, b, c),
                   geometry::distanceToSegment(p, c, a)});
}

/// How far a vertex of the first mesh is from the surface of the second one at most, picture pixels.
double apart(const mesh::TriMesh& of, const mesh::TriMesh& from) {
  const auto point = [](const mesh::TriMesh& mesh, std::uint32_t i) {
    const auto& p = mesh.positions[i];
    return ModelPoint{p[0], p[1], p[2]};
  };
  double most = 0;
  for (std::uint32_t i = 0; i < of.positions.size(); ++i) {
    double least = 1e9;
    for (const auto& [a, b, c] : from.triangles)
      least = std::min(least, toTriangle(point(of, i), {point(from, a), point(from, b), point(from, c)}));
    most = std::max(most, least);
  }
  return most;
}

const std::vector<PicturePoint>& fanOf(const ribs::RibSet& set, bool atStart) {
  return (atStart ? set.startFan : set.endFan).points;
}

/// How far the middle of the outline is beyond the rib, picture pixels.
double beyond(const ribs::RibSet& set, bool atStart) {
  const ribs::Rib& last = atStart ? set.ribs.front() : set.ribs.back();
  const ribs::RibFrame frame(last.left, last.right, atStart);
  const auto& fan = fanOf(set, atStart);
  return fan.empty() ? 0 : frame.fromPicture(fan[fan.size() / 2]).x * frame.unit();
}

/// What a loft draws round an end.
std::vector<PicturePoint> outlineOf(const ribs::RibSet& set, bool atStart) {
  const std::size_t last = atStart ? 0 : set.ribs.size() - 1, inner = atStart ? 1 : last - 1;
  std::vector<PicturePoint> frame{set.ribs[inner].left, set.ribs[last].left};
  frame.insert(frame.end(), fanOf(set, atStart).begin(), fanOf(set, atStart).end());
  frame.insert(frame.end(), {set.ribs[last].right, set.ribs[inner].right});
  std::vector<PicturePoint> outline;
  geometry::throughPoints(frame, 32, outline);
  return outline;
}

/// How far one of these points is from the line at most.
double apart(const std::vector<PicturePoint>& points, const std::vector<PicturePoint>& line) {
  double most = 0;
  for (const PicturePoint p : points) {
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      least = std::min(least, geometry::distanceToSegment(p, line[i], line[i + 1]));
    most = std::max(most, least);
  }
  return most;
}

}  // namespace

TEST_CASE("links are short, and every rib end is at most a quarter of a pixel off in each direction" *
          doctest::test_suite("slow")) {
  struct Case {
    Document document;
    std::size_t characters;
  };
  // An even shape, and limbs whose outlines go in and out.
  for (const auto& [document, characters] : {Case{onPhoto(40), 150}, Case{ofLimbs(1, 40), 150},
                                             Case{ofLimbs(7, 40), 1000}, Case{ofLimbs(12, 60), kMostLinkText}}) {
    const pipeline::Derived before = derivedOf(document);
    const auto shared = shareModel(document, before);
    REQUIRE(shared.ok());
    CHECK(shared.value().text.size() <= characters);
    const pipeline::Derived after = derivedOf(io::readShareText(shared.value().text).value());
    // A quarter to each side.
    CHECK(worstEnd(before, after) <= 0.25 * std::sqrt(2.0) + 1e-6);
  }
}

TEST_CASE("the ends of a shared part are where they were, as are its sides: its solid is the same to within a pixel" *
          doctest::test_suite("slow")) {
  for (const Document& document : {onPhoto(40), ofLimbs(7, 40)}) {
    const pipeline::Derived before = derivedOf(document);
    const pipeline::Derived after = derivedOf(io::readShareText(shareModel(document, before).value().text).value());
    for (std::size_t k = 0; k < before.parts.size(); ++k) {
      CAPTURE(k);
      const auto &was = *before.parts[k].shape, &is = *after.parts[k].shape;
      CHECK(apart(was.mesh, is.mesh) <= 1);
      CHECK(apart(is.mesh, was.mesh) <= 1);
    }
  }
}

TEST_CASE("the outline beyond an end is told by points at most a quarter of a pixel off, and is within a pixel") {
  const Document document = ofLimbs(7, 40);
  const pipeline::Derived before = derivedOf(document);
  const pipeline::Derived after = derivedOf(io::readShareText(shareModel(document, before).value().text).value());
  int ends = 0;
  for (std::size_t k = 0; k < before.parts.size(); ++k) {
    const ribs::RibSet &was = before.parts[k].shape->ribs, &is = after.parts[k].shape->ribs;
    for (const bool atStart : {true, false}) {
      CAPTURE(k);
      CAPTURE(atStart);
      if (beyond(was, atStart) < 1) {  // the part ends at the rib
        CHECK(beyond(is, atStart) < 1.3);
        continue;
      }
      // A quarter to each side.
      CHECK(apart(fanOf(is, atStart), outlineOf(was, atStart)) <= 0.25 * std::sqrt(2.0) + 0.01);
      CHECK(apart(outlineOf(was, atStart), outlineOf(is, atStart)) <= 1);
      ++ends;
    }
  }
  CHECK(ends >= 7);
}

TEST_CASE("a model that came as a text is the same text again") {
  const Document document = ofLimbs(3, 40);
  const std::string text = shareModel(document, derivedOf(document)).value().text;
  const Document read = io::readShareText(text).value();
  CHECK(shareModel(read, derivedOf(read)).value().text == text);
}

TEST_CASE("an end that the part does not go beyond stays there") {
  Document document = onPhoto(40);
  const pipeline::Derived before = derivedOf(document);
  Part part = document.parts[0].get();
  loftOf(part)->edits.startFan = {{-0.2, 0.5}, {-0.1, 0}, {-0.2, -0.5}};
  document.parts[0] = part;
  const pipeline::Derived cut = derivedOf(document);
  const pipeline::Derived after = derivedOf(io::readShareText(shareModel(document, cut).value().text).value());
  const auto left = [](const pipeline::Derived& derived) {
    double least = 1e9;
    for (const auto& p : derived.parts[0].shape->mesh.positions) least = std::min<double>(least, p[0]);
    return least;
  };
  CHECK(left(cut) > left(before) + 5);
  CHECK(std::abs(left(after) - left(cut)) <= 0.5);
}

TEST_CASE("a part on a photo keeps its ribs to within half a pixel without the photo, and shows its mean colour") {
  const Document document = onPhoto(60);
  const pipeline::Derived before = derivedOf(document);
  const auto shared = shareModel(document, before);
  REQUIRE(shared.ok());
  CHECK(shared.value().photosLeft == 1);
  const Document read = io::readShareText(shared.value().text).value();
  const pipeline::Derived after = derivedOf(read);
  REQUIRE(after.parts[0].shape);
  testing::requireLawful(after.parts[0].shape->mesh);
  const auto& was = before.parts[0].shape->ribs.ribs;
  const auto& is = after.parts[0].shape->ribs.ribs;
  REQUIRE(is.size() == was.size());
  double most = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    most = std::max({most, distance(is[i].left, was[i].left), distance(is[i].right, was[i].right)});
  }
  CHECK(most <= 0.5);
  const Look& look = read.parts[0]->look;
  CHECK_FALSE(look.textured);
  CHECK(look.colour != Look{}.colour);
}

TEST_CASE("a model without photos is shared as it is") {
  Document document = update({}, AddSketch{"Sketch 1", {400, 300}}).value();
  document = update(document, DrawSpine{PictureId{1}, {{100, 150}, {200, 150}, {300, 150}}}).value();
  const pipeline::Derived derived = derivedOf(document);
  CHECK(withoutPhotos(document, derived) == document);
  CHECK(shareModel(document, derived).value().photosLeft == 0);
}

TEST_CASE("with a copy of its photo a model keeps its ribs and goes on to show the photo") {
  const Document document = onPhoto(40);
  const pipeline::Derived before = derivedOf(document);
  const io::PhotoCopies copies = {{PictureId{1}, testing::jpegCopy(512, 358)}};
  const auto shared = shareModel(document, before, copies);
  REQUIRE(shared.ok());
  CHECK(shared.value().photosLeft == 0);
  const std::string& text = shared.value().text;
  // The copy costs its own characters; up to a tenth more for how letters are coded.
  const std::size_t plain = shareModel(document, before).value().text.size();
  const std::size_t copy = copies.begin()->second.size();
  CHECK(text.size() <= plain + copy + copy / 10);
  CHECK(io::photosInShareText(text).value() == copies);
  const Document read = io::readShareText(text, nullptr, {{PictureId{1}, ellipsePicture(512, 358)}}).value();
  CHECK(read.parts[0]->look.textured);
  const pipeline::Derived after = derivedOf(read);
  CHECK(worstEnd(before, after) <= 0.25 * std::sqrt(2.0) + 1e-6);
  // Who cannot decode the copy sees the mean colour, as without it.
  const Look blind = io::readShareText(text).value().parts[0]->look;
  CHECK(blind == io::readShareText(shareModel(document, before).value().text).value().parts[0]->look);
}
