#include <doctest/doctest.h>

#include <set>

#include "tests/unit/web/rig.h"
#include "web/ui/icons.h"

using namespace spineloft;
using spineloft::test::Rig;

TEST_CASE("ids of the command table are unique, and every command has words and an icon") {
  std::set<std::string_view> ids;
  for (const app::Command& command : app::commandTable()) {
    CAPTURE(command.id);
    CHECK(ids.insert(command.id).second);
    CHECK(static_cast<bool>(command.run));
    CHECK_FALSE(command.label.empty());
    CHECK_FALSE(command.hint.empty());
    CHECK(app::iconCode(command.icon) != 0);
  }
  // A CommandId that compiles has its row.
  CHECK(ids == std::set<std::string_view>(app::kCommandIds.begin(), app::kCommandIds.end()));
}

TEST_CASE("every key of the table reaches its command and no other") {
  const std::pair<platform::KeyEvent, std::string_view> keys[] = {
      {{"KeyZ", "z", true, platform::kControl}, "undo"},
      {{"KeyZ", "z", true, platform::kMeta}, "undo"},
      {{"KeyZ", "Z", true, platform::kControl | platform::kShift}, "redo"},
      {{"KeyY", "y", true, platform::kControl}, "redo"},
      {{"Delete", "Delete", true, 0}, "delete-part"},
      {{"Backspace", "Backspace", true, 0}, "delete-part"},
      {{"BracketRight", "+", true, platform::kShift}, "zoom-in"},
      {{"NumpadAdd", "+", true, 0}, "zoom-in"},
      {{"Minus", "-", true, 0}, "zoom-out"},
      {{"KeyH", "h", true, 0}, "home-view"},
      {{"KeyS", "s", true, platform::kControl}, "save-project"},
      {{"Escape", "Escape", true, 0}, "cancel"},
  };
  for (const auto& [event, id] : keys) {
    const app::Command* command = app::commandForKey(event);
    REQUIRE(command != nullptr);
    CHECK(command->id == id);
  }
  CHECK(app::commandForKey({"KeyZ", "z", true, 0}) == nullptr);
  CHECK(app::commandForKey({"KeyZ", "z", true, platform::kControl | platform::kAlt}) == nullptr);
}

TEST_CASE("an empty board refuses what needs a picture or a part, by name and with a sentence") {
  Rig rig;
  for (const char* id : {"draw-spine", "delete-part", "undo", "redo", "save-glb", "fit", "clear"}) {
    const app::Json answer = rig.run(id);
    CAPTURE(id);
    CHECK(answer.flag("ok") == false);
    CHECK(*answer.text("error") == "NotNow");
    CHECK(answer.text("sentence")->size() > 10);
  }
  CHECK(*rig.run("fly-to-the-moon").text("error") == "NoSuchCommand");
  CHECK(*rig.run("undo", "{not json").text("error") == "JsonInvalid");
  CHECK(*rig.run("set-height", R"({"mm":1e999})").text("error") == "JsonInvalid");  // larger than every double
}

TEST_CASE("strokes by numbers meet the engine's named errors and change nothing") {
  Rig rig;
  rig.openBar();
  const std::string before = std::string(rig.app->state());
  const std::pair<const char*, const char*> bad[] = {
      {R"({"stroke":[[10,10]]})", "StrokeTooShort"},
      {R"({"stroke":[[10,10],[null,20]]})", "StrokeNotFinite"},
      {R"({"stroke":[[10,10],["x",20],[30,30]]})", "StrokeNotFinite"},
      {R"({"stroke":[[-500,-500],[-400,-400]]})", "StrokeOutsidePicture"},
      {R"({"stroke":"no"})", "ArgumentMissing"},
      {R"({"stroke":[[100,40],[100,160]],"section":"potato"})", "ValueOutOfRange"},
  };
  for (const auto& [args, error] : bad) {
    const app::Json answer = rig.run("draw-spine", args);
    CAPTURE(args);
    CHECK(answer.flag("ok") == false);
    CHECK(*answer.text("error") == error);
  }
  rig.settle();
  CHECK(rig.parts() == 0);
  CHECK(rig.state().number("undo") == 1);
  CHECK(app::Json::parse(before)->number("undo") == 1);
}

