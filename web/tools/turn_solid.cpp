#include "web/tools/turn_solid.h"

#include <algorithm>
#include <vector>

#include "web/commands/intents.h"
#include "web/tools/pick.h"

namespace spineloft::tools {
namespace {

/// The chosen hollow solid opens where the ray meets what it is made of.
void pointOpening(const ToolEnv& env, const app::Ray& ray) {
  const StepId step = env.ui.solids.step;
  const std::vector<PartId> own = document::partsIn(env.document, {{}, step});
  std::vector<PartId> others;
  for (const document::Part& part : env.document.parts) {
    if (std::ranges::find(own, part.id) == own.end()) others.push_back(part.id);
  }
  const app::RayHit hit = env.picker->firstHit(env.document, env.derived, env.ui, ray, others);
  if (!hit) return;
  env.sink.run(app::openTowards, step, hit.normal);
}

}  // namespace

void TurnSolid::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  stops_ = env.ui.fliesAlong();
  if (stops_) env.ui.flight.reset();
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
  if (watch_.moved() || stops_) return;
  const app::Ray ray{env.ui.camera.eye(), app::rayThrough(env.ui.camera, env.ui.layout.solid, watch_.start())};
  if (env.ui.solids.pointing) {
    pointOpening(env, ray);
    return;
  }
  if (env.ui.solids.hollow) {
    const app::RayHit hit = env.picker->firstHit(env.document, env.derived, env.ui, ray);
    if (hit) env.sink.run(app::tapHollow, hit.part, hit.normal);
    return;
  }
  const PartId part = env.picker->partUnderRay(env.document, env.derived, env.ui, ray);
  selectTapped(env, part, adds_);
}

}  // namespace spineloft::tools
