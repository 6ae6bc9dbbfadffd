#include "tests/support/mesh_laws.h"

#include <doctest/doctest.h>

namespace spineloft::testing {

mesh::MeshReport requireLawful(const mesh::TriMesh& mesh) {
  const mesh::MeshReport report = mesh::inspect(mesh);
  const std::string broken = mesh::brokenLaw(report);
  REQUIRE_MESSAGE(broken.empty(), broken);
  REQUIRE(report.valid());
  return report;
}

}  // namespace spineloft::testing
