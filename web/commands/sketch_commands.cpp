// Commands about paper, pen and eraser, and about the pictures of the board.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr int kLongSide = 1024;          // of a sheet of paper, in pixels: what edges are sought on
constexpr int kSquareSide = 896;         // as many pixels
constexpr double kClearlyLonger = 1.12;  // a view that is nearly square gets square paper

bool onPaper(Env env) { return shownSketch(env.studio.document(), env.ui) != nullptr; }
bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasPictures(Env env) { return env.studio.document().pictures.size() > 1; }
bool penInHand(Env env) { return env.ui.tool == ToolKind::Pen; }
bool eraserInHand(Env env) { return env.ui.tool == ToolKind::Eraser; }

/// Paper that fills the picture view as it will be.
image::Size paperFor(const UiState& ui) {
  const Rect view = layoutFor(ui.canvasWidth, ui.canvasHeight, ui.share, true).picture;
  constexpr int kShortSide = kLongSide * 3 / 4;
  if (view.width > view.height * kClearlyLonger) return {kLongSide, kShortSide};
  if (view.height > view.width * kClearlyLonger) return {kShortSide, kLongSide};
  return {kSquareSide, kSquareSide};
}

/// A whole number, or −1 for one that is none.
int sideOf(const Json& args, std::string_view key, int fallback) {
  if (args.find(key) == nullptr) return fallback;
  const std::optional<double> value = args.number(key);
  return value && *value == std::floor(*value) && std::abs(*value) < 1e6 ? static_cast<int>(*value) : -1;
}

/// What comes into view is seen as it was last, with nothing of another picture chosen.
void show(Env env, PictureId id) {
  UiState& ui = env.ui;
  const document::Part* part = document::findPart(env.studio.document(), ui.selection);
  const bool staysInHand = partOfViews(env.studio.document(), ui) != nullptr;
  if (part != nullptr && document::pictureOf(*part) != id && !staysInHand) ui.selection = {};
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), id);
  if (ui.picture != id && entry != nullptr) {
    sendStatus(env.host, words::tr("{name} is in view.", {{"name", words::nameOf(entry->name)}}));
  }
  featureAt(ui, id);
  ui.pictureMenu = {};
  ui.redraw = {};
  ui.preview.reset();
  ui.focus = Focus::Picture;
}

Outcome newSketch(Env env, const Json& args) {
  const image::Size usual = paperFor(env.ui);
  const image::Size size{sideOf(args, "width", usual.width), sideOf(args, "height", usual.height)};
  const Status status = env.studio.act(document::AddSketch{"", size});
  if (!status) return refuse(status.failure());
  show(env, env.studio.document().pictures.back()->id);
  env.ui.selection = {};
  env.ui.tool = ToolKind::Pen;
  sendStatus(env.host, "A sheet of paper. Draw the outline of a thing with the pen.");
  return {};
}

Outcome usePen(Env env, const Json&) {
  env.ui.tool = ToolKind::Pen;
  env.ui.redraw = {};
  return {};
}
Outcome useEraser(Env env, const Json&) {
  env.ui.tool = ToolKind::Eraser;
  env.ui.redraw = {};
  return {};
}

Outcome penSize(Env env, const Json& args) {
  if (args.find("size") == nullptr) return setPenSize(env, (sizeInHand(env.ui) + 1) % kPenSizes.size());
  const std::string* key = args.text("size");
  const auto at = key ? std::ranges::find(kPenSizes, *key) : kPenSizes.end();
  if (at == kPenSizes.end()) return refuse({Error::ValueOutOfRange, "size: fine, medium or bold"});
  return setPenSize(env, static_cast<std::size_t>(at - kPenSizes.begin()));
}

Outcome penColour(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return Refusal{"ArgumentMissing", "This needs a colour such as #1f2430."};
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  return setPenColour(env, *colour);
}

/// [[x, y, pressure?], …] of `args.stroke`; numbers that are none become NaN, for the engine to refuse.
bool readStroke(const Json& args, image::SketchStroke& stroke) {
  const Json* list = args.find("stroke");
  if (list == nullptr || list->array() == nullptr || list->array()->empty()) return false;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t fields = list->array()->front().array() ? list->array()->front().array()->size() : 0;
  if (fields < 2) return false;
  for (const Json& entry : *list->array()) {
    const Json::Array* point = entry.array();
    if (point == nullptr || point->size() < 2 || (point->size() > 2) != (fields > 2)) return false;
    stroke.points.push_back({(*point)[0].number().value_or(nan), (*point)[1].number().value_or(nan)});
    if (fields > 2) stroke.pressure.push_back(static_cast<float>((*point)[2].number().value_or(nan)));
  }
  return true;
}

