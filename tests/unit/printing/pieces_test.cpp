#include "engine/printing/pieces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "engine/mesh/laws.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::printing;
using spineloft::testing::requireLawful;

namespace {

using At = std::array<double, 3>;

struct Block {
  At low, size;
};

mesh::TriMesh meshOf(const Block& block) {
  mesh::TriMesh mesh = testing::box(1, 1, 1);
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  for (auto& p : mesh.positions) {
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = static_cast<float>(block.low[i] + (p[i] - bounds.low[i]) * block.size[i]);
  }
  requireLawful(mesh);
  return mesh;
}

std::size_t piecesOf(std::initializer_list<Block> blocks) {
  std::vector<mesh::TriMesh> meshes;
  for (const Block& block : blocks) meshes.push_back(meshOf(block));
  return countPieces(meshes);
}

mesh::TriMesh insideOut(mesh::TriMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

mesh::TriMesh together(const std::vector<mesh::TriMesh>& meshes) {
  mesh::TriMesh out;
  for (const mesh::TriMesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& [a, b, c] : mesh.triangles) out.triangles.push_back({a + first, b + first, c + first});
  }
  return out;
}

}  // namespace

TEST_CASE("nothing is no piece, and one part is one") {
  CHECK(countPieces({}) == 0);
  CHECK(piecesOf({{{0, 0, 0}, {10, 20, 30}}}) == 1);
}

TEST_CASE("parts that overlap, or stand on each other, are one piece; a gap makes two") {
  const Block foot{{0, 0, 0}, {30, 10, 30}};
  CHECK(piecesOf({foot, {{10, 5, 10}, {5, 40, 5}}}) == 1);   // stuck in
  CHECK(piecesOf({foot, {{10, 10, 10}, {5, 40, 5}}}) == 1);  // standing on it
  CHECK(piecesOf({foot, {{10, 12, 10}, {5, 40, 5}}}) == 2);  // above it
  CHECK(piecesOf({foot, {{32, 0, 0}, {5, 40, 5}}}) == 2);    // beside it
  CHECK(piecesOf({foot, {{-5, 4, 14}, {40, 2, 2}}}) ==
        1);  // a rod right through: no corner of either is inside the other
}

TEST_CASE("a chain is one piece, whatever the order of its links") {
  std::vector<mesh::TriMesh> links;
  for (int i = 0; i < 7; ++i) links.push_back(meshOf({{9.0 * i, 0, 0}, {10, 4, 4}}));
  Rng rng(3);
  for (int round = 0; round < testing::rounds(10); ++round) {
    for (std::size_t i = links.size() - 1; i > 0; --i) std::swap(links[i], links[rng.below(i + 1)]);
    CHECK(countPieces(links) == 1);
    CHECK(countPieces(std::span(links).first(1)) == 1);
  }
}

TEST_CASE("what is inside material is part of it; what rattles in a hollow is not") {
  const mesh::TriMesh outer = meshOf({{0, 0, 0}, {40, 40, 40}}), inner = meshOf({{15, 15, 15}, {5, 5, 5}});
  CHECK(countPieces(std::vector{outer, inner}) == 1);
  const mesh::TriMesh hollow = together({outer, insideOut(meshOf({{5, 5, 5}, {30, 30, 30}}))});
  CHECK(countPieces(std::vector{hollow}) == 1);
  CHECK(countPieces(std::vector{hollow, inner}) == 2);
  CHECK(countPieces(std::vector{inner, hollow}) == 2);
  CHECK(countPieces(std::vector{together({hollow, inner})}) == 2);
  CHECK(countPieces(std::vector{hollow, meshOf({{15, 5, 15}, {5, 5, 5}})}) == 1);  // it lies on the floor
}

TEST_CASE("random blocks come in as many pieces as their boxes say") {
  Rng rng(11);
  for (int round = 0; round < testing::rounds(60); ++round) {
    // On a lattice of 4 mm, so that what does not touch is clearly apart.
    const std::size_t count = 2 + rng.below(9);
    std::vector<Block> blocks;
    std::vector<mesh::TriMesh> meshes;
    for (std::size_t i = 0; i < count; ++i) {
      Block block;
      for (std::size_t k = 0; k < 3; ++k) {
        block.low[k] = 4.0 * static_cast<double>(rng.below(9));
        block.size[k] = 4.0 * static_cast<double>(1 + rng.below(4));
      }
      blocks.push_back(block);
      meshes.push_back(meshOf(block));
    }
    std::vector<std::size_t> group(count);
    for (std::size_t i = 0; i < count; ++i) group[i] = i;
    const auto touch = [&](const Block& a, const Block& b) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (a.low[k] > b.low[k] + b.size[k] || b.low[k] > a.low[k] + a.size[k]) return false;
      }
      return true;
    };
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!touch(blocks[i], blocks[j]) || group[i] == group[j]) continue;
        std::ranges::replace(group, group[i], group[j]);
      }
    }
    std::ranges::sort(group);
    const auto expected = static_cast<std::size_t>(std::ranges::unique(group).begin() - group.begin());
    CHECK(countPieces(meshes) == expected);
  }
}
