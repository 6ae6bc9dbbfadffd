#include "web/model/solid_work.h"

#include <algorithm>
#include <cstring>

#include "engine/base/hash.h"
#include "engine/io/json_fields.h"
#include "engine/mesh/self_crossing.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kMostFailures = 256, kMostLooked = 256;

Error errorNamed(std::string_view name) {
  for (int i = 0; i < static_cast<int>(Error::kCount); ++i) {
    if (errorName(static_cast<Error>(i)) == name) return static_cast<Error>(i);
  }
  return Error::SolidFailed;
}

platform::SolverMesh meshOf(const mesh::TriMesh& mesh) {
  return {static_cast<std::uint32_t>(mesh.positions.size()), static_cast<std::uint32_t>(mesh.triangles.size()),
          reinterpret_cast<const float*>(mesh.positions.data()),
          mesh.uv.empty() ? nullptr : reinterpret_cast<const float*>(mesh.uv.data()),
          reinterpret_cast<const std::uint32_t*>(mesh.triangles.data())};
}

void writeNode(JsonWriter& json, const publish::SolidPlan& plan, const publish::SolidPlan::Node& node, bool coarse) {
  json.beginObject().key("key").text(io::hashKey(node.key.hash)).key("step").number(node.step.value);
  json.key("kind").text(document::stepKindKey(node.kind)).key("operands").beginArray();
  for (const publish::SolidPlan::Operand& operand : node.operands) {
    json.beginObject();
    if (operand.node) {
      json.key("node").text(io::hashKey(plan.nodes[*operand.node].key.hash));
    } else {
      json.key("mesh").text(io::hashKey(plan.meshes[operand.mesh].key.hash));
      json.key("part").number(operand.part.value).key("matrix").beginArray();
      for (const double value : operand.toWorld) json.number(value);
      json.endArray();
    }
    json.endObject();
  }
  json.endArray().key("blend").number(node.blend).key("wall").number(node.wall).key("opening");
  if (node.opening) {
    json.beginArray();
    for (const double value : *node.opening) json.number(value);
    json.endArray();
  } else {
    json.null();
  }
  json.key("cut").number(node.cut).key("coarse").flag(coarse).endObject();
}

/// Whether parts that are drawn together look as the solid of the step does: they are only joined, with no round
/// seams and no look of the whole.
bool looksAsItsParts(const document::Document& document, const document::Step& step, int depth = 0) {
  constexpr int kMostDepth = 64;
  if (step.kind != document::StepKind::Join || step.blend > 0 || depth > kMostDepth) return false;
  if (depth == 0 && step.ownLook) return false;
  return std::ranges::all_of(step.operands, [&](const document::Operand& operand) {
    const document::Step* inner = operand.step ? findStep(document, operand.step) : nullptr;
    return operand.part || (inner != nullptr && looksAsItsParts(document, *inner, depth + 1));
  });
}

/// A solid with a part that has no shape: why, or that the part is still on its way.
void waitForParts(const document::Document& document, const pipeline::Derived& derived, StepId id,
                  pipeline::DerivedStep& result) {
  result.waiting = true;
  for (const PartId part : partsIn(document, {{}, id})) {
    const auto at = std::ranges::find(derived.parts, part, &pipeline::DerivedPart::id);
    if (at == derived.parts.end() || at->shape || !at->failure) continue;
    result.waiting = false;
    result.failure = at->failure;
    result.faulty = part;
    return;
  }
}

/// A preview's solid is coarser: it must not be taken for the real one.
SolidKey previewKey(SolidKey key) { return SolidKey{Hasher().text("preview").number(key.hash).value()}; }

/// Takes arrays of numbers off the front of the bytes.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class T>
  std::vector<T> take(std::size_t count) {
    const std::size_t left = bytes_.size() / sizeof(T);
    if (count > left) {
      whole_ = false;
      return {};
    }
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), bytes_.data(), count * sizeof(T));
    bytes_ = bytes_.subspan(count * sizeof(T));
    return values;
  }
  bool whole() const { return whole_ && bytes_.empty(); }

 private:
  std::span<const std::uint8_t> bytes_;
  bool whole_ = true;
};

