// Fast code before the first stroke.
#pragma once

namespace spineloft::platform {

/// One round of the engine's stages on a tiny picture, whose results are forgotten
/// (pipeline::warmUp): some milliseconds, more in the slow tier that a browser begins with. False
/// when there was no memory for it. main.cpp defines it.
bool warmUp();

}  // namespace spineloft::platform