TEST_CASE("section, ends, look, name and height are set for the selected part and undone one by one") {
  Rig rig;
  rig.openBar();
  CHECK(rig.run("draw-spine", R"({"stroke":[[100,40],[100,160]]})").flag("ok") == true);
  CHECK(rig.run("set-section", R"({"section":"heart"})").flag("ok") == true);
  CHECK(rig.run("set-caps", R"({"start":"flat","end":"pointed"})").flag("ok") == true);
  CHECK(rig.run("set-caps", R"({"both":"open"})").flag("ok") == true);
  CHECK(rig.run("set-colour", R"({"colour":"#12aB9f"})").flag("ok") == true);
  CHECK(rig.run("rename-part", R"({"name":"Neck"})").flag("ok") == true);
  CHECK(rig.run("set-height", R"({"mm":55})").flag("ok") == true);
  const app::Json state = rig.state();
  const app::Json& part = (*state.find("parts")->array())[0];
  CHECK(*part.text("section") == "heart");
  CHECK(*part.find("caps")->text("start") == "open");
  CHECK(*part.text("colour") == "#12ab9f");
  CHECK(part.flag("textured") == false);
  CHECK(*part.text("name") == "Neck");
  CHECK(state.number("heightMm") == 55);
  CHECK(state.number("undo") == 8);
  for (int i = 0; i < 8; ++i) CHECK(rig.run("undo").flag("ok") == true);
  CHECK(rig.state().number("undo") == 0);
  CHECK(rig.state().find("picture")->isNull());
  for (int i = 0; i < 8; ++i) CHECK(rig.run("redo").flag("ok") == true);
  CHECK(*(*rig.state().find("parts")->array())[0].text("section") == "heart");
}

TEST_CASE("a value out of range is refused by name") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const std::pair<const char*, const char*> bad[] = {
      {"set-section", R"({"section":"potato"})"},
      {"set-caps", R"({"start":"spiky"})"},
      {"set-colour", R"({"colour":"red"})"},
      {"set-colour", R"({"colour":"#12345g"})"},
      {"set-height", R"({"mm":-3})"},
      {"set-height", R"({"mm":1e300})"},
  };
  for (const auto& [id, args] : bad) {
    CAPTURE(args);
    CHECK(*rig.run(id, args).text("error") == "ValueOutOfRange");
  }
  CHECK(*rig.run("set-section", R"({"part":77,"section":"star"})").text("error") == "NoSuchPart");
  CHECK(*rig.run("set-section").text("error") == "ArgumentMissing");
}

TEST_CASE("rename and height ask in a dialog, and the answer is carried out") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("rename-part");
  CHECK(rig.host.said(R"("id":"rename-part:1")"));
  rig.app->answer("rename-part:1", "Bottle");
  CHECK(*(*rig.state().find("parts")->array())[0].text("name") == "Bottle");
  rig.run("set-height");
  CHECK(rig.host.said(R"("id":"set-height")"));
  for (const char* typed : {"6,25", "6.25 cm", " 62,5mm ", "0.0625 M"}) {
    rig.run("set-height", R"({"mm":10})");
    rig.app->answer("set-height", typed);
    CHECK(*rig.state().number("heightMm") == doctest::Approx(62.5));
  }
  rig.app->answer("set-height", "tall");
  CHECK(rig.state().number("heightMm") == 62.5);
  CHECK(rig.host.said(R"("level":"error")"));
}

TEST_CASE("the state names every error's sentence and the commands give choices that can be run") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  CHECK(rig.app->sentence("StrokeLoops").find("crosses itself") != std::string::npos);
  CHECK(rig.app->sentence("NoSuchError").empty());
  const app::Json commands = *app::Json::parse(rig.app->commands());
  CHECK(commands.array()->size() == app::commandTable().size());
  int choices = 0;
  for (const app::Json& command : *commands.array()) {
    const app::Json* argument = command.find("argument");
    if (argument == nullptr || argument->find("choices") == nullptr) continue;
    if (command.flag("enabled") != true) continue;  // such as the inks while there is no paper
    for (const app::Json& choice : *argument->find("choices")->array()) {
      const app::Json* value = choice.find("value");
      const std::string text =
          value->text() ? "\"" + *value->text() + "\"" : std::to_string(static_cast<int>(*value->number()));
      const std::string args = "{\"" + *argument->text("key") + "\":" + text + "}";
      CAPTURE(args);
      CHECK(rig.run(*command.text("id"), args).flag("ok") == true);
      ++choices;
    }
  }
  CHECK(choices > 20);
}
