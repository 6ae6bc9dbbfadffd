#include "engine/cli/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "engine/cli/files.h"
#include "engine/document/document.h"

namespace spineloft::cli {
namespace {

/// Words sorted into files and options.
struct Words {
  std::vector<std::string> files;
  std::map<std::string, std::string, std::less<>> options;
  std::string problem;

  std::string option(std::string_view name) const {
    const auto at = options.find(name);
    return at == options.end() ? std::string() : at->second;
  }
  bool has(std::string_view name) const { return options.find(name) != options.end(); }
};

bool isHelp(std::string_view word) { return word == "--help" || word == "-h"; }

Words sortWords(std::span<const std::string_view> words, std::span<const std::string_view> known) {
  Words out;
  bool onlyFiles = false;
  for (std::size_t i = 0; i < words.size() && out.problem.empty(); ++i) {
    const std::string_view word = words[i];
    if (onlyFiles || word.size() < 2 || word[0] != '-') {
      out.files.emplace_back(word);
    } else if (word == "--") {
      onlyFiles = true;
    } else {
      const std::size_t equals = word.find('=');
      const std::string name(word.substr(0, equals));
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        out.problem = "There is no option " + name + " here.";
      } else if (out.has(name)) {
        out.problem = "The option " + name + " is given twice.";
      } else if (equals != std::string_view::npos) {
        out.options[name] = word.substr(equals + 1);
      } else if (i + 1 < words.size()) {
        out.options[name] = words[++i];
      } else {
        out.problem = "The option " + name + " needs a value.";
      }
      if (out.problem.empty() && out.options[name].empty()) {
        out.problem = "The option " + name + " needs a value.";
      }
    }
  }
  return out;
}

std::optional<double> numberOf(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

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
std::string keysOf(const Names& names) {
  std::string keys;
  for (const auto& name : names) keys += (keys.empty() ? "" : ", ") + std::string(name.key);
  return keys;
}

UsageProblem oneFile(const Words& words, const char* what) {
  if (words.files.empty()) return {std::string("Name ") + what + "."};
  return {"There is one file name too many, " + words.files[1] + "."};
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
      if (!outputs[j].empty() && samePlace(outputs[i], outputs[j])) {
        return UsageProblem{"Two outputs have the same name, " + outputs[i] + "."};
      }
    }
  }
  return std::nullopt;
}

/// Fills in section, caps and height.
std::optional<UsageProblem> readShape(const Words& words, LoftArguments& loft) {
  if (words.has("--section")) {
    const auto section = loft::sectionFromKey(words.option("--section"));
    if (!section) {
      return UsageProblem{"There is no section " + words.option("--section") + "; there are " +
                          keysOf(loft::sectionNames()) + "."};
    }
    loft.section = *section;
  }
  if (words.has("--caps")) {
    const auto caps = loft::capFromKey(words.option("--caps"));
    if (!caps) {
      return UsageProblem{"There are no caps " + words.option("--caps") + "; there are " + keysOf(loft::capNames()) +
                          "."};
    }
    loft.caps = *caps;
  }
  if (words.has("--height-mm")) {
    const auto height = numberOf(words.option("--height-mm"));
    if (!height || *height < document::kMinHeightMm || *height > document::kMaxHeightMm) {
      std::ostringstream range;
      range << document::kMinHeightMm << " to " << document::kMaxHeightMm;
      return UsageProblem{"The height must be a number of millimetres from " + range.str() + "."};
    }
    loft.heightMm = *height;
  }
  return std::nullopt;
}

/// The form of a model's file, from its name.
std::optional<UsageProblem> readFormat(const std::string& out, publish::Format& format) {
  if (out.empty()) return std::nullopt;
  const auto known = publish::formatFromKey(lowerExtension(out));
  if (!known) {
    return UsageProblem{"The output " + out + " must end in .glb, .obj, .zip, .stl, .3mf or .spineloft."};
  }
  format = *known;
  return std::nullopt;
}

/// A file that has one form only must not have the name of another.
std::optional<UsageProblem> needsEnding(const std::string& out, std::string_view ending) {
  if (out.empty() || lowerExtension(out) == ending) return std::nullopt;
  return UsageProblem{"The output " + out + " must end in ." + std::string(ending) + "."};
}

/// The same for texts, whose names may also have no ending at all.
std::optional<UsageProblem> needsEndingIfAny(const std::string& out, std::string_view ending) {
  return lowerExtension(out).empty() ? std::nullopt : needsEnding(out, ending);
}

