// What Dear ImGui draws outside of what it shows of it.
#pragma once

struct ImDrawData;

namespace spineloft::gl {

/// Takes the triangles out that lie wholly outside of their commands' clip rectangles, as most of a scrolled list does:
/// where a processor draws, each costs as much as one that is seen.
void dropUnseen(ImDrawData& data);

}  // namespace spineloft::gl
