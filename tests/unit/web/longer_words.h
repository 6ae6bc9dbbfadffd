// A language that is English with words 40 % longer, and speaking another language for a while.
#pragma once

#include <cctype>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "web/model/json.h"
#include "web/page/app.h"
#include "web/words/words.h"

namespace spineloft::test {

class LongerWords final : public words::Source {
 public:
  std::string translated(std::string_view english, std::string_view args) override {
    ++asked;
    const std::optional<app::Json> given = app::Json::parse(args);
    std::string out, word;
    const auto end = [&] {
      if (!word.empty()) out += word + std::string((2 * word.size() + 4) / 5, word.back());
      word.clear();
    };
    for (std::size_t i = 0; i < english.size(); ++i) {
      const std::size_t shut = english[i] == '{' ? english.find('}', i) : std::string_view::npos;
      if (shut != std::string_view::npos) {
        end();
        const app::Json* value = given ? given->find(english.substr(i + 1, shut - i - 1)) : nullptr;
        if (value != nullptr) out += value->number() ? plain(*value->number()) : *value->text();
        i = shut;
      } else if (static_cast<unsigned char>(english[i]) < 0x80 &&
                 std::isalpha(static_cast<unsigned char>(english[i])) != 0) {
        word += english[i];
      } else {
        end();
        out += english[i];
      }
    }
    end();
    return out;
  }
  std::string drawn(std::string_view text) override { return std::string(text); }
  int asked = 0;

 private:
  static std::string plain(double number) {
    std::ostringstream out;
    out << number;
    return out.str();
  }
};

/// English again at its end; with an App, that follows.
class Speaking {
 public:
  explicit Speaking(words::Language language) { words::speak(std::move(language)); }
  Speaking(words::Language language, app::App& app) : app_(&app) { app.speak(std::move(language), {}, {}); }
  ~Speaking() { app_ ? app_->speak({}, {}, {}) : words::speak({}); }
  Speaking(const Speaking&) = delete;
  Speaking& operator=(const Speaking&) = delete;

 private:
  app::App* app_ = nullptr;
};

}  // namespace spineloft::test
