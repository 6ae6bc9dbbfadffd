// Ribs on which several hands agree. A hand wanders, and a search from one stroke may take an accident of it
// for the thing: what slightly different strokes through the same thing find tells which of the ends are the thing's.
#pragma once

#include "engine/ribs/ribs.h"
#include "engine/ribs/trace_variant.h"

namespace spineloft::ribs {

/// traceRibs, and again for six other hands: beside the stroke by an eighth and a quarter of the width, and from
/// further in or out at the ends. Every end, those of the fans too, comes to stand where half of the outlines have
/// been left on its gradient curve; each counts for as much as it agrees with the others (mean ratio of lengths, to
/// the third power). Confidence is that of the stroke's own search. As long as seven searches of at most 100
/// ribs. Where nothing is known of the picture, and for fewer than four ribs, it is traceRibs. Its laws and errors.
Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, RibWorkspace& memory);

/// The same with parts of every search exchanged (trace_variant.h).
Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, TraceVariant variant, RibWorkspace& memory);

}  // namespace spineloft::ribs
