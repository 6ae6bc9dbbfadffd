// What the derived parts still want, as work for the workers once the shapes are on the screen.
#pragma once

#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/model/job_queue.h"

namespace spineloft::app {

using TextureWork = JobQueue<pipeline::TextureJob>;
using ReliefWork = JobQueue<pipeline::ReliefJob>;

/// Of Derived::wantedTextures; begins as long as both are as they are.
std::vector<TextureWork::Wanted> wantedTextures(const document::Document& document, const pipeline::Derived& derived);

/// Of Derived::wantedReliefs; likewise.
std::vector<ReliefWork::Wanted> wantedReliefs(const document::Document& document, const pipeline::Derived& derived);

/// Parts that wait for a relief and had another one on the same surface stay as they were.
void keepEarlierReliefs(const pipeline::Derived& before, pipeline::Derived& now);

/// Parts that wait for a texture of their own show that of their earlier shape, where it lies on the same
/// stretch of the picture: nothing flickers while a part is worked on.
void keepEarlierTextures(const pipeline::Derived& before, pipeline::Derived& now);

}  // namespace spineloft::app
