// The program without its main: arguments in, exit code out.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/cli/arguments.h"

namespace spineloft::cli {

inline constexpr int kExitSuccess = 0, kExitUsage = 2, kExitInput = 3;

/// Where a command writes for people to read.
struct Console {
  std::ostream& out;
  std::ostream& err;
};

/// Runs one command; returns the exit code. What went wrong is one sentence on `err`.
int run(std::span<const std::string_view> words, Console console);

/// The failure as one sentence: "That file is empty (cat.png)."
std::string sentenceOf(const Failure& failure);

/// Milliseconds from a steady clock.
double nowMs();

Status runLoft(const LoftArguments& arguments, std::ostream& out);
Status runOpen(const OpenArguments& arguments, std::ostream& out);
Status runEdges(const EdgesArguments& arguments, std::ostream& out);
Status runBench(const BenchArguments& arguments, std::ostream& out);

}  // namespace spineloft::cli
