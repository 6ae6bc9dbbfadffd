// Which part lies under a ray, fast enough for every move of the mouse: boxes round runs of triangles
// are tried before the triangles.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "web/edit/outline.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Where a ray meets a part first.
struct RayHit {
  PartId part;            ///< none: it meets none
  WorldPoint at, normal;  ///< unit, out of the part
  explicit operator bool() const { return static_cast<bool>(part); }
};

class Picker {
 public:
  /// Of the visible parts but those in `without`, where they are shown (a twin counts as its part).
  RayHit firstHit(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                  const Ray& ray, std::span<const PartId> without = {});
  /// The visible part whose surface the ray meets first; none when it meets none.
  PartId partUnderRay(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                      const Ray& ray) {
    return firstHit(document, derived, ui, ray).part;
  }

 private:
  struct Box {
    std::array<float, 3> low, high;
  };
  /// The boxes of one shape. A lofted mesh goes along its spine, so runs of its triangles are compact.
  struct Entry {
    std::weak_ptr<const pipeline::PartShape> shape;
    Box whole;
    std::vector<Box> runs;
  };
  const Entry& entryOf(const std::shared_ptr<const pipeline::PartShape>& shape);
  std::vector<Entry> entries_;
};

}  // namespace spineloft::app
