#include "web/model/messages.h"

#include "engine/io/json_fields.h"
#include "web/model/json.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

void sendText(platform::Host& host, std::string_view type, std::string_view name, std::string_view text) {
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

std::string spokenFailure(const Failure& failure) {
  std::string sentence(words::tr(errorSentence(failure.error)));
  if (!failure.detail.empty()) sentence.append(" (").append(words::nameOf(failure.detail)) += ')';
  return sentence;
}

std::string_view reliefWords(const relief::Relief& relief, const pipeline::PartShape& shape) {
  if (!shape.relief) return {};
  const pipeline::ReliefFound& found = *shape.relief;
  if (!found.seen) return words::tr("Too little of the part is seen in the picture for a relief.");
  if (!found.raises) return words::tr("The picture shows nothing here that could become a relief.");
  if (found.mode != relief.mode) {
    return words::tr("The picture shows no light and shadow here, so its dark lines became grooves.");
  }
  return found.share < 1 ? words::tr("Any higher, and it would go through itself") : std::string_view();
}

void sendError(platform::Host& host, std::string_view sentence) { sendToast(host, "error", sentence); }
void sendInfo(platform::Host& host, std::string_view sentence) { sendToast(host, "info", sentence); }
void sendHint(platform::Host& host, std::string_view sentence) { sendToast(host, "hint", sentence); }
void sendWarning(platform::Host& host, std::string_view sentence) { sendToast(host, "warning", sentence); }
void sendOffer(platform::Host& host, const Offer& offer) {
  JsonWriter json;
  json.beginObject().key("type").text("toast").key("level").text("hint").key("text").text(offer.sentence);
  json.key("offer").beginObject().key("label").text(offer.label).key("command").text(offer.command);
  json.key("args").value(offer.args).endObject().endObject();
  host.send(json.json());
}
void sendPickPicture(platform::Host& host) { host.send(R"({"type":"pickPicture"})"); }
void sendCursor(platform::Host& host, std::string_view css) { sendText(host, "cursor", "css", css); }
void sendStatus(platform::Host& host, std::string_view text) { sendText(host, "status", "text", text); }
void sendShow(platform::Host& host, std::string_view dialog) { sendText(host, "show", "dialog", dialog); }

void sendLanguage(platform::Host& host, std::string_view id) { sendText(host, "language", "id", id); }

void sendQuestion(platform::Host& host, const Question& question) {
  JsonWriter json;
  json.beginObject().key("type").text("ask").key("id").text(question.id);
  json.key("title").text(question.title).key("text").text(question.text);
  json.key("value").text(question.value).key("at");
  if (question.at) {
    json.beginArray();
    for (const double value : *question.at) json.number(value);
    json.endArray();
  } else {
    json.null();
  }
  json.endObject();
  host.send(json.json());
}

void sendJournal(platform::Host& host, const JournalStep& step) {
  JsonWriter json;
  json.beginObject().key("type").text("journal").key("record").text(step.record);
  json.key("photos").beginArray();
  for (const std::uint64_t hash : step.photos) json.text(io::hashKey(hash));
  json.endArray().key("name").text(step.document.name);
  json.key("pictures").number(static_cast<double>(step.document.pictures.size()));
  json.key("parts").number(static_cast<double>(step.document.parts.size())).endObject();
  host.send(json.json());
}

void sendTurntable(platform::Host& host, std::string_view what, std::string_view name) {
  JsonWriter json;
  json.beginObject().key("type").text("turntable").key("what").text(what).key("name").text(name);
  json.endObject();
  host.send(json.json());
}

void sendKeep(platform::Host& host, std::string_view what, std::string_view id) {
  JsonWriter json;
  json.beginObject().key("type").text("keep").key("what").text(what).key("id").text(id);
  json.endObject();
  host.send(json.json());
}

}  // namespace spineloft::app
