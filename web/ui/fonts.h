// ImGui's fonts: Inter in two weights with the letters of the visitor's language and the icons merged in, rasterised
// for the screen's density.
#pragma once

#include "web/platform/page.h"

struct ImFont;

namespace spineloft::app {

struct Fonts {
  ImFont* text = nullptr;   ///< 14.5 CSS pixels
  ImFont* bold = nullptr;   ///< 14.5, semibold
  ImFont* small = nullptr;  ///< 12.5
  ImFont* icons = nullptr;  ///< 18, icons alone
};

/// Rebuilds ImGui's atlas for `dpr`. Missing files are replaced by ImGui's own font.
Fonts buildFonts(const platform::FontFiles& files, double dpr);

}  // namespace spineloft::app
