// What the shell needs to keep a model: the records that are told, and a page that is made anew from them.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "engine/io/journal.h"
#include "rig.h"
#include "tests/support/photo_copies.h"

using namespace spineloft;

namespace {

/// A page, and a shell that writes down what it is told.
struct KeptRig : test::Rig {
  KeptRig() { base = app->history(); }

  /// The records told since the last look.
  std::vector<std::string> records() {
    std::vector<std::string> all;
    for (const std::string& text : host.sent) {
      const auto event = app::Json::parse(text);
      if (event && event->text("type") && *event->text("type") == "journal") {
        all.push_back(*event->text("record"));
        for (const app::Json& hash : *event->find("photos")->array()) photos.push_back(*hash.text());
      }
    }
    return all;
  }
  std::string recordsJson() {
    app::JsonWriter json;
    json.beginArray();
    for (const std::string& record : records()) json.text(record);
    json.endArray();
    return json.json();
  }

  std::string base;
  std::vector<std::string> photos;
};

/// Everything a shell knows of a page, without the page.
struct Kept {
  explicit Kept(KeptRig& rig)
      : base(rig.base), records(rig.recordsJson()), history(rig.app->history()), parts(rig.parts()) {
    for (const std::string& hash : rig.photos) photos.emplace_back(hash, rig.app->photo(hash));
    undo = rig.state().number("undo");
    redo = rig.state().number("redo");
  }
  std::string base, records, history;
  std::size_t parts = 0;
  std::optional<double> undo, redo;
  std::vector<std::pair<std::string, std::shared_ptr<const image::Picture>>> photos;
};

/// Makes a page anew and compares it.
void checkReplayed(const Kept& kept) {
  test::Rig other;
  for (const auto& [hash, photo] : kept.photos) {
    REQUIRE(photo != nullptr);
    CHECK(other.app->layPhotoBy(*photo) == hash);
  }
  const app::Json answer = *app::Json::parse(other.app->restore(kept.base, kept.records));
  REQUIRE(answer.flag("ok") == true);
  CHECK(answer.number("dropped") == 0);
  other.settle();
  CHECK(other.parts() == kept.parts);
  CHECK(other.state().number("undo") == kept.undo);
  CHECK(other.state().number("redo") == kept.redo);
  CHECK(std::string(other.app->history()) == kept.history);
}

}  // namespace

TEST_CASE("base and records of any sequence of commands make the same history in another page") {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    auto page = std::make_unique<KeptRig>();
    KeptRig& rig = *page;
    rig.openBar();
    rig.drawBar();
    const std::vector<std::pair<std::string, std::string>> commands = {
        {"undo", "{}"},
        {"redo", "{}"},
        {"set-section", R"({"section":"star"})"},
        {"set-section", R"({"section":"square"})"},
        {"set-caps", R"({"both":"flat"})"},
        {"toggle-texture", "{}"},
        {"rename-model", R"({"name":"Ünïcode \"quoted\""})"},
        {"draw-spine", R"({"stroke":[[100,50],[100,100],[101,150]]})"},
        {"delete-part", "{}"},
        {"set-height", R"({"mm":55})"},
        {"clear", "{}"},
    };
    for (int i = 0; i < 30; ++i) {
      const auto& [id, args] = commands[random() % commands.size()];
      rig.run(id, args);
    }
    rig.settle();
    const Kept kept(rig);
    page.reset();
    checkReplayed(kept);
  }
}

TEST_CASE("a step is told once, a refused one not at all, and an undo is told as such") {
  KeptRig rig;
  rig.openBar();
  CHECK(rig.records().size() == 1);
  CHECK(rig.photos.size() == 1);
  rig.run("draw-spine", R"({"stroke":[[100,50]]})");
  rig.run("undo");
  rig.run("undo");
  rig.settle();
  const std::vector<std::string> records = rig.records();
  REQUIRE(records.size() == 2);
  CHECK(records.back() == io::undoRecord());
}

