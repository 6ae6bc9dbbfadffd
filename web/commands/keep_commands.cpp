// Commands about models on this device and project files. The shell does what needs the browser
// (web/shell/keep); what is about the open document happens here.
#include <array>

#include "web/commands/command_actions.h"
#include "web/commands/command_groups.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasWork(Env env) {
  const document::Document& document = env.studio.document();
  return !document.pictures.empty() || !document.parts.empty();
}

/// Asks the shell, with the model that `args` names.
Outcome tellShell(Env env, std::string_view what, const Json& args) {
  const std::string* id = args.text("id");
  sendKeep(env.host, what, id ? std::string_view(*id) : std::string_view());
  return {};
}

Outcome newModel(Env env, const Json& args) { return tellShell(env, "new-model", args); }
Outcome nextPupil(Env env, const Json& args) { return tellShell(env, "next-pupil", args); }
Outcome openModel(Env env, const Json& args) { return tellShell(env, "open-model", args); }
Outcome openFile(Env env, const Json& args) { return tellShell(env, "open-file", args); }
Outcome duplicateModel(Env env, const Json& args) { return tellShell(env, "duplicate-model", args); }
Outcome deleteModel(Env env, const Json& args) { return tellShell(env, "delete-model", args); }

Outcome shareModel(Env env, const Json& args) { return tellShell(env, "share-model", args); }

Outcome renameTo(Env env, const std::string& name) { return outcomeOf(env.studio.act(document::RenameDocument{name})); }

Outcome renameModel(Env env, const Json& args) {
  if (const std::string* name = args.text("name")) return renameTo(env, *name);
  return app::ask(env, {"rename-model", "Rename model", "A name for this model", env.studio.document().name}, renameTo);
}

Outcome saveProject(Env env, const Json&) { return outcomeOf(env.studio.save(publish::Format::Project)); }

Outcome saveUnder(Env env, const std::string& name) {
  if (Outcome done = renameTo(env, name); !done) return done;
  return saveProject(env, {});
}

Outcome saveProjectAs(Env env, const Json& args) {
  if (const std::string* name = args.text("name")) return saveUnder(env, *name);
  return app::ask(env, {"save-project-as", "Save as", "A name for the model and its file", env.studio.document().name},
                  saveUnder);
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "save-project", .label = "Save model", .icon = "save", .shortcut = "Ctrl+S", .group = "model",
            .hint = "A file with everything in it, to go on with later or elsewhere", .enabled = hasWork,
            .run = saveProject},
    Command{.id = "save-project-as", .label = "Save model as", .icon = "save-all", .shortcut = "Shift+Ctrl+S",
            .group = "model", .hint = "The same under a new name", .enabled = hasWork, .run = saveProjectAs},
    Command{.id = "new-model", .label = "New model", .icon = "file-plus", .group = "model",
            .hint = "Begin another one; this one stays in your models", .enabled = hasWork, .run = newModel},
    Command{.id = "next-pupil", .label = "Next pupil", .icon = "users", .group = "model",
            .hint = "Put the models away under an animal, and begin afresh", .run = nextPupil},
    Command{.id = "open-model", .label = "Your models", .icon = "layout-grid", .shortcut = "Shift+Ctrl+O",
            .group = "model", .hint = "Go on with a model that this device keeps", .menu = "Model", .run = openModel},
    Command{.id = "open-file", .label = "Open model file", .icon = "folder-open", .group = "model",
            .hint = "A .spineloft file, or a GLB that was saved here", .run = openFile},
    Command{.id = "duplicate-model", .label = "Duplicate model", .icon = "copy", .group = "model",
            .hint = "Go on with a copy; the model as it is stays in your models", .enabled = hasWork,
            .run = duplicateModel},
    Command{.id = "rename-model", .label = "Rename model", .icon = "pencil-line", .group = "model",
            .hint = "Give the model another name", .enabled = hasWork, .run = renameModel},
    Command{.id = "share-model", .label = "Share", .icon = "share-2", .group = "model",
            .hint = "A link or a QR code with the whole model in it", .enabled = hasWork, .run = shareModel},
    Command{.id = "delete-model", .label = "Delete a model by its id", .icon = "trash-2", .group = "model",
            .argument = {"id"}, .hint = "Takes a model off this device", .run = deleteModel},
};
// clang-format on

}  // namespace

std::span<const Command> keepCommands() { return kTable; }

}  // namespace spineloft::app
