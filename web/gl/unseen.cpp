#include "web/gl/unseen.h"

#include <imgui.h>

#include <algorithm>

namespace spineloft::gl {
namespace {

bool isSeen(const ImVec2& a, const ImVec2& b, const ImVec2& c, const ImVec4& clip) {
  return std::max({a.x, b.x, c.x}) > clip.x && std::min({a.x, b.x, c.x}) < clip.z &&
         std::max({a.y, b.y, c.y}) > clip.y && std::min({a.y, b.y, c.y}) < clip.w;
}

}  // namespace

void dropUnseen(ImDrawData& data) {
  for (ImDrawList* list : data.CmdLists) {
    for (ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback != nullptr) continue;
      ImDrawIdx* const first = list->IdxBuffer.Data + command.IdxOffset;
      const ImDrawVert* const vertices = list->VtxBuffer.Data + command.VtxOffset;
      ImDrawIdx* end = first;
      for (const ImDrawIdx* at = first; at < first + command.ElemCount; at += 3) {
        if (isSeen(vertices[at[0]].pos, vertices[at[1]].pos, vertices[at[2]].pos, command.ClipRect)) {
          end = std::copy_n(at, 3, end);
        }
      }
      command.ElemCount = static_cast<unsigned>(end - first);
    }
  }
}

}  // namespace spineloft::gl
