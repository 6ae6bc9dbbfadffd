// The ids of the command table, in the order of the alphabet: a public surface. What is written as a CommandId is one
// of them, or it does not compile; rows of the table as well.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace spineloft::app {

// clang-format off
inline constexpr auto kCommandIds = std::to_array<std::string_view>({
    "add-bone", "add-outline-point", "add-rib", "add-slice", "along-shape", "ask-place", "behind", "bend-spine", "bone",
    "bone-height", "both-sides", "bridge", "bridge-narrower", "bridge-wider", "brush-larger", "brush-smaller",
    "bump-here", "cancel", "check-print", "choose-handle", "choose-rib", "clear", "clear-ignored", "close-line", "coil",
    "colour-step", "copy-slices", "cut", "cut-add", "cut-by-box", "cut-by-scribble", "cut-cancel", "cut-mark",
    "cut-out", "cut-remove", "cut-start", "cut-use", "delete-line", "delete-model", "delete-outline-point",
    "delete-part", "delete-rib", "delete-slice", "delete-step", "depth-by-pressure", "draw", "draw-lathe", "draw-layer",
    "draw-line", "draw-on-sketch", "draw-puff", "draw-shape", "draw-sheet", "draw-spine", "draw-stack", "drop-bone",
    "drop-on-floor", "duplicate", "duplicate-model", "edge-bevel", "edge-round", "edge-sharp", "edit-slice", "eraser",
    "extend-spine", "face-front", "fewer-ribs", "find-command", "find-edges", "fit", "fit-side", "flat-foot",
    "fly-along", "focus-picture", "focus-solid", "fold-step", "group", "hand", "help", "hidden-pen", "hide-line",
    "hollow-cancel", "hollow-next", "hollow-open", "hollow-show", "hollow-use", "home-view", "ignore", "ignore-edges",
    "ignore-whole-picture", "in-front", "inside", "join-ends", "keep-common", "keep-ribs", "keep-slice", "language",
    "layer-blend", "layer-bumps", "layer-circle", "layer-copy", "layer-down", "layer-face", "layer-fork", "layer-free", "layer-lean",
    "layer-link", "layer-move", "layer-open-lines", "layer-rail", "layer-remove", "layer-repeat", "layer-sheet",
    "layer-square", "layer-up", "layer-wall", "layers", "lines", "list-down", "list-up", "load-shelf", "lock-rib",
    "make-puff", "make-round", "make-sheet", "mirror-copy", "more-ribs", "more-tools", "move", "move-bone",
    "move-in-list", "move-outline-point", "move-parts", "move-rib-end", "move-slice", "move-spine", "new-model",
    "new-part", "new-sketch", "next-bone", "next-bridge", "next-outline-point", "next-part", "next-picture",
    "next-point", "next-pupil", "next-shape-point", "next-slice", "nudge", "nudge-bone", "nudge-outline-point",
    "nudge-part", "nudge-shape-point", "open-file", "open-model", "open-picture", "order-operands", "order-pieces",
    "other-end", "paint-over", "paste-slices", "pen", "pen-colour", "pen-size", "pick", "pin-depth", "plain-outline",
    "plain-side", "point-opening", "pose-spine", "previous-bone", "previous-bridge", "previous-outline-point",
    "previous-picture", "previous-point", "previous-shape-point", "puff", "puff-back", "puff-both", "puff-front",
    "puff-slice", "pull", "pull-here", "pull-in", "pull-narrower", "pull-next", "pull-out", "pull-previous",
    "pull-remove", "pull-sharp", "pull-wider", "reach-less", "reach-more", "redo", "redraw", "redraw-region",
    "redraw-spine", "release", "relief", "remove-ignore", "remove-picture", "remove-slice", "rename-group",
    "rename-model", "rename-part", "rename-picture", "rename-slice", "rename-step", "reset-bones", "reset-place",
    "reset-pose", "reset-rib", "reset-ribs", "restore-bone", "ribs", "save-3mf", "save-glb", "save-obj", "save-picture",
    "save-project", "save-project-as", "save-stl", "save-turntable", "scoop-out", "seen-from", "seen-pen", "select-all",
    "select-part", "select-picture", "select-slice", "select-step", "set-along", "set-axis", "set-blend", "set-caps",
    "set-colour", "set-depth", "set-height", "set-paint", "set-parameter", "set-place", "set-pull", "set-second-colour",
    "set-section", "set-slices", "set-step", "set-view", "shape", "shape-kind", "shape-outline", "shape-piece",
    "shape-ribs", "shapes", "share-model", "sheet", "show-along", "show-beside", "show-part", "show-step",
    "show-trouble", "side-picture", "side-view", "size-like", "slice-add-point", "slice-back", "slice-cancel",
    "slice-clear", "slice-corner", "slice-done", "slice-draw", "slice-edge", "slice-flip", "slice-flip-front",
    "slice-front-back", "slice-here", "slice-left-right", "slice-move-point", "slice-on", "slice-redo",
    "slice-remove-point", "slice-start-from", "slice-symmetry", "slice-tool", "slice-traces", "slice-turn",
    "slice-undo", "slice-whole", "snap-to-surface", "solve-again", "spin", "stand-upright", "stick-together",
    "swap-bridge", "symmetry", "take-place", "thicken", "thicker", "thinner", "toggle-bone", "toggle-facets",
    "toggle-ink", "toggle-texture", "turn-down", "turn-left", "turn-right", "turn-up", "undo", "ungroup", "zoom-in",
    "zoom-out",
});
// clang-format on

class CommandId {
 public:
  constexpr CommandId() = default;  ///< none
  consteval CommandId(const char* id) : id_(id) {
    if (!std::ranges::binary_search(kCommandIds, id_)) isNoCommand();
  }
  constexpr operator std::string_view() const { return id_; }
  constexpr bool operator==(const CommandId&) const = default;

 private:
  static void isNoCommand();  ///< what cannot be called while compiling
  std::string_view id_;
};

}  // namespace spineloft::app
