#include "web/commands/commands.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/modes.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

/// In the order of the command bar.
constexpr std::array kGroups = {
    generalCommands,      ribCommands,    regionCommands,    puffBoneCommands, latheCommands,   layerCommands,
    layerSettingCommands, shapeCommands,  shapeToolCommands, lineCommands,     pullCommands,    bridgeCommands,
    reliefCommands,       cutCommands,    outlineCommands,   spineCommands,    sectionCommands, alongCommands,
    sectionBoardCommands, sketchCommands, placeCommands,     lookCommands,     sizeCommands,    solidCommands,
    hollowCommands,       keepCommands};

std::vector<Command> joinGroups() {
  std::vector<Command> all;
  for (const auto group : kGroups) {
    const std::span<const Command> rows = group();
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

bool sameKey(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool matchesOne(std::string_view shortcut, const platform::KeyEvent& event) {
  bool control = false, shift = false;
  for (bool more = true; more;) {
    more = false;
    if (shortcut.starts_with("Ctrl+")) {
      control = more = true;
      shortcut.remove_prefix(5);
    } else if (shortcut.starts_with("Shift+")) {
      shift = more = true;
      shortcut.remove_prefix(6);
    }
  }
  const bool hasControl = (event.modifiers & (platform::kControl | platform::kMeta)) != 0;
  const bool hasShift = (event.modifiers & platform::kShift) != 0;
  if ((event.modifiers & platform::kAlt) != 0 || control != hasControl) return false;
  // A sign such as "+" may need the shift key on some keyboards and not on others.
  const bool sign = shortcut.size() == 1 && std::ispunct(static_cast<unsigned char>(shortcut[0]));
  return !shortcut.empty() && sameKey(shortcut, event.key) && (sign || shift == hasShift);
}

bool matches(std::string_view shortcuts, const platform::KeyEvent& event) {
  while (!shortcuts.empty()) {
    const std::size_t end = shortcuts.find(", ");
    if (matchesOne(shortcuts.substr(0, end), event)) return true;
    shortcuts.remove_prefix(end == std::string_view::npos ? shortcuts.size() : end + 2);
  }
  return false;
}

/// Commands about a part, a solid or a group may name one that is not selected.
bool namesWhatItNeeds(const Command& command, const CommandEnv& env, const Json& args) {
  const document::Document& document = env.studio.document();
  const auto may = [&](Condition::Names what) { return (command.enabled.instead & what) != 0; };
  if (may(Condition::Part) && namesPart(args) && partOf(env, args) != nullptr) return true;
  if (may(Condition::Step) && findStep(document, StepId{idFrom(args, "step").value}) != nullptr) return true;
  if (may(Condition::Group) && findGroup(document, GroupId{idFrom(args, "group").value}) != nullptr) return true;
  return may(Condition::Parts) && args.find("parts") != nullptr;
}

}  // namespace

std::span<const Command> commandTable() {
  static const std::vector<Command> table = joinGroups();
  return table;
}

const Command* findCommand(std::string_view id) {
  const std::span<const Command> table = commandTable();
  const auto at = std::ranges::find_if(table, [&](const Command& command) { return id == command.id; });
  return at == table.end() ? nullptr : &*at;
}

const Command& commandOf(CommandId id) { return *findCommand(id); }

bool enabled(const Command& command, const CommandEnv& env) { return command.enabled(env); }

Outcome runCommand(const CommandEnv& env, const Command& command, const Json& args) {
  if (!enabled(command, env) && !namesWhatItNeeds(command, env, args)) {
    const Error other = command.enabled.ofOtherKind;
    if (other != Error::kCount && hasSelection(env)) return refuse({other, {}});
    const std::string_view what = words::tr(command.label);
    return Refusal{"NotNow", std::string(words::tr("{command} is not possible right now.", {{"command", what}}))};
  }
  // What the tool before said is over; a command may say more.
  const bool isTool = command.group == "tool" && command.toggled != nullptr;
  if (isTool) sendStatus(env.host, std::string(words::tr(command.hint)) + ".");
  return command.run(env, args);
}

Outcome runCommand(const CommandEnv& env, std::string_view id, const Json& args) {
  if (const Command* command = findCommand(id)) return runCommand(env, *command, args);
  return Refusal{"NoSuchCommand", "There is no command called " + std::string(id) + "."};
}

const Command* commandForKey(const platform::KeyEvent& event, const CommandEnv* env) {
  const Command* found = nullptr;
  auto above = modes().end();  // of the mode of `found`
  for (const Command& command : commandTable()) {
    const auto mode = std::find(modes().begin(), above, command.mode);
    const bool counts = command.mode == nullptr ? found == nullptr : env && mode != above && command.mode->open(*env);
    if (!counts || !matches(command.shortcut, event)) continue;
    found = &command;
    above = mode;
  }
  return found;
}

namespace {

void writeArgument(const CommandEnv& env, const Argument& argument, JsonWriter& json) {
  json.key("argument").beginObject().key("key").text(argument.key);
  if (argument.choices == nullptr) {
    json.key("kind").text("api");
  } else {
    json.key("choices").beginArray();
    argument.choices(env, json);
    json.endArray();
  }
  json.endObject();
}

}  // namespace

void writeChoice(JsonWriter& json, std::string_view value, std::string_view label, bool on, std::string_view icon) {
  json.beginObject().key("value").text(value).key("label").text(label);
  if (!icon.empty()) json.key("icon").text(icon);
  json.key("toggled").flag(on).endObject();
}

void writeCommands(const CommandEnv& env, JsonWriter& json) {
  json.beginArray();
  for (const Command& command : commandTable()) {
    json.beginObject();
    json.key("id").text(command.id).key("label").text(command.label);
    json.key("icon").text(command.icon).key("shortcut").text(command.shortcut);
    json.key("enabled").flag(enabled(command, env)).key("group").text(command.group);
    json.key("toggled");
    command.toggled ? json.flag(command.toggled(env)) : json.null();
    if (!command.argument.key.empty()) writeArgument(env, command.argument, json);
    json.key("hint").text(command.hint).key("menu");
    command.menu.empty() ? json.null() : json.text(command.menu);
    json.endObject();
  }
  json.endArray();
}

std::optional<std::array<double, 4>> rowAt(const UiState& ui, const ListRow& row) {
  const auto found = std::ranges::find(ui.rows, row, &ShownRow::row);
  if (found == ui.rows.end()) return std::nullopt;
  return std::array{found->at.x, found->at.y, found->at.width, found->at.height};
}

Outcome ask(const CommandEnv& env, const Question& question, Answers::mapped_type then) {
  env.ui.answers[std::string(question.id)] = std::move(then);
  sendQuestion(env.host, question);
  return {};
}

Outcome answerQuestion(const CommandEnv& env, std::string_view id, const std::string& text) {
  const auto asked = env.ui.answers.find(id);
  if (asked == env.ui.answers.end()) return {};
  const Answers::mapped_type then = asked->second;
  return then(env, text);
}

Outcome refuse(const Failure& failure) {
  return Refusal{std::string(errorName(failure.error)), spokenFailure(failure)};
}

Outcome outcomeOf(const Status& status) {
  if (status) return {};
  return refuse(status.failure());
}

}  // namespace spineloft::app
