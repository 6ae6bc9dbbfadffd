// Whether one sees where the picture on a part ends: steps of colour across the lines where its front meets
// its back and its ends, against steps anywhere else on it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/document/update.h"
#include "engine/pipeline/derive.h"
#include "tests/support/front_view.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::document;

namespace {

constexpr int kWidth = 360, kHeight = 260;

double middleAt(double x) { return 130 + 25 * std::sin(x / 70.0); }
double halfAt(double x) { return 38 + 10 * std::cos(x / 50.0); }

/// A curved thing with stripes and spots on a ground of one loud colour, its outline softened.
image::Picture spottedPicture() {
  image::Image out{kWidth, kHeight, {}};
  const std::array<double, 3> ground = {250, 40, 230};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double inside = std::clamp((halfAt(x) - std::abs(y - middleAt(x))) / 2 + 0.5, 0.0, 1.0) *
                            std::clamp((std::min(x - 40.0, 320.0 - x)) / 2 + 0.5, 0.0, 1.0);
      const double stripe = 0.5 + 0.5 * std::sin(x / 7.0), spot = 0.5 + 0.5 * std::sin(x / 13.0) * std::cos(y / 11.0);
      const std::array<double, 3> thing = {60 + 70 * stripe, 110 + 80 * spot, 50 + 40 * stripe};
      for (std::size_t c = 0; c < 3; ++c) {
        out.pixels.push_back(std::uint8_t(std::lround(ground[c] + inside * (thing[c] - ground[c]))));
      }
      out.pixels.push_back(255);
    }
  }
  return image::makePicture(std::move(out));
}

enum Side { kFront = 1, kBack = 2, kEnd = 3 };

