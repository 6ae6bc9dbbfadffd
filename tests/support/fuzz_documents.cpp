#include "tests/support/fuzz_documents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/io/document_json.h"
#include "engine/io/project_file.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "engine/publish/publish.h"
#include "engine/publish/solid_plan.h"
#include "tests/support/sessions.h"

namespace spineloft::testing {
namespace {

/// Takes numbers off the front of the input; zeros at its end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::uint32_t take(int count) {
    std::uint32_t value = 0;
    for (; count > 0; --count) {
      value = value << 8 | (bytes_.empty() ? 0u : bytes_.front());
      bytes_ = bytes_.subspan(bytes_.empty() ? 0 : 1);
    }
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// What numbers of a text become: limits of the types, of the ranges, and what divides badly.
constexpr std::array<std::string_view, 16> kHard = {"0",     "-0.0",       "1",    "-1",    "0.5",    "2",
                                                    "1e-9",  "1e-300",     "1e9",  "1e300", "-1e300", "255",
                                                    "65536", "4294967295", "96.5", "null"};

struct Place {
  std::size_t from = 0, count = 0;
};

/// Where numbers stand in a JSON text, outside of strings.
std::vector<Place> numbersIn(std::string_view text) {
  std::vector<Place> places;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && (text[i] == '-' || (text[i] >= '0' && text[i] <= '9'))) {
      const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE", i), text.size());
      places.push_back({i, end - i});
      i = end - 1;
    }
  }
  return places;
}

std::string changed(std::string text, Bytes& input) {
  constexpr int kMostChanges = 24;
  for (int i = 0; i < kMostChanges && !input.empty(); ++i) {
    const std::vector<Place> places = numbersIn(text);
    if (places.empty()) return text;
    const Place place = places[input.take(2) % places.size()];
    const std::uint32_t kind = input.take(1);
    std::string value(kHard[kind % kHard.size()]);
    // Every other one stays of its size.
    if (kind & 0x80) {
      const double now = std::strtod(text.c_str() + place.from, nullptr);
      value = std::to_string(now * (static_cast<double>(input.take(1)) - 128) / 64);
    }
    text.replace(place.from, place.count, value);
  }
  return text;
}

bool finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::string faultOf(const publish::SolidPlan& plan) {
  for (const publish::SolidPlan::Mesh& mesh : plan.meshes) {
    if (mesh.mesh == nullptr) return "a plan without a mesh";
    if (const std::string law = mesh::brokenLaw(mesh::inspect(*mesh.mesh)); !law.empty())
      return "a planned mesh: " + law;
  }
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    const publish::SolidPlan::Node& node = plan.nodes[i];
    if (node.operands.empty()) return "a node without operands";
    for (const publish::SolidPlan::Operand& operand : node.operands) {
      if (operand.node ? *operand.node >= i : operand.mesh >= plan.meshes.size()) return "an operand that is not there";
      if (!operand.node && !finite(operand.toWorld)) return "a place in the world";
    }
    const std::array<double, 3> sizes{node.blend, node.wall, node.cut};
    if (!finite(sizes) || node.blend < 0 || node.wall < 0) return "a size of a node";
    if (node.opening && (!finite(*node.opening) ||
                         std::abs(std::hypot((*node.opening)[0], (*node.opening)[1], (*node.opening)[2]) - 1) > 1e-6)) {
      return "the direction of an opening";
    }
  }
  const bool there = std::ranges::all_of(plan.roots, [&](std::size_t root) { return root < plan.nodes.size(); });
  return there ? std::string() : "a root that is not there";
}

std::string faultOf(const document::Document& document, const pipeline::Derived& derived) {
  if (derived.parts.size() != document.parts.size()) return "parts lost";
  for (const pipeline::DerivedPart& part : derived.parts) {
    if (part.waiting || !part.shape == !part.failure) return "a part that is neither made nor failed";
    if (!part.shape) continue;
    if (const std::string law = mesh::brokenLaw(mesh::inspect(part.shape->mesh)); !law.empty()) return "a part: " + law;
    publish::SolidPlan alone;
    publish::planAlone(alone, part.id, *part.shape);
    if (std::string fault = faultOf(alone); !fault.empty()) return fault + ", alone";
  }
  return faultOf(publish::planSolids(document, derived));
}

using publish::Format;
constexpr std::array kFormats = {Format::Glb,     Format::Obj,    Format::Stl,
                                 Format::Project, Format::ObjZip, Format::ThreeMf};

std::string faultOfFile(const document::Document& document, const pipeline::Derived& derived, Format format) {
  const std::string name(publish::formatKey(format));
  const Result<publish::Bytes> file = publish::publish(document, derived, format, Progress());
  if (!file) {
    const Error error = file.failure().error;
    const bool may = format != Format::Project && (error == Error::NothingToExport || error == Error::MeshInvalid);
    return may ? std::string() : name + ": " + failureSentence(file.failure());
  }
  if (file.value().empty()) return name + ": an empty file";
  if (!publish::holdsDocument(format)) return {};
  const auto read = io::readProject(file.value());
  return read && read.value() == document ? std::string() : name + ": another document inside";
}

}  // namespace

std::string tryDocument(std::span<const std::uint8_t> bytes) {
  Bytes input(bytes);
  const std::uint64_t seed = input.take(3);
  const int steps = 1 + static_cast<int>(input.take(1) % 40);
  const Format format = kFormats[input.take(1) % kFormats.size()];
  const std::vector<document::Document> session = randomSession(seed, steps);
  const std::string text = changed(io::writeDocument(session.back()), input);
  const auto read = io::readDocument(text, photosOfAll(session));
  if (!read) return {};
  const document::Document& document = read.value();
  // Large ones are slow and teach nothing new.
  constexpr long long kMostPixels = 100'000;
  for (const document::PictureEntry& entry : document.pictures) {
    if (static_cast<long long>(entry.size.width) * entry.size.height > kMostPixels) return {};
  }
  pipeline::Cache cache;
  const Result<pipeline::Derived> derived = pipeline::deriveWithEdges(document, cache, Progress());
  if (!derived) return "not derived: " + failureSentence(derived.failure());
  if (std::string fault = faultOf(document, derived.value()); !fault.empty()) return fault;
  return faultOfFile(document, derived.value(), format);
}

}  // namespace spineloft::testing
