#include "web/model/cut_out_work.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/io/json_fields.h"
#include "engine/vision/cut_out_numbers.h"
#include "web/model/messages.h"

namespace spineloft::app {

void CutOutWork::begin(const From& from, const vision::CutHints& hints, Finish finish) {
  const image::Picture& picture = from.picture;
  if (++lastId_ == 0) ++lastId_;
  asked_ = Asked{lastId_, {picture.width, picture.height}, std::move(finish)};
  const std::vector<double> numbers = vision::numbersOf(hints);
  const std::string key = io::hashKey(from.contentHash);
  host_.cutOut({lastId_, numbers, key, picture});
}

bool CutOutWork::take(const platform::CutAnswer& answer) {
  using enum platform::CutAnswer::Kind;
  if (!asked_ || answer.id != asked_->id) return false;
  switch (answer.kind) {
    case Progress:
      asked_->done = std::clamp(answer.done, 0.0, 1.0);
      break;
    case Found: {
      auto found = vision::foundFrom(answer.found);
      takeFound(found ? std::move(*found) : Result<vision::CutContours>(Error::NothingCutOut));
      break;
    }
    case Stopped:
      endUnfinished("Cutting out was interrupted. Nothing is lost: try it again.");
      break;
    case Unreachable:
      endUnfinished(
          "What cuts things out could not be loaded. Nothing is lost: check the connection and try it again.");
      break;
  }
  return true;
}

/// The outlines are filled off this thread: there may be thousands of points.
void CutOutWork::takeFound(Result<vision::CutContours> found) {
  if (!found) {
    end(found.failure());
    return;
  }
  asked_->done = 1;
  pool_.submit(
      "",  // it is the end of what `done` tells of
      [contours = std::move(found).value(), size = asked_->picture](const Progress&) {
        return filledShape(contours, size);
      },
      [this, id = asked_->id](CutShape shape) {
        if (asked_ && asked_->id == id) end(std::move(shape));
      });
}

void CutOutWork::end(Result<CutShape> shape) {
  const Finish finish = std::move(asked_->finish);
  asked_.reset();
  finish(std::move(shape));
}

/// The search has no answer: that is said, and all is as before it.
void CutOutWork::endUnfinished(std::string_view sentence) {
  sendError(host_, sentence);
  end(Error::Cancelled);
}

void CutOutWork::stop() {
  if (!asked_) return;
  asked_.reset();
  host_.send(R"({"type":"stopCuttingOut"})");
}

void CutOutWork::cancel() {
  if (!asked_) return;
  const Finish finish = std::move(asked_->finish);
  stop();
  finish(Error::Cancelled);
}

}  // namespace spineloft::app
