// The soft shadow that the parts cast on the floor from above.
#pragma once

#include <vector>

#include "web/gl/handles.h"
#include "web/gl/kept_items.h"
#include "web/gl/mesh_store.h"
#include "web/gl/renderer.h"

namespace spineloft::gl {

/// Two small maps of the floor: how near above each place a part is, and the shadow of that. Both are drawn again only
/// when parts or floor are others, and of the first only what the parts that move add. Where a processor draws, that
/// takes longer than the parts themselves: then they wait until the hand rests.
class FloorShadow {
 public:
  /// False when the programs cannot be made.
  bool make();
  /// Draws the maps where that is due. `quad`: the corners of the unit square, a strip of four at attribute 0.
  void update(const Scene& scene, MeshStore& meshes, const VertexArray& quad);
  /// The shadow of the last scene: r, 0…1.
  GLuint texture() const { return shadow_.texture.name(); }
  /// The context is lost: forgets every name.
  void forget();

 private:
  struct Map {
    Texture texture;
    Framebuffer framebuffer;
  };
  struct Cast {
    MeshKey mesh;
    Mat4 toWorld;
    bool operator==(const Cast&) const = default;
  };
  static Map makeMap(int side);
  void drawHeights(const Scene& scene, MeshStore& meshes);
  void drawCasts(const Scene& scene, MeshStore& meshes, const std::vector<Cast>& casts) const;
  void drawShadow(const VertexArray& quad) const;

  Program height_, soften_;
  Map heights_, kept_, shadow_;  ///< `kept_`: the heights of what stays as it is
  // What the maps show.
  Mat4 fromSky_;
  std::vector<Cast> casts_;
  KeptItems<Cast> items_;
};

}  // namespace spineloft::gl
