#include "web/app/texture_work.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

namespace spineloft::app {
namespace {

/// How far beyond a texture a shape may reach that wears it meanwhile, as a share of its sides.
constexpr double kBeyond = 0.25;

bool liesOn(const mesh::TriMesh& mesh, const surface::UvArea& area) {
  const double x = kBeyond * (area.right - area.left), y = kBeyond * (area.bottom - area.top);
  return std::ranges::all_of(mesh.uv, [&](const auto& uv) {
    const auto u = static_cast<double>(uv[0]), v = static_cast<double>(uv[1]);
    return u >= area.left - x && u <= area.right + x && v >= area.top - y && v <= area.bottom + y;
  });
}

}  // namespace

struct TextureWork::Job {
  std::shared_ptr<pipeline::TextureMaking> making;
  bool started = false;
  std::atomic<bool> dropped = false;  ///< nobody waits for it any more
};

void TextureWork::update(const document::Document& document, const pipeline::Derived& derived) {
  std::vector<std::shared_ptr<Job>> jobs;
  for (const PartId id : derived.wantedTextures) {
    const auto part = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
    if (part == derived.parts.end() || !part->shape || isDressed(*part->shape)) continue;
    const std::uint64_t key = part->shape->key;
    const auto known = std::ranges::find_if(
        jobs_, [&](const auto& job) { return job->making->key() == key; });
    if (known != jobs_.end()) {
      jobs.push_back(*known);
    } else if (auto making = pipeline::makeTexture(document, derived, id)) {
      jobs.push_back(std::make_shared<Job>());
      jobs.back()->making = std::move(making);
    }
  }
  for (const auto& job : jobs_) {
    if (!std::ranges::count(jobs, job)) job->dropped = true;
  }
  jobs_ = std::move(jobs);
  start();
}

void TextureWork::start() {
  const auto most = static_cast<std::size_t>(std::max(1, pool_.threads()));
  for (std::size_t i = 0; i < std::min(most, jobs_.size()); ++i) {
    if (!std::exchange(jobs_[i]->started, true)) run(jobs_[i]);
  }
}

void TextureWork::run(const std::shared_ptr<Job>& job) {
  const bool inOneGo = pool_.threads() > 0;
  // No label: nobody who draws needs to know of it.
  pool_.submit(
      "",
      [job, inOneGo](const Progress& progress) {
        bool more = true;
        do {
          more = job->making->step();
        } while (more && inOneGo && !job->dropped && !progress.cancelled());
        return more;
      },
      [this, job](bool more) {
        if (job->dropped) return;
        if (more) {
          run(job);
        } else {
          done(job);
        }
      });
}

void TextureWork::done(const std::shared_ptr<Job>& job) {
  std::erase(jobs_, job);
  start();
  take_(job->making->key(), job->making->texture());
}

void TextureWork::finish(const document::Document& document, const pipeline::Derived& derived) {
  // What a worker has in hand is made anew: its steps are that worker's.
  for (const auto& job : jobs_) job->dropped = true;
  jobs_.clear();
  for (const PartId id : derived.wantedTextures) {
    const auto part = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
    if (part == derived.parts.end() || !part->shape || isDressed(*part->shape)) continue;
    const auto making = pipeline::makeTexture(document, derived, id);
    if (!making) continue;
    while (making->step()) {
    }
    take_(making->key(), making->texture());
  }
}

void wearEarlier(const pipeline::Derived& before, pipeline::Derived& now) {
  for (pipeline::DerivedPart& part : now.parts) {
    if (!part.shape || part.shape->key == 0 || isDressed(*part.shape)) continue;
    const auto was = std::ranges::find(before.parts, part.id, &pipeline::DerivedPart::id);
    if (was == before.parts.end() || !was->shape || !was->shape->texture) continue;
    if (!liesOn(part.shape->mesh, was->shape->texture->area)) continue;
    auto dressed = std::make_shared<pipeline::PartShape>(*part.shape);
    dressed->texture = was->shape->texture;
    dressed->textureKey = was->shape->textureKey;
    part.shape = std::move(dressed);
  }
}

}  // namespace spineloft::app
