// A tool turns one drag on the canvas into a preview and then a command, or into a moved view.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/commands/action_sink.h"
#include "web/edit/picker.h"
#include "web/platform/page.h"
#include "web/ui/ui_state.h"

namespace spineloft::tools {

/// One position of the pointer that leads a gesture.
struct ToolEvent {
  app::ClientPoint at;
  double pressure = 0;  ///< 0…1, of a pen; 0.5 for what knows none
  double timeMs = 0;
  int modifiers = 0;  ///< bits of platform::Modifier
  platform::Device device = platform::Device::Mouse;
  bool barrel = false;  ///< the button of a pen is held
  bool touch() const { return device == platform::Device::Touch; }
};

struct ToolEnv {
  const document::Document& document;
  const pipeline::Derived& derived;
  app::UiState& ui;
  app::ActionSink& sink;
  app::Picker* picker = nullptr;  ///< null where nothing is pressed
};

/// A press that moves less than this is a click, in CSS pixels.
inline constexpr double kMouseSlop = 4, kTouchSlop = 9;

struct FingerPair;  // pinch.h

/// begin, any number of moves, then commit or cancel: one gesture.
class Tool {
 public:
  virtual ~Tool() = default;
  virtual void begin(const ToolEnv& env, const ToolEvent& event) = 0;
  virtual void move(const ToolEnv& env, const ToolEvent& event) = 0;
  virtual void commit(const ToolEnv& env) = 0;
  virtual void cancel(const ToolEnv& env) = 0;
  /// Whether a second finger joins the gesture instead of ending it; then `followPair` leads it.
  virtual bool takesPair() const { return false; }
  virtual void followPair(const ToolEnv&, const FingerPair&, const FingerPair&) {}
};

/// Tells a click from a drag.
class DragWatch {
 public:
  void begin(const ToolEvent& event) {
    start_ = last_ = event.at;
    slop_ = event.touch() ? kTouchSlop : kMouseSlop;
    moved_ = false;
  }
  /// The way since the last call; nothing while it is still a click.
  app::ClientPoint move(const ToolEvent& event) {
    const app::ClientPoint at = event.at;
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
