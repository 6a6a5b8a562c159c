#include "lessons/files/write_file.h"

#include "lessons/files/descriptor.h"
#include "lessons/files/held_signals.h"
#include "lessons/words.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <random>
#include <sys/stat.h>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view unfinishedBeginning = ".halfspace-";
constexpr std::string_view unfinishedEnd = ".part";

/// More links than this one behind another are a circle.
constexpr int mostLinks = 40;

constexpr mode_t permissionBits = 0777; // a document needs no others
constexpr mode_t groupBits = 0070;
constexpr mode_t anyoneWrites = 0222;
constexpr mode_t usualMode = 0666; // less what the process's mask takes away
constexpr mode_t ownerMode = 0600;

/// Thrown within this file at the first thing that fails.
struct Failure {
  std::string reason;
};

[[noreturn]] void fail(int error) { throw Failure{reasonOf(error)}; }

/// The result of a system call, which is negative where it failed.
int checked(int result) {
  if (result < 0)
    fail(errno);
  return result;
}

/// What stands at a path, links followed; nothing where nothing does.
std::optional<struct stat> whatIsAt(const fs::path &path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) == 0)
    return found;
  if (errno != ENOENT)
    fail(errno);
  return {};
}

/// Where a path leads when links are followed, also to what is not there yet.
fs::path targetOf(fs::path path) {
  for (int links = 0; links < mostLinks; ++links) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (error && status.type() != fs::file_type::not_found)
      fail(error.value());
    if (!fs::is_symlink(status))
      return path;
    const fs::path next = fs::read_symlink(path, error);
    if (error)
      fail(error.value());
    path = path.parent_path() / next;
  }
  fail(ELOOP);
}

/// A pipe or a device: there is nothing to keep, and no name to take.
void writeAsItIs(const fs::path &file, std::string_view content) {
  // Opened without waiting: a pipe that nobody reads would wait for ever.
  Descriptor out(checked(::open(file.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)));
  if (const int error = writeAll(out.get(), content))
    fail(error);
  if (const int error = out.close())
    fail(error);
}

std::string randomName() {
  std::random_device random;
  const std::uint64_t number = (std::uint64_t{random()} << 32U) | random();
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16).ptr;
  return std::string(unfinishedBeginning) + std::string(digits.data(), end) + std::string(unfinishedEnd);
}

/// A new file in a folder, which is removed again unless it takes the target's name.
class PartFile {
public:
  PartFile(int folder, mode_t mode) : m_folder(folder), m_name(randomName()) {
    m_out =
        Descriptor(checked(::openat(folder, m_name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode)));
  }
  ~PartFile() {
    if (!m_name.empty())
      ::unlinkat(m_folder, m_name.c_str(), 0);
  }
  PartFile(const PartFile &) = delete;
  PartFile &operator=(const PartFile &) = delete;

  [[nodiscard]] const std::string &name() const { return m_name; }

  void write(std::string_view content) {
    if (const int error = writeAll(m_out.get(), content))
      fail(error);
  }

  /// Gives it the owner, the group and the permissions of another file. Not everyone may give files away: who
  /// then owns it is who wrote it, and a group that did not come along gets no rights by it.
  void takeRightsOf(const struct stat &other) {
    mode_t mode = other.st_mode & permissionBits;
    struct stat own {};
    checked(::fstat(m_out.get(), &own));
    const bool sameOwner = own.st_uid == other.st_uid && own.st_gid == other.st_gid;
    if (!sameOwner && ::fchown(m_out.get(), other.st_uid, other.st_gid) != 0 &&
        ::fchown(m_out.get(), static_cast<uid_t>(-1), other.st_gid) != 0)
      mode &= ~groupBits;
    checked(::fchmod(m_out.get(), mode));
  }

  void finishAs(const fs::path &name) {
    if (const int error = syncToDisk(m_out.get()))
      fail(error);
    if (const int error = m_out.close())
      fail(error);
    checked(::renameat(m_folder, m_name.c_str(), m_folder, name.c_str()));
    m_name.clear();
    if (const int error = syncToDisk(m_folder))
      fail(error);
  }

private:
  int m_folder;
  std::string m_name; ///< empty once it has the target's
  Descriptor m_out;
};

