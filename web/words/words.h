// The visitor's language. English words stand in the code and are the keys of the catalogue (assets/words); they are
// translated where they are shown. Ids, keys, files and what a visitor typed are never translated.
#pragma once

#include <concepts>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace spineloft::words {

/// What a sentence names in braces: "Set on {n} parts." has the argument n, a number or a text.
struct Arg {
  std::string_view name;
  std::string_view text = {};
  double number = 0;
  bool isNumber = false;

  Arg(std::string_view key, std::string_view value) : name(key), text(value) {}
  Arg(std::string_view key, const std::string& value) : name(key), text(value) {}
  Arg(std::string_view key, const char* value) : name(key), text(value) {}
  template <class T>
    requires std::integral<T> || std::floating_point<T>
  Arg(std::string_view key, T value) : name(key), number(static_cast<double>(value)), isNumber(true) {}
};
using Args = std::initializer_list<Arg>;

/// Who knows another language: the shell in the browser, a stand-in in tests.
class Source {
 public:
  virtual ~Source() = default;
  /// The text in that language with its arguments (a JSON object) put in; empty where there is none.
  virtual std::string translated(std::string_view english, std::string_view args) = 0;
  /// What is drawn letter by letter from the left: letters in their joined forms, in visual order.
  virtual std::string drawn(std::string_view text) = 0;
};

/// The languages of the catalogue: their id, and their name in themselves.
struct Known {
  std::string_view id, name;
};
std::span<const Known> known();

struct Language {
  std::string id = "en";
  bool rightToLeft = false;
  Source* source = nullptr;  ///< null: English
};

/// From now on the page speaks this language. All views that `tr` and `drawn` gave are over.
void speak(Language language);
const Language& language();

/// Once a frame: keeps what is remembered small. Views of the frame before are over.
void forgetMuch();

/// A text of the code in the visitor's language; English where that has no word for it. The same text and arguments are
/// asked for once and remembered, so a frame like the one before asks for no memory. Of the main thread. Valid until
/// the next `speak` or `forgetMuch`; without arguments in English: as long as `english`.
std::string_view tr(std::string_view english, Args args = {});

/// Any text in the order and form in which the canvas draws it. As `tr`, and in languages written from the left the
/// text itself.
std::string_view drawn(std::string_view text);

/// The text, kept as long as what `drawn` gives: for what was put together for a frame.
std::string_view kept(std::string text);

/// A name that the engine gave ("Part 2", "Solid 1") in the visitor's language; any other is what a visitor typed.
std::string_view nameOf(std::string_view name);

/// Marks a text of a table that the catalogue is to hold; nothing else.
constexpr const char* text(const char* english) { return english; }

}  // namespace spineloft::words
