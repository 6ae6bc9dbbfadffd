// Commands about how the surface of parts looks, and the files it goes into.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/surface/finish.h"
#include "web/app/colour_text.h"
#include "web/app/command_actions.h"
#include "web/app/command_args.h"
#include "web/app/command_groups.h"
#include "web/app/messages.h"
#include "web/app/print_report.h"
#include "web/app/swatches.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool faceted(Env env) { return currentLook(env).faceted; }

/// The look that `args` means: the named part's, else the current one.
document::Look lookOf(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part ? part->look : env.ui.look;
}

Outcome setPaint(Env env, const Json& args) {
  const std::string* key = args.text("paint");
  if (key == nullptr) return missing("a paint: plain, two-tone, clay, glaze or metal");
  const std::optional<surface::Paint> paint = surface::paintFromKey(*key);
  if (!paint) return refuse({Error::ValueOutOfRange, *key});
  document::Look look = lookOf(env, args);
  look.textured = false;
  look.paint = *paint;
  return setLook(env, args, look);
}

Outcome setSecondColour(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return missing("a colour such as #f1ede4");
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  document::Look look = lookOf(env, args);
  look.textured = false;
  look.paint = surface::Paint::TwoTone;
  look.second = *colour;
  return setLook(env, args, look);
}

Outcome toggleFacets(Env env, const Json& args) {
  document::Look look = lookOf(env, args);
  look.faceted = args.flag("faceted").value_or(!look.faceted);
  return setLook(env, args, look);
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

Outcome sizeLike(Env env, const Json& args) {
  const std::string* key = args.text("thing");
  const auto known = things();
  const auto at = std::ranges::find(known, key ? std::string_view(*key) : std::string_view(), &Thing::key);
  if (at == known.end()) return missing("a thing: coin, cupcake or hand");
  return outcomeOf(env.studio.act(document::SetHeight{Millimetres{at->mm}}));
}

void thingChoices(Env env, JsonWriter& json) {
  for (const Thing& thing : things()) {
    writeChoice(json, thing.key, thing.label, env.studio.document().height.value == thing.mm);
  }
}

Outcome checkPrint(Env env, const Json&) {
  Result<printing::PrintCheck> check = publish::checkPrint(env.studio.document(), env.studio.derived());
  if (!check) return refuse(check.failure());
  env.ui.print = PrintReport{check.value(), env.studio.document()};
  std::string said;
  for (const PrintLine& line : printLines(*env.ui.print)) said += (said.empty() ? "" : " ") + line.text;
  sendInfo(env.host, said);
  return {};
}

Outcome thicken(Env env, const Json& args) {
  if (!env.ui.print || !(env.ui.print->of == env.studio.document())) {
    if (const Outcome refused = checkPrint(env, args)) return refused;
  }
  const double thinnest = env.ui.print->check.thinnest;
  if (!(thinnest > 0)) return refuse({Error::NothingToExport, {}});
  if (env.ui.print->check.thick()) return {};
  const double mm = env.studio.document().height.value * 1.01 * printing::kLeastWall / thinnest;
  if (const Status status = env.studio.act(document::SetHeight{Millimetres{std::ceil(mm)}}); !status) {
    return refuse(status.failure());
  }
  return checkPrint(env, args);
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
    const bool on = !look.textured && look.paint == surface::Paint::TwoTone &&
                    colourText(look.second) == swatch.value;
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
            setPaint},
    Command{"set-second-colour",
            "Colour below",
            "palette",
            "",
            "look",
            {"colour", secondChoices},
            "The second of two colours",
            hasPicture,
            nullptr,
            setSecondColour},
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
    Command{"size-like",
            "As tall as",
            "ruler",
            "",
            "file",
            {"thing", thingChoices},
            "As tall as a coin, a cupcake or a hand",
            hasParts,
            nullptr,
            sizeLike},
    Command{"check-print",
            "Check for printing",
            "scan-search",
            "",
            "file",
            {},
            "Closed, size, thinnest wall, and whether it stands",
            hasParts,
            nullptr,
            checkPrint},
    Command{"thicken",
            "Make it thick enough",
            "maximize",
            "",
            "file",
            {},
            "Larger, so that its thinnest place can be printed",
            hasParts,
            nullptr,
            thicken},
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

std::span<const Command> lookCommands() { return kTable; }

}  // namespace spineloft::app
