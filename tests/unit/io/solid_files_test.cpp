// Faces of one solid that belong to several parts: printers must get one closed thing.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/io/picture_file.h"
#include "engine/io/stl.h"
#include "engine/io/three_mf.h"
#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"
#include "tests/support/unzip.h"

using namespace spineloft;
using namespace spineloft::testing;
using io::Bytes;
using io::ExportPart;

namespace {

mesh::TriMesh vase() {
  loft::LoftParams params;
  params.sectionPoints = 24;
  const auto set = straightRibs({300, 700}, {320, 100}, 20, [](double t) { return 120 + 60 * std::sin(7 * t); });
  auto mesh = loft::loftRibs(set, {640, 800}, params);
  REQUIRE(mesh.ok());
  requireLawful(mesh.value());
  return std::move(mesh).value();
}

/// A vertex more on an edge, where one of its ends is: two triangles more that have no area.
void splitAtEnd(mesh::TriMesh& mesh, std::size_t first) {
  const auto [a, b, c] = mesh.triangles[first];
  const auto added = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(mesh.positions[a]);
  if (!mesh.uv.empty()) mesh.uv.push_back(mesh.uv[a]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<std::uint32_t, 3> old = mesh.triangles[t];
      if (old[k] != b || old[(k + 1) % 3] != a) continue;
      mesh.triangles[t] = {b, added, old[(k + 2) % 3]};
      mesh.triangles.push_back({added, a, old[(k + 2) % 3]});
      mesh.triangles[first] = {a, added, c};
      mesh.triangles.push_back({added, b, c});
      return;
    }
  }
  FAIL("an open edge");
}

/// Every third triangle in a piece of its own, with vertices of its own.
std::vector<mesh::TriMesh> pieces(const mesh::TriMesh& mesh) {
  std::vector<mesh::TriMesh> out(3);
  for (std::size_t piece = 0; piece < out.size(); ++piece) {
    std::map<std::uint32_t, std::uint32_t> own;
    for (std::size_t t = piece; t < mesh.triangles.size(); t += 3) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[t][k];
        const auto [at, added] = own.try_emplace(v, static_cast<std::uint32_t>(own.size()));
        if (added) {
          out[piece].positions.push_back(mesh.positions[v]);
          out[piece].uv.push_back({0.25f, 0.5f});
        }
        corners[k] = at->second;
      }
      out[piece].triangles.push_back(corners);
    }
  }
  return out;
}

std::vector<ExportPart> partsOf(const std::vector<mesh::TriMesh>& meshes) {
  std::vector<ExportPart> parts;
  for (const mesh::TriMesh& mesh : meshes) {
    ExportPart part;
    part.name = "Solid";
    part.mesh = &mesh;
    part.placement = {{310, -400, 0}, 0.1};
    part.ofSolid = true;
    part.joins = !parts.empty();
    parts.push_back(part);
  }
  return parts;
}

/// Every edge as often one way as the other, and three different corners a triangle.
template <typename Corner>
void checkClosed(const std::vector<std::array<Corner, 3>>& triangles) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const auto& t : triangles) {
    CHECK(std::set<Corner>(t.begin(), t.end()).size() == 3);
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    CHECK((back != edges.end() && back->second == count));
  }
}

}  // namespace

TEST_CASE("a solid of several parts is one closed object of a 3MF, and each part keeps its colours") {
  mesh::TriMesh whole = vase();
  const std::size_t triangles = whole.triangles.size();
  splitAtEnd(whole, 100);
  const std::vector<mesh::TriMesh> meshes = pieces(whole);
  std::vector<ExportPart> parts = partsOf(meshes);
  const Bytes jpeg = io::encodeJpeg(ellipsePicture(16, 12)->working, 90).value();
  parts[1].picture = 0;
  parts[2].colour = {1, 0, 0};
  const std::vector<io::ExportPicture> pictures = {{"texture", jpeg}};
  const auto bytes = io::write3mf(parts, pictures);
  REQUIRE(bytes.ok());
  const auto files = unzipped(bytes.value());
  const Bytes& model = files.at("3D/3dmodel.model");
  const std::string xml(model.begin(), model.end());
  CHECK(attributes(xml, "component", "objectid").size() == 1);
  std::vector<std::array<std::string, 3>> found;
  const auto a = attributes(xml, "triangle", "v1"), b = attributes(xml, "triangle", "v2"),
             c = attributes(xml, "triangle", "v3");
  for (std::size_t i = 0; i < a.size(); ++i) found.push_back({a[i], b[i], c[i]});
  CHECK(found.size() == triangles);
  checkClosed(found);
  // Of the three parts one is as the object is, one has a texture and one a material of its own.
  const std::size_t textured = attributes(xml, "triangle", "p2").size(),
                    named = attributes(xml, "triangle", "p1").size();
  CHECK(textured <= meshes[1].triangles.size());
  CHECK(textured + 2 >= meshes[1].triangles.size());
  CHECK(named <= meshes[1].triangles.size() + meshes[2].triangles.size());
  CHECK(named + 2 >= meshes[1].triangles.size() + meshes[2].triangles.size());
  CHECK(attributes(xml, "m:tex2coord", "u").size() == meshes[1].uv.size());
}

TEST_CASE("an STL has no triangle of two corners in one place, and is closed by places") {
  mesh::TriMesh whole = vase();
  const std::size_t triangles = whole.triangles.size();
  splitAtEnd(whole, 40);
  splitAtEnd(whole, 200);
  const std::vector<mesh::TriMesh> meshes = {whole};
  const auto bytes = io::writeStl(partsOf(meshes));
  REQUIRE(bytes.ok());
  const Bytes& stl = bytes.value();
  std::uint32_t count = 0;
  std::memcpy(&count, stl.data() + 80, 4);
  CHECK(count == triangles);
  REQUIRE(stl.size() == 84 + 50 * std::size_t{count});
  std::vector<std::array<std::array<float, 3>, 3>> found(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) std::memcpy(found[t][k].data(), stl.data() + 84 + 50 * t + 12 + 12 * k, 12);
  }
  checkClosed(found);
}
