// What is true of every file a model is saved as.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/publish/publish.h"
#include "tests/support/gltf_reader.h"
#include "tests/support/random_documents.h"
#include "tests/support/unzip.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::publish;
using spineloft::testing::attributes;
using spineloft::testing::ellipsePicture;
using spineloft::testing::unzipped;

namespace {

constexpr std::array kShown = {Format::Glb, Format::Obj, Format::Stl, Format::ObjZip, Format::ThreeMf};

Document twoParts(double mm) {
  Document document = update({}, AddPicture{"e", ellipsePicture(192, 144)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
  document = update(document, AddPicture{"f", ellipsePicture(100, 180, 4)}).value();
  document = update(document, DrawSpine{PictureId{2}, {{50, 60}, {50, 90}, {50, 120}}}).value();
  return update(document, SetHeight{{mm}}).value();
}

/// The first part stands beyond a mirror that lies over the ground, the second one is moved up, turned
/// and mirrored, and there is a mirrored copy of it below.
Document placedParts(double mm) {
  Document document = twoParts(mm);
  PlaceParts places;
  places.parts.push_back({PartId{1}, {}, MirrorPlane{{0, 0.3, 0}, {0, 1, 0}}});
  Placement up;
  up.move = {0.4, 0.7, -0.2};
  up.turn = geometry::turnAbout(WorldPoint{0, 0, 1}, 0.6);
  up.scale = 1.3;
  up.mirrored = true;
  places.parts.push_back({PartId{2}, up, {}});
  document = update(document, places).value();
  return update(document, DuplicateParts{{PartId{2}}, {}, MirrorPlane{{0, -0.5, 0}, {0, 1, 0}}}).value();
}

Bytes saved(const Document& document, Format format) {
  pipeline::Cache cache;
  const auto derived = pipeline::deriveWithEdges(document, cache, {}).value();
  const auto bytes = publish::publish(document, derived, format, {});
  REQUIRE(bytes.ok());
  return bytes.value();
}

std::string textOf(const Bytes& bytes) { return std::string(bytes.begin(), bytes.end()); }

/// Positions in millimetres with y up, and texture coordinates, as a reader of the format finds them.
struct Points {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<double, 2>> uv;
  std::size_t triangles = 0;
};

Points ofObj(const std::string& text) {
  Points out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    double a = 0, b = 0, c = 0;
    if (key == "v" && words >> a >> b >> c) out.positions.push_back({a, b, c});
    if (key == "vt" && words >> a >> b) out.uv.push_back({a, b});
    if (key == "f") ++out.triangles;
  }
  return out;
}

Points of3mf(const Bytes& bytes) {
  Points out;
  const auto files = unzipped(bytes);
  const std::string xml = textOf(files.at("3D/3dmodel.model"));
  CHECK(xml.find("unit=\"millimeter\"") != std::string::npos);
  const auto x = attributes(xml, "vertex", "x"), y = attributes(xml, "vertex", "y"), z = attributes(xml, "vertex", "z");
  for (std::size_t i = 0; i < x.size(); ++i) {
    out.positions.push_back({std::stod(x[i]), std::stod(z[i]), -std::stod(y[i])});
  }
  const auto u = attributes(xml, "m:tex2coord", "u"), v = attributes(xml, "m:tex2coord", "v");
  for (std::size_t i = 0; i < u.size(); ++i) out.uv.push_back({std::stod(u[i]), std::stod(v[i])});
  out.triangles = attributes(xml, "triangle", "v1").size();
  return out;
}

Points ofStl(const Bytes& stl) {
  Points out;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50, ++out.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), stl.data() + at + 12 + corner * 12, 12);
      out.positions.push_back({double(p[0]), double(p[2]), -double(p[1])});
    }
  }
  return out;
}

