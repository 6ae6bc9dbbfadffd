// What follows from the document: shapes, textures and solids, as one value made of the document and of what is known
// so far. What is not known is looked for by workers and by the solver of solids; the value is made anew with what
// they find. What a gesture does to solids lies over the value and leaves it as it is.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/worker_pool.h"
#include "engine/document/action.h"
#include "engine/pipeline/derive.h"
#include "web/model/session.h"
#include "web/model/solid_work.h"
#include "web/model/wanted_jobs.h"

namespace spineloft::app {

class Derivation {
 public:
  /// All three outlive it.
  Derivation(const Session& session, platform::Host& host, WorkerPool& pool);

  /// What is shown: up to date with the document and what is known. Has the workers look for what is missing, and
  /// reports parts that failed, each once.
  const pipeline::Derived& shown();
  /// The same without what a gesture in hand does to solids: what a file holds.
  const pipeline::Derived& settled();
  /// The document is another one, and previews are over.
  void documentChanged();
  /// Another model is open: nothing of what was made for the last one is kept.
  void forget();

  /// See Studio.
  Status preview(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape);
  Status previewLive(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape);
  std::vector<PicturePoint> strokeOnThing(const document::LoftRecipe& recipe);
  void previewSolid(const publish::Substitute& instead);
  void previewPlaced(const document::PlaceParts& places);
  void previewPinned(const document::PinDepth& pin);
  void endPreview();
  void expectEdit(PartId part);
  bool takeSolid(const Json& answer, std::span<const std::uint8_t> bytes);
  void solveAgain();
  bool finishParts();
  std::vector<PartId> crossingParts();

  /// Every shape and every solid is what it is going to be; pictures on them may still be made.
  bool shapesMade() const { return !stale_ && !behind_ && searching_.empty() && !reliefs_.busy() && !solids_.busy(); }
  /// Nothing that a file is to hold is still being made.
  bool allMade() const { return shapesMade() && !textures_.busy(); }
  /// Makes all of it, here and now: reliefs and textures, not solids.
  void finishNow();
  /// Stops the solver of solids, and nobody waits for a file any more.
  void cancel();

  Result<std::shared_ptr<const image::Picture>> pixels(const document::PictureEntry& entry) {
    return cache_.pixels(entry);
  }
  const SolidWork& solids() const { return solids_; }
  const pipeline::StageMs& lastMs() const { return lastMs_; }

 private:
  const document::Document& document() const { return session_.document(); }
  /// The value: of the document and what is known. `before` shows where what comes in its place is not there yet.
  pipeline::Derived make(const pipeline::Derived& before);
  void refresh();
  void layPreview(const document::Document& document, const publish::Substitute* instead);
  /// In the preview: bridges go along with the parts that they stand on.
  void carryBridges(const document::Document& document, const publish::Substitute* instead);
  void findEdges(PictureId id);
  void noteTimes(const pipeline::Derived& before);
  void report();
  void reportReliefs();
  void reportSolids();

  const Session& session_;
  platform::Host& host_;
  WorkerPool& pool_;
  pipeline::Cache cache_;
  pipeline::Derived derived_;
  std::optional<pipeline::Derived> preview_;  ///< `derived_` with the solids, or with all, of a gesture
  bool stale_ = false;
  bool behind_ = false;     ///< solids came that `derived_` leaves out while a preview lies over it
  bool finishing_ = false;  ///< of parts in no step all is to be known
  pipeline::StageMs lastMs_;
  struct Search {
    PictureId picture;
    std::uint64_t contentHash;
  };
  std::vector<Search> searching_;  ///< whose edges a worker seeks
  std::vector<std::pair<PartId, Error>> reported_;
  std::vector<std::pair<StepId, Error>> reportedSteps_;
  std::map<PartId, std::string> toldReliefs_;  ///< what was said last of each
  bool opened_ = false;                        ///< and not all shown yet
  SolidWork solids_;
  ReliefWork reliefs_;
  TextureWork textures_;
};

}  // namespace spineloft::app
