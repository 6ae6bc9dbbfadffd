// Commands about how the surface of parts looks, and the files it goes into.
#include <array>
#include <string>

#include "engine/surface/finish.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"
#include "web/model/swatches.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool faceted(Env env) { return currentLook(env).faceted; }

Outcome setPaintRow(Env env, const Json& args) {
  const std::string* key = args.text("paint");
  if (key == nullptr) return missing("a paint: plain, two-tone, clay, glaze or metal");
  const std::optional<surface::Paint> paint = surface::paintFromKey(*key);
  if (!paint) return refuse({Error::ValueOutOfRange, *key});
  const std::optional<PartId> part = meantPart(env, args);
  return part ? setPaint(env, *part, *paint) : noPart();
}

Outcome setSecondColourRow(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return missing("a colour such as #f1ede4");
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  const std::optional<PartId> part = meantPart(env, args);
  return part ? setSecondColour(env, *part, *colour) : noPart();
}

Outcome toggleFacets(Env env, const Json& args) {
  const std::optional<PartId> part = meantPart(env, args);
  if (!part) return noPart();
  return setFaceted(env, *part, args.flag("faceted").value_or(!lookOf(env, *part).faceted));
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

constexpr std::array kTable = {
    Command{"set-paint",
            "Paint",
            "palette",
            "",
            "look",
            {"paint", paintChoices},
            "Plain, two colours, clay, glaze or metal",
            hasPicture,
            nullptr,
            setPaintRow},
    Command{"set-second-colour",
            "Colour below",
            "palette",
            "",
            "look",
            {"colour", secondChoices},
            "The second of two colours",
            hasPicture,
            nullptr,
            setSecondColourRow},
    Command{"toggle-facets",
            "Facets",
            "diamond",
            "",
            "look",
            {},
            "Flat like a cut stone, or smooth",
            hasPicture,
            faceted,
            toggleFacets},
    Command{"save-picture",
            "Save picture",
            "image-down",
            "",
            "file",
            {},
            "A PNG of the solid",
            hasParts,
            nullptr,
            savePicture},
    Command{"save-turntable",
            "Save turntable",
            "rotate-3d",
            "",
            "file",
            {},
            "The solid turning round, as an animated GIF",
            hasParts,
            nullptr,
            saveTurntable},
    Command{"save-obj",
            "Save OBJ",
            "download",
            "",
            "file",
            {},
            "For editing: model, colours and picture in one ZIP, in millimetres",
            hasParts,
            nullptr,
            saveObjZip},
    Command{"save-3mf",
            "Save 3MF",
            "download",
            "",
            "file",
            {},
            "For a 3D printer, in millimetres, with colours",
            hasParts,
            nullptr,
            save3mf},
};

}  // namespace

Outcome setPaint(Env env, PartId part, surface::Paint paint) {
  document::Look look = lookOf(env, part);
  look.textured = false;
  look.paint = paint;
  return setLook(env, part, look);
}

Outcome setSecondColour(Env env, PartId part, const Colour& colour) {
  document::Look look = lookOf(env, part);
  look.textured = false;
  look.paint = surface::Paint::TwoTone;
  look.second = colour;
  return setLook(env, part, look);
}

Outcome setFaceted(Env env, PartId part, bool faceted) {
  document::Look look = lookOf(env, part);
  look.faceted = faceted;
  return setLook(env, part, look);
}

std::span<const Command> lookCommands() { return kTable; }

}  // namespace spineloft::app
