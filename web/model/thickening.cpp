#include "web/model/thickening.h"
#include "web/words/words.h"

#include <algorithm>
#include <cmath>

#include "engine/document/params.h"
#include "engine/pipeline/solid.h"
#include "engine/printing/print_check.h"

namespace spineloft::app {
namespace {

using document::Document;
using document::Step;

/// What a thing cuts out is as wide as the thing.
bool cutsOut(const Document& document, document::Operand operand) {
  const Step* holder = holderOf(document, operand);
  return holder != nullptr && holder->kind == document::StepKind::Cut && holder->operands.front() != operand;
}

bool tooThin(double length, double millimetres) { return length * millimetres < printing::kLeastWall; }

constexpr const char* kThickness = "thickness";

/// The next thickness that can be set, not the nearest: that may be too thin again.
double wholeSteps(double thickness) {
  const document::ParamInfo* info = document::findParam(document::PartKind::Extrude, kThickness);
  const double steps = std::ceil((thickness - info->low) / info->step);
  return std::min(info->high, info->low + steps * info->step);
}

}  // namespace

std::vector<Thickening> thickenings(const Document& document, double millimetres) {
  std::vector<Thickening> found;
  if (!(millimetres > 0)) return found;
  const double thick = kThickened / millimetres;
  for (const document::Part& part : document.parts) {
    const document::ExtrudeRecipe* recipe = document::extrudeOf(part);
    if (recipe == nullptr || !pipeline::isVisible(document, part) || cutsOut(document, {part.id, {}})) continue;
    const double scale = part.placement.scale;
    if (!tooThin(recipe->extrude.thickness * scale, millimetres)) continue;
    found.push_back({document::SetParameter{part.id, kThickness, wholeSteps(thick / scale)},
                     std::string(words::nameOf(part.name))});
  }
  for (const Step& step : document.steps) {
    const Step* root = rootOf(document, {{}, step.id});
    const bool seen = root == nullptr ? step.visible : root->visible;
    if (step.kind != document::StepKind::Hollow || !seen || !tooThin(step.wall, millimetres)) continue;
    const double wall = std::min(thick, document::kMostWall);
    found.push_back({document::SetStep{step.id, step.kind, step.blend, wall, step.opening},
                     std::string(words::tr("the wall of {solid}", {{"solid", words::nameOf(step.name)}}))});
  }
  return found;
}

std::string spokenList(const std::vector<Thickening>& all) {
  if (all.empty()) return {};
  std::string text = all.front().what;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool last = i + 1 == all.size();
    text = words::tr(last ? "{list} and {last}" : "{list}, {next}",
                     {{"list", text}, {last ? "last" : "next", all[i].what}});
  }
  return text;
}

}  // namespace spineloft::app
