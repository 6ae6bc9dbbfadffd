#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/web/rig.h"
#include "tests/unit/web/shown.h"
#include "web/scene/thumbnails.h"
#include "web/ui/views.h"

using namespace spineloft;
using platform::Device;
using platform::PointerKind;
using spineloft::test::Rig;

namespace {

const app::Json& picture(const app::Json& state) { return *state.find("picture"); }
double strokes(Rig& rig) { return picture(rig.state()).number("strokes").value(); }

/// A ring by the mouse, a finger or a pen.
void drawRing(Rig& rig, Device device = {}, double reach = 180) {
  for (int i = 0; i <= 36; ++i) {
    const double angle = i * 3.14159265358979323846 / 18;
    const auto p = rig.at(380 + reach * std::cos(angle), 400 + reach * std::sin(angle));
    rig.pointer(i == 0 ? PointerKind::Down : PointerKind::Move, p.x, p.y, device);
    rig.lastX = p.x;
    rig.lastY = p.y;
  }
  rig.lift(device);
  rig.settle();
}

/// Whether the shown picture is all paper at this pixel.
bool isPaper(Rig& rig, int x, int y) {
  rig.app->frame();
  const image::Image& image = *rig.gl->last.picture->image;
  return image.pixels[4 * static_cast<std::size_t>(y * image.width + x)] > 250;
}

}  // namespace

TEST_CASE("a sheet of paper takes strokes of the pen, each one step of undo") {
  for (const Device device : {Device::Mouse, Device::Touch, Device::Pen}) {
    Rig rig;
    CHECK(rig.run("new-sketch").flag("ok") == true);
    rig.settle();
    CHECK(*rig.state().text("tool") == "pen");
    CHECK(picture(rig.state()).flag("sketch") == true);
    CHECK(picture(rig.state()).flag("finished") == false);
    drawRing(rig, device);
    CHECK(strokes(rig) == 1);
    CHECK(rig.parts() == 0);
    CHECK(picture(rig.state()).flag("finished") == true);
    CHECK(rig.state().number("undo") == 2);
    CHECK_FALSE(isPaper(rig, 560, 400));
    CHECK(isPaper(rig, 380, 400));
    rig.key("KeyZ", "z", platform::kControl);
    CHECK(strokes(rig) == 0);
    CHECK(isPaper(rig, 560, 400));
    rig.run("redo");
    rig.settle();
    CHECK(strokes(rig) == 1);
    CHECK(rig.app->idle());
  }
}

TEST_CASE("the ink is under the pen before it is lifted, and in the document after") {
  Rig rig;
  rig.run("new-sketch");
  rig.settle();
  rig.press(100, 100, 300, 100);
  rig.settle();
  CHECK(rig.state().find("pen")->number("points").value() > 10);
  CHECK(strokes(rig) == 0);
  CHECK(rig.state().find("preview")->isNull());
  rig.lift();
  rig.settle();
  CHECK(rig.state().find("pen")->find("points")->isNull());
  CHECK(strokes(rig) == 1);
}

TEST_CASE("Escape, the right button, a second finger and the system take the ink back") {
  using Way = void (*)(Rig&);
  const Way ways[] = {
      [](Rig& rig) {
        rig.press(100, 100, 300, 100);
        CHECK(rig.key("Escape", "Escape"));
        rig.lift();
      },
      [](Rig& rig) {
        rig.press(100, 100, 300, 100);
        rig.pointer(PointerKind::Down, rig.lastX, rig.lastY, Device::Mouse, 1, 2);
        rig.lift();
      },
      [](Rig& rig) {
        rig.press(100, 100, 300, 100, Device::Touch, 5);
        rig.pointer(PointerKind::Down, 60, 60, Device::Touch, 6);
        rig.lift(Device::Touch, 5);
        rig.pointer(PointerKind::Up, 60, 60, Device::Touch, 6);
      },
      [](Rig& rig) {
        rig.press(100, 100, 300, 100);
        rig.pointer(PointerKind::Cancel, rig.lastX, rig.lastY);
      },
  };
  for (const Way way : ways) {
    Rig rig;
    rig.run("new-sketch");
    rig.settle();
    way(rig);
    rig.settle();
    CHECK(strokes(rig) == 0);
    CHECK(rig.state().number("undo") == 1);
    CHECK(rig.state().find("pen")->find("points")->isNull());
    drawRing(rig);
    CHECK(strokes(rig) == 1);
  }
}

