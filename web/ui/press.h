// What a press is.
#pragma once

namespace spineloft::app {

/// A finger that stays in its place for so long has asked for something else than a tap, milliseconds.
inline constexpr double kLongPressMs = 450;

}  // namespace spineloft::app
