// The command table: everything a visitor can do, once. It feeds the panels' buttons, the keyboard,
// the shell's command bar, the public API and the tests.
#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/result.h"
#include "web/commands/command_ids.h"
#include "web/edit/command_env.h"
#include "web/model/json.h"
#include "web/model/messages.h"
#include "web/platform/page.h"

namespace spineloft::app {

/// Why a command did nothing: an Error's name (or NoSuchCommand, NotNow, ArgumentMissing) and a
/// sentence for the visitor.
struct Refusal {
  std::string error, sentence;
};
/// What came of a command: it was done (true), or it was refused.
class [[nodiscard]] Outcome {
 public:
  Outcome() = default;  ///< done
  Outcome(Refusal refusal) : refusal_(std::move(refusal)) {}
  bool ok() const { return !refusal_; }
  explicit operator bool() const { return ok(); }
  const Refusal& refusal() const {
    assert(!ok() && "refusal() of what was done");
    return *refusal_;
  }

 private:
  std::optional<Refusal> refusal_;
};

/// What a command can be told.
struct Argument {
  std::string_view key = {};  ///< of the one that a menu offers; empty: a plain button
  /// Writes the choices of a menu, as objects {value, label, toggled}; null: only programs give it.
  void (*choices)(const CommandEnv&, JsonWriter&) = nullptr;
};

/// What a command needs, and what may be named in its arguments instead.
struct Condition {
  enum Names : unsigned { Nothing = 0, Part = 1, Parts = 2, Step = 4, Group = 8 };
  bool (*holds)(const CommandEnv&) = nullptr;  ///< null: always
  unsigned instead = Nothing;                  ///< bits of Names: one that is there stands for what is selected
  Error ofOtherKind = Error::kCount;           ///< why not, where a part is selected that is none of these

  constexpr Condition(bool (*now)(const CommandEnv&), unsigned named = Nothing, Error other = Error::kCount)
      : holds(now), instead(named), ofOtherKind(other) {}
  bool operator()(const CommandEnv& env) const { return holds == nullptr || holds(env); }
};

/// What a command, a step of undo or Escape does.
using Run = Outcome(const CommandEnv&, const Json& args);
struct Mode;

/// What a menu can hold that is read at a glance and fits a small screen.
inline constexpr std::size_t kMostInMenu = 14;

struct Command {
  CommandId id = {};
  std::string_view label = {}, icon = {};
  /// Such as "Shift+Ctrl+Z" (Ctrl means Cmd as well), or several: "Delete, Backspace".
  std::string_view shortcut = {};
  std::string_view group = {};  ///< file, tool, edit, part, view
  Argument argument = {};
  std::string_view hint = {};
  /// The heading under which the menu "More" offers it while it can be run; empty: the search finds it. At most
  /// kMostInMenu rows have one.
  std::string_view menu = {};
  Condition enabled = nullptr;
  bool (*toggled)(const CommandEnv&) = nullptr;  ///< null: it is no toggle
  Run* run = nullptr;
  /// Its keys count only while this mode is open (see modes.h); `run` is told {key, far: with shift}. Null: they
  /// always count, after those of modes.
  const Mode* mode = nullptr;
};

/// In the order of the command bar; ids and shortcuts are unique.
std::span<const Command> commandTable();
const Command& commandOf(CommandId id);
/// Null: there is none of this name.
const Command* findCommand(std::string_view id);
bool enabled(const Command& command, const CommandEnv& env);

/// Runs a command of the table, if it can run now.
Outcome runCommand(const CommandEnv& env, const Command& command, const Json& args);
Outcome runCommand(const CommandEnv& env, std::string_view id, const Json& args);

/// The command of a key, or null: that of the topmost open mode which has one. Without `env` modes are left out.
const Command* commandForKey(const platform::KeyEvent& event, const CommandEnv* env = nullptr);

/// One choice of a menu, as Argument::choices writes them; `icon`: its picture, by the name that the shell knows.
void writeChoice(JsonWriter& json, std::string_view value, std::string_view label, bool on, std::string_view icon = {});

/// The table as the contract's `spl_commands` gives it.
void writeCommands(const CommandEnv& env, JsonWriter& json);

/// Where a row of the part list has its name, as Question::at; none: it is out of sight.
std::optional<std::array<double, 4>> rowAt(const UiState& ui, const ListRow& row);

/// Asks the visitor for a text in a dialog of the shell, or in place; `then` is told it.
Outcome ask(const CommandEnv& env, const Question& question, Answers::mapped_type then);
/// The text that came for the question of this id. Nothing for one that was never asked.
Outcome answerQuestion(const CommandEnv& env, std::string_view id, const std::string& text);

Outcome refuse(const Failure& failure);
Outcome outcomeOf(const Status& status);

}  // namespace spineloft::app
