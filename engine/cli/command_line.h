// The words of the command line, checked before any work begins.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/ids.h"
#include "engine/loft/loft.h"
#include "engine/publish/publish.h"
#include "engine/sections/section.h"

namespace spineloft::cli {

struct HelpArguments {};
struct VersionArguments {};

struct LoftArguments {
  std::string image;       ///< empty only with a recipe
  std::string stroke;      ///< empty only with a recipe
  std::string strokeName;  ///< empty: the first in the file
  std::string recipe;      ///< JSON of a part or of a whole document; says section and caps
  sections::SectionPreset section = sections::SectionPreset::Circle;
  sections::CapStyle caps = sections::CapStyle::Round;
  std::optional<double> heightMm;  ///< without: the recipe's, or the usual one
  /// Empty where the output is not wanted.
  std::string out, mask, ribs, report;
  publish::Format format = publish::Format::Glb;  ///< of `out`
  bool objInPicture = false;                      ///< OBJ in picture pixels, y down
  bool wholeStroke = false;                       ///< the stroke is not cut to the thing under it (ribs/overshoot.h)
};

struct EdgesArguments {
  std::string image, out;
};

struct OpenArguments {
  std::string file;  ///< a .spineloft or .glb with a project inside, or the text of a shared model
  /// Empty where the output is not wanted.
  std::string out, document, report;
  publish::Format format = publish::Format::Project;  ///< of `out`
};

struct ShareArguments {
  std::string file;  ///< as OpenArguments::file
};

struct OdeArguments {
  std::string file;
};

struct MakeArguments {
  std::string recipe;
  std::vector<std::pair<PictureId, std::string>> pictures;  ///< photos of its pictures
  /// Empty where the output is not wanted; `silhouettes` is a folder.
  std::string out, silhouettes, report;
  publish::Format format = publish::Format::Glb;  ///< of `out`
};

struct BenchArguments {
  std::string folder;
  std::string json, overlays;  ///< empty where not wanted
  int jobs = 1;                ///< 1…64
};

/// What is wrong with the words, in one sentence.
struct UsageProblem {
  std::string sentence;
};

using Arguments = std::variant<HelpArguments, VersionArguments, LoftArguments, EdgesArguments, OpenArguments,
                               ShareArguments, BenchArguments, OdeArguments, MakeArguments, UsageProblem>;

/// `words` without the program's name. Options may stand anywhere, as `--name value` or
/// `--name=value`, each at most once; after `--` everything is a file name.
Arguments parseArguments(std::span<const std::string_view> words);

/// What `--help` prints.
std::string usageText();

}  // namespace spineloft::cli
