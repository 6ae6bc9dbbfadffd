// Memory that tracing ribs reuses from stroke to stroke.
#pragma once

#include <memory>

namespace spineloft::ribs {

/// What traceRibs keeps besides its result: field, curves, picture along them, costs, and the tables of
/// the evidence, the medial offsets and the search. A result never depends on what the memory was used for before.
/// Belongs to one thread; may be moved.
class RibWorkspace {
 public:
  RibWorkspace();
  ~RibWorkspace();
  RibWorkspace(RibWorkspace&&) noexcept;
  RibWorkspace& operator=(RibWorkspace&&) noexcept;

  struct Search;
  /// Made when first asked for.
  Search& search();

 private:
  std::unique_ptr<Search> search_;
};

}  // namespace spineloft::ribs
