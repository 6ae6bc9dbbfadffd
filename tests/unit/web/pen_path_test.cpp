// From the move of a pen to the mesh that is drawn, as a frame of the page goes that way: no memory once warm.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/scarce_memory.h"
#include "tests/unit/web/rig.h"
#include "web/edit/preview.h"
#include "web/model/studio.h"
#include "web/tools/tools.h"

using namespace spineloft;
using namespace spineloft::app;

namespace {

double middleAt(double x) { return 110 + 25 * std::sin(0.015 * x); }

/// A bent dark tube on white paper.
image::Picture tubePicture() {
  image::Image image{420, 220, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = std::abs(y - middleAt(x)) < 22 && x > 20 && x < 400;
      for (int channel = 0; channel < 3; ++channel) image.pixels.push_back(inside ? 50 : 245);
      image.pixels.push_back(255);
    }
  }
  return image::makePicture(std::move(image));
}

/// What a frame of the page does with a pen on a picture, without the page around it.
struct Desk {
  test::FakeHost host;
  Studio studio{host, 0};
  UiState ui;
  ActionSink sink;
  std::unique_ptr<tools::Tool> tool;

  Desk() {
    REQUIRE(studio.act(document::AddPicture{"tube", std::make_shared<const image::Picture>(tubePicture())}).ok());
    studio.derived();
    while (studio.busy()) studio.pump();
    ui.picture = studio.document().pictures.back()->id;
    ui.layout.picture = {0, 0, 420, 220};
    ui.pictureView.centre = {210, 110};
  }
  tools::ToolEnv env() { return {studio.document(), studio.derived(), ui, sink, nullptr}; }
  tools::ToolEvent event(double x) {
    const PicturePoint p{x, middleAt(x) + shift + 0.8 * std::sin(0.7 * x)};
    return {ui.pictureView.toClient(p, ui.layout.picture), 0.3 + 0.2 * std::sin(0.02 * x), host.clockMs, 0,
            platform::Device::Pen};
  }
  void press() {
    tool = tools::pictureTool(env(), ToolKind::Draw);
    tool->begin(env(), event(40));
  }
  /// A move, and the shape that the next frame draws.
  void move(double x) {
    host.clockMs += 16;
    tool->move(env(), event(x));
    growPreview(ui, studio, host);
  }
  void lift() {
    tool->commit(env());
    sink.take();
  }

  double shift = 0;
};

constexpr double kFirst = 60, kLast = 360, kStep = 5;

}  // namespace

TEST_CASE(
    "from pen move to mesh a stroke like the one before asks for no memory, whatever its ends and its slice, and with "
    "pressure" *
    doctest::test_suite("slow")) {
  Desk desk;
  std::size_t asked[2] = {};
  SUBCASE("round ends, a circle") {}
  SUBCASE("flat ends") { desk.ui.startCap = desk.ui.endCap = sections::CapStyle::Flat; }
  SUBCASE("open ends") { desk.ui.startCap = desk.ui.endCap = sections::CapStyle::Open; }
  SUBCASE("pointed ends") { desk.ui.startCap = desk.ui.endCap = sections::CapStyle::Pointed; }
  SUBCASE("a star") { desk.ui.section = sections::SectionPreset::Star; }
  SUBCASE("depth by pressure") { desk.ui.edit.depthByPressure = true; }
  for (std::size_t& bytes : asked) {
    desk.press();
    int live = 0;
    for (double x = kFirst; x <= kLast; x += kStep) {
      const std::uint64_t before = desk.ui.previewShapes;
      const std::size_t had = testing::allocatedBytes();
      desk.move(x);
      bytes += testing::allocatedBytes() - had;
      CHECK(desk.ui.previewShapes == before + 1);
      REQUIRE(desk.ui.preview->shape);
      live += desk.ui.preview->shape->quality == pipeline::TraceQuality::Live ? 1 : 0;
    }
    CHECK(live > 30);
    CHECK(desk.ui.preview->shape->ribs.ribs.size() == 100);
    CHECK(desk.ui.preview->shape->mesh.triangles.size() > 1000);
    CHECK(desk.ui.preview->loft().pose.depth.empty() != desk.ui.edit.depthByPressure);
    desk.lift();
  }
  CHECK(asked[0] > 100000);
  CHECK(asked[1] == 0);
}

TEST_CASE("a stroke in memory that earlier ones were drawn in has the shapes of a first stroke") {
  Desk fresh, used;
  for (const double shift : {9.0, -6.0}) {
    used.shift = shift;
    used.press();
    for (double x = kLast; x >= 100; x -= 4 * kStep) used.move(x);
    used.lift();
  }
  used.shift = 0;
  fresh.press();
  used.press();
  for (double x = kFirst; x <= kLast; x += kStep) {
    CAPTURE(x);
    fresh.move(x);
    used.move(x);
    REQUIRE(fresh.ui.preview->shape);
    REQUIRE(used.ui.preview->shape);
    const pipeline::PartShape &a = *fresh.ui.preview->shape, &b = *used.ui.preview->shape;
    CHECK(a.quality == b.quality);
    CHECK(a.spine == b.spine);
    CHECK(a.generated == b.generated);
    CHECK(a.ribs == b.ribs);
    CHECK(a.shown == b.shown);
    CHECK(a.centreLine == b.centreLine);
    CHECK(a.mesh == b.mesh);
  }
}

TEST_CASE("a line that cannot be followed leaves the last shape of the stroke standing") {
  Desk desk;
  desk.press();
  for (double x = kFirst; x <= kLast; x += kStep) desk.move(x);
  const mesh::TriMesh last = desk.ui.preview->shape->mesh;
  const std::uint64_t revision = desk.ui.preview->revision;
  // Back through its own middle: a loop.
  std::vector<PicturePoint>& stroke = desk.ui.preview->asLoft().stroke;
  stroke.push_back({360, 20});
  stroke.push_back({200, 20});
  stroke.push_back({200, 190});
  stroke.push_back({230, 190});
  desk.ui.preview->fresh = false;
  desk.host.clockMs += 16;
  growPreview(desk.ui, desk.studio, desk.host);
  CHECK(desk.ui.preview->fresh);
  CHECK(desk.ui.preview->revision == revision);
  CHECK(desk.ui.preview->shape->mesh == last);
  // The next part begins without it.
  desk.tool->cancel(desk.env());
  desk.press();
  desk.tool->move(desk.env(), desk.event(kFirst));
  REQUIRE(desk.ui.preview);
  CHECK_FALSE(desk.ui.preview->shape);
  CHECK(desk.ui.preview->loft().stroke.size() == 2);
}
