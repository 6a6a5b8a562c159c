// A library to be loaded before all others (LD_PRELOAD): it makes one of the system calls that a save needs
// fail, or kills the program there. It counts only calls that concern a folder, by path or by a descriptor
// opened there.
//
// FAILING_FOLDER is the folder. FAILING_REPORT is a file outside of it: one line for each counted call, its
// name and what in the folder it is for. FAILING_AT is the call that fails, counted from 1; without it none
// does. FAILING_ERROR is the number of the error.
//
// FAILING_HOW is once: that call alone; onwards: that one and all that follow; half: that call, a write,
// takes half of its bytes, and the writes that follow fail; kill: SIGKILL in its place; end: SIGTERM before
// it.
//
// The program says by countCalls(true) from where on calls are counted.
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::string_view setting(const char *name) {
  const char *value = std::getenv(name); // NOLINT(concurrency-mt-unsafe): nobody changes it
  return value ? value : std::string_view();
}

long numberIn(const char *name) { return std::atol(std::string(setting(name)).c_str()); }

/// What is in the folder, by its path there; the folder itself is a dot.
using Place = std::optional<std::string>;

bool counting = false;
long seen = 0;

/// What the open descriptors are of. Never destroyed: calls come until the very end.
std::map<int, std::string> &openFiles() {
  static auto &files = *new std::map<int, std::string>;
  return files;
}

Place placeOf(std::string_view path) {
  const std::string_view folder = setting("FAILING_FOLDER");
  if (folder.empty() || !path.starts_with(folder))
    return {};
  path.remove_prefix(folder.size());
  if (path.empty() || path == "/")
    return ".";
  return path.front() == '/' ? Place(path.substr(1)) : std::nullopt;
}

Place placeOf(int descriptor) {
  const auto found = openFiles().find(descriptor);
  return found == openFiles().end() ? std::nullopt : Place(found->second);
}

Place placeOf(int folder, std::string_view path) {
  const Place above = path.starts_with('/') ? std::nullopt : placeOf(folder);
  if (!above)
    return placeOf(path);
  return *above == "." ? std::string(path) : *above + "/" + std::string(path);
}

/// By the system call itself: it must not be counted.
void report(const char *call, const std::string &place) {
  const std::string line = std::string(call) + " " + place + "\n";
  const auto file = syscall(SYS_open, setting("FAILING_REPORT").data(), O_WRONLY | O_APPEND | O_CREAT, 0600);
  syscall(SYS_write, file, line.data(), line.size());
  syscall(SYS_close, file);
}

enum class Fate { Passes, Fails, IsHalfDone };

/// Counts a call and decides what becomes of it.
Fate fateOf(const char *call, const Place &place) {
  if (!counting || !place)
    return Fate::Passes;
  report(call, *place);
  ++seen;
  const long at = numberIn("FAILING_AT");
  const std::string_view how = setting("FAILING_HOW");
  if (at == 0 || seen < at)
    return Fate::Passes;
  if (how == "kill")
    syscall(SYS_kill, getpid(), SIGKILL);
  if (how == "end") {
    if (seen == at)
      syscall(SYS_kill, getpid(), SIGTERM);
    return Fate::Passes;
  }
  if (how == "half" && seen == at)
    return Fate::IsHalfDone;
  const bool follows = how == "onwards" || (how == "half" && std::string_view(call) == "write");
  return seen == at || follows ? Fate::Fails : Fate::Passes;
}

template <class Result> Result failed() {
  errno = static_cast<int>(numberIn("FAILING_ERROR"));
  return -1;
}

/// The call of that name that this library stands in front of.
template <class Function> Function *behind(const char *name) {
  return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
}

/// Lets a call through, or fails it.
template <class Call> auto passed(const char *name, const Place &place, Call call) -> decltype(call()) {
  return fateOf(name, place) == Fate::Passes ? call() : failed<decltype(call())>();
}

/// Likewise, for a call that opens.
template <class Call> int opened(const char *name, const Place &place, Call call) {
  const int descriptor = passed(name, place, call);
  if (descriptor >= 0 && place)
    openFiles()[descriptor] = *place;
  return descriptor;
}

using Open = int(const char *, int, mode_t);
using OpenAt = int(int, const char *, int, mode_t);

mode_t modeFor(int flags, va_list rest) {
  return (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(rest, unsigned)) : 0;
}

} // namespace

