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
Outcome openModel(Env env, const Json& args) { return tellShell(env, "open-model", args); }
Outcome openFile(Env env, const Json& args) { return tellShell(env, "open-file", args); }
Outcome duplicateModel(Env env, const Json& args) { return tellShell(env, "duplicate-model", args); }
Outcome deleteModel(Env env, const Json& args) { return tellShell(env, "delete-model", args); }

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

constexpr std::array kTable = {
    Command{"save-project",
            "Save model",
            "save",
            "Ctrl+S",
            "model",
            {},
            "A file with everything in it, to go on with later or elsewhere",
            hasWork,
            nullptr,
            saveProject},
    Command{"save-project-as",
            "Save model as",
            "save-all",
            "Shift+Ctrl+S",
            "model",
            {},
            "The same under a new name",
            hasWork,
            nullptr,
            saveProjectAs},
    Command{"new-model",
            "New model",
            "file-plus",
            "",
            "model",
            {},
            "Begin another one; this one stays in your models",
            hasWork,
            nullptr,
            newModel},
    Command{"open-model",
            "Your models",
            "layout-grid",
            "Shift+Ctrl+O",
            "model",
            {},
            "Go on with a model that this device keeps",
            nullptr,
            nullptr,
            openModel},
    Command{"open-file",
            "Open model file",
            "folder-open",
            "",
            "model",
            {},
            "A .spineloft file, or a GLB that was saved here",
            nullptr,
            nullptr,
            openFile},
    Command{"duplicate-model",
            "Duplicate model",
            "copy",
            "",
            "model",
            {},
            "Go on with a copy; the model as it is stays in your models",
            hasWork,
            nullptr,
            duplicateModel},
    Command{"rename-model",
            "Rename model",
            "pencil-line",
            "",
            "model",
            {},
            "Give the model another name",
            hasWork,
            nullptr,
            renameModel},
    Command{"delete-model",
            "Delete a model by its id",
            "trash-2",
            "",
            "model",
            {"id"},
            "Takes a model off this device",
            nullptr,
            nullptr,
            deleteModel},
};

}  // namespace

std::span<const Command> keepCommands() { return kTable; }

}  // namespace spineloft::app