TEST_CASE("after the first touch of a pen a finger moves the paper and draws nothing") {
  Rig rig;
  rig.run("new-sketch");
  rig.settle();
  drawRing(rig, Device::Pen);
  drawRing(rig, Device::Touch);
  CHECK(strokes(rig) == 1);
}

TEST_CASE("the eraser makes paper again, and undo the drawing") {
  Rig rig;
  rig.run("new-sketch", R"({"width":800,"height":800})");
  rig.settle();
  rig.run("draw-on-sketch", R"({"stroke":[[100,100],[700,100]],"radius":6})");
  rig.settle();
  CHECK_FALSE(isPaper(rig, 400, 100));
  rig.run("eraser");
  rig.press(350, 60, 450, 140);
  rig.lift();
  rig.settle();
  CHECK(isPaper(rig, 400, 100));
  CHECK_FALSE(isPaper(rig, 200, 100));
  rig.run("undo");
  rig.settle();
  CHECK_FALSE(isPaper(rig, 400, 100));
}

TEST_CASE("what was drawn on paper lofts like a photo, and drawing on does not take the part away" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Rig rig({1200, 700, 1}, threads);
    rig.run("new-sketch", R"({"width":800,"height":800})");
    rig.run("draw-on-sketch", R"({"stroke":[[300,150],[300,650]]})");
    rig.run("draw-on-sketch", R"({"stroke":[[500,150],[500,650]]})");
    rig.settle();
    CHECK(picture(rig.state()).flag("finished") == true);
    CHECK(rig.run("draw-spine", R"({"stroke":[[400,180],[400,620]]})").flag("ok") == true);
    rig.settle();
    REQUIRE(rig.parts() == 1);
    app::Json state = rig.state();
    const app::Json& part = (*state.find("parts")->array())[0];
    const app::Json::Array& ribs = *part.find("ribs")->array();
    REQUIRE(ribs.size() > 20);
    const app::Json& middle = ribs[ribs.size() / 2];
    CHECK(std::abs(*(*middle.find("left")->array())[0].number() - 500) < 6);
    CHECK(std::abs(*(*middle.find("right")->array())[0].number() - 300) < 6);
    rig.run("draw-on-sketch", R"({"stroke":[[600,700],[700,700]]})");
    rig.app->frame();
    CHECK(rig.gl->last.meshes.size() == 1);
    rig.settle();
    CHECK(rig.gl->last.meshes.size() == 1);
  }
}

TEST_CASE("strokes while edges are sought do not pile searches up") {
  Rig rig({1200, 700, 1}, 0);
  rig.run("new-sketch");
  for (int i = 0; i < 30; ++i) {
    rig.run("draw-on-sketch", R"({"stroke":[[100,100],[300,)" + std::to_string(100 + i) + "]]}");
  }
  // Without threads a pump runs one job: the first search, and one for what is there afterwards.
  rig.app->wake();
  rig.app->wake();
  rig.app->wake();
  rig.settle();
  CHECK(rig.app->idle());
  CHECK(strokes(rig) == 30);
}

