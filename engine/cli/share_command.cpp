// spineloft share: a project → the text that links and QR codes hold.
#include <ostream>

#include "engine/cli/opened.h"
#include "engine/cli/program.h"
#include "engine/publish/share_model.h"

namespace spineloft::cli {

Status runShare(const ShareArguments& arguments, Console console) {
  const Result<Opened> opened = openModel(arguments.file);
  if (!opened.ok()) return opened.failure();
  const Result<publish::SharedModel> shared = publish::shareModel(opened.value().document, opened.value().derived);
  if (!shared.ok()) return shared.failure();
  console.out << shared.value().text << '\n';
  if (shared.value().photosLeft > 0) {
    console.err << "spineloft: A link has no room for photos, so the ribs are kept as they were found and the parts "
                   "have the mean colour of what the photo shows there.\n";
  }
  if (shared.value().text.size() > publish::kMostLinkText) {
    console.err << "spineloft: The text has " << shared.value().text.size() << " characters; some programs cut links "
                << "and QR codes above " << publish::kMostLinkText << ".\n";
  }
  return Done{};
}

}  // namespace spineloft::cli
