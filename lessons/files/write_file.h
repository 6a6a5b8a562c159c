// The one writer of files: sessions, unsaved work, settings, pictures and all that is exported.
#pragma once

#include "lessons/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace halfspace {

/// Who may read a file that is made anew. One that is there keeps its permissions.
enum class Readers { AsUsual, OwnerOnly };

/// Writes a file whole or not at all.
///
/// The content goes into a new file of a random name beside the target, is synced to the disk, and takes the
/// target's name only then: whatever fails, and whenever the program is killed, the old content or the new
/// one is there. Links are followed, a target keeps its permissions and, where the system allows it, its
/// owner; other hard links to it keep the old content. Pipes and character devices are written to as they
/// are. Folders, sockets, block devices and files without any permission to write are refused.
///
/// Every system call's result is looked at. Nothing means that all went well; otherwise one sentence says
/// why not. (Where the last step fails, the syncing of the folder, the new content is there already, but may
/// not survive a loss of power.)
[[nodiscard]] std::optional<Problem> writeFile(const std::filesystem::path &file, std::string_view content,
                                               Readers readers = Readers::AsUsual);

/// A file as writeFile writes it, for what comes in parts or from another program: as long as it is not
/// finished it has a random name beside the target, and is removed at the end of its life. Pipes and devices
/// are refused. Signals are not held back: who is ended by one leaves it behind.
class UnfinishedFile {
public:
  [[nodiscard]] static Result<UnfinishedFile> begin(const std::filesystem::path &file,
                                                    Readers readers = Readers::AsUsual);
  UnfinishedFile(UnfinishedFile &&other) noexcept;
  UnfinishedFile &operator=(UnfinishedFile &&other) noexcept;
  ~UnfinishedFile();

  /// Where another program may write it, over the empty file that is there.
  [[nodiscard]] std::filesystem::path path() const;
  /// Adds to what was written.
  [[nodiscard]] std::optional<Problem> write(std::string_view part);
  /// Syncs it to the disk and gives it the target's name; it is written and finished no more.
  [[nodiscard]] std::optional<Problem> finish();

private:
  class Impl;
  explicit UnfinishedFile(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> m_impl;
};

/// Whether a file's name is that of a file that writeFile had begun: left behind by a program that was killed
/// in the middle.
[[nodiscard]] bool isUnfinishedFile(const std::filesystem::path &file);

} // namespace halfspace