std::size_t countOf(const Json& json, std::string_view key) {
  const double value = json.number(key).value_or(0);
  return value >= 0 && value < 1e9 ? static_cast<std::size_t>(value) : 0;
}

std::vector<pipeline::SolidArrays::Run> runsOf(const Json& mesh) {
  std::vector<pipeline::SolidArrays::Run> runs;
  const Json* list = mesh.find("runs");
  if (list == nullptr || list->array() == nullptr) return runs;
  for (const Json& run : *list->array()) {
    const std::size_t part = countOf(run, "part");
    runs.push_back({PartId{static_cast<std::uint32_t>(part)}, countOf(run, "first"), countOf(run, "count")});
  }
  return runs;
}

}  // namespace

void SolidWork::update(const document::Document& document, pipeline::Derived& derived, Alone alone) {
  derived.steps.clear();
  publish::SolidPlan plan;
  std::vector<SolidKey> missing;
  if (document.steps.empty()) {
    latest_.clear();
  } else {
    plan = publish::planSolids(document, derived);
    updateSteps(document, derived, plan, missing);
  }
  updateAlone(document, derived, alone, plan, missing);
  if (missing.empty()) {
    if (document.steps.empty() && busy()) cancel();
    return;
  }
  const bool isAsked = asked_ && asked_->purpose == Purpose::Document && asked_->keys == missing;
  if (!isAsked) ask(plan, std::move(missing), Purpose::Document);
}

void SolidWork::updateSteps(const document::Document& document, pipeline::Derived& derived,
                            const publish::SolidPlan& plan, std::vector<SolidKey>& missing) {
  for (const document::Step& step : document.steps) {
    pipeline::DerivedStep result;
    result.id = step.id;
    const auto root =
        std::ranges::find_if(plan.roots, [&](std::size_t node) { return plan.nodes[node].step == step.id; });
    const auto last = std::ranges::find(latest_, step.id, &decltype(latest_)::value_type::first);
    if (last != latest_.end()) result.solid = last->second;
    if (root != plan.roots.end()) {
      const SolidKey key = plan.nodes[*root].key;
      const StepFailure* failed = failureOf(key);
      if (auto known = solids_.find(key)) {
        result.solid = known;
        if (last == latest_.end()) {
          latest_.emplace_back(step.id, known);
        } else {
          last->second = known;
        }
      } else if (failed != nullptr) {
        result.failure = failed->failure;
        result.faulty = failed->faulty;
        result.thickest = failed->thickest;
        result.at = failed->at;
      } else {
        result.waiting = true;
        missing.push_back(key);
      }
    }
    if (root == plan.roots.end() && holderOf(document, {{}, step.id}) == nullptr) {
      waitForParts(document, derived, step.id, result);
    }
    derived.steps.push_back(std::move(result));
  }
  std::erase_if(latest_, [&](const auto& entry) { return findStep(document, entry.first) == nullptr; });
}

void SolidWork::updateAlone(const document::Document& document, pipeline::Derived& derived, Alone alone,
                            publish::SolidPlan& plan, std::vector<SolidKey>& missing) {
  for (pipeline::DerivedPart& part : derived.parts) {
    part.mended.reset();
    part.crossesAt.reset();
    const document::Part* known = document::findPart(document, part.id);
    if (known == nullptr || !known->visible || !part.shape || rootOf(document, {part.id, {}}) != nullptr) continue;
    const Looked* looked = lookOver(*part.shape, alone);
    if (looked == nullptr || !looked->crosses) continue;
    const SolidKey key = publish::aloneKey(part.id, *part.shape);
    const StepFailure* failed = failureOf(key);
    part.mended = solids_.find(key);
    if (part.mended) continue;
    if (failed == nullptr && alone == Alone::All) {
      publish::planAlone(plan, part.id, *part.shape);
      missing.push_back(key);
    } else if (failed != nullptr && failed->failure.error != Error::Cancelled) {
      part.crossesAt = looked->crosses;
      if (failed->at) part.crossesAt = ModelPoint{failed->at->x, failed->at->y, failed->at->z};
    }
  }
}

