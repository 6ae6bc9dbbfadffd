#include "web/words/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <unordered_map>
#include <utility>

#include "engine/base/hash.h"

namespace spineloft::words {
namespace {

constexpr std::size_t kMostRemembered = 4000;

using Memory = std::unordered_map<std::uint64_t, std::string>;

/// What is spoken, and what was asked for since.
struct Voice {
  Language language;
  Memory translated, drawn, kept;
};
Voice& voice() {
  static Voice instance;
  return instance;
}

std::string plain(double number) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%.15g", number);
  return {text, static_cast<std::size_t>(length)};
}

std::string_view spokenArg(const Arg& arg, std::string& own) {
  return arg.isNumber ? std::string_view(own = plain(arg.number)) : arg.text;
}

/// English: every {name} by its value.
std::string filledIn(std::string_view english, Args args) {
  std::string out, own;
  while (!english.empty()) {
    const std::size_t open = std::min(english.find('{'), english.size()), shut = english.find('}', open);
    out += english.substr(0, open);
    if (shut == std::string_view::npos) return out += english.substr(open);
    const std::string_view name = english.substr(open + 1, shut - open - 1);
    const auto arg = std::ranges::find(args, name, &Arg::name);
    out += arg == args.end() ? english.substr(open, shut + 1 - open) : spokenArg(*arg, own);
    english.remove_prefix(shut + 1);
  }
  return out;
}

void quote(std::string& json, std::string_view text) {
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  json += '"';
}

std::string jsonOf(Args args) {
  std::string json = "{", own;
  for (const Arg& arg : args) {
    if (json.size() > 1) json += ',';
    quote(json, arg.name);
    json += ':';
    arg.isNumber ? void(json += spokenArg(arg, own)) : quote(json, arg.text);
  }
  return json + '}';
}

std::uint64_t keyOf(std::string_view text, Args args) {
  Hasher hash;
  hash.text(text);
  for (const Arg& arg : args) {
    hash.text(arg.name);
    arg.isNumber ? hash.number(arg.number) : hash.text(arg.text);
  }
  return hash.value();
}

/// What was remembered of a key, or what `make` gives for it.
template <class Make>
std::string_view remembered(Memory& memory, std::uint64_t key, const Make& make) {
  const auto at = memory.find(key);
  return at != memory.end() ? at->second : memory.emplace(key, make()).first->second;
}

}  // namespace

std::span<const Known> known() {
  static constexpr std::array kKnown = {Known{"en", "English"}, Known{"de", "Deutsch"}, Known{"fr", "Français"},
                                        Known{"es", "Español"}, Known{"ja", "日本語"},  Known{"ar", "العربية"}};
  return kKnown;
}

void speak(Language language) { voice() = {std::move(language), {}, {}, {}}; }

const Language& language() { return voice().language; }

void forgetMuch() {
  for (Memory* memory : {&voice().translated, &voice().drawn, &voice().kept}) {
    if (memory->size() > kMostRemembered) memory->clear();
  }
}

std::string_view tr(std::string_view english, Args args) {
  Source* source = voice().language.source;
  if (english.empty() || (source == nullptr && args.size() == 0)) return english;
  return remembered(voice().translated, keyOf(english, args), [&] {
    std::string text = source ? source->translated(english, jsonOf(args)) : std::string();
    return text.empty() ? filledIn(english, args) : text;
  });
}

std::string_view drawn(std::string_view text) {
  const Language& spoken = voice().language;
  if (text.empty() || !spoken.rightToLeft || spoken.source == nullptr) return text;
  return remembered(voice().drawn, keyOf(text, {}), [&] { return spoken.source->drawn(text); });
}

std::string_view kept(std::string text) {
  return remembered(voice().kept, keyOf(text, {}), [&] { return std::move(text); });
}

std::string_view nameOf(std::string_view name) {
  struct Kind {
    std::string_view word;
    const char* text;
  };
  constexpr std::array kKinds = {Kind{"Part ", text("Part {n}")},       Kind{"Solid ", text("Solid {n}")},
                                 Kind{"Group ", text("Group {n}")},     Kind{"Sketch ", text("Sketch {n}")},
                                 Kind{"Picture ", text("Picture {n}")}, Kind{"My slice ", text("My slice {n}")},
                                 Kind{"Bridge ", text("Bridge {n}")}};
  for (const Kind& kind : kKinds) {
    if (!name.starts_with(kind.word)) continue;
    const std::string_view digits = name.substr(kind.word.size());
    unsigned number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec == std::errc() && read.ptr == digits.data() + digits.size()) return tr(kind.text, {{"n", number}});
  }
  return name;
}

}  // namespace spineloft::words
