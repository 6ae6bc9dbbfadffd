// What the fuzzer of whole documents and its replay do with one input.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace spineloft::testing {

/// Takes any bytes as a document: the first name a random session, how long it goes on, and a format of files; the
/// others change numbers in its text. What can be read of that is derived, planned for the solver of solids, and
/// written in that format. Returns what is wrong with what came out, empty when nothing is.
std::string tryDocument(std::span<const std::uint8_t> input);

}  // namespace spineloft::testing