Outcome drawOnSketchRow(Env env, const Json& args) {
  image::SketchStroke stroke;
  if (!readStroke(args, stroke)) {
    return Refusal{"ArgumentMissing",
                   "This needs a stroke: a list of [x, y] or of [x, y, pressure], in picture pixels."};
  }
  stroke.erase = args.flag("erase").value_or(false);
  const Sketching& set = env.ui.sketching;
  stroke.radius = stroke.erase ? kEraserRadii[set.eraserSize] : kPenRadii[set.penSize];
  stroke.colour = set.colour;
  if (args.find("radius") != nullptr) {
    stroke.radius = args.number("radius").value_or(std::numeric_limits<double>::quiet_NaN());
  }
  if (const std::string* text = args.text("colour")) {
    const auto colour = colourFrom(*text);
    if (!colour) return refuse({Error::ValueOutOfRange, *text});
    stroke.colour = *colour;
  }
  return drawOnSketch(env, stroke);
}

/// The picture that `args.picture` or `args.id` names, else the one in view; null when there is none.
const document::PictureEntry* pictureOf(Env env, const Json& args) {
  PictureId id = env.ui.picture;
  for (const std::string_view key : {"picture", "id"}) {
    if (args.find(key) == nullptr) continue;
    id = PictureId{static_cast<std::uint32_t>(std::max(0, sideOf(args, key, 0)))};
    break;
  }
  return document::findPicture(env.studio.document(), id);
}

Outcome noPicture() { return refuse({Error::NoSuchPicture, {}}); }

Outcome selectPictureRow(Env env, const Json& args) {
  const document::PictureEntry* entry = pictureOf(env, args);
  return entry ? selectPicture(env, entry->id) : noPicture();
}

Outcome step(Env env, std::size_t by) {
  const auto& pictures = env.studio.document().pictures;
  std::size_t at = 0;
  while (at < pictures.size() && pictures[at]->id != env.ui.picture) ++at;
  if (at == pictures.size()) return noPicture();
  show(env, pictures[(at + by) % pictures.size()]->id);
  return {};
}
Outcome nextPicture(Env env, const Json&) { return step(env, 1); }
Outcome previousPicture(Env env, const Json&) { return step(env, env.studio.document().pictures.size() - 1); }

Outcome renamePicture(Env env, const Json& args) {
  const document::PictureEntry* entry = pictureOf(env, args);
  if (entry == nullptr) return noPicture();
  env.ui.pictureMenu = {};
  if (const std::string* name = args.text("name")) {
    return outcomeOf(env.studio.act(document::RenamePicture{entry->id, *name}));
  }
  return askPictureName(env, entry->id);
}

Outcome removePictureRow(Env env, const Json& args) {
  const document::PictureEntry* entry = pictureOf(env, args);
  return entry ? removePicture(env, entry->id) : noPicture();
}

void sizeChoices(Env env, JsonWriter& json) {
  constexpr std::array<std::string_view, 3> kLabels = {"Fine", "Medium", "Bold"};
  for (std::size_t i = 0; i < kPenSizes.size(); ++i) {
    writeChoice(json, kPenSizes[i], kLabels[i], sizeInHand(env.ui) == i);
  }
}

void inkChoices(Env env, JsonWriter& json) {
  for (const Ink& ink : kInks) {
    writeChoice(json, ink.value, ink.label, env.ui.sketching.colour == ink.colour);
  }
}

