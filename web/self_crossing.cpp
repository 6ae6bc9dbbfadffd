// The engine's test for meshes that go through themselves as a WebAssembly program of its own: the worker of solids
// (web/shell/solids/self_crossing.ts) loads it, so that the engine and the solver have one test.
#include "engine/mesh/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace {

/// The rows of a list of numbers.
template <class Row>
std::vector<Row> rowsOf(const void* numbers, std::uint32_t count) {
  std::vector<Row> rows(count);
  if (count > 0) std::memcpy(rows.data(), numbers, count * sizeof(Row));
  return rows;
}

/// Whether all numbers are finite and every corner is a vertex; any other mesh is left to the solver to refuse.
bool isMesh(const spineloft::mesh::TriMesh& mesh) {
  const auto isPlace = [](const auto& p) { return std::ranges::all_of(p, [](float x) { return std::isfinite(x); }); };
  const auto isFace = [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return v < mesh.positions.size(); });
  };
  return std::ranges::all_of(mesh.positions, isPlace) && std::ranges::all_of(mesh.triangles, isFace);
}

}  // namespace

/// 1 where the mesh goes through itself, and the place in `at` (x, y, z); otherwise 0. Three floats a vertex, three
/// vertex numbers a triangle.
extern "C" int spl_selfCrossing(const float* positions, std::uint32_t vertices, const std::uint32_t* corners,
                                std::uint32_t triangles, double* at) {
  using namespace spineloft::mesh;
  TriMesh mesh;
  mesh.positions = rowsOf<std::array<float, 3>>(positions, vertices);
  mesh.triangles = rowsOf<std::array<std::uint32_t, 3>>(corners, triangles);
  const auto crossing = isMesh(mesh) ? selfCrossing(mesh) : std::nullopt;
  if (!crossing) return 0;
  std::memcpy(at, crossing->data(), sizeof *crossing);
  return 1;
}
