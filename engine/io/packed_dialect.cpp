#include "engine/io/packed_dialect.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/io/packed_example.h"
#include "engine/io/packed_json.h"
#include "engine/io/packed_links.h"
#include "engine/io/packed_parts.h"
#include "engine/io/packed_traces.h"

namespace spineloft::io {
namespace {

using Json = nlohmann::json;

constexpr std::array<Dialect, kPackedVersion> kDialects{{
    {5, 3, 5, false, false, {8}, {kPackedExample}, Traced::None, false},
    {8,
     3,
     6,
     true,
     false,
     {8},
     {kPackedExample, kPackedPart1, kPackedPart2, kPackedPart3, kPackedPart4, kPackedPart5, kPackedPart6, kPackedPart7},
     Traced::None,
     false},
    {9, 4, 6, true, true, {5}, {kPackedExample}, Traced::Ribs, false},
    {11, 4, 6, true, true, {5}, {kPackedExample}, Traced::Ribs, true},
    {11, 4, 6, true, true, {5}, {kPackedExample, kPackedWords}, Traced::RibsAndFans, true},
    {14,
     4,
     6,
     true,
     true,
     {5, 64, 4096, 3},
     {kPackedExample, kPackedWords, kPackedLaterWords},
     Traced::Linked,
     true,
     true},
}};

void collectWords(const Json& value, std::set<std::string>& words) {
  if (value.is_string()) words.insert(value.get<std::string>());
  if (!value.is_structured()) return;
  for (const auto& [key, element] : value.items()) {
    if (value.is_object()) words.insert(key);
    collectWords(element, words);
  }
}

template <int version>
const Example& exampleOnce() {
  static const Example made = [] {
    Example out;
    std::set<std::string> words;
    for (const std::string_view text : kDialects[version - 1].examples) {
      if (text.empty()) continue;
      out.documents.push_back(Json::parse(text, nullptr, false));
      collectWords(out.documents.back(), words);
    }
    out.words.assign(words.begin(), words.end());
    const Traced traced = kDialects[version - 1].traced;
    if (traced == Traced::Linked) {
      std::ranges::move(linkedModels(), std::back_inserter(out.documents));
    } else if (traced != Traced::None) {
      std::ranges::move(tracedModels(traced == Traced::RibsAndFans), std::back_inserter(out.documents));
    }
    return out;
  }();
  return made;
}
}  // namespace

const Dialect& dialectOf(int version) { return kDialects[static_cast<std::size_t>(version - 1)]; }

const Example& exampleOf(int version) {
  static constexpr std::array kOnce{exampleOnce<1>, exampleOnce<2>, exampleOnce<3>,
                                    exampleOnce<4>, exampleOnce<5>, exampleOnce<6>};
  static_assert(kOnce.size() == kPackedVersion);
  return kOnce[static_cast<std::size_t>(version - 1)]();
}

}  // namespace spineloft::io
