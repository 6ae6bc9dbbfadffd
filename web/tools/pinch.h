// Two fingers: what was between them stays between them.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

struct FingerPair {
  app::ClientPoint a, b;
  app::ClientPoint middle() const { return (a + b) / 2; }
  double spread() const { return distance(a, b); }
};

/// Moves and zooms the picture from one position of the fingers to the next.
void pinchPicture(const ToolEnv& env, const FingerPair& from, const FingerPair& to);
/// Shifts and zooms the solid.
void pinchSolid(const ToolEnv& env, const FingerPair& from, const FingerPair& to);

}  // namespace spineloft::tools