/// Every triangle with corners of its own, and the side of the part that it is on.
struct Sides {
  mesh::TriMesh mesh;
  std::vector<Side> of;  ///< one a vertex
};
Sides sidesOf(const mesh::TriMesh& mesh, bool withEnds = true) {
  Sides out;
  for (const auto& t : mesh.triangles) {
    std::array<ModelPoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& q = mesh.positions[t[k]];
      p[k] = {double(q[0]), double(q[1]), double(q[2])};
    }
    const ModelPoint n = cross(p[1] - p[0], p[2] - p[0]);
    const Side side = withEnds && std::abs(n.x) > 0.9 * norm(n) ? kEnd : n.z >= 0 ? kFront : kBack;
    const auto first = std::uint32_t(out.mesh.positions.size());
    for (std::size_t k = 0; k < 3; ++k) {
      out.mesh.positions.push_back(mesh.positions[t[k]]);
      out.mesh.uv.push_back(mesh.uv[t[k]]);
      out.of.push_back(side);
    }
    out.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// From where one looks: about which axis (0 or 1) through the middle of the picture, and how far.
struct View {
  std::size_t axis;
  double degrees;
};
mesh::TriMesh turned(mesh::TriMesh mesh, View view) {
  const double a = view.degrees * 3.14159265358979 / 180, c = std::cos(a), s = std::sin(a);
  const std::size_t moved = 1 - view.axis;
  const double middle = moved == 0 ? kWidth / 2.0 : -kHeight / 2.0;
  for (auto& p : mesh.positions) {
    const double x = double(p[moved]) - middle, z = double(p[2]);
    p[moved] = float(x * c + z * s + middle);
    p[2] = float(z * c - x * s);
  }
  return mesh;
}

struct Steps {
  double sum = 0;
  int count = 0;
  double mean() const { return count > 0 ? sum / count : 0; }
  void add(double step) {
    sum += step;
    ++count;
  }
};

/// Steps between neighbouring pixels on one surface: across a line between two sides, and within a side.
struct Seen {
  Steps seam, within;
};
Seen featureAt(const Sides& part, const surface::PartTexture& texture, View view) {
  const image::Size size{kWidth, kHeight};
  mesh::TriMesh mesh = turned(part.mesh, view);
  const auto colours = testing::frontView(mesh, size, [&](double u, double v) {
    const surface::UvArea& a = texture.area;
    return testing::sampled(texture.pixels, (u - a.left) / (a.right - a.left), (v - a.top) / (a.bottom - a.top));
  });
  // Once more, the side and the height instead of the colour.
  for (std::size_t v = 0; v < mesh.uv.size(); ++v) mesh.uv[v] = {float(part.of[v]), mesh.positions[v][2]};
  const auto places =
      testing::frontView(mesh, size, [](double side, double z) { return std::array<double, 3>{side, z, 0}; });
  Seen out;
  const auto compare = [&](std::size_t i, std::size_t j) {
    if (!colours[i] || !colours[j]) return;
    constexpr double kApart = 6;  // pixels of depth from one to the next: then one lies behind the other
    if (std::abs((*places[i])[1] - (*places[j])[1]) > kApart) return;
    double step = 0;
    for (std::size_t c = 0; c < 3; ++c) step = std::max(step, std::abs((*colours[i])[c] - (*colours[j])[c]));
    const bool across = std::lround((*places[i])[0]) != std::lround((*places[j])[0]);
    (across ? out.seam : out.within).add(step);
  };
  for (int y = 0; y + 1 < kHeight; ++y) {
    for (int x = 0; x + 1 < kWidth; ++x) {
      const auto i = std::size_t(y) * kWidth + std::size_t(x);
      compare(i, i + 1);
      compare(i, i + kWidth);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("one does not see where the picture on a part ends, from the front and from 60 degrees aside") {
  const auto picture = std::make_shared<const image::Picture>(spottedPicture());
  Document document = update({}, AddPicture{"spotted", picture}).value();
  std::vector<PicturePoint> stroke;
  for (int x = 48; x <= 312; x += 4) stroke.push_back({double(x), middleAt(x)});
  document = update(document, DrawSpine{PictureId{1}, stroke}).value();
  for (const sections::CapStyle cap :
       {sections::CapStyle::Round, sections::CapStyle::Flat, sections::CapStyle::Pointed}) {
    const Document styled = update(document, SetCaps{PartId{1}, cap, cap}).value();
    pipeline::Cache cache;
    const auto shape = pipeline::deriveWithEdges(styled, cache, {}).value().parts[0].shape;
    REQUIRE(shape);
    REQUIRE(shape->texture);
    testing::requireLawful(shape->mesh);
    Sides part = sidesOf(shape->mesh);
    for (const View view : {View{0, 60}, View{0, -60}, View{1, 60}, View{1, -60}}) {
      CAPTURE(view.axis);
      CAPTURE(view.degrees);
      CAPTURE(std::string(sections::capKey(cap)));
      const Seen seen = featureAt(part, *shape->texture, view);
      MESSAGE(view.axis << " " << view.degrees << " " << sections::capKey(cap) << ": across " << seen.seam.mean()
                        << " (" << seen.seam.count << "), elsewhere " << seen.within.mean());
      CHECK(seen.seam.count > 100);
      CHECK(seen.seam.mean() <= 1.5 * seen.within.mean());
    }
    // From the front there is none but the outline, and where a steep end begins, which one does not see either. And
    // a back that begins ten pixels further on would be seen.
    CHECK(featureAt(sidesOf(shape->mesh, false), *shape->texture, {0, 0}).seam.count == 0);
    const Seen front = featureAt(part, *shape->texture, {0, 0});
    MESSAGE("front: across " << front.seam.mean() << " (" << front.seam.count << "), elsewhere "
                             << front.within.mean());
    CHECK(front.seam.mean() <= 1.55 * front.within.mean());  // of about a hundred places
    for (std::size_t v = 0; v < part.of.size(); ++v) {
      if (part.of[v] == kBack) part.mesh.uv[v][0] += 10.0f / kWidth;
    }
    const Seen torn = featureAt(part, *shape->texture, {0, 60});
    CHECK(torn.seam.mean() > 1.5 * torn.within.mean());
  }
}
