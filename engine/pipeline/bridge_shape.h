// Bridges as derived: they stand on other parts.
#pragma once

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::pipeline {

/// The part that an end stands on; null where it is not there, or is a bridge itself.
const document::Part* hostOf(const document::Document& document, const document::BridgeEnd& end);

/// The bridge between two meshes of its parts, each in its own ModelSpace, as they stand in the world. `key` of the
/// result is 0; the time stands in `ms.loft`. Errors: HostGone (a part is not there), those of bridge::makeBridge.
Result<PartShape> bridgeStage(const document::BridgeRecipe& recipe, const document::Document& document,
                              const mesh::TriMesh& from, const mesh::TriMesh& to, const Clock& clock = {});

}  // namespace spineloft::pipeline