TEST_CASE("a burst that goes on is told after a while, as one record, and before the next step") {
  test::FakeHost host;
  app::Studio studio(host, 0);
  const auto told = [&] {
    return std::ranges::count_if(host.sent,
                                 [](const std::string& json) { return json.starts_with(R"({"type":"journal")"); });
  };
  const auto rename = [&](const std::string& name, std::string_view burst) {
    const document::Action action = document::RenameDocument{name};
    REQUIRE(studio.act({&action, 1}, burst).ok());
  };
  rename("a", "names");
  CHECK(told() == 1);
  for (const char* name : {"b", "c", "d"}) rename(name, "names");
  CHECK(told() == 1);
  host.clockMs += 300;
  studio.sendAmends();
  CHECK(told() == 2);
  rename("e", "names");
  rename("f", "");
  CHECK(told() == 4);
  CHECK(studio.undoSteps() == 2);

  std::vector<std::string> records;
  for (const std::string& text : host.sent) {
    const auto event = app::Json::parse(text);
    if (event->text("record")) records.push_back(*event->text("record"));
  }
  const auto read = io::readHistory(io::writeHistory(io::DocumentHistory()), records, {});
  REQUIRE(read.ok());
  CHECK(io::writeHistory(read.value().history) == io::writeHistory(studio.history()));
}

TEST_CASE("a model that cannot be read leaves the page as it is and says why") {
  KeptRig rig;
  rig.openBar();
  rig.drawBar();
  const std::string before = rig.app->history();
  for (const char* base : {"nonsense", "{}", R"({"present":{"version":99}})"}) {
    CAPTURE(base);
    const app::Json answer = *app::Json::parse(rig.app->restore(base, "[]"));
    CHECK(answer.flag("ok") == false);
    CHECK(!answer.text("sentence")->empty());
    CHECK(rig.app->history() == before);
  }
  CHECK(app::Json::parse(rig.app->restore(before, "{}"))->flag("ok") == false);
  CHECK(rig.app->history() == before);
}

TEST_CASE("damaged records are left out from the first one on, and counted") {
  KeptRig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("set-height", R"({"mm":55})");
  std::vector<std::string> records = rig.records();
  REQUIRE(records.size() == 3);
  records[1][records[1].size() / 2] ^= 1;
  app::JsonWriter json;
  json.beginArray();
  for (const std::string& record : records) json.text(record);
  json.endArray();
  const auto photo = rig.app->photo(rig.photos.front());
  rig.app->layPhotoBy(*photo);
  const app::Json answer = *app::Json::parse(rig.app->restore(rig.base, json.json()));
  REQUIRE(answer.flag("ok") == true);
  CHECK(answer.number("dropped") == 2);
  CHECK(rig.parts() == 0);
  CHECK(rig.state().number("undo") == 1);
}

TEST_CASE("an empty base is a new model; nothing of the old one stays") {
  KeptRig rig;
  rig.openBar();
  rig.drawBar();
  CHECK(app::Json::parse(rig.app->restore("", "[]"))->flag("ok") == true);
  rig.settle();
  CHECK(rig.state().find("picture")->isNull());
  CHECK(rig.state().number("undo") == 0);
  CHECK(rig.app->photos() == "[]");
  CHECK(rig.app->history() == rig.base);
}

TEST_CASE("the history knows its photos, also those that only undo brings back") {
  KeptRig rig;
  rig.openBar();
  rig.run("remove-picture");
  rig.records();
  REQUIRE(rig.photos.size() == 1);
  CHECK(rig.app->photos() == "[\"" + rig.photos[0] + "\"]");
  CHECK(rig.app->photo(rig.photos[0]) != nullptr);
  CHECK(rig.app->photo("0000000000000000") == nullptr);
  CHECK(rig.app->photo("no hash") == nullptr);
}

TEST_CASE("a thumbnail shows the solid, the picture before there is one, and nothing on an empty board") {
  test::Rig rig;
  CHECK(rig.app->thumbnail(192, 144).empty());
  rig.openBar();
  CHECK(rig.app->thumbnail(192, 144).width == 192);
  CHECK(rig.gl->last.meshes.empty());
  CHECK(rig.gl->last.picture.has_value());
  // The picture covers it all.
  CHECK(rig.gl->last.pictureAt.width >= 192);
  CHECK(rig.gl->last.pictureAt.height >= 144);
  rig.drawBar();
  CHECK(rig.app->thumbnail(192, 144).height == 144);
  CHECK(rig.gl->last.meshes.size() == 1);
  CHECK(rig.gl->last.solidView.width == 192);
  CHECK(rig.app->thumbnail(0, 144).empty());
  CHECK(rig.app->thumbnail(100000, 144).empty());
}

