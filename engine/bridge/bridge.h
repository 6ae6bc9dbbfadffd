// Bridges: a tube from a closed line on one surface to one on another, tangent to both (method-bridge.md).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/bridge/bridge_params.h"
#include "engine/mesh/front_uv.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::bridge {

/// Where a bridge stands: a closed mesh, and a closed line that lies on it or near to it, either way round,
/// kLeastRimPoints … kMostRimPoints points. ModelSpace of the bridge.
struct Host {
  const mesh::TriMesh& mesh;
  std::span<const ModelPoint> rim;
};

/// Where a bridge leaves a host.
struct Rim {
  std::vector<ModelPoint> points;  ///< on the surface, evenly spaced, counter-clockwise about the way of the bridge
  ModelPoint centre, out;          ///< `out`: unit, away from the host, square to the rim as a whole
};

struct Bridge {
  mesh::TriMesh mesh;  ///< closed, of genus 0; its ends lie in the hosts
  std::array<Rim, 2> rims;
};

/// The tube between two rims. At its rims it leaves the surfaces tangentially: across the rim, towards its inside or,
/// where the rim runs round an arm, along the arm to the other end. Between them it follows a cubic that begins and
/// ends square to the rims. Both hosts may be one. Where it would go through itself, its middle is thicker than asked
/// for, or it goes less or farther out. `picture`: in which the UV are. Errors: BridgeInvalid, with what; OutOfMemory.
/// Cost: that of the triangles of the hosts times the points of the rims.
Result<Bridge> makeBridge(const Host& from, const Host& to, const BridgeParams& params, mesh::PictureSize picture);

}  // namespace spineloft::bridge
