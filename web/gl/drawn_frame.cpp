#include "web/gl/drawn_frame.h"

#include <imgui.h>

#include <span>
#include <type_traits>
#include <utility>

namespace spineloft::gl {
namespace {

template <class T>
void put(std::vector<std::byte>& out, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

template <class T>
void put(std::vector<std::byte>& out, const T& value) {
  put(out, std::span(&value, 1));
}

/// All that decides about the pixels: vertices, indices, and for each command what is cut off and which texture it has.
void put(std::vector<std::byte>& out, const ImDrawList& list) {
  put(out, std::span<const ImDrawVert>(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size)));
  put(out, std::span<const ImDrawIdx>(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size)));
  const ImTextureID font = ImGui::GetIO().Fonts->TexID;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    put(out, std::span<const float>(&command.ClipRect.x, 4));
    put(out, command.VtxOffset);
    put(out, command.IdxOffset);
    put(out, command.ElemCount);
    const bool words = command.UserCallback != nullptr || command.TextureId == font;
    put(out, words ? TextureKey{} : static_cast<const SceneTexture*>(command.TextureId)->key);
  }
}

}  // namespace

bool DrawnFrame::takePanels(const ImDrawData* panels) {
  staging_.clear();
  if (panels != nullptr) {
    for (const ImDrawList* list : panels->CmdLists) put(staging_, *list);
  }
  std::swap(panels_, staging_);
  return panels_ == staging_;
}

bool DrawnFrame::shows(const Scene& scene, const ImDrawData* panels) {
  const bool samePanels = takePanels(panels);
  const bool still = scene_.still;
  scene_.still = scene.still;
  scene_.held = scene.held;  // the same pixels
  if (known_ && samePanels && scene_ == scene && (still || !scene.still)) {
    scene_.still = still;
    return true;
  }
  scene_ = scene;
  known_ = true;
  return false;
}

}  // namespace spineloft::gl
