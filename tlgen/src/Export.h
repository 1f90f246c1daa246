// The folder of --export: a model, the library's files that it needs, an example program, and what is said about them.
#ifndef TLGEN_EXPORT_H
#define TLGEN_EXPORT_H

#include "EmitCalls.h"

namespace tlgen {

// What of the model an export holds: its motion functions alone where they do all that is asked for, without constraints.
Content exportContent(const Model &model, const MotionText &motion, const std::set<std::string> &needs);

using ExportFiles = std::vector<std::pair<std::string, std::string>>; // path inside of the folder, and text

// Files of the user's by the names that they have in the folder. why: filled where one cannot be read; then there are none.
ExportFiles readCarried(const std::vector<std::string> &paths, std::string &why);

// All files, with those that are carried along. why: filled where the model cannot be exported; then there are none.
ExportFiles exportFiles(const Program &program, const Model &model, const MotionText &motion, const EmittedModel &text, Content content,
                        const std::string &real, const ExportFiles &carried, std::string &why);

// True where the folder can take these files: it does not exist, or all that would be overwritten or removed there is what an earlier
// export wrote. why: filled where not. stale: files of the earlier export that this one no longer has.
bool canExport(const std::string &folder, const ExportFiles &files, std::vector<std::string> &stale, std::string &why);

// Makes the folders that the files stand in; made: those that were not there, outermost first. False with errno set.
bool makeFolders(const std::string &folder, const ExportFiles &files, std::vector<std::string> &made);

} // namespace tlgen

#endif
