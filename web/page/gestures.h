// Which pointer does what: routes presses to the panels, the splitter or a tool, tells one finger
// from two, a pen from a palm.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "web/platform/page.h"
#include "web/tools/tool.h"

namespace spineloft::app {

class Gestures {
 public:
  /// What a pointer event was for.
  enum class Target { Nothing, Panels, Views };

  /// Follows one event. `Panels`: the caller hands it to ImGui.
  Target pointer(const platform::PointerEvent& event, const tools::ToolEnv& env);
  void wheel(const platform::WheelEvent& event, const tools::ToolEnv& env);
  /// Drops the gesture in hand, without a trace.
  void cancel(const tools::ToolEnv& env);
  /// Leads the gesture in hand to where it is once more: an option of its tool has changed.
  void again(const tools::ToolEnv& env);
  bool active() const { return usesTool() || splitting_; }
  /// Something on a view is in hand.
  bool usesTool() const { return tool_ != nullptr; }

  /// The CSS cursor for the place of the mouse.
  const char* cursor(const tools::ToolEnv& env) const;

 private:
  enum class Place { Panels, Splitter, Picture, Solid, Sections };
  struct Contact {
    int id = 0;
    platform::Device device = platform::Device::Mouse;
    Place place = Place::Panels;
    ClientPoint at;
  };

  Place placeOf(const UiState& ui, ClientPoint at) const;
  Contact* find(int id);
  void press(const platform::PointerEvent& event, const tools::ToolEnv& env);
  void move(const platform::PointerEvent& event, Contact& contact, const tools::ToolEnv& env);
  void release(const platform::PointerEvent& event, const tools::ToolEnv& env);
  void startPinch(const tools::ToolEnv& env);
  std::unique_ptr<tools::Tool> toolFor(const platform::PointerEvent& event, Place place,
                                       const tools::ToolEnv& env) const;
  void hover(const platform::PointerEvent& event, const tools::ToolEnv& env);

  std::vector<Contact> contacts_;
  std::unique_ptr<tools::Tool> tool_;
  int toolContact_ = 0;
  bool splitting_ = false;
  bool pinching_ = false;
  Place pinchPlace_ = Place::Picture;
  ClientPoint hover_;
  tools::ToolEvent last_;
};

}  // namespace spineloft::app