Points ofGlb(const Bytes& glb, tinygltf::Model& model) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; },
                        nullptr);
  std::string error, warning;
  REQUIRE(reader.LoadBinaryFromMemory(&model, &error, &warning, glb.data(), unsigned(glb.size())));
  Points out;
  const auto floats = [&](int accessor, std::size_t width, auto&& take) {
    const auto& a = model.accessors[std::size_t(accessor)];
    const auto& view = model.bufferViews[std::size_t(a.bufferView)];
    const unsigned char* data = model.buffers[0].data.data() + view.byteOffset + a.byteOffset;
    for (std::size_t i = 0; i < a.count; ++i) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), data + i * width * 4, width * 4);
      take(p);
    }
  };
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      floats(primitive.attributes.at("POSITION"), 3, [&](const auto& p) {
        out.positions.push_back({1000.0 * double(p[0]), 1000.0 * double(p[1]), 1000.0 * double(p[2])});
      });
      if (primitive.attributes.count("TEXCOORD_0")) {
        floats(primitive.attributes.at("TEXCOORD_0"), 2,
               [&](const auto& p) { out.uv.push_back({double(p[0]), double(p[1])}); });
      }
      out.triangles += model.accessors[std::size_t(primitive.indices)].count / 3;
    }
  }
  return out;
}

Points pointsOf(const Bytes& bytes, Format format) {
  tinygltf::Model model;
  switch (format) {
    case Format::Obj:
      return ofObj(textOf(bytes));
    case Format::Stl:
      return ofStl(bytes);
    case Format::ThreeMf:
      return of3mf(bytes);
    case Format::ObjZip:
      return ofObj(textOf(unzipped(bytes).at("model.obj")));
    default:
      return ofGlb(bytes, model);
  }
}

}  // namespace

TEST_CASE("a typed height is that height in every file, to a hundredth of a millimetre" * doctest::test_suite("slow")) {
  for (const double mm : {12.5, 999.0}) {
    std::size_t before = 0;
    // As they were traced, and mirrored, moved, turned and copied: all of them count.
    for (const Document& document : {twoParts(mm), placedParts(mm)}) {
      std::size_t triangles = 0;
      for (const Format format : kShown) {
        CAPTURE(formatKey(format));
        const Points points = pointsOf(saved(document, format), format);
        REQUIRE_FALSE(points.positions.empty());
        double low = 1e9, high = -1e9;
        for (const auto& p : points.positions) low = std::min(low, p[1]), high = std::max(high, p[1]);
        CHECK(std::abs(high - low - mm) < 0.01);
        CHECK(std::abs(low) < 0.01);
        if (triangles == 0) triangles = points.triangles;
        CHECK(points.triangles == triangles);
      }
      CHECK(triangles > 3 * before / 2);
      before = triangles;
    }
  }
}

TEST_CASE("texture coordinates stay within the texture, in every file that has them") {
  Document document = twoParts(50);
  document = update(document, SetLook{PartId{2}, {false, {9, 90, 200}, surface::Paint::TwoTone}}).value();
  for (const Format format : {Format::Glb, Format::ObjZip, Format::ThreeMf}) {
    CAPTURE(formatKey(format));
    const Points points = pointsOf(saved(document, format), format);
    REQUIRE_FALSE(points.uv.empty());
    for (const auto& [u, v] : points.uv) {
      CHECK((u >= 0 && u <= 1 && v >= 0 && v <= 1));
    }
  }
}

TEST_CASE("the paint of a part is in its material, and two colours are its texture") {
  Document document = twoParts(50);
  document = update(document, SetLook{PartId{1}, {false, {255, 0, 0}, surface::Paint::Metal}}).value();
  document =
      update(document, SetLook{PartId{2}, {false, {0, 0, 255}, surface::Paint::TwoTone, {0, 255, 0}, true}}).value();
  tinygltf::Model model;
  ofGlb(saved(document, Format::Glb), model);
  REQUIRE(model.materials.size() == 2);
  CHECK(model.materials[0].pbrMetallicRoughness.metallicFactor == 1);
  CHECK(model.materials[0].pbrMetallicRoughness.baseColorTexture.index == -1);
  CHECK(model.materials[1].pbrMetallicRoughness.metallicFactor == 0);
  CHECK(model.materials[1].pbrMetallicRoughness.baseColorTexture.index == 0);
  // Faceted: no corner of a triangle is shared.
  const auto& faceted = model.meshes[1].primitives[0];
  CHECK(model.accessors[std::size_t(faceted.attributes.at("POSITION"))].count >
        model.accessors[std::size_t(faceted.indices)].count / 3);
  const auto files = unzipped(saved(document, Format::ObjZip));
  const std::string materials = textOf(files.at("model.mtl"));
  CHECK(materials.find("newmtl part-1\nKd 1 0 0") != std::string::npos);
  CHECK(materials.find("map_Kd model.png") != std::string::npos);
  // Above the middle the first colour, below it the second.
  const auto picture = io::decodeImage(files.at("model.png"), 1 << 20);
  REQUIRE(picture.ok());
  const image::Image& atlas = picture.value();
  CHECK(atlas.pixels[2] == 255);
  const std::size_t last = 4 * std::size_t(atlas.width) * std::size_t(atlas.height - 1);
  CHECK(atlas.pixels[last + 1] == 255);
  CHECK(atlas.pixels[last + 2] == 0);
}

