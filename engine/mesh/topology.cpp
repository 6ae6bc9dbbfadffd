#include "engine/mesh/topology.h"

#include <algorithm>

namespace spineloft::mesh {

Twins findTwins(const TriMesh& mesh) {
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.triangles.size() * 3);
  // Half-edges in buckets by their smaller vertex (counting sort), then by the larger one.
  struct Entry {
    std::uint32_t far, halfEdge;
    bool forward;
  };
  std::vector<std::uint32_t> start(mesh.positions.size() + 1, 0);
  for (std::uint32_t h = 0; h < count; ++h) {
    ++start[std::min(cornerVertex(mesh, h), cornerVertex(mesh, nextHalfEdge(h))) + 1];
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  std::vector<Entry> entries(count);
  for (std::uint32_t h = 0; h < count; ++h) {
    const std::uint32_t a = cornerVertex(mesh, h), b = cornerVertex(mesh, nextHalfEdge(h));
    entries[fill[std::min(a, b)]++] = {std::max(a, b), h, a < b};
  }
  Twins twins;
  twins.of.assign(count, kNone);
  twins.closed = true;
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto low = entries.begin() + start[v], high = entries.begin() + start[v + 1];
    std::sort(low, high,
              [](const Entry& a, const Entry& b) { return a.far != b.far ? a.far < b.far : a.halfEdge < b.halfEdge; });
    for (auto run = low; run != high;) {
      auto end = run;
      while (end != high && end->far == run->far) ++end;
      ++twins.edges;
      if (end - run == 2 && run->forward != run[1].forward) {
        twins.of[run->halfEdge] = run[1].halfEdge;
        twins.of[run[1].halfEdge] = run->halfEdge;
      } else {
        twins.closed = false;
      }
      run = end;
    }
  }
  return twins;
}

}  // namespace spineloft::mesh
