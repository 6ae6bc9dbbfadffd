#include "web/commands/relief_json.h"

namespace spineloft::app {

void writeRelief(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived) {
  json.key("relief");
  if (!part.relief) {
    json.null();
    return;
  }
  const relief::Relief& relief = *part.relief;
  json.beginObject().key("mode").text(relief::modeKey(relief.mode)).key("height").number(relief.height);
  json.key("smooth").number(relief.smooth).key("region").number(static_cast<double>(relief.region.size()));
  json.key("laid");
  if (relief.laid) {
    const auto& [picture, at, width, turn] = *relief.laid;
    json.beginObject().key("picture").number(picture.value).key("at").beginArray().number(at.x).number(at.y).endArray();
    json.key("width").number(width).key("turn").number(turn).endObject();
  } else {
    json.null();
  }
  json.key("made");
  if (derived.shape && derived.shape->relief && !derived.waiting && !derived.wantedRelief) {
    const auto& [mode, seen, raises, explained, share] = *derived.shape->relief;
    json.beginObject()
        .key("mode")
        .text(relief::modeKey(mode))
        .key("seen")
        .flag(seen)
        .key("raises")
        .flag(raises)
        .key("explained")
        .number(explained);
    json.key("share").number(share).endObject();
  } else {
    json.null();
  }
  json.endObject();
}

}  // namespace spineloft::app
