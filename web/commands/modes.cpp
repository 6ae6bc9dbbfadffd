#include "web/commands/modes.h"

#include <array>

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool always(Env) { return true; }
bool never(Env) { return false; }

// clang-format off
constexpr Mode
    kGesture{"gesture", [](Env env) { return env.hand != nullptr && env.hand->holds(); },
             [](Env env) { env.hand->drop(); },  // it is the last thing done, and all that undo takes back
             [](Env env, const Json&) { return env.hand->drop(), Outcome(); },
             [](Env, const Json&) { return Outcome(); }, always, never},
    kMenu{"menu", [](Env env) { return env.ui.barMenu != BarMenu::None || env.ui.pictureMenu ||
                                       env.ui.sketching.menu != PenMenu::None; },
          [](Env env) { closeMenus(env.ui); }},
    kPlaceSection{"place-slice", [](Env env) { return env.ui.sections.placing; },
                  [](Env env) { env.ui.sections.placing = false; }},
    kPointOpening{"point-opening", [](Env env) { return env.ui.solids.pointing; },
                  [](Env env) { env.ui.solids.pointing = false; }},
    kPreview{"preview", [](Env env) { return bool(env.ui.preview); }, [](Env env) { env.ui.preview.reset(); }},
    kRedraw{"redraw", [](Env env) { return bool(env.ui.redraw); }, [](Env env) { env.ui.redraw = {}; }},
    kWork{"work", [](Env env) { return env.studio.activity().has_value(); }, [](Env env) { env.studio.cancelWork(); }},
    kChosen{"chosen", [](Env env) { return env.ui.chosen != Chosen{}; }, [](Env env) { env.ui.chosen = {}; }},
    kTool{"tool", [](Env env) { return env.ui.tool != ToolKind::Draw && env.ui.tool != ToolKind::Hand; },
          [](Env env) { env.ui.tool = ToolKind::Draw; }},
    kModel{"model", always, [](Env env) { env.ui.selection = {}; },
           [](Env env, const Json&) { return outcomeOf(env.studio.undo()); },
           [](Env env, const Json&) { return outcomeOf(env.studio.redo()); },
           [](Env env) { return env.studio.undoSteps() > 0; }, [](Env env) { return env.studio.redoSteps() > 0; }};

constexpr std::array kModes = {
    &kGesture, &kMenu, &kBoardMode, &kCutMode, &kPlaceSection, &kPointOpening, &kHollowMode, &kPreview, &kRedraw, &kWork,
    &kOutlinePointMode, &kBoneMode, &kShapePointMode, &kPullMode, &kRibMode, &kPointMode, &kChosen, &kBonesMode, &kShapeMode, &kCrossingMode, &kLinesMode, &kOutlineMode, &kPullToolMode, &kBridgeToolMode, &kRailMode, &kLayerMode, &kPartsMode, &kTool, &kModel};
// clang-format on

}  // namespace

std::span<const Mode* const> modes() { return kModes; }

}  // namespace spineloft::app