/// What is known of a shape; null where it was not looked at, and need not be.
const SolidWork::Looked* SolidWork::lookOver(const pipeline::PartShape& shape, Alone alone) {
  const auto at = std::ranges::find(looked_, shape.key, &Looked::key);
  if (at != looked_.end()) return &*at;
  if (alone == Alone::AsKnown) return nullptr;
  if (looked_.size() >= kMostLooked) looked_.erase(looked_.begin());
  Looked looked{shape.key, {}};
  if (const auto found = mesh::selfCrossing(shape.mesh))
    looked.crosses = ModelPoint{(*found)[0], (*found)[1], (*found)[2]};
  looked_.push_back(looked);
  return &looked_.back();
}

void SolidWork::forgetUnanswered(const pipeline::Derived& derived) {
  for (const pipeline::DerivedPart& part : derived.parts) {
    if (!part.shape) continue;
    std::erase_if(failures_, [key = publish::aloneKey(part.id, *part.shape)](const StepFailure& failed) {
      return failed.key == key && isWithoutAnswer(failed.failure.error);
    });
  }
}

void SolidWork::preview(const document::Document& document, pipeline::Derived& derived,
                        const publish::Substitute* instead) {
  const publish::SolidPlan plan = publish::planSolids(document, derived, instead);
  std::vector<SolidKey> missing;
  for (const std::size_t index : plan.roots) {
    const publish::SolidPlan::Node& node = plan.nodes[index];
    const auto at = std::ranges::find(derived.steps, node.step, &pipeline::DerivedStep::id);
    const document::Step* step = findStep(document, node.step);
    auto known = solids_.find(node.key);
    if (!known && step != nullptr && at != derived.steps.end() && looksAsItsParts(document, *step)) {
      at->solid = nullptr;
      continue;
    }
    if (!known) known = solids_.find(previewKey(node.key));
    if (!known && failureOf(node.key) == nullptr && failureOf(previewKey(node.key)) == nullptr) {
      missing.push_back(node.key);
    }
    if (known && at != derived.steps.end()) at->solid = known;
  }
  if (!missing.empty() && !busy()) ask(plan, std::move(missing), Purpose::Preview);
}

void SolidWork::ask(const publish::SolidPlan& plan, std::vector<SolidKey> keys, Purpose purpose) {
  JsonWriter json;
  json.beginObject().key("type").text("solve").key("id").number(static_cast<double>(++lastId_));
  json.key("meshes").beginArray();
  std::vector<platform::SolverMesh> meshes;
  for (const publish::SolidPlan::Mesh& mesh : plan.meshes) {
    json.text(io::hashKey(mesh.key.hash));
    meshes.push_back(meshOf(*mesh.mesh));
  }
  json.endArray().key("nodes").beginArray();
  for (const publish::SolidPlan::Node& node : plan.nodes) writeNode(json, plan, node, purpose == Purpose::Preview);
  json.endArray().key("wanted").beginArray();
  for (const SolidKey key : keys) json.text(io::hashKey(key.hash));
  json.endArray().endObject();
  asked_ = Asked{static_cast<double>(lastId_), std::move(keys), purpose, 0};
  host_.solve(json.json(), meshes);
}

void SolidWork::expect(PartId part) {
  if (part == expected_) return;
  expected_ = part;
  JsonWriter json;
  json.beginObject().key("type").text("expectEdit").key("part");
  if (part) {
    json.number(part.value);
  } else {
    json.null();
  }
  json.endObject();
  host_.send(json.json());
}

void SolidWork::cancel() {
  if (!asked_) return;
  for (const SolidKey key : asked_->keys) {
    if (asked_->purpose == Purpose::Document) keepFailure({key, {Error::Cancelled, {}}, {}, {}});
  }
  asked_.reset();
  host_.send(R"({"type":"stopSolving"})");
}

void SolidWork::forget() {
  solids_ = pipeline::LruCache<SolidKey, pipeline::Solid>(kMostBytes);
  latest_.clear();
  failures_.clear();
}

