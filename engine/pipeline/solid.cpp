#include "engine/pipeline/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/pipeline/derive.h"

namespace spineloft::pipeline {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

bool fits(const SolidArrays& a) {
  const std::size_t vertices = a.positions.size() / 3, triangles = a.corners.size() / 3;
  const auto known = [&](std::uint32_t v) { return v < vertices; };
  const auto finite = [](float value) { return std::isfinite(value); };
  const auto within = [&](const SolidArrays::Run& run) {
    return run.first <= triangles && run.count <= triangles - run.first;
  };
  return a.positions.size() == 3 * vertices && a.corners.size() == 3 * triangles && a.uv.size() == 2 * vertices &&
         vertices < kNone && triangles > 0 && a.mergeFrom.size() == a.mergeTo.size() &&
         std::ranges::all_of(a.corners, known) && std::ranges::all_of(a.mergeFrom, known) &&
         std::ranges::all_of(a.mergeTo, known) && std::ranges::all_of(a.positions, finite) &&
         std::ranges::all_of(a.uv, finite) && std::ranges::all_of(a.runs, within);
}

/// Adds vertices of a larger mesh one by one, each once.
class Picker {
 public:
  Picker(const SolidArrays& from, bool withUv) : from_(from), withUv_(withUv) {
    to_.assign(from.positions.size() / 3, kNone);
  }
  std::uint32_t take(std::uint32_t vertex) {
    std::uint32_t& at = to_[vertex];
    if (at != kNone) return at;
    at = static_cast<std::uint32_t>(mesh_.positions.size());
    used_.push_back(vertex);
    const std::size_t p = 3 * std::size_t{vertex}, t = 2 * std::size_t{vertex};
    mesh_.positions.push_back({from_.positions[p], from_.positions[p + 1], from_.positions[p + 2]});
    if (withUv_) {
      mesh_.uv.push_back({std::clamp(from_.uv[t], 0.0f, 1.0f), std::clamp(from_.uv[t + 1], 0.0f, 1.0f)});
    }
    return at;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({take(a), take(b), take(c)});
  }
  /// What was picked; begins again.
  mesh::TriMesh finish() {
    for (const std::uint32_t vertex : used_) to_[vertex] = kNone;
    used_.clear();
    return std::exchange(mesh_, {});
  }

 private:
  const SolidArrays& from_;
  bool withUv_;
  std::vector<std::uint32_t> to_, used_;
  mesh::TriMesh mesh_;
};

}  // namespace

std::size_t bytesOf(const Solid& solid) {
  const auto of = [](const mesh::TriMesh& mesh) {
    return mesh.positions.size() * sizeof(mesh.positions[0]) + mesh.triangles.size() * sizeof(mesh.triangles[0]) +
           mesh.uv.size() * sizeof(mesh.uv[0]);
  };
  std::size_t bytes = sizeof(Solid) + of(solid.mesh);
  for (const SolidPiece& piece : solid.pieces) bytes += sizeof(piece) + of(piece.mesh);
  return bytes;
}

Result<Solid> solidFrom(const SolidArrays& arrays) {
  if (!fits(arrays)) return {Error::MeshInvalid, "solid"};
  std::vector<std::uint32_t> place(arrays.positions.size() / 3);
  for (std::uint32_t v = 0; v < place.size(); ++v) place[v] = v;
  for (std::size_t i = 0; i < arrays.mergeFrom.size(); ++i) {
    place[arrays.mergeFrom[i]] = arrays.mergeTo[i];
  }
  // One may be merged into one that is merged itself; a ring of them would be damage.
  for (std::uint32_t& to : place) {
    for (int hops = 0; place[to] != to; ++hops) {
      if (hops > 64) return {Error::MeshInvalid, "solid"};
      to = place[to];
    }
  }
  Solid solid;
  Picker closed(arrays, false), open(arrays, true);
  for (std::size_t i = 0; i < arrays.corners.size(); i += 3) {
    closed.triangle(place[arrays.corners[i]], place[arrays.corners[i + 1]], place[arrays.corners[i + 2]]);
  }
  solid.mesh = closed.finish();
  // Runs of one part are one piece.
  std::vector<PartId> parts;
  for (const SolidArrays::Run& run : arrays.runs) {
    if (run.count > 0 && std::ranges::find(parts, run.part) == parts.end()) parts.push_back(run.part);
  }
  for (const PartId part : parts) {
    for (const SolidArrays::Run& run : arrays.runs) {
      if (run.part != part) continue;
      for (std::size_t i = 3 * run.first; i < 3 * (run.first + run.count); i += 3) {
        open.triangle(arrays.corners[i], arrays.corners[i + 1], arrays.corners[i + 2]);
      }
    }
    solid.pieces.push_back({part, open.finish()});
  }
  return solid;
}

const DerivedStep* solidOf(const document::Document& document, const Derived& derived, PartId part) {
  const document::Step* root = rootOf(document, {part, {}});
  if (root == nullptr) return nullptr;
  const auto at = std::ranges::find(derived.steps, root->id, &DerivedStep::id);
  return at == derived.steps.end() || !at->solid ? nullptr : &*at;
}

bool isVisible(const document::Document& document, const document::Part& part) {
  const document::Step* root = document.steps.empty() ? nullptr : rootOf(document, {part.id, {}});
  return root != nullptr ? root->visible : part.visible;
}

bool showsItself(const document::Document& document, const Derived& derived, const document::Part& part) {
  // Until the solver has answered for the first time, the parts stand for their solid.
  return isVisible(document, part) && solidOf(document, derived, part.id) == nullptr;
}

const DerivedStep* shownSolid(const document::Document& document, const Derived& derived, const document::Step& step) {
  if (!step.visible || holderOf(document, {{}, step.id}) != nullptr) return nullptr;
  const auto at = std::ranges::find(derived.steps, step.id, &DerivedStep::id);
  return at == derived.steps.end() || !at->solid ? nullptr : &*at;
}

}  // namespace spineloft::pipeline