TEST_CASE("a 3MF is one thing to print, with its materials and its texture") {
  const auto files = unzipped(saved(twoParts(60), Format::ThreeMf));
  CHECK(files.count("[Content_Types].xml") == 1);
  CHECK(files.count("_rels/.rels") == 1);
  CHECK(files.count("3D/Textures/1.jpg") == 1);
  const std::string xml = textOf(files.at("3D/3dmodel.model"));
  CHECK(attributes(xml, "item", "objectid").size() == 1);
  CHECK(attributes(xml, "component", "objectid").size() == 2);
  const auto ids = attributes(xml, "object", "id");
  REQUIRE(ids.size() == 3);
  CHECK(attributes(xml, "item", "objectid")[0] == ids[2]);
  CHECK(attributes(xml, "base", "displaycolor").size() == 2);
  for (const char* axis : {"x", "y", "z"}) {
    double low = 1e9;
    for (const std::string& value : attributes(xml, "vertex", axis)) low = std::min(low, std::stod(value));
    CHECK(low == doctest::Approx(0));
  }
  CHECK(textOf(files.at("3D/_rels/3dmodel.model.rels")).find("/3D/Textures/1.jpg") != std::string::npos);
}

TEST_CASE("what a photo's file says besides its pixels is in no file we write") {
  // A JPEG with a place in its EXIF block, in a comment and in XMP.
  const std::string secret = "GPSLatitude 52.5163 N";
  Bytes jpeg = io::encodeJpeg(ellipsePicture(192, 144)->working, 90).value();
  const auto segment = [&](std::uint8_t marker, const std::string& text) {
    const std::size_t length = text.size() + 2;
    Bytes bytes = {0xff, marker, std::uint8_t(length >> 8), std::uint8_t(length & 255)};
    bytes.insert(bytes.end(), text.begin(), text.end());
    jpeg.insert(jpeg.begin() + 2, bytes.begin(), bytes.end());
  };
  const std::string exif("Exif\0\0MM\0*\0\0\0\x08\0\0\0\0\0\0", 20);
  segment(0xe1, exif + secret);
  segment(0xe1, "http://ns.adobe.com/xap/1.0/ " + secret);
  segment(0xfe, secret);
  REQUIRE(textOf(jpeg).find(secret) != std::string::npos);
  auto picture = std::make_shared<const image::Picture>(io::decodePicture(jpeg, {}).value());
  Document document = update({}, AddPicture{"holiday", picture}).value();
  document = update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
  for (const Format format :
       {Format::Glb, Format::Obj, Format::Stl, Format::Project, Format::ObjZip, Format::ThreeMf}) {
    CAPTURE(formatKey(format));
    const Bytes bytes = saved(document, format);
    std::vector<Bytes> looked = {bytes};
    if (format == Format::ObjZip || format == Format::ThreeMf) {
      for (auto& [name, content] : unzipped(bytes)) looked.push_back(content);
    }
    for (const Bytes& content : looked) {
      const std::string text = textOf(content);
      // Shorter ones stand in packed bytes by chance.
      CHECK(text.find("GPSLat") == std::string::npos);
      CHECK(text.find("Exif") == std::string::npos);
      CHECK(text.find("52.5163") == std::string::npos);
    }
  }
}
