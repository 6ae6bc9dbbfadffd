// The program without its main: arguments in, exit code out.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/cli/command_line.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

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

/// Says on `err` which solids of the document this program writes as the parts they are made of: it has no solver.
/// Nothing where there are none.
void reportSeparateParts(const document::Document& document, std::ostream& err);

/// Says on `err` which visible parts go through themselves: a page with a solver would mend them. Nothing where none
/// does.
void reportCrossingParts(const document::Document& document, const pipeline::Derived& derived, std::ostream& err);

/// Milliseconds from a steady clock.
double nowMs();

Status runLoft(const LoftArguments& arguments, Console console);
/// The same for a recipe that is a bare drawing (io/drawing_file.h), whose text this is.
Status runDrawing(const LoftArguments& arguments, const std::string& text, Console console);
Status runMake(const MakeArguments& arguments, Console console);
Status runOpen(const OpenArguments& arguments, Console console);
Status runShare(const ShareArguments& arguments, Console console);
Status runEdges(const EdgesArguments& arguments, std::ostream& out);
Status runBench(const BenchArguments& arguments, std::ostream& out);
/// Prints {"closed": […], "differences": […], "largest": …} of the case. Error: JsonInvalid with what is wrong.
Status runOde(const OdeArguments& arguments, std::ostream& out);

}  // namespace spineloft::cli
