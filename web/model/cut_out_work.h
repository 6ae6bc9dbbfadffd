// Cut-outs: asks the program of the page that cuts out (vision::CutOutSearch in a worker, web/cut_out.cpp) for one
// thing at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "engine/base/worker_pool.h"
#include "engine/image/image.h"
#include "engine/vision/cut_out.h"
#include "web/model/cut_draft.h"
#include "web/platform/host.h"
#include "web/platform/page.h"

namespace spineloft::app {

class CutOutWork {
 public:
  using Finish = std::function<void(Result<CutShape>)>;
  /// Both outlive it.
  CutOutWork(platform::Host& host, WorkerPool& pool) : host_(host), pool_(pool) {}

  struct From {
    const image::Picture& picture;
    std::uint64_t contentHash = 0;
  };
  /// Asks for a thing in a picture in place of what was asked for before. `finish` is called once, later, unless
  /// another `begin` or `stop` comes first. Errors that it is given: those of vision::CutOutSearch; Cancelled after
  /// `cancel`, and where the program ends or cannot be loaded, which is said.
  void begin(const From& from, const vision::CutHints& hints, Finish finish);
  /// What the program says. True when something changed.
  bool take(const platform::CutAnswer& answer);
  /// Nobody waits any more.
  void stop();
  /// The same, and whoever waits is told.
  void cancel();

  bool busy() const { return asked_.has_value(); }
  /// 0…1
  double done() const { return busy() ? asked_->done : 1; }

 private:
  struct Asked {
    std::uint32_t id = 0;
    image::Size picture;
    Finish finish;
    double done = 0;
  };
  void takeFound(Result<vision::CutContours> found);
  void end(Result<CutShape> shape);
  void endUnfinished(std::string_view sentence);

  platform::Host& host_;
  WorkerPool& pool_;
  std::optional<Asked> asked_;
  std::uint32_t lastId_ = 0;
};

}  // namespace spineloft::app
