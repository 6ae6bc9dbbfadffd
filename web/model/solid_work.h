// Solids of the document's steps: asks the solver of the page for those that are not known, keeps the last good
// ones, and says what went wrong. The solver itself is the shell's (web/shell/solids).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/pipeline/cache.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/solid.h"
#include "engine/publish/solid_plan.h"
#include "web/model/json.h"
#include "web/platform/host.h"

namespace spineloft::app {

/// Whether a solid is missing because its making ended early, not because it cannot be made.
inline bool isWithoutAnswer(Error error) {
  return error == Error::Cancelled || error == Error::SolverStopped || error == Error::SolverUnreachable;
}

class SolidWork {
 public:
  explicit SolidWork(platform::Host& host) : host_(host) {}

  /// What is to be known of parts in no step: what is known, or, for a file, all.
  enum class Alone { AsKnown, All };

  /// Sets `derived.steps`, and what is known of parts that go through themselves; asks the solver for what is not known
  /// yet. A newer request replaces the one it is at.
  void update(const document::Document& document, pipeline::Derived& derived, Alone alone = Alone::AsKnown);
  /// Forgets the failures of parts in no step for which the solver was stopped or ended without an answer: the next
  /// `update` for all asks again.
  void forgetUnanswered(const pipeline::Derived& derived);
  /// The same for a document as a gesture would make it, with another mesh for a part that is being edited. While the
  /// solver is busy nothing is asked for, so that gestures do not wait. Results show until the next `update`. Parts
  /// that are only joined are drawn themselves: the picture is the same, without a solver.
  void preview(const document::Document& document, pipeline::Derived& derived, const publish::Substitute* instead);

  /// The part that is likely to be edited next, or none. A change is sent to the solver, which prefetches for that part
  /// while nothing else is asked for.
  void expect(PartId part);

  /// What the solver says: {id, done}, {id, progress}, {lost, loaded} or {id, step, key, ms, mesh | failure}, with the
  /// arrays of the mesh as bytes: positions, uv, corners, both lists of merged vertices. True when something
  /// changed.
  bool take(const Json& answer, std::span<const std::uint8_t> bytes);

  /// Whether something is asked for.
  bool busy() const { return asked_.has_value(); }
  double done() const { return busy() ? asked_->done : 1; }
  /// Stops the solver; what it was at is not asked for again before it changes, or `again`.
  void cancel();
  /// Forgets failures, so that the next `update` asks once more.
  void again() { failures_.clear(); }
  /// Lets go of all solids: another model is opened.
  void forget();

 private:
  /// For the document as it is, or for a gesture.
  enum class Purpose { Document, Preview };
  struct Asked {
    double id = 0;
    std::vector<SolidKey> keys;
    Purpose purpose = Purpose::Document;
    double done = 0;
  };
  struct StepFailure {
    SolidKey key;
    Failure failure;
    PartId faulty;
    std::optional<WorldPoint> at;
    std::optional<double> thickest = {};
  };
  /// A shape that was looked over for places where it goes through itself.
  struct Looked {
    ShapeKey key;
    std::optional<ModelPoint> crosses;
  };
  void updateSteps(const document::Document& document, pipeline::Derived& derived, const publish::SolidPlan& plan,
                   std::vector<SolidKey>& missing);
  void updateAlone(const document::Document& document, pipeline::Derived& derived, Alone alone,
                   publish::SolidPlan& plan, std::vector<SolidKey>& missing);
  const Looked* lookOver(const pipeline::PartShape& shape, Alone alone);
  void ask(const publish::SolidPlan& plan, std::vector<SolidKey> keys, Purpose purpose);
  void keepFailure(StepFailure failed);
  const StepFailure* failureOf(SolidKey key) const;
  bool takeLoss(Error reason);
  bool takeSolid(const Json& answer, std::span<const std::uint8_t> bytes);

  platform::Host& host_;
  static constexpr std::size_t kMostBytes = std::size_t{96} << 20;
  pipeline::LruCache<SolidKey, pipeline::Solid> solids_{kMostBytes};
  std::vector<std::pair<StepId, std::shared_ptr<const pipeline::Solid>>> latest_;  ///< last good ones
  std::vector<StepFailure> failures_;
  std::vector<Looked> looked_;
  std::optional<Asked> asked_;
  std::uint64_t lastId_ = 0;
  PartId expected_;  ///< as told
};

}  // namespace spineloft::app
