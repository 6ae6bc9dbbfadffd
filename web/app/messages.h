// Events of the contract, as the shell understands them.
#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "web/platform/host.h"

namespace spineloft::app {

void sendChanged(platform::Host& host);
void sendError(platform::Host& host, std::string_view sentence);
void sendInfo(platform::Host& host, std::string_view sentence);
void sendPickPicture(platform::Host& host);
void sendCursor(platform::Host& host, std::string_view css);
void sendStatus(platform::Host& host, std::string_view text);

/// A text that the visitor types in a dialog of the shell; the answer comes with `id`.
struct Question {
  std::string_view id, title, text, value;
};
void sendQuestion(platform::Host& host, const Question& question);

}  // namespace spineloft::app
