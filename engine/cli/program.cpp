#include "engine/cli/program.h"

#include <chrono>
#include <exception>
#include <ostream>
#include <variant>

#include "engine/cli/printable.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/solid.h"

namespace spineloft::cli {
namespace {

/// To a list that is one line.
void addName(const std::string& name, std::string& names) { names += (names.empty() ? "" : ", ") + onOneLine(name); }

int finish(const Status& status, std::ostream& err) {
  if (status.ok()) return kExitSuccess;
  err << "spineloft: " << sentenceOf(status.failure()) << '\n';
  return kExitInput;
}

int runCommand(const Arguments& arguments, Console console) {
  if (std::holds_alternative<HelpArguments>(arguments)) {
    console.out << usageText();
    return kExitSuccess;
  }
  if (std::holds_alternative<VersionArguments>(arguments)) {
    console.out << "spineloft " SPINELOFT_VERSION "\n";
    return kExitSuccess;
  }
  if (const auto* loft = std::get_if<LoftArguments>(&arguments)) {
    return finish(runLoft(*loft, console), console.err);
  }
  if (const auto* make = std::get_if<MakeArguments>(&arguments)) {
    return finish(runMake(*make, console), console.err);
  }
  if (const auto* open = std::get_if<OpenArguments>(&arguments)) {
    return finish(runOpen(*open, console), console.err);
  }
  if (const auto* share = std::get_if<ShareArguments>(&arguments)) {
    return finish(runShare(*share, console), console.err);
  }
  if (const auto* edges = std::get_if<EdgesArguments>(&arguments)) {
    return finish(runEdges(*edges, console.out), console.err);
  }
  if (const auto* bench = std::get_if<BenchArguments>(&arguments)) {
    return finish(runBench(*bench, console.out), console.err);
  }
  if (const auto* ode = std::get_if<OdeArguments>(&arguments)) {
    return finish(runOde(*ode, console.out), console.err);
  }
  std::string sentence = std::get<UsageProblem>(arguments).sentence;
  sentence.pop_back();  // the full stop moves behind the hint
  console.err << "spineloft: " << sentence << " (spineloft --help shows how).\n";
  return kExitUsage;
}

}  // namespace

int run(std::span<const std::string_view> words, Console console) {
  Printable out(console.out), err(console.err);
  const auto flushed = [&](int code) {
    out.flush();
    err.flush();
    return code;
  };
  try {
    return flushed(runCommand(parseArguments(words), {out, err}));
  } catch (const std::bad_alloc&) {
    return flushed(finish(Error::OutOfMemory, err));
  } catch (const std::exception& problem) {
    // File systems may throw where no error code can be asked for.
    return flushed(finish({Error::FileUnreadable, problem.what()}, err));
  }
}

std::string sentenceOf(const Failure& failure) {
  std::string_view words = errorSentence(failure.error);
  words = words.substr(0, words.find(". "));
  if (words.ends_with('.')) words.remove_suffix(1);
  std::string sentence(words);
  if (!failure.detail.empty()) sentence += " (" + failure.detail + ")";
  // Details may quote file names and messages with line breaks.
  return onOneLine(sentence + '.');
}

void reportSeparateParts(const document::Document& document, std::ostream& err) {
  std::string names;
  for (const document::Step& step : document.steps) {
    if (holderOf(document, {{}, step.id}) == nullptr && step.visible) addName(step.name, names);
  }
  if (names.empty()) return;
  err << "spineloft: This program does not put parts together, so these solids are written as the separate parts "
         "that they are made of ("
      << names << ").\n";
}

void reportCrossingParts(const document::Document& document, const pipeline::Derived& derived, std::ostream& err) {
  std::string names;
  for (const pipeline::DerivedPart& made : derived.parts) {
    const document::Part* part = document::findPart(document, made.id);
    if (part == nullptr || !made.shape || !showsItself(document, derived, *part)) continue;
    if (mesh::selfCrossing(made.shape->mesh)) addName(part->name, names);
  }
  if (names.empty()) return;
  err << "spineloft: These parts go through themselves and are written as they are; the page mends most such parts "
         "when it saves ("
      << names << ").\n";
}

double nowMs() {
  using Ms = std::chrono::duration<double, std::milli>;
  return Ms(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace spineloft::cli
