// The pictures of the board, where there are several: small copies in a row above the picture view,
// or in a column beside it where that is low.
#pragma once

#include "web/panels/panels.h"

namespace spineloft::panels {

/// Tap one to show it; the one in view, a long press or the right button opens its small menu.
void drawPictureStrip(const PanelEnv& env);

}  // namespace spineloft::panels
