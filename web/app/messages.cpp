#include "web/app/messages.h"

#include "web/app/json.h"

namespace spineloft::app {
namespace {

void sendText(platform::Host& host, std::string_view type, std::string_view name,
              std::string_view text) {
  JsonWriter json;
  json.beginObject().key("type").text(type).key(name).text(text).endObject();
  host.send(json.json());
}

void sendToast(platform::Host& host, std::string_view level, std::string_view sentence) {
  JsonWriter json;
  json.beginObject().key("type").text("toast").key("level").text(level);
  json.key("text").text(sentence).endObject();
  host.send(json.json());
}

}  // namespace

void sendChanged(platform::Host& host) { host.send(R"({"type":"changed"})"); }
void sendError(platform::Host& host, std::string_view sentence) {
  sendToast(host, "error", sentence);
}
void sendInfo(platform::Host& host, std::string_view sentence) {
  sendToast(host, "info", sentence);
}
void sendPickPicture(platform::Host& host) { host.send(R"({"type":"pickPicture"})"); }
void sendCursor(platform::Host& host, std::string_view css) {
  sendText(host, "cursor", "css", css);
}
void sendStatus(platform::Host& host, std::string_view text) {
  sendText(host, "status", "text", text);
}

void sendQuestion(platform::Host& host, const Question& question) {
  JsonWriter json;
  json.beginObject().key("type").text("ask").key("id").text(question.id);
  json.key("title").text(question.title).key("text").text(question.text);
  json.key("value").text(question.value).endObject();
  host.send(json.json());
}

}  // namespace spineloft::app
