// Small copies of the pictures, for the strip above the picture view.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/pipeline/derive.h"
#include "web/gl/renderer.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

inline constexpr int kThumbnailSide = 144;  ///< pixels of the longer side: sharp on any screen

class Thumbnails {
 public:
  /// Puts what `ui.thumbnails` asks for into the scene. A picture is made small once; what is no
  /// longer shown is forgotten.
  void addTo(gl::Scene& scene, const document::Document& document, const pipeline::Derived& derived, const UiState& ui);

 private:
  struct Slot {
    std::uint64_t contentHash;
    std::unique_ptr<const image::Image> image;
    bool used;
  };
  const image::Image* small(const document::PictureEntry& entry, const image::Picture& pixels);
  std::vector<Slot> slots_;
};

}  // namespace spineloft::app
