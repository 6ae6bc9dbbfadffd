#include "tests/support/test_files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace spineloft::testing {
namespace {

const std::filesystem::path kTests = SPINELOFT_TESTS_DIR;

}  // namespace

std::vector<std::uint8_t> testFile(const std::string& path) {
  std::ifstream file(kTests / path, std::ios::binary);
  REQUIRE_MESSAGE(file.good(), path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::pair<std::string, std::vector<std::uint8_t>>> testFiles(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kTests / folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> files;
  for (const std::string& name : names) files.emplace_back(name, testFile(folder + "/" + name));
  return files;
}

}  // namespace spineloft::testing