const SolidWork::StepFailure* SolidWork::failureOf(SolidKey key) const {
  const auto at = std::ranges::find(failures_, key, &StepFailure::key);
  return at == failures_.end() ? nullptr : &*at;
}

void SolidWork::keepFailure(StepFailure failed) {
  if (failures_.size() >= kMostFailures) failures_.erase(failures_.begin());
  failures_.push_back(std::move(failed));
}

bool SolidWork::take(const Json& answer, std::span<const std::uint8_t> bytes) {
  if (answer.flag("lost").value_or(false)) {
    return takeLoss(answer.flag("loaded").value_or(true) ? Error::SolverStopped : Error::SolverUnreachable);
  }
  if (answer.text("key") != nullptr) return takeSolid(answer, bytes);
  if (!asked_ || answer.number("id") != asked_->id) return false;
  if (const auto done = answer.number("progress")) asked_->done = std::clamp(*done, 0.0, 1.0);
  if (answer.flag("done").value_or(false)) asked_.reset();
  return true;
}

bool SolidWork::takeLoss(Error reason) {
  if (!asked_) return false;
  const Asked lost = *std::exchange(asked_, std::nullopt);
  if (lost.purpose != Purpose::Document) return true;
  for (const SolidKey key : lost.keys) {
    if (!solids_.find(key)) keepFailure({key, {reason, {}}, {}, {}});
  }
  sendError(host_, errorSentence(reason));
  return true;
}

bool SolidWork::takeSolid(const Json& answer, std::span<const std::uint8_t> bytes) {
  const std::optional<std::uint64_t> named = io::hashFromKey(*answer.text("key"));
  if (!named) return false;
  const bool preview = answer.flag("coarse").value_or(false);
  const SolidKey key = preview ? previewKey(SolidKey{*named}) : SolidKey{*named};
  const Json* mesh = answer.find("mesh");
  if (mesh == nullptr || mesh->isNull()) {
    const Json* failure = answer.find("failure");
    if (failure == nullptr) return false;
    const std::string* name = failure->text("error");
    StepFailure failed{key, {name ? errorNamed(*name) : Error::SolidFailed, {}}, {}, {}};
    failed.faulty = PartId{static_cast<std::uint32_t>(countOf(*failure, "part"))};
    failed.thickest = failure->number("thickest");
    const Json* at = failure->find("at");
    if (at != nullptr && at->array() != nullptr && at->array()->size() == 3) {
      const Json::Array& xyz = *at->array();
      failed.at = WorldPoint{xyz[0].number().value_or(0), xyz[1].number().value_or(0), xyz[2].number().value_or(0)};
    }
    keepFailure(std::move(failed));
    return true;
  }
  Bytes from(bytes);
  const std::size_t vertices = countOf(*mesh, "vertices"), merges = countOf(*mesh, "merges");
  const auto positions = from.take<float>(3 * vertices), uv = from.take<float>(2 * vertices);
  const auto corners = from.take<std::uint32_t>(3 * countOf(*mesh, "triangles"));
  const auto mergeFrom = from.take<std::uint32_t>(merges), mergeTo = from.take<std::uint32_t>(merges);
  Result<pipeline::Solid> made = from.whole()
                                     ? pipeline::solidFrom({positions, uv, corners, mergeFrom, mergeTo, runsOf(*mesh)})
                                     : Result<pipeline::Solid>(Error::MeshInvalid);
  if (!made) {
    keepFailure({key, made.failure(), {}, {}});
    return true;
  }
  pipeline::Solid solid = std::move(made).value();
  solid.key = key;
  solid.volume = mesh->number("volume").value_or(0);
  solid.area = mesh->number("area").value_or(0);
  solid.genus = static_cast<int>(mesh->number("genus").value_or(0));
  solid.ms = answer.number("ms").value_or(0);
  const std::size_t size = bytesOf(solid);
  solids_.keep(key, std::make_shared<const pipeline::Solid>(std::move(solid)), size);
  return true;
}

}  // namespace spineloft::app