extern "C" {

void countCalls(bool on) { counting = on; }

int open(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeFor(flags, rest);
  va_end(rest);
  return opened("open", placeOf(path), [&] { return behind<Open>("open")(path, flags, mode); });
}

int open64(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeFor(flags, rest);
  va_end(rest);
  return opened("open", placeOf(path), [&] { return behind<Open>("open64")(path, flags, mode); });
}

int openat(int folder, const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeFor(flags, rest);
  va_end(rest);
  return opened("openat", placeOf(folder, path),
                [&] { return behind<OpenAt>("openat")(folder, path, flags, mode); });
}

int openat64(int folder, const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeFor(flags, rest);
  va_end(rest);
  return opened("openat", placeOf(folder, path),
                [&] { return behind<OpenAt>("openat64")(folder, path, flags, mode); });
}

ssize_t write(int descriptor, const void *bytes, size_t count) {
  const Fate fate = fateOf("write", placeOf(descriptor));
  if (fate == Fate::Fails)
    return failed<ssize_t>();
  return behind<decltype(write)>("write")(descriptor, bytes, fate == Fate::IsHalfDone ? count / 2 : count);
}

int fsync(int descriptor) {
  return passed("fsync", placeOf(descriptor), [&] { return behind<decltype(fsync)>("fsync")(descriptor); });
}

int fdatasync(int descriptor) {
  return passed("fdatasync", placeOf(descriptor),
                [&] { return behind<decltype(fdatasync)>("fdatasync")(descriptor); });
}

/// Linux closes also where it says that it failed.
int close(int descriptor) {
  const Fate fate = fateOf("close", placeOf(descriptor));
  openFiles().erase(descriptor);
  const int result = behind<decltype(close)>("close")(descriptor);
  return fate == Fate::Fails ? failed<int>() : result;
}

int stat(const char *path, struct stat *found) noexcept {
  return passed("stat", placeOf(path), [&] { return behind<decltype(stat)>("stat")(path, found); });
}

int stat64(const char *path, struct stat64 *found) noexcept {
  return passed("stat", placeOf(path), [&] { return behind<decltype(stat64)>("stat64")(path, found); });
}

int lstat(const char *path, struct stat *found) noexcept {
  return passed("lstat", placeOf(path), [&] { return behind<decltype(lstat)>("lstat")(path, found); });
}

int lstat64(const char *path, struct stat64 *found) noexcept {
  return passed("lstat", placeOf(path), [&] { return behind<decltype(lstat64)>("lstat64")(path, found); });
}

int fstat(int descriptor, struct stat *found) noexcept {
  return passed("fstat", placeOf(descriptor),
                [&] { return behind<decltype(fstat)>("fstat")(descriptor, found); });
}

int fstat64(int descriptor, struct stat64 *found) noexcept {
  return passed("fstat", placeOf(descriptor),
                [&] { return behind<decltype(fstat64)>("fstat64")(descriptor, found); });
}

int fstatat(int folder, const char *path, struct stat *found, int flags) noexcept {
  return passed("fstatat", placeOf(folder, path),
                [&] { return behind<decltype(fstatat)>("fstatat")(folder, path, found, flags); });
}

int statx(int folder, const char *path, int flags, unsigned mask, struct statx *found) noexcept {
  return passed("statx", *path == '\0' ? placeOf(folder) : placeOf(folder, path),
                [&] { return behind<decltype(statx)>("statx")(folder, path, flags, mask, found); });
}

int access(const char *path, int mode) noexcept {
  return passed("access", placeOf(path), [&] { return behind<decltype(access)>("access")(path, mode); });
}

int faccessat(int folder, const char *path, int mode, int flags) noexcept {
  return passed("faccessat", placeOf(folder, path),
                [&] { return behind<decltype(faccessat)>("faccessat")(folder, path, mode, flags); });
}

ssize_t readlink(const char *path, char *target, size_t size) noexcept {
  return passed("readlink", placeOf(path),
                [&] { return behind<decltype(readlink)>("readlink")(path, target, size); });
}

int chmod(const char *path, mode_t mode) noexcept {
  return passed("chmod", placeOf(path), [&] { return behind<decltype(chmod)>("chmod")(path, mode); });
}

int fchmod(int descriptor, mode_t mode) noexcept {
  return passed("fchmod", placeOf(descriptor),
                [&] { return behind<decltype(fchmod)>("fchmod")(descriptor, mode); });
}

int fchown(int descriptor, uid_t owner, gid_t group) noexcept {
  return passed("fchown", placeOf(descriptor),
                [&] { return behind<decltype(fchown)>("fchown")(descriptor, owner, group); });
}

int ftruncate(int descriptor, off_t size) noexcept {
  return passed("ftruncate", placeOf(descriptor),
                [&] { return behind<decltype(ftruncate)>("ftruncate")(descriptor, size); });
}

int ftruncate64(int descriptor, off64_t size) noexcept {
  return passed("ftruncate", placeOf(descriptor),
                [&] { return behind<decltype(ftruncate64)>("ftruncate64")(descriptor, size); });
}

int flock(int descriptor, int operation) noexcept {
  return passed("flock", placeOf(descriptor),
                [&] { return behind<decltype(flock)>("flock")(descriptor, operation); });
}

int rename(const char *from, const char *to) noexcept {
  return passed("rename", placeOf(to), [&] { return behind<decltype(rename)>("rename")(from, to); });
}

int renameat(int fromFolder, const char *from, int toFolder, const char *to) noexcept {
  return passed("renameat", placeOf(toFolder, to),
                [&] { return behind<decltype(renameat)>("renameat")(fromFolder, from, toFolder, to); });
}

int renameat2(int fromFolder, const char *from, int toFolder, const char *to, unsigned flags) noexcept {
  return passed("renameat2", placeOf(toFolder, to), [&] {
    return behind<decltype(renameat2)>("renameat2")(fromFolder, from, toFolder, to, flags);
  });
}

int link(const char *from, const char *to) noexcept {
  return passed("link", placeOf(to), [&] { return behind<decltype(link)>("link")(from, to); });
}

int unlink(const char *path) noexcept {
  return passed("unlink", placeOf(path), [&] { return behind<decltype(unlink)>("unlink")(path); });
}

int unlinkat(int folder, const char *path, int flags) noexcept {
  return passed("unlinkat", placeOf(folder, path),
                [&] { return behind<decltype(unlinkat)>("unlinkat")(folder, path, flags); });
}

int mkdir(const char *path, mode_t mode) noexcept {
  return passed("mkdir", placeOf(path), [&] { return behind<decltype(mkdir)>("mkdir")(path, mode); });
}

} // extern "C"
