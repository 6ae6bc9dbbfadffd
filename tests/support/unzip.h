// Reads ZIP archives, for tests: by the directory at the end, with another program's inflate.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace spineloft::testing {

/// Files by name; every size and checksum of both headers is checked, and a test fails where they lie.
std::map<std::string, std::vector<std::uint8_t>> unzipped(const std::vector<std::uint8_t>& zip);

/// Values of an attribute of all elements of that name, in order: `values(xml, "vertex", "x")`.
std::vector<std::string> attributes(const std::string& xml, const std::string& element, const std::string& attribute);

}  // namespace spineloft::testing
