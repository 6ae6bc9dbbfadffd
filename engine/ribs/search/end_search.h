// The last step of a search for ribs: the ends of the part, and the ribs that bend round them. Internal to
// ribs/.
#pragma once

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {

/// Where the part ends beyond the stroke's start or end: the fan of that end. Near the end of a wide part the
/// last ribs run round it, and neighbours and the width so far may have held them beyond it. So the end
/// is looked for twice, from the last ribs as they are, and with all ribs that reach beyond the stroke
/// free to find it too; where that explains the picture better and the part goes no farther, these ribs
/// of `set` are moved to it. The fan is that of `set`; what it was taken for is returned. O((ribs moved + fan) ·
/// levels).
EndShape findEnd(bool atStart, RibSet& set, Search& s);

/// The fan of that end where its curves are to end at these lengths (of every curve, picture pixels), shaped as
/// `s.shapes` says; without curves that go nowhere.
void placeEnd(bool atStart, const std::vector<float>& lengths, RibSet& set, Search& s);

}  // namespace spineloft::ribs
