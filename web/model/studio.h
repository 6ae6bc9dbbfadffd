// The open model: its session, what is derived from it, and what is saved of it, on one pool of workers. No
// drawing, no input: commands and tests talk to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/worker_pool.h"
#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/document/history.h"
#include "engine/pipeline/derive.h"
#include "engine/publish/publish.h"
#include "web/model/cut_out_work.h"
#include "web/model/derivation.h"
#include "web/model/saver.h"
#include "web/model/session.h"
#include "web/platform/host.h"

namespace spineloft::app {

class Studio {
 public:
  /// `threads` of the worker pool; 0 works between frames.
  Studio(platform::Host& host, int threads);

  // The session; see session.h.
  const document::Document& document() const { return session_.document(); }
  const document::History<document::Document>& history() const { return session_.history(); }
  std::size_t undoSteps() const { return history().undoSteps(); }
  std::size_t redoSteps() const { return history().redoSteps(); }
  Status act(std::span<const document::Action> actions, std::string_view burst = {}) {
    return changed(session_.act(actions, burst));
  }
  Status act(const document::Action& action) { return act({&action, 1}); }
  Status undo() { return changed(session_.undo()); }
  Status redo() { return changed(session_.redo()); }
  /// An empty board; undo brings the old one back.
  void clear();
  /// Another model: its history takes the place of this one. No record of it is told.
  void open(document::History<document::Document> history);
  /// Tells the record of a burst that goes on (amends), once its time has come or `now`.
  void sendAmends(bool now = false) { session_.sendAmends(now); }

  // What is derived; see derivation.h.
  /// What is shown: up to date with the document, derived now if it has to be.
  const pipeline::Derived& derived();
  /// What a recipe would become, with the edges known so far (pipeline::previewShape).
  Status preview(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape) {
    return derivation_.preview(recipe, worked, shape);
  }
  /// The same while its stroke is being drawn (pipeline::liveShape).
  Status previewLive(const document::Recipe& recipe, pipeline::Worked worked, pipeline::PartShape& shape) {
    return derivation_.previewLive(recipe, worked, shape);
  }
  /// A stroke as far as it lies on the thing under it (pipeline::strokeOnThing).
  std::vector<PicturePoint> strokeOnThing(const document::LoftRecipe& recipe) {
    return derivation_.strokeOnThing(recipe);
  }
  /// A file or a check is wanted: parts in no step that go through themselves are mended by the solver, as far as they
  /// can be (DerivedPart::mended). False: it is at it, or shapes are still searched for, until `shapesMade`.
  bool finishParts() { return derivation_.finishParts(); }
  /// Every shape and every solid is what it is going to be; pictures on them may still be made.
  bool shapesMade() const { return derivation_.shapesMade(); }
  /// What goes through itself and could not be mended.
  std::vector<PartId> crossingParts() { return derivation_.crossingParts(); }
  /// The chosen part, or none: what an edit of it needs of the solid that it is in is made ready.
  void expectEdit(PartId part) { derivation_.expectEdit(part); }
  /// What the solver of solids says (SolidWork::take). True when something changed.
  bool takeSolid(const Json& answer, std::span<const std::uint8_t> bytes);
  /// A part of a solid with the mesh that a gesture makes: its solid follows, as fast as the solver is.
  void previewSolid(const publish::Substitute& instead) { derivation_.previewSolid(instead); }
  /// The same while parts are being placed.
  void previewPlaced(const document::PlaceParts& places) { derivation_.previewPlaced(places); }
  /// The pieces of a line drawing, and the solids they are in, as they would be with this depth.
  void previewPinned(const document::PinDepth& pin) { derivation_.previewPinned(pin); }
  /// Back to what follows from the document, after a preview.
  void endPreview() { derivation_.endPreview(); }
  /// Asks once more for solids that failed or were cancelled.
  void solveAgain() { derivation_.solveAgain(); }
  const pipeline::StageMs& lastMs() const { return derivation_.lastMs(); }

  // Files; see saver.h.
  Status save(publish::Format format) { return saver_.save(format); }
  Result<publish::Bytes> publishNow(publish::Format format) { return saver_.publishNow(format); }
  Result<publish::SharedModel> shareNow() { return saver_.shareNow(); }
  bool unsaved() const { return saver_.unsaved(); }

  /// Has a thing cut out of a picture; see cut_out_work.h. `done` is called once, unless another search or stopCutOut
  /// comes first; with Cancelled after cancelWork. Errors: NoSuchPicture, those of the pixels.
  Status cutOut(PictureId picture, const vision::CutHints& hints, CutOutWork::Finish done);
  void stopCutOut() { cutOut_.stop(); }
  /// What the program that cuts out says. True when something changed.
  bool takeCutOut(const platform::CutAnswer& answer) { return cutOut_.take(answer); }

  /// Takes in what the workers finished. True when something changed.
  bool pump();
  bool busy() const { return works() || cutOut_.busy() || derivation_.solids().busy(); }
  /// Threads of its own are at something; what works elsewhere speaks up by itself.
  bool works() const { return !pool_.idle(); }
  int threads() const { return pool_.threads(); }
  /// What is going on, for a progress bar; not what takes a moment only.
  struct Activity {
    std::string label;
    double done = 0;
  };
  std::optional<Activity> activity() const;
  void cancelWork();

 private:
  /// The document is another one, if that went well.
  Status changed(Status status);

  Session session_;
  Derivation derivation_;
  Saver saver_;
  CutOutWork cutOut_;
  WorkerPool pool_;  ///< last: its jobs end before the rest goes
};

}  // namespace spineloft::app
