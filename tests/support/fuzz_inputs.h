// What the fuzzers and the replay of their corpus do with one input.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace spineloft::testing {

/// Reads any bytes as a project file ("glTF…"), as a document or as the JSON and binary chunk of one
/// ("{…", binary behind the first zero byte), else as a journal (lines: a base, then records, whose
/// check sums are set right). What comes of it must be the same after writing and reading. Returns what
/// went wrong, empty when nothing did.
std::string tryProject(std::span<const std::uint8_t> input);

/// Reads any bytes as a picture file of any use. Returns what went wrong.
std::string tryPicture(std::span<const std::uint8_t> input);

/// The text of a version, '1' … the last one as the first byte (else of the last one), with these bytes in it and the
/// check sum set right.
std::string shareTextOf(std::span<const std::uint8_t> input);

/// Reads any bytes as shareTextOf them. What comes of it must give a text that reads as the same. Returns what went
/// wrong.
std::string tryShare(std::span<const std::uint8_t> input);

}  // namespace spineloft::testing
