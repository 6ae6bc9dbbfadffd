#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include "engine/io/gltf.h"
#include "engine/io/obj.h"
#include "engine/io/stl.h"
#include "engine/loft/loft.h"
#include "engine/mesh/laws.h"
#include "tests/support/generators.h"
#include "tests/support/gltf_reader.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::testing;
using io::Bytes;
using io::ExportPart;
using io::ExportPicture;

namespace {

/// The smallest PNG: one grey pixel.
const Bytes kPng = {0x89, 'P',  'N',  'G',  0x0d, 0x0a, 0x1a, 0x0a, 0,    0,    0,    13,  'I',  'H',  'D',  'R',  0,
                    0,    0,    1,    0,    0,    0,    1,    8,    0,    0,    0,    0,   0x3a, 0x7e, 0x9b, 0x55, 0,
                    0,    0,    10,   'I',  'D',  'A',  'T',  0x78, 0x9c, 0x63, 0x68, 0,   0,    0,    0x82, 0,    0x81,
                    0x77, 0xcd, 0x72, 0xb6, 0,    0,    0,    0,    'I',  'E',  'N',  'D', 0xae, 0x42, 0x60, 0x82};

mesh::TriMesh vase(sections::SectionPreset section, int points = 48) {
  loft::LoftParams params;
  params.sections.front().shape.preset = section;
  params.sectionPoints = points;
  params.startCap = sections::CapStyle::Flat;
  const auto set = straightRibs({300, 700}, {320, 100}, 40, [](double t) { return 120 + 60 * std::sin(7 * t); });
  const auto mesh = loft::loftRibs(set, {640, 800}, params);
  REQUIRE(mesh.ok());
  requireLawful(mesh.value());
  return mesh.value();
}

io::Placement metres() { return {{310, -400, 0}, 0.1 / 600}; }

ExportPart partOf(const mesh::TriMesh& mesh, std::string name) {
  ExportPart part;
  part.name = std::move(name);
  part.mesh = &mesh;
  part.placement = metres();
  return part;
}

tinygltf::Model parse(const Bytes& bytes) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(
      [](tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* data, int size,
         void*) {
        image->image.assign(data, data + size);
        return true;
      },
      nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const bool ok =
      reader.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), static_cast<unsigned>(bytes.size()));
  REQUIRE_MESSAGE(ok, error);
  CHECK(warning.empty());
  return model;
}

/// The floats of an accessor, `count` × components.
std::vector<float> floatsOf(const tinygltf::Model& model, int index, std::size_t components) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  REQUIRE(accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  CHECK(view.byteOffset % 4 == 0);
  std::vector<float> values(accessor.count * components);
  REQUIRE(view.byteLength == values.size() * sizeof(float));
  std::memcpy(values.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
  return values;
}

std::vector<std::uint32_t> indicesOf(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const unsigned char* data = model.buffers[0].data.data() + view.byteOffset;
  std::vector<std::uint32_t> values(accessor.count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
      std::uint16_t value;
      std::memcpy(&value, data + i * 2, 2);
      values[i] = value;
    } else {
      REQUIRE(accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
      std::memcpy(&values[i], data + i * 4, 4);
    }
  }
  return values;
}

}  // namespace

