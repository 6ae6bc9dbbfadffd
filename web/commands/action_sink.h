// Where tools and panels put what the visitor wants; it happens when they are done.
#pragma once

#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "web/commands/commands.h"

namespace spineloft::app {

class ActionSink {
 public:
  using Action = std::function<Outcome(const CommandEnv&)>;

  /// A row of the table that needs no argument, while it is possible.
  void run(const Command& command) {
    actions_.push_back([&command](const CommandEnv& env) { return runCommand(env, command, {}); });
  }
  void run(CommandId id) { run(commandOf(id)); }
  /// An intent (intents.h) with its arguments, which are copied.
  template <class... Params, class... Args>
  void run(Outcome (*intent)(const CommandEnv&, Params...), Args&&... args) {
    actions_.push_back(
        [intent, kept = std::tuple<std::decay_t<Params>...>(std::forward<Args>(args)...)](const CommandEnv& env) {
          return std::apply([&](const auto&... each) { return intent(env, each...); }, kept);
        });
  }

  /// Hands over and forgets the actions.
  std::vector<Action> take() { return std::exchange(actions_, {}); }
  bool empty() const { return actions_.empty(); }

 private:
  std::vector<Action> actions_;
};

}  // namespace spineloft::app
