// spineloft_accuracy: how well the method and its variations do on a data folder.
#include <CLI/CLI.hpp>
#include <iostream>

#include "tests/bench/accuracy/accuracy.h"
#include "tests/bench/accuracy/variations.h"

namespace {

using namespace spineloft;

std::vector<std::string> variationKeys() {
  std::vector<std::string> keys;
  for (const accuracy::Variation& variation : accuracy::variations()) keys.emplace_back(variation.key);
  return keys;
}

void addOptions(CLI::App& app, accuracy::AccuracyArguments& to) {
  app.add_option("DATA_DIR", to.folder, "the folder with the cases")->required();
  app.add_option("--json", to.json, "the report");
  app.add_option("--jobs", to.jobs, "threads")->check(CLI::Range(1, 64));
  app.add_option("--overlays", to.overlays, "a folder for pictures of what was found");
  app.add_option("--variation", to.variation, "of the method")->check(CLI::IsMember(variationKeys()));
  app.add_option("--set", to.set, "KEY=VALUE: another value of a parameter");
  app.add_option("--ablation", to.ablation, "a table of all variations, Markdown");
  app.add_option("--leave-one-out", to.leaveOneOut, "a table of weights chosen without each category, Markdown");
  app.add_option("--states", to.states, "a table of how far states and probabilities of ends are true, Markdown");
  app.add_option("--live", to.live, "moves of a stroke under the pen, held against the whole trace")
      ->check(CLI::Range(10, 1000));
  app.add_option("--redraw", to.redraw, "seed of strokes drawn anew")->check(CLI::Range(1, 1000000));
  app.add_option("--erase", to.erase, "share of every outline that is blurred away first")->check(CLI::Range(0., 1.));
  app.add_option("--overshoot", to.overshoot, "half widths that strokes go past the thing's ends")
      ->check(CLI::Range(0., 3.));
}

}  // namespace

int main(int count, char** words) {
  CLI::App app{"How well the method and its variations do on a data folder"};
  accuracy::AccuracyArguments arguments;
  addOptions(app, arguments);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? cli::kExitSuccess : cli::kExitUsage;
  }
  const Status status = accuracy::runAccuracy(arguments, std::cout);
  if (status.ok()) return cli::kExitSuccess;
  std::cerr << "spineloft_accuracy: " << cli::sentenceOf(status.failure()) << '\n';
  return cli::kExitInput;
}