TEST_CASE("sizes and colours of the pen are its own, and drawing by numbers can name others") {
  Rig rig;
  rig.run("new-sketch", R"({"width":400,"height":300})");
  rig.settle();
  CHECK(rig.run("pen-size", R"({"size":"bold"})").flag("ok") == true);
  CHECK(rig.run("pen-colour", R"({"colour":"#2457d6"})").flag("ok") == true);
  CHECK(*rig.state().find("pen")->text("size") == "bold");
  CHECK(*rig.state().find("pen")->text("eraser") == "medium");
  rig.run("draw-on-sketch", R"({"stroke":[[50,50],[350,50]]})");
  rig.settle();
  rig.app->frame();
  const image::Image& image = *rig.gl->last.picture->image;
  const auto at = 4 * static_cast<std::size_t>(50 * image.width + 200);
  CHECK(image.pixels[at] == 36);
  CHECK(image.pixels[at + 2] == 214);
  const std::pair<const char*, const char*> bad[] = {
      {R"({"stroke":[]})", "ArgumentMissing"},
      {R"({"stroke":[[1]]})", "ArgumentMissing"},
      {R"({"stroke":[[1,2,0.5],[3,4]]})", "ArgumentMissing"},
      {R"({"stroke":[[1,2],[null,4]]})", "ValueOutOfRange"},
      {R"({"stroke":[[1,2,7]]})", "ValueOutOfRange"},
      {R"({"stroke":[[1,2]],"radius":0})", "ValueOutOfRange"},
      {R"({"stroke":[[1,2]],"radius":"wide"})", "ValueOutOfRange"},
      {R"({"stroke":[[1,2]],"colour":"mauve"})", "ValueOutOfRange"},
  };
  const double before = strokes(rig);
  for (const auto& [args, error] : bad) {
    CAPTURE(args);
    CHECK(*rig.run("draw-on-sketch", args).text("error") == error);
  }
  CHECK(strokes(rig) == before);
  for (const char* size : {R"({"width":10})", R"({"width":"a"})", R"({"height":5000})"}) {
    CHECK(*rig.run("new-sketch", size).text("error") == "ValueOutOfRange");
  }
  CHECK(*rig.run("pen-size", R"({"size":"huge"})").text("error") == "ValueOutOfRange");
}

TEST_CASE("paper has the shape of the view that it is drawn in") {
  const auto shape = [](platform::CanvasSize size) {
    Rig rig(size);
    rig.run("new-sketch");
    const app::Json state = rig.state();
    return *picture(state).number("width") / *picture(state).number("height");
  };
  CHECK(shape({1440, 850, 1}) < 1);  // two views side by side: each is tall
  CHECK(shape({390, 780, 1}) > 1);   // stacked on a phone
  CHECK(shape({1920, 700, 1}) > 1);
}

TEST_CASE("pen and eraser are for paper: on a photo there is only the line through it") {
  Rig rig;
  rig.openBar();
  for (const char* id : {"pen", "eraser", "draw-on-sketch", "pen-size"}) {
    CHECK(*rig.run(id, R"({"stroke":[[1,1],[9,9]]})").text("error") == "NotNow");
  }
  rig.run("new-sketch");
  CHECK(*rig.state().text("tool") == "pen");
  rig.run("next-picture");
  rig.settle();
  CHECK(*rig.state().text("tool") == "draw");
  rig.drawBar();
  CHECK(rig.parts() == 1);
}

TEST_CASE("several pictures: each part remembers its own, and choosing a part shows it") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.openBar();
  rig.drawBar();
  REQUIRE(rig.parts() == 2);
  const app::Json state = rig.state();
  CHECK(state.number("pictures") == 2);
  CHECK(state.find("pictureList")->array()->size() == 2);
  CHECK(picture(state).number("id") == 2);
  CHECK(rig.gl->last.meshes.size() == 2);
  rig.run("select-part", R"({"id":1})");
  rig.settle();
  CHECK(picture(rig.state()).number("id") == 1);
  CHECK(rig.key("PageDown", "PageDown"));
  CHECK(picture(rig.state()).number("id") == 2);
  CHECK(rig.state().find("selection")->isNull());
  CHECK(rig.key("PageDown", "PageDown"));
  CHECK(picture(rig.state()).number("id") == 1);
  CHECK(rig.key("PageUp", "PageUp"));
  CHECK(picture(rig.state()).number("id") == 2);
  rig.run("select-picture", R"({"id":1})");
  CHECK(picture(rig.state()).number("id") == 1);
  CHECK(*rig.run("select-picture", R"({"id":9})").text("error") == "NoSuchPicture");
  rig.run("rename-picture", R"({"name":"Bottle"})");
  CHECK(*picture(rig.state()).text("name") == "Bottle");
  rig.run("rename-picture", R"({"picture":2})");
  CHECK(rig.host.said(R"("id":"rename-picture:2")"));
  rig.app->answer("rename-picture:2", "Jar");
  CHECK(*(*rig.state().find("pictureList")->array())[1].text("name") == "Jar");
}

TEST_CASE("a removed picture says what went with it, and Undo brings all of it back") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.drawBar();
  rig.openBar();
  rig.drawBar();
  rig.run("remove-picture", R"({"picture":1})");
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(rig.state().number("pictures") == 1);
  CHECK(rig.host.said("its 2 parts"));
  CHECK(rig.host.said("Undo brings them back"));
  rig.run("undo");
  rig.settle();
  CHECK(rig.parts() == 3);
  CHECK(rig.state().number("pictures") == 2);
}

