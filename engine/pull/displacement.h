// How the vertices between a moved line and a rim that stays follow. Internal to pull/.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::pull {

/// A piece of a surface whose vertices are given, follow, or stay.
struct Sheet {
  enum class Role : std::uint8_t {
    Free,   ///< follows
    Given,  ///< moves as told; all its triangles are here
    Rim,    ///< stays; some of its triangles are not here
  };
  std::vector<ModelPoint> points;
  std::vector<Role> roles;
  std::vector<ModelPoint> moves;  ///< of those given; of the others 0
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

enum class Stiffness : std::uint8_t {
  Smooth,      ///< the least squared Laplacian; slope 0 at the rim
  FreeAtRim,   ///< the same; any slope at the rim
  AlongLines,  ///< the least gradient: an edge along what is given
};

/// Fills in the moves of the free vertices: the least energy of the displacement, with cotangents and lumped areas.
/// False where the system has no solution in doubles.
bool spread(Sheet& sheet, Stiffness stiffness);
/// The moves of a sheet without given vertices under an even pressure along `out`, the largest of them `out`.
bool swell(Sheet& sheet, Stiffness stiffness, ModelPoint out);

}  // namespace spineloft::pull
