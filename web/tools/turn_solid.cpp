#include "web/tools/turn_solid.h"

namespace spineloft::tools {

void TurnSolid::begin(const ToolEnv&, const ToolEvent& event) {
  watch_.begin(event);
  adds_ = (event.modifiers & platform::kShift) != 0;
}

void TurnSolid::move(const ToolEnv& env, const ToolEvent& event) {
  const app::ClientPoint by = watch_.move(event);
  if (!watch_.moved()) return;
  env.ui.flight.reset();
  env.ui.cameraTouched = true;
  if (mode_ == Mode::Orbit) {
    app::orbit(env.ui.camera, env.ui.layout.solid, by);
  } else {
    app::panCamera(env.ui.camera, env.ui.layout.solid, by);
  }
}

void TurnSolid::commit(const ToolEnv& env) {
  if (watch_.moved()) return;
  const app::Ray ray{env.ui.camera.eye(),
                     app::rayThrough(env.ui.camera, env.ui.layout.solid, watch_.start())};
  const PartId part = env.picker->partUnderRay(env.document, env.derived, env.ui, ray);
  env.sink.run("select-part", app::Json::Object{{"id", part.value}, {"add", adds_}});
}

}  // namespace spineloft::tools
