// The laws of modes, over random piles of open ones.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/web/rig.h"
#include "web/commands/modes.h"

using namespace spineloft;
using app::Mode;

namespace {

struct TestHand final : app::Hand {
  bool held = false;
  bool holds() const override { return held; }
  void drop() override { held = false; }
};

/// A picture with a loft, a region, a shape, two pieces of lines and one of layers, steps to undo and one to redo.
struct Desk {
  test::FakeHost host;
  app::Studio studio{host, 0};
  app::UiState ui;
  TestHand hand;
  app::CommandEnv env{studio, ui, host, &hand};

  Desk() {
    const auto picture = std::make_shared<const image::Picture>(test::barPicture());
    REQUIRE(studio.act(document::AddPicture{"bar", picture}).ok());
    ui.picture = studio.document().pictures.back()->id;
    run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
    run("draw-puff", R"({"contours":[[[40,40],[90,45],[80,120],[35,100]]]})");
    run("puff-slice", R"({"slice":"round"})");
    run("draw-shape", R"({"kind":"ball","axis":[[150,80],[150,40]]})");
    run("pull", R"({"line":[[150,60]]})");
    run("draw-line", R"({"points":[[20,130],[80,130],[80,180],[20,180]],"closed":true})");
    run("draw-line", R"({"points":[[60,140],[120,140],[120,170],[60,170]],"closed":true})");
    run("draw-layer", R"({"through":[[30,0],[0,30],[-30,0],[0,-30]]})");
    run("rename-model", R"({"name":"A swan"})");
    run("undo");
    REQUIRE(studio.document().parts.size() == 6);
    do {
      studio.pump();
      studio.derived();
    } while (studio.busy());
  }
  void run(std::string_view id, std::string_view args = "{}") {
    const app::Outcome done = app::runCommand(env, id, *app::Json::parse(args));
    CAPTURE(id);
    REQUIRE(done.ok());
  }

  PartId anyPart(Rng& rng) { return studio.document().parts[rng.below(6)]->id; }
  /// Opens and closes what modes are about, each with a chance of a quarter.
  void pile(Rng& rng) {
    const auto chance = [&] { return rng.below(4) == 0; };
    hand.held = chance();
    ui.barMenu = chance() ? app::BarMenu::Edit : app::BarMenu::None;
    ui.pictureMenu = chance() ? ui.picture : PictureId{};
    ui.sketching.menu = chance() ? app::PenMenu::Both : app::PenMenu::None;
    ui.sections.board.reset();
    if (chance()) pileBoard();
    ui.cut.reset();
    if (chance()) pileCut(rng);
    ui.sections.placing = chance();
    ui.solids.pointing = chance();
    ui.solids.hollow.reset();
    if (chance()) ui.solids.hollow.emplace();
    ui.preview.reset();
    if (chance()) ui.preview.renew();
    ui.redraw = chance() ? anyPart(rng) : PartId{};
    ui.selection = chance() ? PartId{} : anyPart(rng);
    ui.focus = chance() ? app::Focus::Solid : app::Focus::Picture;
    using enum app::ToolKind;
    ui.tool = std::array{Draw, Ribs, Spine, Inflate, Place, Pen, Layers, Primitive, Lines, Pull, Bridge}[rng.below(11)];
    ui.layers = {};
    if (rng.below(12) == 0) {
      ui.tool = Layers;
      ui.selection = ui.layers.part = studio.document().parts.back()->id;
      ui.layers.drawsRail = !ui.sections.board;  // which ends it
    }
    ui.chosen = {};
    if (rng.below(2) == 0) ui.chosen.end = ribs::EndRef{};
    if (chance()) ui.chosen.handle = 0;
    if (rng.below(2) == 0) ui.chosen.bone = 0;
    if (rng.below(2) == 0) ui.chosen.outline = app::OutlinePoint{};
    if (rng.below(2) == 0) ui.chosen.shape = 0;
    if (rng.below(2) == 0) ui.chosen.crossing = 0;
    if (rng.below(2) == 0) ui.chosen.pull = 0;
    if (rng.below(12) == 0) {  // rare otherwise
      ui.tool = Primitive;
      ui.selection = studio.document().parts[2]->id;
      ui.chosen.shape = 0;
    }
    studio.cancelWork();
    studio.pump();
    vision::CutHints hints;
    hints.inside = {{100, 100}};
    if (chance()) REQUIRE(studio.cutOut(ui.picture, hints, [](auto) {}).ok());
  }
  void pileBoard() {
    app::SectionBoard& board = ui.sections.board.emplace();
    board.past.resize(2);
    board.future.resize(1);
  }
  void pileCut(Rng& rng) {
    app::CutDraft& cut = ui.cut.emplace();
    cut.picture = ui.picture;
    cut.hints.inside = {{100, 100}};
    cut.hints.marks.resize(rng.below(3));
    cut.undone.resize(rng.below(2));
  }

