#include "engine/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "engine/cli/files.h"
#include "engine/document/document.h"

namespace spineloft::cli {
namespace {

constexpr std::array<std::string_view, 7> kCommands{"loft", "make", "open", "share", "edges", "bench", "ode"};
constexpr const char* kModelFile =
    ".glb (metres), .obj, .zip (OBJ with its picture), .stl, .3mf (millimetres) or .spineloft; the first and the last "
    "can "
    "be opened again and edited";

/// "loft, open or share", with `word` before the last.
std::string commandList(const std::string& word) {
  std::string list;
  for (const std::string_view& command : kCommands) {
    if (!list.empty()) list += &command == &kCommands.back() ? " " + word + " " : ", ";
    list += command;
  }
  return list;
}

bool isHelp(std::string_view word) { return word == "--help" || word == "-h"; }

std::string lowerExtension(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos) return {};
  std::string extension = path.substr(dot + 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

template <class Names>
std::vector<std::string> keysOf(const Names& names) {
  std::vector<std::string> keys;
  for (const auto& name : names) keys.emplace_back(name.key);
  return keys;
}

std::string listOf(const std::vector<std::string>& keys) { return CLI::detail::join(keys, ", "); }

/// One of these words.
CLI::Validator oneOf(const std::vector<std::string>& keys) {
  const std::string listed = listOf(keys);
  const auto check = [keys, listed](const std::string& word) {
    return std::ranges::find(keys, word) != keys.end() ? "" : "there is no " + word + "; there are " + listed;
  };
  return CLI::Validator(check, "");
}

/// A file that has one form only must not have the name of another.
CLI::Validator endsIn(const std::string& ending) {
  const auto check = [ending](const std::string& name) {
    return lowerExtension(name) == ending ? "" : name + " must end in ." + ending;
  };
  return CLI::Validator(check, "");
}

/// The same for texts, whose names may also have no ending at all.
CLI::Validator endsInIfAtAll(const std::string& ending) {
  const auto check = [ending](const std::string& name) {
    const std::string has = lowerExtension(name);
    return has.empty() || has == ending ? "" : name + " must end in ." + ending;
  };
  return CLI::Validator(check, "");
}

CLI::Validator modelFile() {
  const auto check = [](const std::string& name) {
    return publish::formatFromKey(lowerExtension(name))
               ? ""
               : name + " must end in .glb, .obj, .zip, .stl, .3mf or .spineloft";
  };
  return CLI::Validator(check, "");
}

std::optional<double> numberOf(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A number in a range; CLI11's own range lets "nan" through.
CLI::Validator inRange(double least, double most, bool whole = false) {
  std::ostringstream range;
  range << (whole ? "a whole number from " : "a number from ") << least << " to " << most;
  const auto check = [least, most, whole, words = range.str()](const std::string& text) {
    const auto value = numberOf(text);
    const bool fits = value && *value >= least && *value <= most && (!whole || *value == std::floor(*value));
    return fits ? "" : words + " is wanted, not " + (text.empty() ? "nothing" : text);
  };
  return CLI::Validator(check, "");
}

/// The program's commands, which write what they read into their arguments.
class CommandLine {
 public:
  CommandLine() {
    app_.name("spineloft");
    app_.description("spineloft " SPINELOFT_VERSION ": a picture and one stroke become a solid part");
    app_.add_flag("--version")->description("the version");
    app_.require_subcommand(1);
    app_.footer("Exit code: 0 success, 2 wrong usage, 3 bad input or output.\n");
    addLoft(*app_.add_subcommand("loft", "a picture and a stroke become a part"));
    addMake(*app_.add_subcommand("make", "a recipe with any number of pictures becomes a model"));
    addOpen(*app_.add_subcommand("open", "derives a saved model again and writes it in any of the forms of loft"));
    addShare(*app_.add_subcommand("share", "prints a saved model as a short text, which a link or a QR code holds"));
    addEdges(*app_.add_subcommand("edges", "the edges that were found, as large as the picture"));
    addBench(*app_.add_subcommand("bench", "accuracy and stage times of every case below a data folder"));
    addOde(*app_.add_subcommand("ode", "the curves that shapes are made with, beside finite differences of them"));
  }

  std::string help() const { return app_.help("", CLI::AppFormatMode::All); }

  Arguments parse(std::span<const std::string_view> words);

 private:
  void addLoft(CLI::App& app);
  void addMake(CLI::App& app);
  void addOpen(CLI::App& app);
  void addShare(CLI::App& app);
  void addEdges(CLI::App& app);
  void addBench(CLI::App& app);
  void addOde(CLI::App& app);
  std::optional<UsageProblem> problemOfLoft() const;
  std::optional<UsageProblem> problemOfMake() const;

  CLI::App app_;
  LoftArguments loft_;
  MakeArguments make_;
  OpenArguments open_;
  ShareArguments share_;
  EdgesArguments edges_;
  BenchArguments bench_;
  OdeArguments ode_;
  CLI::Option *section_ = nullptr, *caps_ = nullptr, *objSpace_ = nullptr;
};

void CommandLine::addLoft(CLI::App& app) {
  app.add_option("IMAGE", loft_.image, "the picture to loft from")->type_name("");
  app.add_option("--stroke", loft_.stroke, "JSON: a list of [x, y] picture pixels, or {\"spines\": {name: list}}")
      ->option_text("FILE");
  app.add_option("--stroke-name", loft_.strokeName, "which of the spines (default: the first)")->option_text("NAME");
  app.add_option_function<std::string>(
         "--stroke-ends", [this](const std::string& ends) { loft_.wholeStroke = ends == "keep"; },
         "cut (default): what clearly went past the thing is left off; keep")
      ->check(oneOf({"cut", "keep"}))
      ->option_text("WHAT");
  section_ = app.add_option_function<std::string>(
      "--section", [this](const std::string& key) { loft_.section = *sections::sectionFromKey(key); },
      listOf(keysOf(sections::sectionNames())));
  section_->check(oneOf(keysOf(sections::sectionNames())))->option_text("NAME");
  caps_ = app.add_option_function<std::string>(
      "--caps", [this](const std::string& key) { loft_.caps = *sections::capFromKey(key); },
      listOf(keysOf(sections::capNames())));
  caps_->check(oneOf(keysOf(sections::capNames())))->option_text("NAME");
  app.add_option(
         "--recipe", loft_.recipe,
         "instead of --section and --caps: JSON of a part or of a whole document, as projects hold it, or of a "
         "drawing of lines; then IMAGE and --stroke are only needed where the recipe has no picture or no stroke "
         "of its own")
      ->option_text("FILE");
  std::ostringstream height;
  height << "height of the model in GLB and STL (default " << document::Document{}.height.value << ")";
  app.add_option_function<std::string>(
         "--height-mm", [this](const std::string& text) { loft_.heightMm = numberOf(text); }, height.str())
      ->check(inRange(document::kMinHeightMm, document::kMaxHeightMm))
      ->option_text("N");
  app.add_option("--out", loft_.out, kModelFile)->check(modelFile())->option_text("FILE");
  objSpace_ = app.add_option_function<std::string>(
      "--obj-space", [this](const std::string& space) { loft_.objInPicture = space == "image"; },
      "world (default: y up, millimetres) or image (picture pixels, y down, z towards the viewer)");
  objSpace_->check(oneOf({"image", "world"}))->option_text("SPACE");
  app.add_option("--mask", loft_.mask, "the part's silhouette, as large as the picture")
      ->check(endsIn("png"))
      ->option_text("FILE.png");
  app.add_option("--ribs", loft_.ribs, "the ribs' ends in picture pixels")
      ->check(endsInIfAtAll("json"))
      ->option_text("FILE.json");
  app.add_option("--report", loft_.report, "sizes, energy, mesh measures and times")
      ->check(endsInIfAtAll("json"))
      ->option_text("FILE.json");
}

/// "ID=FILE".
std::optional<std::pair<PictureId, std::string>> pictureOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  const auto id = numberOf(text.substr(0, equals));
  if (equals == std::string::npos || equals + 1 == text.size() || !id || !(*id >= 1 && *id <= 1e6)) return std::nullopt;
  if (*id != std::floor(*id)) return std::nullopt;
  return std::pair(PictureId{static_cast<std::uint32_t>(*id)}, text.substr(equals + 1));
}

void CommandLine::addMake(CLI::App& app) {
  const CLI::Validator named(
      [](const std::string& text) { return pictureOf(text) ? "" : "ID=FILE is wanted, not " + text; }, "");
  app.add_option("--recipe", make_.recipe, "JSON of a part or of a whole document, as projects hold it")
      ->required()
      ->option_text("FILE.json");
  app.add_option_function<std::vector<std::string>>(
         "--picture",
         [this](const std::vector<std::string>& all) {
           for (const std::string& text : all) make_.pictures.push_back(*pictureOf(text));
         },
         "the photo of a picture of the recipe; once for each")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(named)
      ->option_text("ID=FILE");
  app.add_option("--out", make_.out, kModelFile)->check(modelFile())->option_text("FILE");
  app.add_option("--silhouettes", make_.silhouettes, "a folder for the silhouettes from front, side and top")
      ->option_text("DIR");
  app.add_option("--report", make_.report, "mesh measures, times, and how well silhouettes are the drawn outlines")
      ->check(endsInIfAtAll("json"))
      ->option_text("FILE.json");
}

void CommandLine::addOpen(CLI::App& app) {
  app.add_option("FILE", open_.file, "the project to open, .spineloft or .glb, or a link with a model, or its text")
      ->required()
      ->type_name("");
  app.add_option("--out", open_.out, kModelFile)->check(modelFile())->option_text("FILE");
  app.add_option("--document", open_.document, "the document as JSON")
      ->check(endsInIfAtAll("json"))
      ->option_text("FILE.json");
  app.add_option("--report", open_.report, "counts and times")->check(endsInIfAtAll("json"))->option_text("FILE.json");
}

void CommandLine::addShare(CLI::App& app) {
  app.add_option("FILE", share_.file, "the project, .spineloft or .glb")->required()->type_name("");
}

void CommandLine::addEdges(CLI::App& app) {
  app.add_option("IMAGE", edges_.image, "the picture whose edges are wanted")->required()->type_name("");
  app.add_option("--out", edges_.out, "the edges")->required()->check(endsIn("png"))->option_text("FILE.png");
}

void CommandLine::addBench(CLI::App& app) {
  app.add_option("DATA_DIR", bench_.folder, "the folder with the cases")->required()->type_name("");
  app.add_option("--json", bench_.json, "the report")->check(endsInIfAtAll("json"))->option_text("FILE.json");
  app.add_option("--jobs", bench_.jobs, "cases at a time (default 1)")->check(inRange(1, 64, true))->option_text("N");
  app.add_option("--overlays", bench_.overlays, "a folder for pictures of what was found")->option_text("DIR");
}

void CommandLine::addOde(CLI::App& app) {
  app.add_option("--case", ode_.file,
                 "JSON: {\"ends\": [a, b], \"slopes\": [m, n], \"lambda\": L, \"n\": N} of an interval, or {\"ring\": "
                 "[[place, value], ...], \"lambda\": L, \"n\": N} with places that are multiples of 1 / N")
      ->required()
      ->option_text("FILE.json");
}

/// Outputs must not fall on one another or on an input; empty names are none.
std::optional<UsageProblem> clash(std::span<const std::string> inputs, std::span<const std::string> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) continue;
    for (const std::string& input : inputs) {
      if (!input.empty() && samePlace(outputs[i], input))
        return UsageProblem{"The output " + outputs[i] + " would replace an input."};
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!outputs[j].empty() && samePlace(outputs[i], outputs[j]))
        return UsageProblem{"Two outputs have the same name, " + outputs[i] + "."};
    }
  }
  return std::nullopt;
}

