// Rows of the part list: a small picture of each part, names changed where they stand, and a sign after joining.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/web/shown.h"
#include "tests/unit/web/two_bars.h"
#include "web/edit/part_pictures.h"

using namespace spineloft;
using app::Json;
using test::Rig;
using test::TwoBars;

namespace {

/// A box between two corners.
pipeline::PartShape boxShape(std::array<float, 3> low, std::array<float, 3> high) {
  pipeline::PartShape shape;
  for (int i = 0; i < 8; ++i) {
    shape.mesh.positions.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
  for (const auto& s : kSides) {
    shape.mesh.triangles.push_back({s[0], s[1], s[2]});
    shape.mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  return shape;
}

document::Look plain(std::array<std::uint8_t, 3> colour) {
  document::Look look;
  look.textured = false;
  look.colour = colour;
  return look;
}

const std::uint8_t* pixel(const image::Image& image, int x, int y) {
  return image.pixels.data() +
         4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

double covered(const image::Image& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) sum += image.pixels[i] / 255.;
  return sum / (static_cast<double>(image.width) * image.height);
}

/// Where a row has its name now, from the last question; none: it asks in a dialog.
std::optional<std::array<double, 4>> askedAt(const Rig& rig) {
  for (auto sent = rig.host.sent.rbegin(); sent != rig.host.sent.rend(); ++sent) {
    const auto event = Json::parse(*sent);
    if (!event || *event->text("type") != "ask") continue;
    const Json* at = event->find("at");
    if (at->isNull()) return std::nullopt;
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = *(*at->array())[i].number();
    return out;
  }
  FAIL("nothing was asked");
  return std::nullopt;
}

std::size_t questions(const Rig& rig) {
  return static_cast<std::size_t>(std::ranges::count_if(
      rig.host.sent, [](const std::string& json) { return json.find(R"("type":"ask")") != std::string::npos; }));
}

app::Rect rowOf(Rig& rig, std::string_view name) {
  for (const test::Shown& one : test::inSight(rig)) {
    if (one.kind == "row" && one.words == name) return one.at;
  }
  FAIL("no row " << name);
  return {};
}

}  // namespace

TEST_CASE("the picture of a part is its outline from the front, whole, in its colour") {
  // Twice as wide as high: half of a square is covered, from side to side and about the middle.
  const image::Image wide = app::partPicture(boxShape({10, -30, 0}, {50, -10, 7}), plain({200, 100, 50}), nullptr);
  REQUIRE(wide.width == app::kPartPictureSide);
  REQUIRE(wide.height == app::kPartPictureSide);
  CHECK(covered(wide) == doctest::Approx(0.5).epsilon(0.05));
  const int middle = app::kPartPictureSide / 2;
  CHECK(pixel(wide, middle, middle)[3] == 255);
  CHECK(pixel(wide, middle, 3)[3] == 0);
  CHECK(pixel(wide, 2, middle)[3] == 255);
  // Where it lies and how deep it is changes nothing.
  CHECK(wide == app::partPicture(boxShape({-400, 70, -9}, {0, 270, 30}), plain({200, 100, 50}), nullptr));
  // The light makes it darker in all channels alike.
  const std::uint8_t* c = pixel(wide, middle, middle);
  CHECK(c[0] <= 200);
  CHECK(c[0] > 120);
  CHECK(c[1] * 2. == doctest::Approx(c[0]).epsilon(0.03));
  CHECK(c[2] * 4. == doctest::Approx(c[0]).epsilon(0.05));
}

TEST_CASE("what is in front hides what is behind, two colours meet in the middle, and nothing has no picture") {
  pipeline::PartShape both = boxShape({0, 0, 0}, {10, 10, 1});
  const pipeline::PartShape near = boxShape({2, 2, 4}, {8, 8, 5});
  const auto first = static_cast<std::uint32_t>(both.mesh.positions.size());
  both.mesh.positions.insert(both.mesh.positions.end(), near.mesh.positions.begin(), near.mesh.positions.end());
  for (const auto& t : near.mesh.triangles) both.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  image::Image picture{2, 1, {255, 0, 0, 255, 0, 0, 255, 255}};
  both.mesh.uv.assign(8, {0.25f, 0.5f});
  both.mesh.uv.resize(16, {0.75f, 0.5f});
  const image::Image seen = app::partPicture(both, {}, &picture);
  const int middle = app::kPartPictureSide / 2;
  CHECK(pixel(seen, middle, middle)[2] > 120);
  CHECK(pixel(seen, middle, middle)[0] == 0);
  CHECK(pixel(seen, 4, middle)[0] > 120);
  document::Look two = plain({200, 0, 0});
  two.paint = surface::Paint::TwoTone;
  two.second = {0, 0, 200};
  const image::Image halves = app::partPicture(boxShape({0, 0, 0}, {10, 10, 1}), two, nullptr);
  CHECK(pixel(halves, middle, middle - 10)[0] > 120);
  CHECK(pixel(halves, middle, middle + 10)[2] > 120);
  CHECK(pixel(halves, middle, middle + 10)[0] == 0);
  CHECK(app::partPicture({}, plain({1, 2, 3}), nullptr).empty());
}

TEST_CASE("a picture is made once for each look and shape, and forgotten when nobody asks for it") {
  document::Document document;
  pipeline::Derived derived;
  document::Part part;
  part.id = PartId{1};
  part.look = plain({200, 100, 50});
  auto shape = std::make_shared<pipeline::PartShape>(boxShape({0, 0, 0}, {4, 4, 4}));
  shape->key = {7};
  derived.parts.push_back({part.id, shape, {}});
  app::PartPictures pictures;
  const gl::SceneTexture* first = pictures.of(document, derived, part);
  REQUIRE(first != nullptr);
  const gl::TextureKey key = first->key;
  CHECK(pictures.of(document, derived, part) == first);
  part.look.colour[0] = 100;
  CHECK(pictures.of(document, derived, part)->key != key);
  pictures.forgetUnused();
  part.look.colour[0] = 200;
  CHECK(pictures.of(document, derived, part)->key == key);
  CHECK(pictures.of(document, {}, part) == nullptr);
}

TEST_CASE("a double click, F2 and a finger that stays ask for a name where it stands") {
  TwoBars page;
  const app::Rect row = rowOf(page, "Part 2");
  const auto isInRow = [&] {
    const auto at = askedAt(page);
    REQUIRE(at);
    CHECK((*at)[0] >= row.x);
    CHECK((*at)[1] == doctest::Approx(row.y));
    CHECK((*at)[2] > 40);
    CHECK((*at)[3] == doctest::Approx(row.height));
  };
  page.run("select-part", R"({"id": 2})");
  page.settle();
  CHECK(page.key("F2", "F2"));
  CHECK(questions(page) == 1);
  isInRow();
  page.click(row.centre().x, row.centre().y);
  page.click(row.centre().x, row.centre().y);
  CHECK(questions(page) == 2);
  isInRow();
  using platform::Device;
  using platform::PointerKind;
  const auto stay = [&](const app::Rect& at) {
    page.pointer(PointerKind::Down, at.centre().x, at.centre().y, Device::Touch, 5);
    page.settle();
    page.host.clockMs += 700;
    page.app->wake();
    page.settle();
    page.pointer(PointerKind::Up, at.centre().x, at.centre().y, Device::Touch, 5);
    page.settle();
  };
  page.pointer(PointerKind::Move, 5, 5, Device::Touch, 5);
  page.settle();
  stay(rowOf(page, "Part 2"));
  CHECK(questions(page) == 3);
  // Of another part a finger that stays takes it in hand as well.
  stay(rowOf(page, "Part 1"));
  CHECK(questions(page) == 3);
  CHECK(page.state().find("selected")->array()->size() == 2);
}

TEST_CASE("a name whose row is out of sight is asked for in a dialog") {
  Rig phone({390, 740, 2});
  phone.openBar();
  phone.drawBar();
  phone.run("rename-part");
  CHECK_FALSE(askedAt(phone));
}

TEST_CASE("what was put together is lit from when it is there, for a moment, and it is said") {
  test::Stuck page;
  CHECK(page.host.said("are together now"));
  page.answer(page.lastAsked());
  page.app->wake();
  page.app->frame();
  REQUIRE(page.gl->last.meshes.size() == 2);
  for (const gl::SceneMesh& mesh : page.gl->last.meshes) CHECK(mesh.glow > 0.9f);
  CHECK(page.settle());
  const auto lit =
      std::ranges::count_if(page.gl->last.meshes, [](const gl::SceneMesh& mesh) { return mesh.glow > 0.9f; });
  CHECK(lit == 0);
}

TEST_CASE("a few guesses are told with the part, without an offer") {
  Rig page;
  page.openBar();
  page.run("draw-spine", R"({"stroke": [[100, 40], [100, 174]]})");
  CHECK(page.host.said("ends are guesses."));
  CHECK_FALSE(page.host.said("Try again"));
}

TEST_CASE("what was drawn is said, by an offer that many of its ends are guesses, and what was deleted") {
  Rig page;
  page.openBar();
  page.drawBar();
  CHECK(page.host.said("Part 1 is made."));
  page.run("draw-spine", R"({"stroke": [[20, 40], [22, 100], [20, 160]]})");
  CHECK(page.host.said("of the ends are guesses"));
  page.run("delete-part");
  CHECK(page.host.said("Part 2 is deleted."));
  page.run("undo");
  page.run("select-all");
  page.run("delete-part");
  CHECK(page.host.said("2 parts are deleted."));
}
