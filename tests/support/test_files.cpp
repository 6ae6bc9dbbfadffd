#include "tests/support/test_files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace spineloft::testing {
namespace {

const std::filesystem::path kTests = SPINELOFT_TESTS_DIR;

}  // namespace

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE_MESSAGE(file.good(), path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::filesystem::path dataFolder() {
  const char* folder = std::getenv("SPINELOFT_DATA");
  REQUIRE_MESSAGE((folder != nullptr && std::filesystem::is_directory(folder)), "SPINELOFT_DATA names no folder");
  return folder;
}

std::filesystem::path testPath(const std::string& path) { return kTests / path; }

std::vector<std::uint8_t> testFile(const std::string& path) { return bytesOf(testPath(path)); }

std::vector<std::pair<std::string, std::vector<std::uint8_t>>> testFiles(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kTests / folder)) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> files;
  for (const std::string& name : names) files.emplace_back(name, testFile(folder + "/" + name));
  return files;
}

}  // namespace spineloft::testing