TEST_CASE("what is about models asks the shell, with the model it names") {
  test::Rig rig;
  CHECK(rig.run("new-model").flag("ok") == false);
  rig.openBar();
  for (const char* id : {"new-model", "open-model", "open-file", "duplicate-model", "delete-model"}) {
    CHECK(rig.run(id, R"({"id":"abc"})").flag("ok") == true);
    CHECK(rig.host.said(R"({"type":"keep","what":")" + std::string(id) + R"(","id":"abc"})"));
  }
  rig.run("rename-model");
  CHECK(rig.host.said(R"("id":"rename-model")"));
  rig.app->answer("rename-model", "Swan");
  CHECK(*rig.state().text("documentName") == "Swan");
}

TEST_CASE("a project file opens as a model of its own, and any other file leaves the page as it is") {
  KeptRig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("rename-model", R"({"name":"Swan"})");
  const auto bytes = rig.app->exportModel("spineloft");
  const std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
  REQUIRE(!file.empty());
  rig.run("clear");
  const std::string before = rig.app->history();
  std::vector<std::uint8_t> cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(file.size() / 2));
  for (const std::vector<std::uint8_t>& bad : {cut, std::vector<std::uint8_t>{1, 2, 3}}) {
    const app::Json refused = *app::Json::parse(rig.app->openProject(bad, "{}"));
    CHECK(refused.flag("ok") == false);
    CHECK(!refused.text("sentence")->empty());
    CHECK(rig.app->history() == before);
  }
  CHECK(*app::Json::parse(rig.app->openProject(cut, "{}"))->text("error") == "ProjectInvalid");
  CHECK(app::Json::parse(rig.app->openProject(file, "{}"))->flag("ok") == true);
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(*rig.state().text("documentName") == "Swan");
  CHECK(rig.state().number("undo") == 0);
  CHECK(rig.state().flag("unsaved") == false);
  CHECK(!rig.state().find("parts")->array()->front().find("ribs")->array()->empty());
}

TEST_CASE("a link with copies of its photos opens with what was laid by for them, and without them in one colour") {
  image::Picture photo;
  std::vector<std::uint8_t> bytes;
  std::string picture;
  {
    test::Rig rig;
    rig.openBar();
    rig.drawBar();
    const std::string hash = *app::Json::parse(rig.app->photos())->array()->front().text();
    photo = *rig.app->photo(hash);
    const std::string copy = testing::base64url(io::encodeJpeg(photo.working, 60).value());
    const app::Json shared = *app::Json::parse(rig.app->shareText(R"({")" + hash + R"(":")" + copy + R"("})"));
    REQUIRE(shared.flag("ok") == true);
    CHECK(shared.number("photos") == 0);
    CHECK(app::Json::parse(rig.app->shareText("{}"))->number("photos") == 1);
    const std::string link = "#m=" + *shared.text("text");
    bytes.assign(link.begin(), link.end());
    const app::Json inside = *app::Json::parse(rig.app->photosOfLink(bytes));
    REQUIRE(inside.find("photos")->object()->size() == 1);
    picture = inside.find("photos")->object()->front().first;
    CHECK(*inside.find("photos")->object()->front().second.text() == copy);
    const std::vector<std::uint8_t> none{1, 2, 3};
    CHECK(app::Json::parse(rig.app->photosOfLink(none))->find("photos")->object()->empty());
  }
  test::Rig rig;
  const std::string laid = R"({")" + picture + R"(":")" + rig.app->layPhotoBy(photo) + R"("})";
  const auto isTextured = [&] {
    REQUIRE(app::Json::parse(rig.app->openProject(bytes, laid))->flag("ok") == true);
    rig.settle();
    const app::Json state = rig.state();
    return *state.find("parts")->array()->front().flag("textured");
  };
  CHECK(isTextured());
  const app::Json photos = *app::Json::parse(rig.app->photos());
  REQUIRE(photos.array()->size() == 1);
  CHECK(rig.app->photo(*photos.array()->front().text())->working == photo.working);
  // It was given back: nothing is laid by any more.
  CHECK_FALSE(isTextured());
}

TEST_CASE("Save model writes a project file, also of a board without parts, and of a new name where one is given") {
  test::Rig rig;
  CHECK(rig.run("save-project").flag("ok") == false);
  rig.openBar();
  CHECK(rig.run("save-project").flag("ok") == true);
  rig.settle();
  REQUIRE(rig.host.files.size() == 1);
  CHECK(rig.host.files[0].first == "bar.spineloft");
  rig.run("save-project-as");
  CHECK(rig.host.said(R"("id":"save-project-as")"));
  rig.app->answer("save-project-as", "Swan");
  rig.settle();
  REQUIRE(rig.host.files.size() == 2);
  CHECK(rig.host.files[1].first == "swan.spineloft");
}