/// Fills in what is written, and in which form.
std::optional<UsageProblem> readOutputs(const Words& words, LoftArguments& loft) {
  loft.out = words.option("--out");
  loft.mask = words.option("--mask");
  loft.ribs = words.option("--ribs");
  loft.report = words.option("--report");
  if (const auto problem = readFormat(loft.out, loft.format)) return problem;
  if (const auto problem = needsEnding(loft.mask, "png")) return problem;
  for (const std::string& text : {loft.ribs, loft.report}) {
    if (const auto problem = needsEndingIfAny(text, "json")) return problem;
  }
  if (words.has("--obj-space")) {
    const std::string space = words.option("--obj-space");
    if (space != "image" && space != "world") {
      return UsageProblem{"The OBJ space must be image or world."};
    }
    if (loft.out.empty() || loft.format != publish::Format::Obj) {
      return UsageProblem{"The option --obj-space needs an --out that ends in .obj."};
    }
    loft.objInPicture = space == "image";
  }
  const std::array inputs{loft.image, loft.stroke, loft.recipe};
  const std::array outputs{loft.out, loft.mask, loft.ribs, loft.report};
  return clash(inputs, outputs);
}

Arguments parseLoft(std::span<const std::string_view> rest) {
  static constexpr std::array<std::string_view, 12> kKnown{
      "--stroke",    "--stroke-name", "--stroke-ends", "--recipe", "--section", "--caps",
      "--height-mm", "--out",         "--mask",        "--ribs",   "--report",  "--obj-space"};
  const Words words = sortWords(rest, kKnown);
  if (!words.problem.empty()) return UsageProblem{words.problem};
  LoftArguments loft;
  loft.stroke = words.option("--stroke");
  loft.strokeName = words.option("--stroke-name");
  loft.recipe = words.option("--recipe");
  if (words.files.size() > 1 || (words.files.empty() && loft.recipe.empty())) {
    return oneFile(words, "the picture to loft from");
  }
  if (!words.files.empty()) loft.image = words.files[0];
  if (loft.stroke.empty() && loft.recipe.empty()) {
    return UsageProblem{"Name the stroke's file with --stroke."};
  }
  if (!loft.recipe.empty() && (words.has("--section") || words.has("--caps"))) {
    return UsageProblem{"The section and the caps stand in the recipe; leave --section and --caps out."};
  }
  if (words.has("--stroke-ends")) {
    const std::string& ends = words.option("--stroke-ends");
    if (ends != "cut" && ends != "keep") {
      return UsageProblem{"What to do with the stroke's ends must be cut or keep."};
    }
    loft.wholeStroke = ends == "keep";
  }
  if (const auto problem = readShape(words, loft)) return *problem;
  if (const auto problem = readOutputs(words, loft)) return *problem;
  return loft;
}

Arguments parseEdges(std::span<const std::string_view> rest) {
  static constexpr std::array<std::string_view, 1> kKnown{"--out"};
  const Words words = sortWords(rest, kKnown);
  if (!words.problem.empty()) return UsageProblem{words.problem};
  if (words.files.size() != 1) return oneFile(words, "the picture whose edges are wanted");
  if (!words.has("--out")) return UsageProblem{"Name the output with --out FILE.png."};
  EdgesArguments edges{words.files[0], words.option("--out")};
  if (const auto problem = needsEnding(edges.out, "png")) return *problem;
  if (const auto problem = clash(std::array{edges.image}, std::array{edges.out})) return *problem;
  return edges;
}

Arguments parseOpen(std::span<const std::string_view> rest) {
  static constexpr std::array<std::string_view, 3> kKnown{"--out", "--document", "--report"};
  const Words words = sortWords(rest, kKnown);
  if (!words.problem.empty()) return UsageProblem{words.problem};
  if (words.files.size() != 1) return oneFile(words, "the project to open");
  OpenArguments open;
  open.file = words.files[0];
  open.out = words.option("--out");
  open.document = words.option("--document");
  open.report = words.option("--report");
  if (const auto problem = readFormat(open.out, open.format)) return *problem;
  for (const std::string& text : {open.document, open.report}) {
    if (const auto problem = needsEndingIfAny(text, "json")) return *problem;
  }
  const std::array outputs{open.out, open.document, open.report};
  if (const auto problem = clash(std::array{open.file}, outputs)) return *problem;
  return open;
}

struct Range {
  int least, most;
};