namespace {

/// The middle of a picture's small copy in the strip.
app::ClientPoint inStrip(Rig& rig, std::uint32_t id) {
  for (const app::Thumbnail& thumbnail : rig.app->ui().thumbnails) {
    if (thumbnail.picture == PictureId{id}) return thumbnail.at.centre();
  }
  FAIL("picture ", id, " is not in the strip");
  return {};
}

}  // namespace

TEST_CASE("the menu of a picture lies over the cards of tools, whatever was pressed before") {
  for (const platform::CanvasSize& size : {platform::CanvasSize{390, 760, 1}, platform::CanvasSize{1200, 700, 1}}) {
    CAPTURE(size.width);
    Rig rig(size);
    rig.openBar();
    rig.openBar();
    rig.run("shapes");
    rig.settle();
    const auto press = [&](const char* words) {
      for (const test::Shown& one : test::inSight(rig)) {
        if (one.words != words || one.kind == "thumbnail") continue;
        rig.click(one.at.centre().x, one.at.centre().y);
        rig.settle();
        return true;
      }
      return false;
    };
    const auto strip = inStrip(rig, 2);
    rig.click(strip.x, strip.y);  // in view already: its menu
    REQUIRE(press("Side picture"));
    const app::Json now = rig.state();
    CHECK_FALSE((*now.find("pictureList")->array())[1].find("view")->isNull());
  }
}

TEST_CASE("a strip shows the pictures where there are several, a tap chooses one") {
  const platform::CanvasSize sizes[] = {{1200, 700, 1}, {1024, 690, 1}, {390, 760, 1}, {720, 400, 1}};
  for (const platform::CanvasSize& size : sizes) {
    CAPTURE(size.width);
    Rig rig(size);
    rig.openBar();
    CHECK(rig.app->ui().thumbnails.empty());
    CHECK(rig.gl->last.thumbnails.empty());
    rig.openBar();
    rig.run("new-sketch");
    rig.settle();
    REQUIRE(rig.app->ui().thumbnails.size() == 3);
    CHECK(rig.gl->last.thumbnails.size() == 3);
    for (const gl::SceneThumbnail& small : rig.gl->last.thumbnails) {
      CHECK(std::max(small.texture.image->width, small.texture.image->height) <= app::kThumbnailSide);
    }
    const auto at = inStrip(rig, 1);
    rig.click(at.x, at.y);
    CHECK(picture(rig.state()).number("id") == 1);
    CHECK(rig.gl->last.picture->image->width == 200);
    // The strip takes nothing from what is drawn on: the picture lies beside it.
    const auto corner = rig.at(-0.5, -0.5);
    CHECK_FALSE(rig.app->ui().layout.pictures.contains({corner.x + 1, corner.y + 1}));
    CHECK(rig.app->idle());
  }
}

