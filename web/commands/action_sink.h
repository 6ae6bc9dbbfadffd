// Where tools and panels put what the visitor wants; it happens when they are done.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "web/model/json.h"

namespace spineloft::app {

/// One call of the command table.
struct CommandCall {
  std::string id;
  Json args;
};

class ActionSink {
 public:
  void run(std::string_view id, Json args = {}) { calls_.push_back({std::string(id), std::move(args)}); }
  /// Hands over and forgets the calls.
  std::vector<CommandCall> take() { return std::exchange(calls_, {}); }
  bool empty() const { return calls_.empty(); }

 private:
  std::vector<CommandCall> calls_;
};

}  // namespace spineloft::app
