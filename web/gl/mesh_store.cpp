#include "web/gl/mesh_store.h"

#include <algorithm>

#include "engine/mesh/shading.h"

namespace spineloft::gl {
namespace {

constexpr std::size_t kSpares = 2;
constexpr GLsizei kFloatsAVertex = 8;

void attribute(GLuint index, GLint size, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, kFloatsAVertex * sizeof(float),
                        reinterpret_cast<const void*>(offset * sizeof(float)));
}

void forget(GpuMesh& mesh) {
  mesh.array.forget();
  mesh.vertices.forget();
  mesh.indices.forget();
}

}  // namespace

GpuMesh MeshStore::takeSpare() {
  if (!spares_.empty()) {
    GpuMesh mesh = std::move(spares_.back());
    spares_.pop_back();
    return mesh;
  }
  GpuMesh mesh;
  mesh.array = VertexArray::make();
  mesh.vertices = Buffer::make();
  mesh.indices = Buffer::make();
  glBindVertexArray(mesh.array.name());
  glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.name());
  attribute(0, 3, 0);
  attribute(1, 3, 3);
  attribute(2, 2, 6);
  glBindVertexArray(0);
  return mesh;
}

void MeshStore::upload(GpuMesh& target, const SceneMesh& item) {
  const mesh::ShadedMesh shaded = mesh::shade(*item.mesh, item.faceted ? 0 : mesh::kCreaseAngle);
  staging_.clear();
  for (std::size_t i = 0; i < shaded.positions.size(); ++i) {
    const std::array<float, 2> uv = shaded.uv.empty() ? std::array<float, 2>{} : shaded.uv[i];
    staging_.insert(staging_.end(), shaded.positions[i].begin(), shaded.positions[i].end());
    staging_.insert(staging_.end(), shaded.normals[i].begin(), shaded.normals[i].end());
    staging_.insert(staging_.end(), uv.begin(), uv.end());
  }
  glBindVertexArray(target.array.name());
  glBindBuffer(GL_ARRAY_BUFFER, target.vertices.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(staging_.size() * sizeof(float)), staging_.data(),
               GL_DYNAMIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(shaded.triangles.size() * sizeof(shaded.triangles[0])),
               shaded.triangles.data(), GL_DYNAMIC_DRAW);
  glBindVertexArray(0);
  target.count = static_cast<GLsizei>(shaded.triangles.size() * 3);
}

const GpuMesh& MeshStore::get(const SceneMesh& item) {
  const auto at = std::ranges::find(slots_, item.key, &Slot::key);
  if (at != slots_.end()) {
    at->used = true;
    return at->mesh;
  }
  Slot slot{item.key, takeSpare(), true};
  upload(slot.mesh, item);
  slots_.push_back(std::move(slot));
  return slots_.back().mesh;
}

void MeshStore::endFrame() {
  for (Slot& slot : slots_) {
    if (!slot.used && spares_.size() < kSpares) spares_.push_back(std::move(slot.mesh));
  }
  std::erase_if(slots_, [](const Slot& slot) { return !slot.used; });
  for (Slot& slot : slots_) slot.used = false;
}

void MeshStore::forgetAll() {
  for (Slot& slot : slots_) forget(slot.mesh);
  for (GpuMesh& spare : spares_) forget(spare);
  slots_.clear();
  spares_.clear();
}

}  // namespace spineloft::gl
