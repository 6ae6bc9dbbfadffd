// Which part lies under a ray, fast enough for every move of the mouse: boxes round runs of triangles
// are tried before the triangles.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "web/app/outline.h"

namespace spineloft::app {

class Picker {
 public:
  /// The visible part whose surface the ray meets first; none when it meets none.
  PartId partUnderRay(const document::Document& document, const pipeline::Derived& derived,
                      const Ray& ray);

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
