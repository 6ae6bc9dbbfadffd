#include "web/model/solid_faults.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/publish/publish.h"
#include "web/model/messages.h"
#include "web/model/spoken_length.h"
#include "web/words/words.h"

namespace spineloft::app {

double millimetresPerUnit(const document::Document& document, const pipeline::Derived& derived) {
  const auto bounds = publish::worldBounds(document, derived);
  const double height = bounds ? bounds->high.y - bounds->low.y : 0;
  return height > 0 ? document.height.value / height : 0;
}

std::string spokenWall(double mm) {
  // What is thinner than a millimetre is told to a hundredth.
  const double notch = mm < 1 ? 0.01 : 0.1;
  return spokenLength(std::floor(mm / notch + 1e-6) * notch);
}

std::string solidFailureSentence(const document::Document& document, const pipeline::Derived& derived,
                                 const pipeline::DerivedStep& step) {
  const document::Part* part = findPart(document, step.faulty);
  std::string sentence = spokenFailure(Failure{step.failure->error, part ? part->name : std::string()});
  const double scale = millimetresPerUnit(document, derived);
  if (!step.thickest || !(scale > 0)) return sentence;
  const bool some = *step.thickest >= document::kLeastWall;
  sentence += ' ';
  return sentence +=
         some ? words::tr("The thickest that fits is {length}.", {{"length", spokenWall(*step.thickest * scale)}})
              : words::tr("No wall fits with this opening.");
}

std::string spokenFailure(const document::Document& document, const pipeline::Derived& derived,
                          const pipeline::DerivedStep& step) {
  if (step.failure->error == Error::Cancelled) return std::string(words::tr("Stopped. Press \"Try again\" to go on."));
  return solidFailureSentence(document, derived, step);
}

std::string faultsOf(const document::Document& document, const pipeline::Derived& derived) {
  std::string text;
  std::vector<StepId> told;
  for (const pipeline::DerivedStep& step : derived.steps) {
    const document::Step* root = step.failure ? findStep(document, step.id) : nullptr;
    if (root != nullptr && holderOf(document, {{}, root->id}) != nullptr) root = rootOf(document, {{}, root->id});
    if (root == nullptr || !root->visible || std::ranges::count(told, root->id) > 0) continue;
    told.push_back(root->id);
    const bool kept = pipeline::shownSolid(document, derived, *root) != nullptr;
    text += text.empty() ? "" : " ";
    text += words::tr(kept ? "{solid} is as it was before: {why}" : "{solid} is there as its parts alone: {why}",
                      {{"solid", words::nameOf(root->name)}, {"why", spokenFailure(document, derived, step)}});
  }
  return text;
}

}  // namespace spineloft::app
