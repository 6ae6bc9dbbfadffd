#include "web/commands/shell_view.h"

#include <algorithm>
#include <span>

#include "web/commands/commands.h"
#include "web/model/json.h"
#include "web/ui/sketching.h"

namespace spineloft::app {
namespace {

void reach(std::span<const PicturePoint> points, std::optional<std::array<double, 4>>& box) {
  for (const PicturePoint& p : points) {
    if (!box) box = {p.x, p.y, p.x, p.y};
    auto& [left, top, right, bottom] = *box;
    left = std::min(left, p.x);
    top = std::min(top, p.y);
    right = std::max(right, p.x);
    bottom = std::max(bottom, p.y);
  }
}

std::optional<std::array<double, 4>> drawnOn(const document::Document& document, const document::PictureEntry& entry) {
  std::optional<std::array<double, 4>> box;
  for (const image::SketchStroke& stroke : entry.sketch) {
    if (!stroke.erase) reach(stroke.points, box);
  }
  for (const document::Part& part : document.parts) {
    const document::LoftRecipe* loft = document::loftOf(part);
    if (!box && loft != nullptr && loft->picture == entry.id) reach(loft->stroke, box);
  }
  return box;
}

void showPicture(const document::Document& document, const UiState& ui, const document::PictureEntry& entry,
                 ViewPicture& picture) {
  const auto corner = [&](double x, double y) { return ui.pictureView.toClient({x, y}, ui.layout.picture); };
  picture.size = entry.size;
  picture.strokes = entry.sketch.size();
  picture.sketch = entry.isSketch();
  picture.finished = entry.isSketch() && looksFinished(entry);
  picture.topLeft = corner(-0.5, -0.5);
  picture.bottomRight = corner(entry.size.width - 0.5, entry.size.height - 0.5);
  picture.buttons = ui.layout.picture.bottom() - ui.barFoot;
  picture.drawn.reset();
  if (!ui.sections.board) picture.drawn = drawnOn(document, entry);
}

void showPart(const pipeline::Derived& derived, const document::Part& part, ViewSelected& selected) {
  const auto at = std::ranges::find(derived.parts, part.id, &pipeline::DerivedPart::id);
  selected.id = part.id;
  selected.name = part.name;
  selected.kind = document::kindOf(part);
  selected.ribs = at != derived.parts.end() && at->shape ? at->shape->ribs.ribs.size() : 0;
}

/// What a visitor who is led through the first steps has made.
void countKinds(const document::Document& document, ShellView& view) {
  const auto isShaped = [](const document::Part& part) {
    const document::LoftRecipe* loft = document::loftOf(part);
    if (loft == nullptr) return false;
    const auto& sections = loft->loft.sections;
    return sections.size() > 1 || sections.front().shape != sections::SectionShape{};
  };
  const auto count = [](auto number) { return static_cast<std::size_t>(number); };
  view.solids = document.steps.size();
  view.hollow = count(std::ranges::count(document.steps, document::StepKind::Hollow, &document::Step::kind));
  view.mirrored =
      count(std::ranges::count_if(document.parts, [](const document::Part& part) { return part.mirror.has_value(); }));
  view.shaped = count(std::ranges::count_if(document.parts, isShaped));
}

void showCommands(const CommandEnv& env, ShellView& view) {
  view.enabled.reset();
  view.toggled.reset();
  const std::span<const Command> table = commandTable();
  for (std::size_t i = 0; i < table.size() && i < ShellView::kMostCommands; ++i) {
    view.enabled[i] = enabled(table[i], env);
    view.toggled[i] = table[i].toggled != nullptr && table[i].toggled(env);
  }
}

/// The value to fill in: the one that is there, whose memory is used again, or a new one.
template <class T>
T& filled(std::optional<T>& value) {
  return value ? *value : value.emplace();
}

}  // namespace

void viewOf(const CommandEnv& env, ShellView& view) {
  const document::Document& document = env.studio.document();
  const UiState& ui = env.ui;
  view.documentName = document.name;
  view.pictures = document.pictures.size();
  view.parts = document.parts.size();
  view.picked = ui.solids.picked.size();
  countKinds(document, view);
  view.turned = ui.cameraTouched;
  view.checked = ui.print.has_value();
  if (const document::PictureEntry* entry = document::findPicture(document, ui.picture)) {
    showPicture(document, ui, *entry, filled(view.picture));
  } else {
    view.picture.reset();
  }
  if (const document::Part* part = document::findPart(document, ui.selection)) {
    showPart(env.studio.derived(), *part, filled(view.selected));
  } else {
    view.selected.reset();
  }
  view.tool = ui.tool;
  view.penMenu = ui.sketching.menu != PenMenu::None;
  view.undo = env.studio.undoSteps();
  view.redo = env.studio.redoSteps();
  view.historyBytes = env.studio.history().bytes();
  view.historyBudget = env.studio.history().budget();
  view.unsaved = env.studio.unsaved();
  if (const auto activity = env.studio.activity()) {
    ViewActivity& shown = filled(view.activity);
    shown.label = activity->label;
    shown.done = static_cast<int>(activity->done * ShellView::kActivitySteps);
  } else {
    view.activity.reset();
  }
  showCommands(env, view);
}

namespace {

void writePicture(const ShellView& view, JsonWriter& json) {
  json.key("picture");
  if (!view.picture) {
    json.null();
    return;
  }
  const ViewPicture& picture = *view.picture;
  json.beginObject().key("width").number(picture.size.width).key("height").number(picture.size.height);
  json.key("sketch").flag(picture.sketch).key("strokes").number(static_cast<double>(picture.strokes));
  json.key("finished").flag(picture.finished).key("drawn");
  if (picture.drawn) {
    json.beginArray();
    for (const double side : *picture.drawn) json.number(side);
    json.endArray();
  } else {
    json.null();
  }
  json.key("topLeft").beginObject().key("x").number(picture.topLeft.x).key("y").number(picture.topLeft.y).endObject();
  json.key("bottomRight").beginObject().key("x").number(picture.bottomRight.x);
  json.key("y").number(picture.bottomRight.y).endObject();
  json.key("buttons").number(picture.buttons).endObject();
}

void writeSelected(const ShellView& view, JsonWriter& json) {
  json.key("selected");
  if (!view.selected) {
    json.null();
    return;
  }
  const ViewSelected& part = *view.selected;
  json.beginObject().key("id").number(part.id.value).key("name").text(part.name);
  json.key("kind").text(document::kindKey(part.kind)).key("ribs").number(static_cast<double>(part.ribs)).endObject();
}

void writeActivity(const ShellView& view, JsonWriter& json) {
  json.key("activity");
  if (!view.activity) {
    json.null();
    return;
  }
  const double done = static_cast<double>(view.activity->done) / ShellView::kActivitySteps;
  json.beginObject().key("label").text(view.activity->label).key("done").number(done).endObject();
}

/// A sign for each command: '1', '0', or '-' where there is nothing to say.
void writeCommandSigns(const ShellView& view, JsonWriter& json) {
  std::string enabled, toggled;
  for (std::size_t i = 0; const Command& command : commandTable()) {
    enabled += view.enabled[i] ? '1' : '0';
    toggled += command.toggled == nullptr ? '-' : view.toggled[i] ? '1' : '0';
    ++i;
  }
  json.key("enabled").text(enabled).key("toggled").text(toggled);
}

void writeView(const ShellView& view, JsonWriter& json) {
  const auto count = [&](std::string_view key, std::size_t value) { json.key(key).number(static_cast<double>(value)); };
  json.beginObject().key("documentName").text(view.documentName);
  count("pictures", view.pictures);
  count("parts", view.parts);
  count("picked", view.picked);
  count("solids", view.solids);
  count("hollow", view.hollow);
  count("mirrored", view.mirrored);
  count("shaped", view.shaped);
  json.key("turned").flag(view.turned).key("checked").flag(view.checked);
  writePicture(view, json);
  writeSelected(view, json);
  json.key("tool").text(toolKey(view.tool)).key("penMenu").flag(view.penMenu);
  count("undo", view.undo);
  count("redo", view.redo);
  json.key("history").beginObject();
  count("bytes", view.historyBytes);
  count("budget", view.historyBudget);
  json.endObject().key("unsaved").flag(view.unsaved);
  writeActivity(view, json);
  writeCommandSigns(view, json);
  json.endObject();
}

}  // namespace

void sendView(platform::Host& host, const ShellView& view) {
  JsonWriter json;
  json.beginObject().key("type").text("changed").key("view");
  writeView(view, json);
  json.endObject();
  host.send(json.json());
}

}  // namespace spineloft::app
