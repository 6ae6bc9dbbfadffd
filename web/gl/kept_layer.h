// Solids that stay as they are while others move, drawn once: colours and depths, from which the frames of a gesture
// take them. For canvases that a processor draws, where each triangle counts.
#pragma once

#include <vector>

#include "web/gl/handles.h"
#include "web/gl/kept_items.h"
#include "web/gl/renderer.h"

namespace spineloft::gl {

class KeptLayer {
 public:
  /// False when the program cannot be made.
  bool make();
  /// Every frame is told, in order.
  void follow(const Scene& scene);
  /// Shares the frame's meshes out between the layer and `others`. True when the layer is to be drawn: the ground and
  /// the meshes `kept`, between `begin` and `end`.
  bool share() { return items_.share(); }
  const std::vector<SceneMesh>& kept() const { return items_.picture(); }
  const std::vector<SceneMesh>& others() const { return items_.others(); }
  /// Binds and clears the layer, in the size of the solid view.
  void begin(const Scene& scene);
  /// Binds the canvas again.
  void end();
  /// Puts the layer into the viewport, whose left and lower edges these are. `quad`: as FloorShadow::update.
  void draw(int left, int bottom, const VertexArray& quad) const;
  /// The context is lost: forgets every name.
  void forget();

 private:
  Program program_;
  Texture colours_, depths_;
  Framebuffer framebuffer_;
  int width_ = 0, height_ = 0;
  Scene before_;  ///< its view; what it points to may be gone
  KeptItems<SceneMesh> items_;
};

}  // namespace spineloft::gl
