// The last step of a search for ribs: the ends of the part, and the ribs that bend round them. Internal to
// ribs/.
#pragma once

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {

/// Finds the end of the part beyond the start or end of the stroke and fills the fan of that end in `set`.
/// Near the end of a wide part the last ribs bend round it, and neighbour and opposite costs may have held
/// them beyond it. The end is therefore searched twice: from the last ribs as they are, and with all ribs that reach
/// beyond the stroke free. If the second explains the picture better and reaches no farther, these ribs of `set` are
/// moved. O((ribs moved + fan) · levels).
void findEnd(bool atStart, RibSet& set, Search& s);

}  // namespace spineloft::ribs
