#include "web/commands/pull_json.h"

#include "web/edit/pulling.h"

namespace spineloft::app {

void writePulls(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived) {
  json.key("pulls").beginArray();
  for (std::size_t i = 0; i < part.pulls.size(); ++i) {
    const pull::Pull& pull = part.pulls[i];
    const bool made = derived.shape && i < derived.shape->pulled.size();
    json.beginObject().key("points").number(static_cast<double>(pull.line.size())).key("height").number(pull.height);
    json.key("to").number(static_cast<double>(pull.to.size())).key("radius").number(pull.radius);
    json.key("crease").flag(pull.crease).key("ring").number(static_cast<double>(pull.ring.size()));
    json.key("share").number(made ? derived.shape->pulled[i].share : 1).endObject();
  }
  json.endArray();
}

void writePullKnobs(JsonWriter& json, const CommandEnv& env) {
  json.key("pullKnobs").beginArray();
  const PulledPart part = pulledPart(env.studio.document(), env.studio.derived(), env.ui);
  for (std::size_t i = 0; part && i < part.pulls.size(); ++i) {
    const auto knob = pullKnob(part, env.ui, i);
    json.beginObject().key("pull").number(static_cast<double>(i)).key("facing").flag(knob && knob->facing).key("at");
    if (knob) {
      json.beginArray().number(knob->at.x).number(knob->at.y).endArray();
    } else {
      json.null();
    }
    json.endObject();
  }
  json.endArray();
}

}  // namespace spineloft::app
