// Sections on the spine in the picture: a handle slides along it or is pulled off; a tap puts one
// there.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

/// Farther from the spine than this, a section that is let go is taken off. CSS pixels.
inline constexpr double kPulledOff = 56;

class SlideSection final : public Tool {
 public:
  explicit SlideSection(std::size_t key) : key_(key) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  std::size_t key_;
  double at_ = 0;
  bool off_ = false;
};

class PlaceSection final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  app::ClientPoint at_;
};

}  // namespace spineloft::tools
