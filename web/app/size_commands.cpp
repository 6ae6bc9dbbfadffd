// Commands about the size of the finished model, and about printing it.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "web/app/command_actions.h"
#include "web/app/command_args.h"
#include "web/app/command_groups.h"
#include "web/app/messages.h"
#include "web/app/print_report.h"
#include "web/app/sizing.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }

/// What stands beside the solid stays in sight.
Outcome makeTall(Env env, double mm) {
  const Status status = env.studio.act(document::SetHeight{Millimetres{mm}});
  if (!status) return refuse(status.failure());
  if (env.ui.beside) flyTo(env, false);
  return {};
}

Outcome setHeight(Env env, const Json& args) {
  if (const std::optional<double> mm = args.number("mm")) return makeTall(env, *mm);
  if (const std::string* typed = args.text("typed")) {
    const std::optional<double> mm = millimetresFrom(*typed);
    if (!mm) return Refusal{"ValueOutOfRange", "Type a size such as 4 cm or 40 mm."};
    return makeTall(env, *mm);
  }
  sendQuestion(env.host, {"set-height", "How tall?", "Such as 4 cm or 40 mm",
                          spokenLength(env.studio.document().height.value)});
  return {};
}

Outcome sizeLike(Env env, const Json& args) {
  const std::string* key = args.text("thing");
  const std::optional<std::size_t> thing = key ? findThing(*key) : std::nullopt;
  if (!thing) return missing("a thing: coin, cupcake or hand");
  env.ui.beside = thing;
  return makeTall(env, things()[*thing].mm);
}

void likeChoices(Env env, JsonWriter& json) {
  for (const Thing& thing : things()) {
    writeChoice(json, thing.key, thing.label, env.studio.document().height.value == thing.mm);
  }
}

Outcome showBeside(Env env, const Json& args) {
  const std::string* key = args.text("thing");
  if (key == nullptr) return missing("a thing: coin, cupcake, hand, or none");
  const std::optional<std::size_t> thing = findThing(*key);
  if (!thing && *key != "none") return refuse({Error::ValueOutOfRange, *key});
  env.ui.beside = thing;
  flyTo(env, false);
  return {};
}

void besideChoices(Env env, JsonWriter& json) {
  for (std::size_t i = 0; i < things().size(); ++i) {
    writeChoice(json, things()[i].key, things()[i].label, env.ui.beside == i);
  }
  writeChoice(json, "none", "Nothing", !env.ui.beside);
}

Outcome checkPrint(Env env, const Json&) {
  const auto& steps = env.studio.derived().steps;
  if (std::ranges::any_of(steps, &pipeline::DerivedStep::waiting)) {
    return Refusal{"NotReady", "The parts are still being put together. Ask again in a moment."};
  }
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

constexpr Argument kNone{};

constexpr std::array kTable = {
    Command{"set-height", "How tall?", "ruler", "", "file", kNone, "Height of the finished model",
            hasParts, nullptr, setHeight},
    Command{"size-like", "As tall as", "ruler", "", "file", {"thing", likeChoices},
            "As tall as a coin, a cupcake or a hand", hasParts, nullptr, sizeLike},
    Command{"show-beside", "Show beside it", "ruler", "", "view", {"thing", besideChoices},
            "A coin, a cupcake or a hand beside the solid, as large as it is", hasParts, nullptr,
            showBeside},
    Command{"check-print", "Check for printing", "scan-search", "", "file", kNone,
            "Closed, size, thinnest wall, and whether it stands", hasParts, nullptr, checkPrint},
    Command{"thicken", "Make it thick enough", "maximize", "", "file", kNone,
            "Larger, so that its thinnest place can be printed", hasParts, nullptr, thicken},
};

}  // namespace

std::span<const Command> sizeCommands() { return kTable; }

}  // namespace spineloft::app
