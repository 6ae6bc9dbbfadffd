// Meshes on the GPU: one upload a key; the buffers of meshes that are gone serve the next ones.
#pragma once

#include <vector>

#include "web/gl/handles.h"
#include "web/gl/renderer.h"

namespace spineloft::gl {

struct GpuMesh {
  VertexArray array;
  Buffer vertices, indices;
  GLsizei count = 0;  ///< of indices
};

/// Vertex attributes: 0 position, 1 normal, 2 uv.
class MeshStore {
 public:
  /// The mesh of this item, uploaded now if it is new. Valid until the next call.
  const GpuMesh& get(const SceneMesh& item);
  /// Retires what was not asked for since the last call.
  void endFrame();
  /// The context is lost: forgets every name.
  void forgetAll();

 private:
  struct Slot {
    MeshKey key;
    GpuMesh mesh;
    bool used = true;
  };
  GpuMesh takeSpare();
  void upload(GpuMesh& target, const SceneMesh& item);
  std::vector<Slot> slots_;
  std::vector<GpuMesh> spares_;
  std::vector<float> staging_;
};

}  // namespace spineloft::gl