Problem problemOf(const fs::path &file, const Failure &failure) {
  return {words("This cannot be written: {reason}.", {{"reason", failure.reason}}), file.string(), 0, ""};
}

bool isStream(const struct stat &found) { return S_ISCHR(found.st_mode) || S_ISFIFO(found.st_mode); }

} // namespace

class UnfinishedFile::Impl {
public:
  Impl(const fs::path &file, Readers readers)
      : m_file(file), m_old(replaceable(file)), m_target(targetOf(file)), m_folder(openFolder()),
        m_part(m_folder.get(), m_old || readers == Readers::OwnerOnly ? ownerMode : usualMode) {}

  [[nodiscard]] const fs::path &file() const { return m_file; }
  [[nodiscard]] fs::path path() const { return m_target.parent_path() / m_part.name(); }

  void write(std::string_view part) { m_part.write(part); }

  void finish() {
    if (m_old)
      m_part.takeRightsOf(*m_old);
    m_part.finishAs(m_target.filename());
  }

private:
  /// What stands there now: nothing, or a file that may be replaced.
  static std::optional<struct stat> replaceable(const fs::path &file) {
    if (file.empty())
      throw Failure{words("no file is named")};
    const auto old = whatIsAt(file);
    if ((old && S_ISDIR(old->st_mode)) || !file.has_filename())
      throw Failure{words("it is a folder")};
    if (old && !S_ISREG(old->st_mode))
      throw Failure{words("it is no file but a device or a socket")};
    if (old && (old->st_mode & anyoneWrites) == 0)
      throw Failure{words("it is read-only")}; // to the superuser too
    return old;
  }

  [[nodiscard]] Descriptor openFolder() const {
    if (m_old && ::faccessat(AT_FDCWD, m_target.c_str(), W_OK, AT_EACCESS) != 0)
      fail(errno);
    const fs::path parent = m_target.parent_path();
    return Descriptor(
        checked(::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)));
  }

  fs::path m_file; ///< as it was named
  std::optional<struct stat> m_old;
  fs::path m_target;
  Descriptor m_folder;
  PartFile m_part;
};

UnfinishedFile::UnfinishedFile(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
UnfinishedFile::UnfinishedFile(UnfinishedFile &&) noexcept = default;
UnfinishedFile &UnfinishedFile::operator=(UnfinishedFile &&) noexcept = default;
UnfinishedFile::~UnfinishedFile() = default;

Result<UnfinishedFile> UnfinishedFile::begin(const fs::path &file, Readers readers) {
  try {
    return UnfinishedFile(std::make_unique<Impl>(file, readers));
  } catch (const Failure &failure) {
    return problemOf(file, failure);
  }
}

fs::path UnfinishedFile::path() const { return m_impl->path(); }

std::optional<Problem> UnfinishedFile::write(std::string_view part) {
  try {
    m_impl->write(part);
    return {};
  } catch (const Failure &failure) {
    return problemOf(m_impl->file(), failure);
  }
}

std::optional<Problem> UnfinishedFile::finish() {
  try {
    m_impl->finish();
    return {};
  } catch (const Failure &failure) {
    return problemOf(m_impl->file(), failure);
  }
}

std::optional<Problem> writeFile(const fs::path &file, std::string_view content, Readers readers) {
  try {
    if (const auto there = file.empty() ? std::nullopt : whatIsAt(file); there && isStream(*there)) {
      writeAsItIs(file, content);
      return {};
    }
  } catch (const Failure &failure) {
    return problemOf(file, failure);
  }
  const HeldSignals whole; // who is told to end would leave a file of a strange name behind
  auto unfinished = UnfinishedFile::begin(file, readers);
  if (!unfinished)
    return unfinished.problem();
  if (auto problem = unfinished->write(content))
    return problem;
  return unfinished->finish();
}

bool isUnfinishedFile(const fs::path &file) {
  const std::string name = file.filename().string();
  return name.starts_with(unfinishedBeginning) && name.ends_with(unfinishedEnd);
}

} // namespace halfspace
