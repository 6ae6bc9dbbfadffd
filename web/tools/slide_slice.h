// Slices on the bone in the picture: a handle slides along it or is pulled off; a tap puts one
// there.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

/// Farther from the bone than this, a slice that is let go is taken off. CSS pixels.
inline constexpr double kPulledOff = 56;

class SlideSlice final : public Tool {
 public:
  explicit SlideSlice(std::size_t stop) : stop_(stop) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  std::size_t stop_;
  double at_ = 0;
  bool off_ = false;
};

class PlaceSlice final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  app::ClientPoint at_;
};

/// The part and the place on its bone that a slice dropped at `at` is for; no part elsewhere.
struct DropPlace {
  PartId part;
  double at = 0;
};
DropPlace dropPlace(const ToolEnv& env, app::ClientPoint at);

}  // namespace spineloft::tools
