#include "web/model/wanted_jobs.h"

#include <algorithm>
#include <utility>

namespace spineloft::app {
namespace {

/// How far beyond a texture a shape may reach that shows it meanwhile, as a share of its sides.
constexpr double kBeyond = 0.25;

bool liesOn(const mesh::TriMesh& mesh, const surface::UvArea& area) {
  const double x = kBeyond * (area.right - area.left), y = kBeyond * (area.bottom - area.top);
  return std::ranges::all_of(mesh.uv, [&](const auto& uv) {
    const auto u = static_cast<double>(uv[0]), v = static_cast<double>(uv[1]);
    return u >= area.left - x && u <= area.right + x && v >= area.top - y && v <= area.bottom + y;
  });
}

}  // namespace

std::vector<TextureWork::Wanted> wantedTextures(const document::Document& document, const pipeline::Derived& derived) {
  std::vector<TextureWork::Wanted> wanted;
  for (const PartId id : derived.wantedTextures) {
    const auto part = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
    if (part == derived.parts.end() || !part->shape || isTextureKnown(*part->shape)) continue;
    wanted.push_back({part->shape->wantedTexture,
                      [&document, &derived, id] { return pipeline::makeTexture(document, derived, id); }});
  }
  return wanted;
}

std::vector<ReliefWork::Wanted> wantedReliefs(const document::Document& document, const pipeline::Derived& derived) {
  std::vector<ReliefWork::Wanted> wanted;
  for (const PartId id : derived.wantedReliefs) {
    const auto part = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
    if (part == derived.parts.end() || !part->wantedRelief) continue;
    wanted.push_back({part->wantedRelief->raised,
                      [&document, &derived, id] { return pipeline::makeRelief(document, derived, id); }});
  }
  return wanted;
}

void keepEarlierReliefs(const pipeline::Derived& before, pipeline::Derived& now) {
  for (pipeline::DerivedPart& part : now.parts) {
    const auto was = std::ranges::find(before.parts, part.id, &pipeline::DerivedPart::id);
    if (!part.wantedRelief || was == before.parts.end() || !was->shape || !was->shape->smooth) continue;
    if (*was->shape->smooth == part.wantedRelief->smooth->mesh) part.shape = was->shape;
  }
}

void keepEarlierTextures(const pipeline::Derived& before, pipeline::Derived& now) {
  for (pipeline::DerivedPart& part : now.parts) {
    if (!part.shape || part.shape->texture || isTextureKnown(*part.shape)) continue;
    const auto was = std::ranges::find(before.parts, part.id, &pipeline::DerivedPart::id);
    if (was == before.parts.end() || !was->shape || !was->shape->texture) continue;
    if (!liesOn(part.shape->mesh, was->shape->texture->area)) continue;
    auto textured = std::make_shared<pipeline::PartShape>(*part.shape);
    textured->texture = was->shape->texture;
    textured->textureKey = was->shape->textureKey;
    part.shape = std::move(textured);
  }
}

}  // namespace spineloft::app
