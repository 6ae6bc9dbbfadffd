// Files that are committed for tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spineloft::testing {

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& path);

/// The folder with real cases that $SPINELOFT_DATA names; a test fails when there is none. Only for the suite `data`,
/// which npm test leaves out, and counts as skipped, where there is no such folder.
std::filesystem::path dataFolder();

/// Where `tests/PATH` is.
std::filesystem::path testPath(const std::string& path);

/// The bytes of `tests/PATH`; a test fails when there is no such file.
std::vector<std::uint8_t> testFile(const std::string& path);

/// Names and bytes of all files of `tests/FOLDER`, sorted by name.
std::vector<std::pair<std::string, std::vector<std::uint8_t>>> testFiles(const std::string& folder);

}  // namespace spineloft::testing
