// What a pen feels: from its move to the new mesh, and what a thousand strokes leave behind.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/image/image.h"
#include "tests/bench/report.h"

namespace spineloft::bench {

/// A stroke that grows, as the page previews it: the caches of a document, one thread. Spines of 100
/// and 200 points; then a thousand finished strokes, and by how much the heap grew from the tenth on.
void reportPenStages(const image::Picture& picture, const image::EdgeMap& edges, Report& report);

/// The heap at its largest after a photo of 24 megapixels was handed over as the page does it, its edges
/// were found and a stroke was traced, in MB: of WebAssembly all of its memory, native the process's.
void reportPhoto(Report& report);

/// How much faster two workers find the edges of two pictures, and the field on two halves of a grid,
/// than one: 2 at best. Nothing where there are no threads. Beside them what sums in registers gain: processors that
/// are threads of one core share its arithmetic, and there no work of this kind gains more.
void reportTwoWorkers(const image::Picture& picture, Report& report);

}  // namespace spineloft::bench
