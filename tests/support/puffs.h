// Puffs of outlines, made and checked.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "engine/inflate/inflate.h"
#include "tests/support/mesh_laws.h"

namespace spineloft::testing {

inline constexpr image::Size kPuffPicture{400, 400};

struct Puffed {
  mesh::TriMesh mesh;
  mesh::MeshReport report;
};
/// A lawful solid, on a picture of the size above.
inline Puffed puffed(const geometry::Contours& contours, const inflate::InflateParams& params) {
  Result<mesh::TriMesh> solid = inflate::inflateRegion(contours, kPuffPicture, params);
  REQUIRE_MESSAGE(solid.ok(), (solid.ok() ? std::string() : failureSentence(solid.failure())));
  const mesh::MeshReport report = requireLawful(solid.value());
  return {std::move(solid).value(), report};
}

}  // namespace spineloft::testing
