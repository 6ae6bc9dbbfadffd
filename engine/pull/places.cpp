#include "engine/pull/places.h"

#include <algorithm>
#include <limits>

namespace spineloft::pull {

Places::Places(const CutMesh& mesh) : mesh_(mesh) {
  for (std::uint32_t t = 0; t < mesh.triangles(); ++t) {
    const std::uint32_t h = 3 * t;
    const ModelPoint a = mesh.at(mesh.from(h)), b = mesh.at(mesh.from(h + 1)), c = mesh.at(mesh.from(h + 2));
    const ModelPoint centre = (a + b + c) / 3;
    centres_.push_back(centre);
    sizes_.push_back(std::max({distance(a, centre), distance(b, centre), distance(c, centre)}));
  }
}

std::optional<Place> Places::nearest(ModelPoint p) const {
  std::optional<Place> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < centres_.size(); ++t) {
    if (distance(centres_[t], p) - sizes_[t] >= least) continue;
    const ModelPoint on = mesh_.nearestOn(t, p), normal = mesh_.areaNormal(t);
    if (distance(on, p) >= least || dot(normal, normal) <= 0) continue;
    least = distance(on, p);
    best = {on, normalized(normal), {}, t};
  }
  return best;
}

ModelPoint Places::meanNormal(ModelPoint at, double reach) const {
  ModelPoint sum;
  for (std::uint32_t t = 0; t < centres_.size(); ++t) {
    if (distance(centres_[t], at) - sizes_[t] > reach || distance(mesh_.nearestOn(t, at), at) > reach) continue;
    const ModelPoint normal = mesh_.areaNormal(t);
    if (dot(normal, normal) > 0) sum += normalized(normal);
  }
  return normalized(sum);
}

std::vector<Place> Places::lay(std::span<const ModelPoint> points, double apart) const {
  std::vector<Place> line;
  for (const ModelPoint p : points) {
    const auto place = nearest(p);
    if (place && (line.empty() || distance(line.back().at, place->at) > apart)) line.push_back(*place);
  }
  return line;
}

}  // namespace spineloft::pull
