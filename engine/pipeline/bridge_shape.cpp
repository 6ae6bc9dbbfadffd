#include "engine/pipeline/bridge_shape.h"

#include <new>
#include <utility>
#include <vector>

#include "engine/bridge/bridge.h"
#include "engine/pipeline/world.h"

namespace spineloft::pipeline {
namespace {

// From the space of a part to that of a bridge.
class ToBridge {
 public:
  ToBridge(const document::Document& document, const document::Part& host, image::Size picture)
      : toWorld_(*copiesInWorld(host, findPicture(document, pictureOf(host))->size).begin()),
        frame_(worldFrame(picture)) {}
  ModelPoint operator()(ModelPoint p) const { return frame_.toModel(toWorld_(p)); }
  bool flips() const { return toWorld_.flips; }

 private:
  ToWorld toWorld_;
  WorldFrame frame_;
};

// A host in the space of its bridge.
struct Carried {
  mesh::TriMesh mesh;
  std::vector<ModelPoint> rim;
};
Carried carried(const mesh::TriMesh& mesh, const document::BridgeEnd& end, const ToBridge& toBridge) {
  Carried host{{mesh.positions, {}, mesh.triangles}, end.rim};
  for (auto& p : host.mesh.positions) {
    const ModelPoint q = toBridge({p[0], p[1], p[2]});
    p = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  if (toBridge.flips()) {
    for (auto& triangle : host.mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  for (ModelPoint& p : host.rim) p = toBridge(p);
  return host;
}

}  // namespace

const document::Part* hostOf(const document::Document& document, const document::BridgeEnd& end) {
  const document::Part* host = findPart(document, end.part);
  const bool stands =
      host != nullptr && bridgeOf(*host) == nullptr && findPicture(document, pictureOf(*host)) != nullptr;
  return stands ? host : nullptr;
}

Result<PartShape> bridgeStage(const document::BridgeRecipe& recipe, const document::Document& document,
                              const mesh::TriMesh& from, const mesh::TriMesh& to, const Clock& clock) {
  const double started = clock ? clock() : 0;
  const document::PictureEntry* entry = findPicture(document, recipe.picture);
  const document::Part *start = hostOf(document, recipe.from), *end = hostOf(document, recipe.to);
  if (entry == nullptr) return Error::NoSuchPicture;
  if (start == nullptr || end == nullptr) return Error::HostGone;
  try {
    const Carried a = carried(from, recipe.from, ToBridge(document, *start, entry->size));
    const Carried b = carried(to, recipe.to, ToBridge(document, *end, entry->size));
    Result<bridge::Bridge> made =
        bridge::makeBridge({a.mesh, a.rim}, {b.mesh, b.rim}, recipe.bridge,
                           {static_cast<double>(entry->size.width), static_cast<double>(entry->size.height)});
    if (!made) return made.failure();
    PartShape shape;
    shape.mesh = std::move(made.value().mesh);
    for (bridge::Rim& rim : made.value().rims) shape.rims.push_back(std::move(rim));
    shape.ms.loft = (clock ? clock() : 0) - started;
    return shape;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::pipeline