TEST_CASE("a GLB read back is what was written: places, normals, texture, one node a part") {
  const mesh::TriMesh square = vase(sections::SectionPreset::Square);
  const mesh::TriMesh circle = vase(sections::SectionPreset::Circle, 512);
  std::vector<ExportPart> parts = {partOf(square, "Kiste"), partOf(circle, "Käse\xff\n"), partOf(square, "plain")};
  parts[0].picture = parts[1].picture = 1;
  parts[2].colour = {1, 0.5f, 0};
  const std::vector<ExportPicture> pictures = {{"unused", kPng}, {"photo.png", kPng}};
  const Result<Bytes> bytes = io::writeGlb(parts, pictures);
  REQUIRE(bytes.ok());
  CHECK(io::writeGlb(parts, pictures).value() == bytes.value());
  const tinygltf::Model model = parse(bytes.value());
  CHECK(model.asset.generator == "SpineLoft");
  CHECK(model.asset.version == "2.0");
  REQUIRE(model.nodes.size() == 3);
  CHECK(model.scenes.at(0).nodes.size() == 3);
  CHECK(model.nodes[0].name == "Kiste");
  CHECK(model.nodes[1].name == "Käse? ");
  REQUIRE(model.images.size() == 1);
  CHECK(model.images[0].image == kPng);
  CHECK(model.images[0].mimeType == "image/png");
  CHECK(model.materials.at(0).pbrMetallicRoughness.baseColorTexture.index == 0);
  CHECK(model.materials.at(1).pbrMetallicRoughness.baseColorTexture.index == 0);
  CHECK(model.materials.at(2).pbrMetallicRoughness.baseColorTexture.index == -1);
  CHECK(model.materials[2].pbrMetallicRoughness.baseColorFactor[1] == doctest::Approx(0.2140).epsilon(1e-3));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const tinygltf::Primitive& primitive = model.meshes.at(i).primitives.at(0);
    const mesh::ShadedMesh shaded = mesh::shade(*parts[i].mesh);
    const auto positions = floatsOf(model, primitive.attributes.at("POSITION"), 3);
    const auto normals = floatsOf(model, primitive.attributes.at("NORMAL"), 3);
    REQUIRE(positions.size() == shaded.positions.size() * 3);
    CHECK(std::memcmp(normals.data(), shaded.normals.data(), normals.size() * 4) == 0);
    for (std::size_t v = 0; v < shaded.positions.size(); ++v) {
      const auto at = io::placed(parts[i].placement, shaded.positions[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(positions[v * 3 + axis] == static_cast<float>(at[axis]));
      }
    }
    const auto indices = indicesOf(model, primitive.indices);
    REQUIRE(indices.size() == shaded.triangles.size() * 3);
    CHECK(std::memcmp(indices.data(), shaded.triangles.data(), indices.size() * 4) == 0);
    CHECK(primitive.attributes.count("TEXCOORD_0") == (i < 2 ? 1 : 0));
    if (i < 2) {
      const auto uv = floatsOf(model, primitive.attributes.at("TEXCOORD_0"), 2);
      CHECK(std::memcmp(uv.data(), shaded.uv.data(), uv.size() * 4) == 0);
    }
    const auto& accessor = model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float low = positions[axis], high = positions[axis];
      for (std::size_t v = axis; v < positions.size(); v += 3) {
        low = std::min(low, positions[v]);
        high = std::max(high, positions[v]);
      }
      CHECK(accessor.minValues.at(axis) == low);
      CHECK(accessor.maxValues.at(axis) == high);
    }
    const auto report = mesh::inspect(*parts[i].mesh);
    // As tall as its ribs and its round end: the spine runs over 600 pixels, which are 0.1 m.
    const auto [lowest, highest] =
        std::ranges::minmax(parts[i].mesh->positions, {}, [](const auto& at) { return at[1]; });
    const double pixels = static_cast<double>(highest[1]) - static_cast<double>(lowest[1]);
    CHECK(accessor.maxValues[1] - accessor.minValues[1] == doctest::Approx(pixels * 0.1 / 600).epsilon(1e-6));
    CHECK(pixels > 600);
    CHECK(pixels < 800);
    CHECK(report.genus == 0);
  }
}

TEST_CASE("a GLB with more than 65535 vertices uses wide indices") {
  loft::LoftParams params;
  params.sectionPoints = 512;
  const auto set = straightRibs({10, 50}, {900, 50}, 300, [](double) { return 60.0; });
  const auto mesh = loft::loftRibs(set, {1000, 100}, params).value();
  requireLawful(mesh);
  REQUIRE(mesh.positions.size() > 65535);
  const std::vector<ExportPart> parts = {partOf(mesh, "long")};
  const auto model = parse(io::writeGlb(parts, {}).value());
  const auto indices = indicesOf(model, model.meshes[0].primitives[0].indices);
  CHECK(model.accessors[static_cast<std::size_t>(model.meshes[0].primitives[0].indices)].componentType ==
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  CHECK(indices.size() == mesh.triangles.size() * 3);
}

TEST_CASE("binary STL has its layout, stands up, and keeps the volume") {
  const mesh::TriMesh mesh = vase(sections::SectionPreset::Heart);
  std::vector<ExportPart> parts = {partOf(mesh, "a"), partOf(mesh, "b")};
  for (ExportPart& part : parts) part.placement = {{}, 0.5};
  const Bytes bytes = io::writeStl(parts).value();
  const std::size_t triangles = 2 * mesh.triangles.size();
  REQUIRE(bytes.size() == 84 + 50 * triangles);
  CHECK(std::string(bytes.begin(), bytes.begin() + 5) != "solid");
  const auto number = [&](std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
  };
  CHECK(number(80) == triangles);
  double volume = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<ModelPoint, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t at = 84 + 50 * t + 12 * i;
      const auto f = [&](std::size_t k) { return std::bit_cast<float>(number(at + 4 * k)); };
      p[i] = {f(0), f(1), f(2)};
    }
    CHECK(norm(p[0]) == doctest::Approx(1));
    const ModelPoint facet = normalized(cross(p[2] - p[1], p[3] - p[1]));
    CHECK(dot(facet, p[0]) > 0.98);
    volume += dot(p[1], cross(p[2], p[3])) / 6;
    if (t < mesh.triangles.size()) {
      const auto& v = mesh.positions[mesh.triangles[t][0]];
      CHECK(p[1].x == doctest::Approx(v[0] / 2));
      CHECK(p[1].y == doctest::Approx(-v[2] / 2));
      CHECK(p[1].z == doctest::Approx(v[1] / 2));
    }
  }
  CHECK(volume == doctest::Approx(2 * mesh::inspect(mesh).volume / 8).epsilon(1e-5));
}