/// What the options of a loft must be together.
std::optional<UsageProblem> CommandLine::problemOfLoft() const {
  if (loft_.image.empty() && loft_.recipe.empty()) return UsageProblem{"Name the picture to loft from."};
  if (loft_.stroke.empty() && loft_.recipe.empty()) return UsageProblem{"Name the stroke's file with --stroke."};
  if (objSpace_->count() > 0 &&
      (loft_.out.empty() || publish::formatFromKey(lowerExtension(loft_.out)) != publish::Format::Obj))
    return UsageProblem{"The option --obj-space needs an --out that ends in .obj."};
  if (!loft_.recipe.empty() && section_->count() + caps_->count() > 0)
    return UsageProblem{"The section and the caps stand in the recipe; leave --section and --caps out."};
  return clash(std::array{loft_.image, loft_.stroke, loft_.recipe},
               std::array{loft_.out, loft_.mask, loft_.ribs, loft_.report});
}

std::optional<UsageProblem> CommandLine::problemOfMake() const {
  std::vector<std::string> inputs{make_.recipe};
  for (const auto& [id, file] : make_.pictures) {
    inputs.push_back(file);
    if (std::ranges::count(make_.pictures, id, &std::pair<PictureId, std::string>::first) > 1)
      return UsageProblem{"Picture " + std::to_string(id.value) + " is named twice."};
  }
  return clash(inputs, std::array{make_.out, make_.report});
}

