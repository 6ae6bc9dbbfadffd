// What is known of a picture before a stroke is traced in it.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/image/image.h"

namespace spineloft::ribs {

struct IgnoredEdges;

/// What a picture shows. References must outlive the call.
struct PictureEvidence {
  const image::EdgeMap& edges;            ///< may be empty: no picture, or nothing known of it yet
  image::Size size;                       ///< of the picture, pixels
  const IgnoredEdges* ignored = nullptr;  ///< edges scribbled away (ignored.h), of the same map
};

}  // namespace spineloft::ribs
