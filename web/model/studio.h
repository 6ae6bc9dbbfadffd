// The document with its history, everything derived from it, and the work going on about it. No
// drawing, no input: commands and tests talk to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/worker_pool.h"
#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/document/history.h"
#include "engine/pipeline/derive.h"
#include "engine/publish/publish.h"
#include "web/model/cut_draft.h"
#include "web/model/solid_work.h"
#include "web/model/wanted_jobs.h"
#include "web/platform/host.h"

namespace spineloft::app {

class Studio {
 public:
  /// `threads` of the worker pool; 0 works between frames.
  Studio(platform::Host& host, int threads);

  const document::Document& document() const { return history_.present(); }
  std::size_t undoSteps() const { return history_.undoSteps(); }
  std::size_t redoSteps() const { return history_.redoSteps(); }

  /// All actions or none, as one step of undo. Errors: those of document::update.
  /// Equal bursts (not empty) shortly after each other, with nothing in between, are one step.
  Status act(std::span<const document::Action> actions, std::string_view burst = {});
  Status act(const document::Action& action) { return act({&action, 1}); }
  Status undo();
  Status redo();
  /// An empty board; undo brings the old one back.
  void clear();

  /// Every step with its past and future. Each commit, undo and redo is told to the host as a record
  /// of the journal (engine/io/journal.h), in order.
  const document::History<document::Document>& history() const { return history_; }
  /// Another model: its history takes the place of this one. No record of it is told.
  void open(document::History<document::Document> history);
  /// Tells the record of a burst that goes on (amends), once its time has come or `now`.
  void sendAmends(bool now = false);

  /// Up to date with the document: derives now if it has to. Starts the search for edges that are
  /// missing and the making of textures, and reports parts that failed, each once.
  const pipeline::Derived& derived();

  /// What a recipe would become, with the edges known so far (pipeline::previewShape).
  Status preview(const document::Recipe& recipe, pipeline::PartShape& shape);
  /// The same while its stroke is being drawn (pipeline::liveShape).
  Status previewLive(const document::Recipe& recipe, pipeline::PartShape& shape);

  /// A stroke as far as it lies on the thing under it (pipeline::strokeOnThing).
  std::vector<PicturePoint> strokeOnThing(const document::LoftRecipe& recipe);

  /// A file or a check is wanted: parts in no step that go through themselves are mended by the solver, as far as they
  /// can be (DerivedPart::mended). False: it is at it, or shapes are still searched for, until `shapesMade`.
  bool finishParts();
  /// Every shape and every solid is what it is going to be; pictures on them may still be made.
  bool shapesMade() const { return !stale_ && searching_.empty() && !traces_.busy() && !solids_.busy(); }
  /// What goes through itself and could not be mended.
  std::vector<PartId> crossingParts();

  /// Writes the model on a worker and hands the file to the shell. Errors: NothingToExport.
  Status save(publish::Format format);
  /// The file, now and here.
  Result<publish::Bytes> publishNow(publish::Format format);

  /// Looks for a thing in a picture (vision::CutOutSearch) on a worker, a round a job, so that without
  /// threads the page is drawn in between. `done` is called once, unless another search or stopCutOut
  /// comes first; with Cancelled after cancelWork. Errors: NoSuchPicture, those of the pixels.
  Status cutOut(PictureId picture, const vision::CutHints& hints, std::function<void(Result<CutShape>)> done);
  void stopCutOut();

  /// Takes in what the workers finished. True when something changed.
  bool pump();
  bool busy() const { return works() || solids_.busy(); }
  /// Threads of its own are at something; the solver of solids speaks up by itself.
  bool works() const { return !pool_.idle(); }
  int threads() const { return pool_.threads(); }
  /// What is going on, for a progress bar; not what takes a moment only.
  struct Activity {
    std::string label;
    double done = 0;
  };
  std::optional<Activity> activity() const;
  void cancelWork();

  /// The chosen part, or none: what an edit of it needs of the solid that it is in is made ready.
  void expectEdit(PartId part);
  /// What the solver of solids says (SolidWork::take). True when something changed.
  bool takeSolid(const Json& answer, std::span<const std::uint8_t> bytes);
  /// A part of a solid with the mesh that a gesture makes: its solid follows, as fast as the solver is.
  void previewSolid(const publish::Substitute& instead);
  /// The same while parts are being placed.
  void previewPlaced(const document::PlaceParts& places);
  /// Back to the solids of the document, after a preview.
  void endPreview();
  /// Asks once more for solids that failed or were cancelled.
  void solveAgain();

  const pipeline::StageMs& lastMs() const { return lastMs_; }
  /// There are parts, and no file that a model can be opened from holds the document as it is.
  bool unsaved() const;
  /// Counts the changes of the document and of what is derived from it.
  std::uint64_t revision() const { return revision_; }

 private:
  struct CutSearch;
  void nextCutRound(const std::shared_ptr<CutSearch>& search);
  void changed();
  /// Tells what was just committed.
  void tell(document::Committed committed, const document::Document& before);
  void sendRecord(std::string record, const document::Document& before);
  void findEdges(PictureId id);
  void keepShown(const pipeline::Derived& before);
  void noteTimes(const pipeline::Derived& before);
  void updateSolids();
  void reportSolids();
  void takeTrace(const pipeline::TraceJob& making);
  void takeTexture(const pipeline::TextureJob& making);
  /// Nothing that a file is to hold is still being made.
  bool allMade() const { return shapesMade() && !textures_.busy(); }
  /// Saves what waited for it, when all is there.
  void saveWaiting();
  Status saveNow(publish::Format format);
  /// Says what of the model a file in this format does not hold as it should be.
  void reportFaults(publish::Format format);
  void report(const pipeline::Derived& derived);
  void finishSave(Result<publish::Bytes> bytes, publish::Format format, const document::Document& written);

  platform::Host& host_;
  document::History<document::Document> history_;
  document::Document saved_;
  std::optional<document::Document> amendedFrom_;  ///< amends since this one are not told yet
  double amendedMs_ = 0;                           ///< when the first of them was
  pipeline::Cache cache_;
  pipeline::Derived derived_;
  bool stale_ = false;
  std::string burst_;
  double burstMs_ = 0;
  document::Gesture gesture_ = 0;  ///< of the history: counts the bursts
  pipeline::StageMs lastMs_;
  std::uint64_t revision_ = 0;
  struct Search {
    PictureId picture;
    std::uint64_t contentHash;
  };
  std::vector<Search> searching_;  ///< whose edges a worker seeks
  std::vector<std::pair<PartId, Error>> reported_;
  std::vector<std::pair<StepId, Error>> reportedSteps_;
  SolidWork solids_;
  bool previewing_ = false;
  bool finishing_ = false;                ///< of parts in no step all is to be known
  std::shared_ptr<CutSearch> cutSearch_;  ///< the one whose end is waited for
  /// Waits for the ribs, solids and textures it is to hold.
  std::optional<publish::Format> saveWaiting_;
  TraceWork traces_;
  TextureWork textures_;
  WorkerPool pool_;  ///< last: its jobs end before the rest goes
};

}  // namespace spineloft::app