/// What CLI11 says, as one sentence.
UsageProblem problemOf(const CLI::ParseError& problem) {
  std::string words = problem.what();
  const std::string name = words.substr(0, words.find(':'));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&problem) != nullptr) {
    return {"The option " + name + (words.ends_with("missing") ? " needs a value." : " is given twice.")};
  }
  return {(words.starts_with("--") ? "The option " : "") + words + "."};
}

Arguments CommandLine::parse(std::span<const std::string_view> words) {
  try {
    app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& problem) {
    return problemOf(problem);
  }
  if (app_.got_subcommand("loft")) {
    if (const auto problem = problemOfLoft()) return *problem;
    loft_.format = publish::formatFromKey(lowerExtension(loft_.out)).value_or(loft_.format);
    return loft_;
  }
  if (app_.got_subcommand("make")) {
    if (const auto problem = problemOfMake()) return *problem;
    make_.format = publish::formatFromKey(lowerExtension(make_.out)).value_or(make_.format);
    return make_;
  }
  if (app_.got_subcommand("open")) {
    if (const auto problem = clash({&open_.file, 1}, std::array{open_.out, open_.document, open_.report}))
      return *problem;
    open_.format = publish::formatFromKey(lowerExtension(open_.out)).value_or(open_.format);
    return open_;
  }
  if (app_.got_subcommand("share")) return share_;
  if (app_.got_subcommand("edges")) {
    if (const auto problem = clash({&edges_.image, 1}, {&edges_.out, 1})) return *problem;
    return edges_;
  }
  if (app_.got_subcommand("ode")) return ode_;
  return bench_;
}

}  // namespace

Arguments parseArguments(std::span<const std::string_view> words) {
  if (words.empty()) return UsageProblem{"Say what to do: " + commandList("or") + "."};
  const auto files = std::find(words.begin(), words.end(), "--");
  if (std::any_of(words.begin(), files, isHelp)) return HelpArguments{};
  if (words[0] == "--version") {
    if (words.size() > 1) return UsageProblem{"The option --version stands alone."};
    return VersionArguments{};
  }
  if (std::ranges::find(kCommands, words[0]) == kCommands.end())
    return UsageProblem{"There is no command " + std::string(words[0]) + "; there are " + commandList("and") + "."};
  return CommandLine().parse(words);
}

std::string usageText() { return CommandLine().help(); }

}  // namespace spineloft::cli
