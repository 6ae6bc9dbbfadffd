// The mesh laws as a test asks for them.
#pragma once

#include "engine/mesh/laws.h"

namespace spineloft::testing {

/// Fails the test with the broken law in words unless the mesh is lawful; returns its report.
/// Every test that makes a mesh calls it.
mesh::MeshReport requireLawful(const mesh::TriMesh& mesh);

}  // namespace spineloft::testing
