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

class SolidWork {
 public:
  explicit SolidWork(platform::Host& host) : host_(host) {}

  /// What is to be known of parts in no step: what is known, or, for a file, all.
  enum class Alone { AsKnown, All };

  /// Sets `derived.steps`, and what is known of parts that go through themselves; asks the solver for what is not known
  /// yet. A newer request replaces the one it is at.
  void update(const document::Document& document, pipeline::Derived& derived, Alone alone = Alone::AsKnown);
  /// Forgets which parts in no step were not mended because the solver was stopped or died: the next `update` for all
  /// asks once more.
  void refineLabels(const pipeline::Derived& derived);
  /// The same for a document as a gesture would make it, with another mesh for a part that is being edited, unless
  /// the solver is at something: the hand never waits. What comes shows until the next `update`. Parts that are only
  /// joined show themselves meanwhile: that looks the same, and costs nothing.
  void preview(const document::Document& document, pipeline::Derived& derived, const publish::Substitute* instead);

  /// Asks for the outermost solid that was made last in `likely`, a document as it may soon be, unless the solver is at
  /// something that is waited for: when the document comes to be so, the solid is there. Nothing of it shows before.
  void prepare(const document::Document& likely, const pipeline::Derived& derived);

  /// Has the solver make what is newest in `likely` for itself, unless it is at something: nothing of it comes back,
  /// but whatever is asked for next finds the parts and their union there. Not where that is more than a little.
  void prepareParts(const document::Document& likely, const pipeline::Derived& derived);

  /// The part that is likely to be edited next, or none: told to the solver when it is another one than before, so
  /// that it makes ready while nothing else is asked for.
  void expect(PartId part);

  /// What the solver says: {id, done}, {id, progress}, {id, lost} or {id, step, key, ms, mesh | failure}, with the
  /// arrays of the mesh as bytes: positions, uv, corners, both lists of merged vertices. True when something
  /// changed.
  bool take(const Json& answer, std::span<const std::uint8_t> bytes);

  /// Whether something is asked for that is waited for.
  bool busy() const { return asked_ && asked_->purpose != Purpose::Ahead; }
  double done() const { return busy() ? asked_->done : 1; }
  /// Stops the solver; what it was at is not asked for again before it changes, or `again`.
  void cancel();
  /// Forgets failures, so that the next `update` asks once more.
  void again() { failures_.clear(); }
  /// Lets go of all solids: another model is opened.
  void forget();

 private:
  /// For the document as it is, for a gesture, or for what may come.
  enum class Purpose { Document, Preview, Ahead };
  struct Asked {
    double id = 0;
    std::vector<std::uint64_t> keys;
    Purpose purpose = Purpose::Document;
    double done = 0;
  };
  struct Trouble {
    std::uint64_t key = 0;
    Failure failure;
    PartId faulty;
    std::optional<WorldPoint> at;
    std::optional<double> thickest = {};
  };
  /// A shape that was looked over for places where it goes through itself.
  struct Looked {
    std::uint64_t key = 0;
    std::optional<ModelPoint> crosses;
  };
  void updateSteps(const document::Document& document, pipeline::Derived& derived, const publish::SolidPlan& plan,
                   std::vector<std::uint64_t>& missing);
  void updateAlone(const document::Document& document, pipeline::Derived& derived, Alone alone,
                   publish::SolidPlan& plan, std::vector<std::uint64_t>& missing);
  const Looked* lookOver(const pipeline::PartShape& shape, Alone alone);
  void ask(const publish::SolidPlan& plan, std::vector<std::uint64_t> keys, Purpose purpose);
  void keepFailure(Trouble trouble);
  const Trouble* stepFailureWords(std::uint64_t key) const;
  bool takeSolid(const Json& answer, std::span<const std::uint8_t> bytes);

  platform::Host& host_;
  static constexpr std::size_t kMostBytes = std::size_t{96} << 20;
  pipeline::LruCache<pipeline::Solid> solids_{kMostBytes};
  std::vector<std::pair<StepId, std::shared_ptr<const pipeline::Solid>>> latest_;  ///< last good ones
  std::vector<Trouble> failures_;
  std::vector<Looked> looked_;
  std::optional<Asked> asked_;
  std::uint64_t lastId_ = 0;
  PartId expected_;             ///< as told
  std::uint64_t prepared_ = 0;  ///< asked for ahead, once
  std::uint64_t likely_ = 0;    ///< made by the solver for itself, once
};

}  // namespace spineloft::app