void pictureChoices(Env env, JsonWriter& json) {
  for (const document::PictureEntry& entry : env.studio.document().pictures) {
    json.beginObject().key("value").number(entry.id.value).key("label").text(entry.name);
    json.key("toggled").flag(entry.id == env.ui.picture).endObject();
  }
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "new-sketch", .label = "Draw on paper", .icon = "square-pen", .group = "file",
            .hint = "A blank sheet to draw on with a pen", .menu = "Pictures", .run = newSketch},
    Command{.id = "pen", .label = "Pen", .icon = "pen", .shortcut = "B", .group = "tool", .hint = "Draw on the paper",
            .enabled = onPaper, .toggled = penInHand, .run = usePen},
    Command{.id = "eraser", .label = "Eraser", .icon = "eraser", .shortcut = "E", .group = "tool",
            .hint = "Rub out what is on the paper", .enabled = onPaper, .toggled = eraserInHand, .run = useEraser},
    Command{.id = "pen-size", .label = "Pen size", .icon = "circle-dot", .group = "tool",
            .argument = {"size", sizeChoices}, .hint = "How wide the pen or the eraser is", .enabled = onPaper,
            .run = penSize},
    Command{.id = "pen-colour", .label = "Pen colour", .icon = "palette", .group = "tool",
            .argument = {"colour", inkChoices}, .hint = "The colour of the ink", .enabled = onPaper, .run = penColour},
    Command{.id = "draw-on-sketch", .label = "Draw on paper by numbers", .icon = "pen", .group = "tool",
            .argument = {"stroke"}, .hint = "A pen stroke in picture pixels", .enabled = onPaper,
            .run = drawOnSketchRow},
    Command{.id = "select-picture", .label = "Show picture", .icon = "images", .group = "file",
            .argument = {"id", pictureChoices}, .hint = "Choose the picture to draw on", .enabled = hasPictures,
            .run = selectPictureRow},
    Command{.id = "next-picture", .label = "Next picture", .icon = "chevron-right", .shortcut = "PageDown",
            .group = "file", .hint = "Show the next picture", .enabled = hasPictures, .run = nextPicture},
    Command{.id = "previous-picture", .label = "Previous picture", .icon = "chevron-left", .shortcut = "PageUp",
            .group = "file", .hint = "Show the picture before", .enabled = hasPictures, .run = previousPicture},
    Command{.id = "rename-picture", .label = "Rename picture", .icon = "pencil-line", .group = "file",
            .hint = "Give the picture a name", .enabled = hasPicture, .run = renamePicture},
    Command{.id = "remove-picture", .label = "Remove picture", .icon = "image-off", .group = "file",
            .hint = "Takes the picture and its parts away", .enabled = hasPicture, .run = removePictureRow},
};
// clang-format on

}  // namespace

Outcome drawOnSketch(Env env, const image::SketchStroke& stroke) {
  const document::PictureEntry* sketch = shownSketch(env.studio.document(), env.ui);
  if (sketch == nullptr) return noPicture();
  const bool wasFinished = looksFinished(*sketch);
  const Status status = env.studio.act(document::DrawOnSketch{env.ui.picture, stroke});
  if (!status) return refuse(status.failure());
  if (wasFinished || !looksFinished(*shownSketch(env.studio.document(), env.ui))) return {};
  // What is closed is whole; two open lines may go on.
  if (env.ui.tool == ToolKind::Pen && closesOutline(stroke.points)) env.ui.tool = ToolKind::Draw;
  sendStatus(env.host, "Now draw a line through its middle, or take Puff or Flat piece.");
  return {};
}

Outcome setPenSize(Env env, std::size_t size) {
  env.ui.sketching.menu = PenMenu::None;
  sizeInHand(env.ui) = size;
  return {};
}

Outcome setPenColour(Env env, const Colour& colour) {
  env.ui.sketching.menu = PenMenu::None;
  env.ui.sketching.colour = colour;
  env.ui.tool = ToolKind::Pen;
  return {};
}

Outcome selectPicture(Env env, PictureId picture) {
  if (document::findPicture(env.studio.document(), picture) == nullptr) return noPicture();
  show(env, picture);
  return {};
}

Outcome askPictureName(Env env, PictureId picture) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), picture);
  if (entry == nullptr) return noPicture();
  env.ui.pictureMenu = {};
  const std::string id = "rename-picture:" + std::to_string(picture.value);
  return ask(env, {id, "Rename", "A name for this picture", entry->name},
             [picture](Env later, const std::string& name) {
               return outcomeOf(later.studio.act(document::RenamePicture{picture, name}));
             });
}

/// Nothing is asked: what went is said, and Undo brings it back.
Outcome removePicture(Env env, PictureId picture) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), picture);
  if (entry == nullptr) return noPicture();
  env.ui.pictureMenu = {};
  const auto parts = std::ranges::count_if(
      env.studio.document().parts, [&](const document::Part& part) { return document::pictureOf(part) == entry->id; });
  const std::string name(words::nameOf(entry->name));
  const Status status = env.studio.act(document::RemovePicture{entry->id});
  if (!status) return refuse(status.failure());
  if (parts == 0) {
    sendInfo(env.host, words::tr("Removed {name}. Undo brings it back.", {{"name", name}}));
  } else {
    const char* sentence = parts == 1 ? "Removed {name} and its part. Undo brings them back."
                                      : "Removed {name} and its {n} parts. Undo brings them back.";
    sendInfo(env.host, words::tr(sentence, {{"name", name}, {"n", parts}}));
  }
  return {};
}

std::span<const Command> sketchCommands() { return kTable; }

}  // namespace spineloft::app
