// A tool turns one drag on the canvas into a preview and then a command, or into a moved view.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/app/action_sink.h"
#include "web/app/ui_state.h"

namespace spineloft::tools {

struct ToolEnv {
  const document::Document& document;
  const pipeline::Derived& derived;
  app::UiState& ui;
  app::ActionSink& sink;
};

/// A press that moves less than this is a click, in CSS pixels.
inline constexpr double kMouseSlop = 4, kTouchSlop = 9;

/// begin, any number of moves, then commit or cancel: one gesture.
class Tool {
 public:
  virtual ~Tool() = default;
  virtual void begin(const ToolEnv& env, app::ClientPoint at) = 0;
  virtual void move(const ToolEnv& env, app::ClientPoint at) = 0;
  virtual void commit(const ToolEnv& env) = 0;
  virtual void cancel(const ToolEnv& env) = 0;
};

/// Tells a click from a drag.
class DragWatch {
 public:
  void begin(app::ClientPoint at, bool touch) {
    start_ = last_ = at;
    slop_ = touch ? kTouchSlop : kMouseSlop;
    moved_ = false;
  }
  /// The way since the last call; nothing while it is still a click.
  app::ClientPoint move(app::ClientPoint at) {
    if (!moved_ && distance(at, start_) < slop_) return {};
    moved_ = true;
    const app::ClientPoint by = at - last_;
    last_ = at;
    return by;
  }
  bool moved() const { return moved_; }
  app::ClientPoint start() const { return start_; }

 private:
  app::ClientPoint start_, last_;
  double slop_ = kMouseSlop;
  bool moved_ = false;
};

}  // namespace spineloft::tools
