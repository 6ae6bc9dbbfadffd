// What happened is said: by whatever changes the model, by undo and by redo.
#include <doctest/doctest.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using app::Json;
using spineloft::test::Rig;

namespace {

constexpr int kTurns = 20;  // nobody solves solids here

/// The last sentence since `from` messages were sent, in the status line or in a toast; empty: nothing is said.
std::string said(const Rig& rig, std::size_t from = 0) {
  std::string last;
  for (std::size_t i = from; i < rig.host.sent.size(); ++i) {
    if (rig.host.sent[i].size() > 100000) continue;  // a step for the journal
    const std::optional<Json> event = Json::parse(rig.host.sent[i]);
    const std::string* type = event ? event->text("type") : nullptr;
    if (type && (*type == "status" || *type == "toast")) last = *event->text("text");
  }
  return last;
}

/// A page of each kind of work, on which commands are tried.
void begin(Rig& rig, std::string_view work) {
  rig.run("more-tools", R"({"on":true})");
  if (work == "paper") {
    rig.run("new-sketch");
    rig.run("draw-on-sketch", R"({"stroke":[[100,100],[300,100],[300,300],[100,300],[100,100]]})");
    return;
  }
  rig.openBar();
  rig.drawBar();
  if (work == "rib") {
    rig.run("ribs");
    rig.run("choose-rib", R"({"rib":3,"side":"left"})");
  } else if (work == "puff" || work == "solid" || work == "two") {
    rig.run("draw-puff", R"({"line":[[20,60],[50,60],[50,90],[20,90],[20,60]]})");
    if (work != "puff") rig.run("select-all");
    if (work == "solid") rig.run("stick-together");
  } else if (work == "slices") {
    rig.run("add-slice", R"({"at":0.5})");
  }
  rig.settle(kTurns);
}

}  // namespace

TEST_CASE("every command of the table that changes the model says so, and so do its undo and redo" *
          doctest::test_suite("slow")) {
  std::set<std::string_view> changing;
  for (const char* work : {"rib", "two", "solid", "slices", "paper"}) {
    std::optional<Rig> rig;
    for (const app::Command& command : app::commandTable()) {
      if (command.id == "undo" || command.id == "redo") continue;
      if (!rig) begin(rig.emplace(), work);
      const double before = *rig->state().number("undo");
      std::size_t from = rig->host.sent.size();
      if (rig->run(command.id).flag("ok") != true) continue;
      rig->settle(kTurns);
      if (rig->state().number("undo") != before) {
        CAPTURE(work);
        CAPTURE(command.id);
        changing.insert(command.id);
        CHECK_FALSE(said(*rig, from).empty());
        from = rig->host.sent.size();
        rig->run("undo");
        CHECK(said(*rig, from).starts_with("Undone: "));
        from = rig->host.sent.size();
        rig->run("redo");
        CHECK(said(*rig, from).starts_with("Done again: "));
      }
      rig.reset();
    }
  }
  CHECK(changing.size() > 30);
}

TEST_CASE("a step is named after what it changed and of which part") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const std::pair<const char*, const char*> steps[] = {
      {"set-colour", R"({"colour":"#ff0000"})"},
      {"rename-part", R"({"name":"Neck"})"},
      {"set-caps", R"({"both":"flat"})"},
      {"set-section", R"({"section":"star"})"},
      {"set-height", R"({"mm":40})"},
      {"delete-part", "{}"},
  };
  for (const auto& [id, args] : steps) REQUIRE(rig.run(id, args).flag("ok") == true);
  for (const char* sentence :
       {"Undone: Delete part (Neck).", "Undone: Size.", "Undone: Slice (Neck).", "Undone: Ends (Neck).",
        "Undone: Rename (Neck).", "Undone: Colour (Part 1).", "Undone: New part (Part 1)."}) {
    const std::size_t from = rig.host.sent.size();
    REQUIRE(rig.run("undo").flag("ok") == true);
    CHECK(said(rig, from) == sentence);
  }
}

TEST_CASE("undo and redo on the board of a slice and in a cut-out are said, too") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const auto saidOf = [&](const char* id) {
    const std::size_t from = rig.host.sent.size();
    REQUIRE_MESSAGE(rig.run(id).flag("ok") == true, id);
    return said(rig, from);
  };
  REQUIRE(rig.run("edit-slice").flag("ok") == true);
  REQUIRE(rig.run("slice-start-from", R"({"section":"star"})").flag("ok") == true);
  CHECK(saidOf("undo") == "Undone: Slice.");
  CHECK(saidOf("redo") == "Done again: Slice.");
  rig.run("slice-cancel");
  REQUIRE(rig.run("cut-start", R"({"at":[100,100]})").flag("ok") == true);
  REQUIRE(rig.run("cut-mark", R"({"line":[[90,90],[100,100]]})").flag("ok") == true);
  CHECK(saidOf("undo") == "Undone: Mark.");
  CHECK(saidOf("redo") == "Done again: Mark.");
}
