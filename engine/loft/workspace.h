// Memory that lofting reuses from frame to frame.
#pragma once

#include <memory>

namespace spineloft::loft {

/// What loftRibs keeps besides its result: the section on its points, chords, caps, stations, rings. A result never
/// depends on what the memory was used for before. Belongs to one thread; may be moved.
class LoftWorkspace {
 public:
  LoftWorkspace();
  ~LoftWorkspace();
  LoftWorkspace(LoftWorkspace&&) noexcept;
  LoftWorkspace& operator=(LoftWorkspace&&) noexcept;

  struct Tables;
  /// Made when first asked for.
  Tables& tables();

 private:
  std::unique_ptr<Tables> tables_;
};

}  // namespace spineloft::loft
