#include "web/commands/bridge_json.h"

#include <cstddef>
#include <utility>

#include "web/edit/bridging.h"

namespace spineloft::app {

namespace {

double radiusOf(const bridge::Rim& rim) {
  double sum = 0;
  for (const ModelPoint p : rim.points) sum += distance(p, rim.centre);
  return sum / static_cast<double>(rim.points.size());
}

}  // namespace

void writeBridge(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived) {
  json.key("bridge");
  const document::BridgeRecipe* bridge = document::bridgeOf(part);
  if (bridge == nullptr) {
    json.null();
    return;
  }
  json.beginObject();
  const bool made = derived.shape && derived.shape->rims.size() == 2;
  for (std::size_t i = 0; i < 2; ++i) {
    json.key(i == 0 ? "from" : "to").beginObject();
    json.key("part").number((i == 0 ? bridge->from : bridge->to).part.value).key("at");
    if (made) {
      const bridge::Rim& rim = derived.shape->rims[i];
      json.beginArray().number(rim.centre.x).number(rim.centre.y).number(rim.centre.z).endArray();
      json.key("radius").number(radiusOf(rim));
    } else {
      json.null().key("radius").null();
    }
    json.endObject();
  }
  json.endObject();
}

void writeBridgeKnobs(JsonWriter& json, const CommandEnv& env) {
  json.key("bridgeKnobs").beginArray();
  const ShownBridge bridge = bridgeInHand(env.studio.document(), env.studio.derived(), env.ui);
  for (int end = 0; bridge && end < 2; ++end) {
    if (const auto at = rimKnob(bridge, env.ui, end)) {
      json.beginArray().number(at->x).number(at->y).endArray();
    } else {
      json.null();
    }
  }
  json.endArray();
}

}  // namespace spineloft::app