  std::vector<const Mode*> open() const {
    std::vector<const Mode*> all;
    for (const Mode* mode : app::modes()) {
      if (mode->open(env)) all.push_back(mode);
    }
    return all;
  }
  /// Those that Escape can end.
  std::vector<std::string_view> names() const {
    std::vector<std::string_view> all;
    for (const Mode* mode : open()) {
      if (mode->cancel != nullptr) all.push_back(mode->name);
    }
    return all;
  }
  std::pair<std::size_t, std::size_t> steps() const { return {studio.undoSteps(), studio.redoSteps()}; }
};

/// The first one's own: what it shows and what it waits for ends with it.
std::string_view ownOf(std::string_view mode) {
  return mode == "slice-board" ? "preview" : mode == "cut-out" ? "work" : std::string_view();
}

/// The keys of a row, one event each.
std::vector<platform::KeyEvent> keysOf(const app::Command& command) {
  std::vector<platform::KeyEvent> keys;
  for (std::string_view rest = command.shortcut; !rest.empty();) {
    const std::size_t end = rest.find(", ");
    std::string_view key = rest.substr(0, end);
    int modifiers = 0;
    for (const auto& [word, bit] : {std::pair{"Shift+", platform::kShift}, std::pair{"Ctrl+", platform::kControl}}) {
      if (!key.starts_with(word)) continue;
      key.remove_prefix(std::string_view(word).size());
      modifiers |= bit;
    }
    keys.push_back({key, key, true, modifiers});
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
  }
  return keys;
}
bool sameKey(const platform::KeyEvent& a, const platform::KeyEvent& b) {
  return a.key == b.key && a.modifiers == b.modifiers;
}

}  // namespace

TEST_CASE("Escape ends the topmost mode and no other, down to the model, and is no step of the document") {
  Desk desk;
  std::set<std::string_view> ended;
  for (const std::uint64_t seed : testing::seeds(1, 200)) {
    CAPTURE(seed);
    Rng rng(seed);
    desk.pile(rng);
    const auto steps = desk.steps();
    for (std::vector<std::string_view> left = desk.names(); left.size() > 1; left = desk.names()) {
      const std::string_view top = left.front();
      CAPTURE(top);
      left.erase(left.begin());
      std::erase(left, ownOf(top));
      desk.run("cancel");
      if (top == "work" || top == "cut-out") desk.studio.pump();  // what is given up ends where it is taken in
      REQUIRE(desk.names() == left);
      CHECK(desk.steps() == steps);
      ended.insert(top);
    }
    desk.run("cancel");
    CHECK_FALSE(desk.ui.selection);
    CHECK(desk.steps() == steps);
  }
  for (const Mode* mode : app::modes().first(app::modes().size() - 1)) {
    CAPTURE(mode->name);
    CHECK(ended.contains(mode->name) == (mode->cancel != nullptr));
  }
}

TEST_CASE("undo and redo in a mode that has its own steps leave those of the document alone") {
  Desk desk;
  std::set<std::string_view> used;
  for (const std::uint64_t seed : testing::seeds(1, 200)) {
    CAPTURE(seed);
    Rng rng(seed);
    desk.pile(rng);
    for (int i = 0; i < 12; ++i) {
      const auto steps = desk.steps();
      const bool back = rng.below(2) == 0;
      const Mode& top = topMode(desk.env, back ? &Mode::undo : &Mode::redo);
      const app::Command& command = back ? app::commandOf("undo") : app::commandOf("redo");
      CHECK(app::enabled(command, desk.env) == (back ? top.canUndo : top.canRedo)(desk.env));
      const bool enabled = app::enabled(command, desk.env);
      CHECK(app::runCommand(desk.env, command, {}).ok() == enabled);
      used.insert(top.name);
      if (top.name != "model") CHECK(desk.steps() == steps);
    }
    while (desk.studio.redo().ok()) continue;  // the parts are there again
  }
  CHECK(used == std::set<std::string_view>{"gesture", "slice-board", "cut-out", "model"});
}

TEST_CASE("a key goes to the topmost open mode that has a command for it, else to the model") {
  Desk desk;
  std::set<const Mode*> took;
  for (const std::uint64_t seed : testing::seeds(1, 1500)) {
    CAPTURE(seed);
    Rng rng(seed);
    desk.pile(rng);
    const std::vector<const Mode*> open = desk.open();
    for (const app::Command& row : app::commandTable()) {
      for (const platform::KeyEvent& key : keysOf(row)) {
        const app::Command* command = app::commandForKey(key, &desk.env);
        CAPTURE(row.id);
        const auto place = [&](const Mode* mode) { return std::ranges::find(open, mode); };
        const bool counts = row.mode == nullptr || place(row.mode) != open.end();
        if (!counts) continue;
        REQUIRE(command != nullptr);
        took.insert(command->mode);
        if (command != &row) CHECK(place(command->mode) < place(row.mode));
      }
    }
  }
  std::set<const Mode*> withKeys;
  for (const app::Command& row : app::commandTable()) withKeys.insert(row.mode);
  for (const Mode* mode : withKeys) {
    CAPTURE((mode != nullptr ? mode->name : "none"));
    CHECK(took.contains(mode));
  }
}

TEST_CASE("no key means two things in one mode") {
  for (const app::Command& a : app::commandTable()) {
    for (const app::Command& b : app::commandTable()) {
      if (&a == &b || a.mode != b.mode) continue;
      CAPTURE(a.id);
      CAPTURE(b.id);
      for (const auto& key : keysOf(a)) {
        CHECK(std::ranges::none_of(keysOf(b), [&](const auto& other) { return sameKey(key, other); }));
      }
    }
  }
}
