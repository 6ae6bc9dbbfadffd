// Textures of the parts: made by the workers once the shapes are on the screen, or between frames.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "engine/base/worker_pool.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::app {

class TextureWork {
 public:
  /// Is handed the textures, with the keys of their shapes.
  using Take = std::function<void(std::uint64_t key, std::shared_ptr<const surface::PartTexture>)>;
  /// The pool must not outlive it.
  TextureWork(WorkerPool& pool, Take take) : pool_(pool), take_(std::move(take)) {}

  /// Begins with what is wanted now, and lets go of what is not any more. As many are made at a time as
  /// there are workers; without any, a step of one a job.
  void update(const document::Document& document, const pipeline::Derived& derived);
  /// Makes all that are wanted, now and here.
  void finish(const document::Document& document, const pipeline::Derived& derived);
  bool busy() const { return !jobs_.empty(); }

 private:
  struct Job;
  void start();
  void run(const std::shared_ptr<Job>& job);
  void done(const std::shared_ptr<Job>& job);

  WorkerPool& pool_;
  Take take_;
  std::vector<std::shared_ptr<Job>> jobs_;  ///< in the order of the parts
};

/// Parts that wait for a texture of their own wear that of their earlier shape, where it lies on the same
/// stretch of the picture: nothing flickers while a part is worked on.
void wearEarlier(const pipeline::Derived& before, pipeline::Derived& now);

}  // namespace spineloft::app