TEST_CASE(
    "OBJ read back gives the same mesh; in image space y points down and the volume stays "
    "positive") {
  const mesh::TriMesh mesh = vase(sections::SectionPreset::Star);
  std::vector<ExportPart> parts = {partOf(mesh, "first\npart"), partOf(mesh, "second")};
  for (ExportPart& part : parts) part.placement = {};
  for (const io::ObjSpace space : {io::ObjSpace::World, io::ObjSpace::Image}) {
    const Bytes bytes = io::writeObj(parts, space).value();
    std::istringstream text(std::string(bytes.begin(), bytes.end()));
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 2>> uv;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::string> names;
    for (std::string line; std::getline(text, line);) {
      std::istringstream words(line);
      std::string key, name;
      words >> key;
      if (key == "o") {
        std::getline(words >> std::ws, name);
        names.push_back(name);
      } else if (key == "v") {
        auto& p = positions.emplace_back();
        words >> p[0] >> p[1] >> p[2];
        CHECK_FALSE(words.fail());
      } else if (key == "vt") {
        auto& p = uv.emplace_back();
        words >> p[0] >> p[1];
      } else if (key == "f") {
        auto& t = triangles.emplace_back();
        for (auto& v : t) {
          std::uint32_t texture;
          char slash;
          words >> v >> slash >> texture;
          REQUIRE_FALSE(words.fail());
          CHECK(v == texture);
          --v;
        }
      }
    }
    CHECK(names == std::vector<std::string>{"first part", "second"});
    REQUIRE(positions.size() == 2 * mesh.positions.size());
    REQUIRE(uv.size() == positions.size());
    REQUIRE(triangles.size() == 2 * mesh.triangles.size());
    const float sign = space == io::ObjSpace::Image ? -1.0f : 1.0f;
    mesh::TriMesh first;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto& p = mesh.positions[v];
      CHECK(positions[v] == std::array<float, 3>{p[0], sign * p[1], p[2]});
      CHECK(uv[v][1] == doctest::Approx(1 - mesh.uv[v][1]));
    }
    first.positions.assign(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(mesh.positions.size()));
    first.triangles.assign(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(mesh.triangles.size()));
    CHECK(requireLawful(first).volume == doctest::Approx(mesh::inspect(mesh).volume));
    CHECK(triangles.back()[0] >= mesh.positions.size());
  }
}

TEST_CASE("what cannot be exported says why, in every format") {
  const mesh::TriMesh mesh = box(1, 1, 1);
  const auto errorsOf = [&](const std::vector<ExportPart>& parts, Error expected) {
    CHECK(io::writeGlb(parts, {}).error() == expected);
    CHECK(io::writeObj(parts).error() == expected);
    CHECK(io::writeStl(parts).error() == expected);
  };
  errorsOf({}, Error::NothingToExport);
  errorsOf({ExportPart{}}, Error::MeshInvalid);
  mesh::TriMesh open = mesh;
  open.triangles.pop_back();
  errorsOf({partOf(open, "open")}, Error::MeshInvalid);
  ExportPart part = partOf(mesh, "box");
  part.placement.scale = 0;
  errorsOf({part}, Error::ValueOutOfRange);
  part = partOf(mesh, "box");
  part.colour[1] = std::nanf("");
  errorsOf({part}, Error::ValueOutOfRange);
  part = partOf(mesh, "box");
  part.picture = 0;
  CHECK(io::writeGlb(std::vector{part}, {}).error() == Error::NoSuchPicture);
  // A picture needs texture coordinates, and must be one.
  const Bytes text = {'h', 'e', 'l', 'l', 'o'};
  const std::vector<ExportPicture> pictures = {{"note.txt", text}};
  CHECK(io::writeGlb(std::vector{part}, pictures).error() == Error::MeshInvalid);
  const mesh::TriMesh textured = vase(sections::SectionPreset::D);
  part.mesh = &textured;
  CHECK(io::writeGlb(std::vector{part}, pictures).error() == Error::PictureUnreadable);
  CHECK(io::writeGlb(std::vector{partOf(mesh, "box")}, {}, {4.0}).error() == Error::ValueOutOfRange);
}

TEST_CASE("names are clean UTF-8 in one line") {
  CHECK(io::cleanName("Käse €uro 🦕") == "Käse €uro 🦕");
  CHECK(io::cleanName("a\nb\tc\x7f") == "a b c ");
  CHECK(io::cleanName("\xc3") == "?");
  CHECK(io::cleanName("\xc0\xaf") == "??");
  CHECK(io::cleanName("\xed\xa0\x80x") == "???x");
  CHECK(io::cleanName("\xf4\x90\x80\x80") == "????");
}