/// A whole number in a range, where the option is given.
std::optional<UsageProblem> readWhole(const Words& words, std::string_view option, std::string_view what, Range range,
                                      int& number) {
  if (!words.has(option)) return std::nullopt;
  const auto value = numberOf(words.option(option));
  if (!value || !(*value >= range.least && *value <= range.most) || *value != std::floor(*value)) {
    return UsageProblem{std::string(what) + " must be a whole number from " + std::to_string(range.least) + " to " +
                        std::to_string(range.most) + "."};
  }
  number = static_cast<int>(*value);
  return std::nullopt;
}

Arguments parseBench(std::span<const std::string_view> rest) {
  static constexpr std::array<std::string_view, 3> kKnown{"--json", "--jobs", "--overlays"};
  const Words words = sortWords(rest, kKnown);
  if (!words.problem.empty()) return UsageProblem{words.problem};
  if (words.files.size() != 1) return oneFile(words, "the folder with the cases");
  BenchArguments bench;
  bench.folder = words.files[0];
  bench.json = words.option("--json");
  bench.overlays = words.option("--overlays");
  if (const auto problem = needsEndingIfAny(bench.json, "json")) return *problem;
  if (const auto problem = readWhole(words, "--jobs", "The number of jobs", {1, 64}, bench.jobs)) return *problem;
  return bench;
}

}  // namespace

Arguments parseArguments(std::span<const std::string_view> words) {
  if (words.empty()) return UsageProblem{"Say what to do: loft, open, edges or bench."};
  const auto files = std::find(words.begin(), words.end(), "--");
  if (std::any_of(words.begin(), files, isHelp)) return HelpArguments{};
  if (words[0] == "--version") {
    if (words.size() > 1) return UsageProblem{"The option --version stands alone."};
    return VersionArguments{};
  }
  const std::span<const std::string_view> rest = words.subspan(1);
  if (words[0] == "loft") return parseLoft(rest);
  if (words[0] == "open") return parseOpen(rest);
  if (words[0] == "edges") return parseEdges(rest);
  if (words[0] == "bench") return parseBench(rest);
  return UsageProblem{"There is no command " + std::string(words[0]) + "; there are loft, open, edges and bench."};
}

std::string usageText() {
  std::ostringstream text;
  text << "spineloft " SPINELOFT_VERSION
          ": a picture and one stroke become a solid part\n\n"
          "spineloft loft IMAGE --stroke FILE [options]\n"
          "  --stroke FILE        JSON: a list of [x, y] picture pixels, or {\"spines\": {name: "
          "list}}\n"
          "  --stroke-name NAME   which of the spines (default: the first)\n"
          "  --stroke-ends WHAT   cut (default): what clearly went past the thing is left off; keep\n"
          "  --recipe FILE        instead of --section and --caps: JSON of a part or of a whole\n"
          "                       document, as projects hold it; then IMAGE and --stroke are only\n"
          "                       needed where the recipe has no picture or no stroke of its own\n"
          "  --section NAME       "
       << keysOf(loft::sectionNames()) << "\n  --caps NAME          " << keysOf(loft::capNames())
       << "\n"
          "  --height-mm N        height of the model in GLB and STL, "
       << document::kMinHeightMm << " to " << document::kMaxHeightMm << " (default "
       << document::Document{}.height.value
       << ")\n"
          "  --out FILE           .glb (metres), .obj, .zip (OBJ with its picture), .stl, .3mf (millimetres) or "
          ".spineloft; the first and\n"
          "                       the last can be opened again and edited\n"
          "  --obj-space SPACE    world (default: y up, millimetres) or image\n"
          "                       (picture pixels, y down, z towards the viewer)\n"
          "  --mask FILE.png      the part's silhouette, as large as the picture\n"
          "  --ribs FILE.json     the ribs' ends in picture pixels\n"
          "  --report FILE.json   sizes, energy, mesh measures and times\n\n"
          "spineloft open FILE.spineloft|.glb [--out FILE] [--document FILE.json] [--report "
          "FILE.json]\n"
          "  derives a saved model again and writes it in any of the forms of loft\n\n"
          "spineloft edges IMAGE --out FILE.png\n"
          "  the edges that were found, as large as the picture\n\n"
          "spineloft bench DATA_DIR [--json FILE] [--jobs N] [--overlays DIR]\n"
          "  accuracy and stage times of every case below a data folder\n\n"
          "spineloft --help | --version\n\n"
          "Exit code: 0 success, 2 wrong usage, 3 bad input or output.\n";
  return text.str();
}

}  // namespace spineloft::cli
