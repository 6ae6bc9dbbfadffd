// Small enough to need no library: lengths that are not pixels.
#pragma once

namespace spineloft {

/// A length in the real world. Pixels are plain doubles in a space that the point type names.
struct Millimetres {
  double value = 0;
  bool operator==(const Millimetres&) const = default;
};

}  // namespace spineloft
