#include "engine/io/zip.h"

#include <doctest/doctest.h>

#include <string>

#include "engine/base/rng.h"
#include "tests/support/unzip.h"

using namespace spineloft;
using io::Bytes;

namespace {

Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }

}  // namespace

TEST_CASE("what goes into an archive comes out of it, squeezed or not, in any size") {
  Rng rng(3);
  std::vector<Bytes> contents = {{}, bytesOf("a"), bytesOf(std::string(100000, 'x'))};
  for (int i = 0; i < 12; ++i) {
    Bytes bytes(rng.below(5000));
    for (std::uint8_t& b : bytes) b = std::uint8_t(rng.below(i % 2 ? 256 : 4));
    contents.push_back(std::move(bytes));
  }
  std::vector<io::ZipEntry> files;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    files.push_back({"ordner/d\xc3\xa4tei-" + std::to_string(i), contents[i], i % 3 != 0});
  }
  const auto zip = io::writeZip(files);
  REQUIRE(zip.ok());
  CHECK(zip.value() == io::writeZip(files).value());
  const auto back = testing::unzipped(zip.value());
  CHECK(back.size() == files.size());
  for (std::size_t i = 0; i < files.size(); ++i) CHECK(back.at(files[i].name) == contents[i]);
}

TEST_CASE("repetition is squeezed, noise is not made larger") {
  const Bytes plain = bytesOf(std::string(100000, 'x'));
  const io::ZipEntry file{"x", plain};
  CHECK(io::writeZip({&file, 1}).value().size() < 2000);
  Rng rng(4);
  Bytes noise(10000);
  for (std::uint8_t& b : noise) b = std::uint8_t(rng.below(256));
  const io::ZipEntry wild{"n", noise};
  CHECK(io::writeZip({&wild, 1}).value().size() < noise.size() + 200);
}

TEST_CASE("an archive without files is one all the same") {
  CHECK(testing::unzipped(io::writeZip({}).value()).empty());
}