TEST_CASE("the picture in view has a small menu, as have the others by the right button") {
  Rig rig;
  rig.openBar();
  rig.openBar();
  auto at = inStrip(rig, 2);
  rig.click(at.x, at.y);
  CHECK(rig.app->ui().pictureMenu == PictureId{2});
  CHECK(rig.key("Escape", "Escape"));
  CHECK_FALSE(rig.app->ui().pictureMenu);
  rig.click(at.x, at.y);
  const auto away = rig.at(100, 180);
  rig.click(away.x, away.y);
  CHECK_FALSE(rig.app->ui().pictureMenu);
  CHECK(rig.parts() == 0);
  at = inStrip(rig, 1);
  rig.pointer(PointerKind::Down, at.x, at.y, Device::Mouse, 1, 2);
  rig.settle();
  rig.pointer(PointerKind::Up, at.x, at.y, Device::Mouse, 1, 2);
  rig.settle();
  CHECK(rig.app->ui().pictureMenu == PictureId{1});
  CHECK(picture(rig.state()).number("id") == 2);
  // The third row of the menu, below the strip.
  rig.click(at.x + 40, rig.app->ui().layout.pictures.bottom() + 2 + 4 + 2 * 34 + 17);
  CHECK(rig.state().number("pictures") == 1);
  CHECK(rig.host.said("Undo brings it back"));
  CHECK(rig.app->ui().thumbnails.empty());
}

TEST_CASE("a finger that rests on a picture opens its menu") {
  Rig rig;
  rig.openBar();
  rig.openBar();
  const auto at = inStrip(rig, 1);
  rig.pointer(PointerKind::Down, at.x, at.y, Device::Touch, 5);
  for (int i = 0; i < 4; ++i) {
    rig.host.clockMs += 400;
    rig.host.wakesAsked = 1;
    rig.settle();
  }
  CHECK(rig.app->ui().pictureMenu == PictureId{1});
  rig.pointer(PointerKind::Up, at.x, at.y, Device::Touch, 5);
  rig.settle();
  CHECK(rig.app->ui().pictureMenu == PictureId{1});
  CHECK(picture(rig.state()).number("id") == 2);
}

TEST_CASE(
    "on a small screen the card of the pen stands beside the sheet, with size and ink, also beside a second picture") {
  for (const platform::CanvasSize size :
       {platform::CanvasSize{390, 755, 2}, {360, 551, 2}, {320, 480, 2}, {844, 310, 2}}) {
    Rig rig(size);
    for (const int pictures : {1, 2}) {
      REQUIRE(rig.run("new-sketch", R"({"width":400,"height":300})").flag("ok") == true);
      rig.settle();
      for (const PointerKind kind : {PointerKind::Move, PointerKind::Down, PointerKind::Up}) {
        rig.pointer(kind, size.width - 2, 2, Device::Touch);
        rig.settle();
      }
      const app::UiState& ui = rig.app->ui();
      const app::Rect sheet = app::pictureRect(ui.pictureView, {400, 300}, ui.layout.picture);
      CAPTURE(size.width);
      CAPTURE(pictures);
      REQUIRE(ui.pictureView.fitted);
      CHECK(sheet.width * sheet.height > 0.22 * ui.layout.picture.width * ui.layout.picture.height);
      for (const app::Rect& bar : ui.overlays) {
        const bool apart =
            bar.x >= sheet.right() || bar.right() <= sheet.x || bar.y >= sheet.bottom() || bar.bottom() <= sheet.y;
        CHECK(apart);
      }
      if (!app::buttonsAtSide(ui.layout.picture)) continue;
      // The third cell is of size and ink; a tap on it shows both.
      const double cell = 46, left = ui.layout.picture.x + 4 + cell / 2;
      const auto column = std::ranges::find_if(
          ui.overlays, [&](const app::Rect& at) { return at.contains({left, at.y + 1}) && at.height > 2.5 * cell; });
      REQUIRE(column != ui.overlays.end());
      const app::ClientPoint third{left, column->y + 4 + 2.5 * cell};
      for (const PointerKind kind : {PointerKind::Move, PointerKind::Down, PointerKind::Up}) {
        rig.pointer(kind, third.x, third.y, Device::Touch);
        rig.settle();
      }
      CHECK(ui.sketching.menu == app::PenMenu::Both);
      CHECK(rig.key("Escape", "Escape"));
      CHECK(ui.sketching.menu == app::PenMenu::None);
    }
  }
}
