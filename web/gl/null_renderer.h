// Draws nothing and remembers what it was asked to draw: the whole page runs in unit tests with it.
#pragma once

#include "web/gl/renderer.h"

namespace spineloft::gl {

class NullRenderer final : public Renderer {
 public:
  void beginUi() override {}
  bool drawsOnCanvas(const Scene& scene) const override { return !slow || scene.held; }
  bool finished() override { return !slow || last.held; }
  void show() override { ++shown; }
  void draw(const Scene& scene) override {
    if (lost) return;
    last = scene;
    ++draws;
  }
  image::Image snapshot(const Scene& scene) override {
    if (lost) return {};
    last = scene;
    const int width = static_cast<int>(scene.width), height = static_cast<int>(scene.height);
    const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<std::uint8_t>(bytes, 255)};
  }
  void fontsChanged() override { ++fontUploads; }
  void contextLost() override { lost = true; }
  bool contextRestored() override {
    lost = false;
    return true;
  }

  Scene last;  ///< its mesh and image pointers are only valid right after `draw`
  int draws = 0, shown = 0, fontUploads = 0;
  bool lost = false;
  bool slow = false;  ///< draws beside the canvas, and does not finish
};

}  // namespace spineloft::gl
