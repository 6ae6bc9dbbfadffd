#include <doctest/doctest.h>

#include <cmath>

#include "engine/base/rng.h"
#include "web/ui/layout.h"
#include "web/ui/views.h"

using namespace spineloft;
using namespace spineloft::app;

namespace {

struct Clip {
  double x, y, z, w;
};
Clip project(const Camera& camera, const Rect& view, WorldPoint p) {
  const gl::Mat4 m = projectionOf(camera, view) * viewOf(camera);
  const auto row = [&](std::size_t r) { return m.m[r] * p.x + m.m[4 + r] * p.y + m.m[8 + r] * p.z + m.m[12 + r]; };
  return {row(0), row(1), row(2), row(3)};
}

ClientPoint onCanvas(const Camera& camera, const Rect& view, WorldPoint p) {
  const Clip c = project(camera, view, p);
  return {view.x + view.width * (c.x / c.w + 1) / 2, view.y + view.height * (1 - c.y / c.w) / 2};
}

Rect randomRect(Rng& rng) {
  return {rng.uniform(0, 300), rng.uniform(0, 300), rng.uniform(120, 1500), rng.uniform(120, 900)};
}

}  // namespace

TEST_CASE("the parts of the layout cover the canvas without overlap") {
  Rng rng(3);
  for (int round = 0; round < 3000; ++round) {
    const double width = std::floor(rng.uniform(280, 2600)), height = std::floor(rng.uniform(300, 1500));
    const bool panel = rng.below(2) == 1;
    const Layout layout = layoutFor(width, height, rng.uniform(-0.5, 1.5), panel);
    const Rect rects[] = {layout.picture, layout.solid, layout.splitter, layout.panel};
    double area = 0;
    for (const Rect& r : rects) {
      CHECK(r.width >= 0);
      CHECK(r.height >= 0);
      CHECK(r.right() <= width + 1e-9);
      CHECK(r.bottom() <= height + 1e-9);
      area += r.width * r.height;
    }
    CHECK(area == doctest::Approx(width * height));
    const ClientPoint p{rng.uniform(0, width), rng.uniform(0, height)};
    int holders = 0;
    for (const Rect& r : rects) holders += r.contains(p) ? 1 : 0;
    CHECK(holders == 1);
    CHECK(layout.stacked == (width < kStackedWidth && height >= kLowShape * width));
  }
}

TEST_CASE("the splitter stays under the pointer that drags it") {
  Rng rng(4);
  for (int round = 0; round < 500; ++round) {
    const double width = rng.uniform(300, 1800), height = rng.uniform(400, 1200);
    const Layout before = layoutFor(width, height, 0.5, true);
    const double length =
        before.stacked ? before.picture.height + before.solid.height : before.picture.width + before.solid.width;
    const double to = rng.uniform(kMinShare + 0.02, kMaxShare - 0.02) * length;
    const ClientPoint at = before.stacked ? ClientPoint{5, to} : ClientPoint{to, 5};
    const Layout after = layoutFor(width, height, shareAt(before, at), true);
    const double middle = after.stacked ? after.splitter.centre().y : after.splitter.centre().x;
    CHECK(std::fabs(middle - to) <= 1);
  }
}

TEST_CASE("canvas to picture undoes picture to canvas") {
  Rng rng(5);
  for (int round = 0; round < 500; ++round) {
    const PictureView view{{rng.uniform(-100, 900), rng.uniform(-100, 900)}, rng.uniform(0.02, 30), false};
    const Rect at = randomRect(rng);
    const PicturePoint p{rng.uniform(-50, 2000), rng.uniform(-50, 2000)};
    CHECK(distance(view.toPicture(view.toClient(p, at), at), p) < 1e-6);
  }
}

TEST_CASE("a fitted picture lies wholly inside its view") {
  Rng rng(6);
  for (int round = 0; round < 500; ++round) {
    const Rect at = randomRect(rng);
    const image::Size size{16 + static_cast<int>(rng.below(6000)), 16 + static_cast<int>(rng.below(6000))};
    const Rect shown = pictureRect(fitPicture(size, at), size, at);
    CHECK(shown.x >= at.x - 1e-6);
    CHECK(shown.y >= at.y - 1e-6);
    CHECK(shown.right() <= at.right() + 1e-6);
    CHECK(shown.bottom() <= at.bottom() + 1e-6);
    CHECK(shown.width / shown.height == doctest::Approx(double(size.width) / size.height));
  }
}

TEST_CASE("on a low and wide view the fitted picture leaves the column of buttons free") {
  for (const double height : {150.0, 222.0, 280.0}) {
    const Rect at{0, 0, 356, height};
    const Rect shown = pictureRect(fitPicture({1024, 576}, at), {1024, 576}, at);
    CHECK(buttonsAtSide(at));
    CHECK(shown.right() <= at.right() - 50);
    CHECK(shown.height > 0.5 * height);
  }
  CHECK_FALSE(buttonsAtSide({0, 0, 390, 306}));
}

TEST_CASE(
    "a fitted picture is clear of the bar at the head and of the row at the foot, and in the middle between them") {
  const Rect phone{0, 60, 390, 300};
  const double head = 54, row = 44 + 6;  // a tool's bar, the buttons
  const Rect shown = pictureRect(fitPicture({1024, 683}, phone, head), {1024, 683}, phone);
  CHECK(shown.y >= phone.y + head);
  CHECK(shown.bottom() <= phone.bottom() - row);
  CHECK(shown.centre().x == doctest::Approx(phone.centre().x));
  const double words = 76;  // buttons with words below their icons
  const Rect less = pictureRect(fitPicture({1024, 683}, phone, head, 0, words), {1024, 683}, phone);
  CHECK(less.y >= phone.y + head);
  CHECK(less.bottom() <= phone.bottom() - words);
}

