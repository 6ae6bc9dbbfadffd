// Commands about how the surface of parts looks, and the files it goes into.
#include <array>
#include <string>

#include "engine/surface/finish.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"
#include "web/model/swatches.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool faceted(Env env) { return currentLook(env).faceted; }
bool inked(Env env) { return currentLook(env).inked; }
bool onPaper(Env env) {
  const document::Document& document = env.studio.document();
  return std::ranges::any_of(document.parts, [&](const document::Part& part) {
    const document::PictureEntry* picture = findPicture(document, document::pictureOf(part));
    return part.look.textured && picture != nullptr && picture->isSketch() && isSelected(document, env.ui, part.id);
  });
}

Outcome setPaintRow(Env env, const Json& args) {
  const std::string* key = args.text("paint");
  if (key == nullptr) return missing("a paint: plain, two-tone, clay, glaze or metal");
  const std::optional<surface::Paint> paint = surface::paintFromKey(*key);
  if (!paint) return refuse({Error::ValueOutOfRange, *key});
  const std::optional<Parts> parts = meantParts(env, args);
  return parts ? setPaint(env, *parts, *paint) : noPart();
}

Outcome setSecondColourRow(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return missing("a colour such as #f1ede4");
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  const std::optional<Parts> parts = meantParts(env, args);
  return parts ? setSecondColour(env, *parts, *colour) : noPart();
}

Outcome toggleFacets(Env env, const Json& args) {
  const std::optional<Parts> parts = meantParts(env, args);
  if (!parts) return noPart();
  return setFaceted(env, *parts, args.flag("faceted").value_or(!lookMeant(env, *parts).faceted));
}

Outcome toggleInk(Env env, const Json& args) {
  const std::optional<Parts> parts = meantParts(env, args);
  if (!parts) return noPart();
  return setInked(env, *parts, args.flag("inked").value_or(!lookMeant(env, *parts).inked));
}

Outcome saveObjZip(Env env, const Json&) { return saveAs(env, publish::Format::ObjZip); }
Outcome save3mf(Env env, const Json&) { return saveAs(env, publish::Format::ThreeMf); }

Outcome saveTurntable(Env env, const Json&) {
  sendTurntable(env.host, "gif", publish::plainName(env.studio.document()));
  return {};
}
Outcome savePicture(Env env, const Json&) {
  sendTurntable(env.host, "png", publish::plainName(env.studio.document()));
  return {};
}

void paintChoices(Env env, JsonWriter& json) {
  const document::Look look = currentLook(env);
  for (const surface::Finish& finish : surface::finishes()) {
    writeChoice(json, finish.key, finish.label, !look.textured && look.paint == finish.paint);
  }
}

void secondChoices(Env env, JsonWriter& json) {
  const document::Look look = currentLook(env);
  for (const Swatch& swatch : kSwatches) {
    const bool on = !look.textured && look.paint == surface::Paint::TwoTone && colourText(look.second) == swatch.value;
    writeChoice(json, swatch.value, swatch.label, on);
  }
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "set-paint", .label = "Paint", .icon = "palette", .group = "look",
            .argument = {"paint", paintChoices}, .hint = "Plain, two colours, clay, glaze or metal",
            .enabled = hasPicture, .run = setPaintRow},
    Command{.id = "set-second-colour", .label = "Colour below", .icon = "palette", .group = "look",
            .argument = {"colour", secondChoices}, .hint = "The second of two colours", .enabled = hasPicture,
            .run = setSecondColourRow},
    Command{.id = "toggle-facets", .label = "Facets", .icon = "diamond", .group = "look",
            .hint = "Flat like a cut stone, or smooth", .enabled = hasPicture, .toggled = faceted, .run = toggleFacets},
    Command{.id = "toggle-ink", .label = "Keep my ink", .icon = "pencil-line", .group = "look",
            .hint = "The drawn outline stays on the part", .enabled = onPaper, .toggled = inked, .run = toggleInk},
    Command{.id = "save-picture", .label = "Save picture", .icon = "image-down", .group = "file",
            .hint = "A PNG of the solid, with the model inside", .enabled = hasParts, .run = savePicture},
    Command{.id = "save-turntable", .label = "Save turntable", .icon = "rotate-3d", .group = "file",
            .hint = "The solid turning round, as an animated GIF", .enabled = hasParts, .run = saveTurntable},
    Command{.id = "save-obj", .label = "Save OBJ", .icon = "download", .group = "file",
            .hint = "For editing: model, colours and picture in one ZIP, in millimetres", .enabled = hasParts,
            .run = saveObjZip},
    Command{.id = "save-3mf", .label = "Save 3MF", .icon = "download", .group = "file",
            .hint = "For a 3D printer, in millimetres, with colours", .enabled = hasParts, .run = save3mf},
};
// clang-format on

}  // namespace

Outcome setPaint(Env env, const Parts& parts, surface::Paint paint) {
  return changeLooks(env, parts, [&](document::Look& look) {
    look.textured = false;
    look.paint = paint;
  });
}

Outcome setSecondColour(Env env, const Parts& parts, const Colour& colour) {
  return changeLooks(env, parts, [&](document::Look& look) {
    look.textured = false;
    look.paint = surface::Paint::TwoTone;
    look.second = colour;
  });
}

Outcome setFaceted(Env env, const Parts& parts, bool faceted) {
  return changeLooks(env, parts, [&](document::Look& look) { look.faceted = faceted; });
}

Outcome setInked(Env env, const Parts& parts, bool inked) {
  return changeLooks(env, parts, [&](document::Look& look) { look.inked = inked; });
}

std::span<const Command> lookCommands() { return kTable; }

}  // namespace spineloft::app
