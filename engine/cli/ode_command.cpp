// spineloft ode: the closed forms of geometry/ode.h beside finite differences of the same equation.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "engine/cli/files.h"
#include "engine/cli/ode_differences.h"
#include "engine/cli/program.h"

namespace spineloft::cli {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLeastNodes = 5, kMostNodes = 4096, kMostRingNodes = 512;

struct Case {
  std::optional<geometry::OdeEnds> ends;  ///< none: a ring
  std::vector<RingNode> ring;
  double tightness = 0;
  std::size_t n = 0;
};

/// A list of two finite numbers.
bool readPair(const Json& json, double& a, double& b) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number()) return false;
  a = json[0].get<double>();
  b = json[1].get<double>();
  return std::isfinite(a) && std::isfinite(b);
}

Result<Case> readCase(const std::string& text) {
  const auto wrong = [](std::string what) { return Failure{Error::JsonInvalid, std::move(what)}; };
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return wrong("it is no object");
  Case found;
  const bool isRing = json.contains("ring");
  const Json lambda = json.value("lambda", Json()), n = json.value("n", Json());
  if (!lambda.is_number() || !(lambda >= 0 && lambda <= geometry::kMostTightness)) return wrong("lambda is 0 to 10000");
  if (!n.is_number_unsigned() || n < kLeastNodes || n > (isRing ? kMostRingNodes : kMostNodes)) {
    return wrong(isRing ? "n is 5 to 512" : "n is 5 to 4096");
  }
  found.tightness = lambda.get<double>();
  found.n = n.get<std::size_t>();
  if (!isRing) {
    geometry::OdeEnds ends;
    if (!readPair(json.value("ends", Json()), ends.start, ends.end) ||
        !readPair(json.value("slopes", Json()), ends.startSlope, ends.endSlope)) {
      return wrong("ends and slopes are two numbers each");
    }
    found.ends = ends;
    return found;
  }
  const double count = static_cast<double>(found.n);
  for (const Json& node : json["ring"].is_array() ? json["ring"] : Json::array()) {
    double place = 0, value = 0;
    if (!readPair(node, place, value) || !(place >= 0 && place < 1)) return wrong("ring is a list of [place, value]");
    const double at = std::round(place * count);
    if (std::abs(at - place * count) > 1e-6) return wrong("places are multiples of 1/n");
    found.ring.push_back({static_cast<std::size_t>(at), value});
  }
  if (found.ring.empty() ||
      std::ranges::adjacent_find(found.ring, std::ranges::greater_equal{}, &RingNode::at) != found.ring.end()) {
    return wrong("ring needs at least one node, and places that grow");
  }
  return found;
}

std::vector<double> closedForm(const Case& given) {
  std::vector<double> values;
  const double n = static_cast<double>(given.n);
  if (given.ends) {
    const geometry::OdeCurve curve(*given.ends, given.tightness);
    for (std::size_t i = 0; i <= given.n; ++i) values.push_back(curve.value(static_cast<double>(i) / n));
    return values;
  }
  std::vector<double> places;
  for (const RingNode& node : given.ring) places.push_back(static_cast<double>(node.at) / n);
  const geometry::RingCardinals ring(places, given.tightness);
  std::vector<double> weights(places.size());
  for (std::size_t i = 0; i < given.n; ++i) {
    ring.at(static_cast<double>(i) / n, weights);
    double sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * given.ring[k].value;
    values.push_back(sum);
  }
  return values;
}

}  // namespace

Status runOde(const OdeArguments& arguments, std::ostream& out) {
  const Result<std::string> text = readText(arguments.file);
  if (!text.ok()) return text.failure();
  const Result<Case> given = readCase(text.value());
  if (!given.ok()) return {given.error(), arguments.file + ": " + given.failure().detail};
  const Case& found = given.value();
  const std::vector<double> closed = closedForm(found);
  const std::vector<double> differences =
      found.ends ? differenceCurve(*found.ends, found.tightness, std::vector<double>(found.n - 1, 0.0))
                 : differenceRing(found.ring, found.tightness, found.n);
  double largest = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) largest = std::max(largest, std::abs(closed[i] - differences[i]));
  out << Json{{"closed", closed}, {"differences", differences}, {"largest", largest}}.dump() << '\n';
  return Done{};
}

}  // namespace spineloft::cli