TEST_CASE("bars never take more than two thirds of a view from its picture") {
  Rng rng(61);
  for (int round = 0; round < 300; ++round) {
    const Rect at = randomRect(rng);
    const image::Size size{100, 16 + static_cast<int>(rng.below(3900))};  // at the least zoom a third of a view
    const Rect shown = pictureRect(fitPicture(size, at, rng.uniform(0, 600), 0, rng.uniform(0, 600)), size, at);
    CHECK(shown.y >= at.y - 1e-6);
    CHECK(shown.bottom() <= at.bottom() + 1e-6);
    const bool fullHeight = shown.width < 0.3 * at.width;
    if (fullHeight) CHECK(shown.height >= 0.3 * at.height - 1e-6);
  }
}

TEST_CASE("zooming the picture keeps what lies under the pointer") {
  Rng rng(7);
  for (int round = 0; round < 500; ++round) {
    PictureView view{{rng.uniform(0, 900), rng.uniform(0, 900)}, rng.uniform(0.1, 5), true};
    const Rect at = randomRect(rng);
    const ClientPoint anchor{rng.uniform(at.x, at.right()), rng.uniform(at.y, at.bottom())};
    const PicturePoint before = view.toPicture(anchor, at);
    zoomPicture(view, at, anchor, std::exp(rng.uniform(-8, 8)));
    CHECK(distance(view.toPicture(anchor, at), before) < 1e-6);
    CHECK_FALSE(view.fitted);
  }
}

TEST_CASE("the picture cannot be pushed out of sight") {
  Rng rng(8);
  for (int round = 0; round < 300; ++round) {
    const image::Size size{400, 300};
    const Rect at = randomRect(rng);
    PictureView view = fitPicture(size, at);
    for (int i = 0; i < 30; ++i) {
      panPicture(view, size, at, {rng.uniform(-900, 900), rng.uniform(-900, 900)});
    }
    const Rect shown = pictureRect(view, size, at);
    CHECK(shown.right() > at.x);
    CHECK(shown.x < at.right());
    CHECK(shown.bottom() > at.y);
    CHECK(shown.y < at.bottom());
  }
}

TEST_CASE("the home camera sees every corner of the model") {
  Rng rng(9);
  for (int round = 0; round < 500; ++round) {
    const WorldPoint low{rng.uniform(-0.5, 0), rng.uniform(-0.5, 0), rng.uniform(-0.5, 0)};
    const publish::WorldBounds bounds{
        low, low + WorldPoint{rng.uniform(0.01, 1), rng.uniform(0.01, 1), rng.uniform(0.01, 1)}};
    const Rect view = randomRect(rng);
    const Camera camera = homeCamera(bounds, view);
    for (int corner = 0; corner < 8; ++corner) {
      const WorldPoint p{corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z};
      const Clip c = project(camera, view, p);
      CHECK(std::fabs(c.x) <= c.w);
      CHECK(std::fabs(c.y) <= c.w);
      CHECK(std::fabs(c.z) <= c.w);
    }
  }
}

TEST_CASE("a camera's axes are orthonormal and up never turns over") {
  Rng rng(10);
  Camera camera;
  for (int round = 0; round < 1000; ++round) {
    orbit(camera, {0, 0, 600, 500}, {rng.uniform(-400, 400), rng.uniform(-400, 400)});
    CHECK(norm(camera.back()) == doctest::Approx(1));
    CHECK(norm(camera.up()) == doctest::Approx(1));
    CHECK(std::fabs(dot(camera.right(), camera.up())) < 1e-12);
    CHECK(std::fabs(dot(camera.back(), camera.up())) < 1e-12);
    CHECK(camera.up().y > 0);
  }
}

TEST_CASE("the ray through a projected point comes back to the point") {
  Rng rng(12);
  for (int round = 0; round < 500; ++round) {
    const Rect view = randomRect(rng);
    Camera camera;
    camera.yaw = rng.uniform(-3, 3);
    camera.pitch = rng.uniform(-1.4, 1.4);
    const WorldPoint p{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)};
    const WorldPoint ray = rayThrough(camera, view, onCanvas(camera, view, p));
    const WorldPoint away = p - camera.eye();
    CHECK(norm(cross(ray, away)) < 1e-4);
    CHECK(dot(ray, away) > 0);
  }
}

TEST_CASE("zooming the solid keeps what lies under the pointer at the target's depth") {
  Rng rng(13);
  for (int round = 0; round < 300; ++round) {
    const Rect view = randomRect(rng);
    Camera camera;
    camera.yaw = rng.uniform(-3, 3);
    camera.pitch = rng.uniform(-1, 1);
    const WorldPoint p = camera.target + camera.right() * rng.uniform(-0.3, 0.3) + camera.up() * rng.uniform(-0.3, 0.3);
    const ClientPoint before = onCanvas(camera, view, p);
    zoomCamera(camera, view, before, std::exp(rng.uniform(-1, 1)));
    CHECK(distance(onCanvas(camera, view, p), before) < 0.05);
  }
}

TEST_CASE("a blend of cameras begins at the first and ends at the second") {
  Camera a, b;
  a.yaw = 3;
  b.yaw = -3;
  b.distance = 5;
  CHECK(blend(a, b, 0).yaw == doctest::Approx(3));
  CHECK(std::cos(blend(a, b, 1).yaw) == doctest::Approx(std::cos(-3.0)));
  CHECK(blend(a, b, 1).distance == doctest::Approx(5));
  CHECK(std::fabs(blend(a, b, 0.5).yaw) > 3);  // the short way round, through the back
}
