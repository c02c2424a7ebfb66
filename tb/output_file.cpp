// SPDX-License-Identifier: Apache-2.0
#include "tb/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <random>
#include <utility>

#include "tb/run_tool.h"

namespace blysk {
namespace {

namespace fs = std::filesystem;

/// Counted in bytes that no sum overflows, so that the compiler makes vectors of them.
std::size_t count_lines(std::string_view text) {
  constexpr std::size_t kLongestSum = 255;
  std::size_t lines = 0;
  for (std::size_t begin = 0; begin < text.size(); begin += kLongestSum) {
    std::uint8_t sum = 0;
    for (const char c : text.substr(begin, kLongestSum)) sum = static_cast<std::uint8_t>(sum + (c == '\n'));
    lines += sum;
  }
  return lines;
}

class descriptor {
 public:
  descriptor() = default;
  explicit descriptor(int number) : number_(number) {}
  ~descriptor() { reset(); }
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;

  void reset(int number = -1) {
    if (number_ != -1) ::close(number_);
    number_ = number;
  }
  int release() { return std::exchange(number_, -1); }
  int number() const { return number_; }

 private:
  int number_ = -1;
};

/// Removes the files in an open folder that is this process's own, those of the tools that wrote there too. Handlers of
/// signals call it, so it asks the kernel itself.
void empty_folder(int folder) noexcept {
  constexpr std::size_t kNameOffset = 19;  // of linux_dirent64: number, offset, size, kind
  constexpr std::size_t kSizeOffset = 16;
  alignas(8) std::array<char, 4096> entries{};
  if (lseek(folder, 0, SEEK_SET) != 0) return;
  for (;;) {
    const long size = syscall(SYS_getdents64, folder, entries.data(), entries.size());
    if (size <= 0) return;
    for (std::size_t at = 0; at < static_cast<std::size_t>(size);) {
      std::uint16_t step = 0;
      std::memcpy(&step, entries.data() + at + kSizeOffset, sizeof step);
      unlinkat(folder, entries.data() + at + kNameOffset, 0);  // fails for "." and ".."
      at += step;
    }
  }
}

/// What a signal that ends the program has to remove: temporary files, folders of such files with all that is in them,
/// and other folders if they are empty.
class unfinished_files {
 public:
  /// \param path  stays where it is until remove()
  static void add(const char* path) { add(paths_, path); }
  static void remove(const char* path) { remove(paths_, path); }

  /// The same for an open folder that nobody else writes into.
  static void add(const descriptor* folder) { add(private_folders_, folder); }
  static void remove(const descriptor* folder) { remove(private_folders_, folder); }

 private:
  template <class T>
  using places = std::array<std::atomic<const T*>, 1024>;  // an export has most, some forty files
  static_assert(std::atomic<const char*>::is_always_lock_free);

  template <class T>
  static void add(places<T>& to, const T* what) {
    static const bool handles_signals = handle_signals();
    static_cast<void>(handles_signals);
    for (auto& place : to) {
      const T* nothing = nullptr;
      if (place.compare_exchange_strong(nothing, what)) return;
    }
  }

  template <class T>
  static void remove(places<T>& from, const T* what) {
    for (auto& place : from) {
      const T* expected = what;
      if (place.compare_exchange_strong(expected, nullptr)) return;
    }
  }

  static bool handle_signals() {
    struct sigaction ending {};
    ending.sa_handler = [](int signal) {
      end_running_tool();
      for (const auto& place : private_folders_) {
        if (const descriptor* const folder = place.load()) empty_folder(folder->number());
      }
      for (const auto& place : paths_) {
        if (const char* const path = place.load()) unlink(path);  // no folder
      }
      for (auto place = paths_.rbegin(); place != paths_.rend(); ++place) {
        if (const char* const path = place->load()) rmdir(path);  // the inner ones first
      }
      raise(signal);  // as if there were no handler
    };
    ending.sa_flags = static_cast<int>(SA_RESETHAND);
    for (int signal = 1; signal <= SIGRTMAX; ++signal) {
      constexpr std::array others{SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU,
                                  SIGCHLD, SIGCONT, SIGURG,  SIGWINCH};
      if (std::find(others.begin(), others.end(), signal) != others.end()) continue;  // they do not end it
      struct sigaction before {};
      if (sigaction(signal, nullptr, &before) != 0) continue;  // the C library's own
      if (before.sa_handler == SIG_DFL) sigaction(signal, &ending, nullptr);
    }
    return true;
  }

  static inline places<char> paths_{};
  static inline places<descriptor> private_folders_{};
};

/// No signal comes to this thread between the making of a file and its registration.
class signals_wait {
 public:
  signals_wait() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~signals_wait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  signals_wait(const signals_wait&) = delete;
  signals_wait& operator=(const signals_wait&) = delete;

 private:
  sigset_t before_{};
};

/// Calls make(name) with new names "FOLDER/BASE.RANDOM ENDING", BASE cut where a name would be too long for the folder,
/// until it makes something; errno says why it did not.
template <class Make>
int make_new(const fs::path& folder, std::string_view base, std::string_view ending, const Make& make) {
  constexpr std::string_view digits = "0123456789abcdefghijklmnopqrstuvwxyz";
  constexpr std::size_t kRandom = 10;
  const long longest = pathconf(folder.empty() ? "." : folder.c_str(), _PC_NAME_MAX);
  const std::size_t room = longest > 0 ? static_cast<std::size_t>(longest) : 255;
  const std::size_t rest = 1 + kRandom + ending.size();
  std::size_t size = std::min(base.size(), room > rest ? room - rest : 0);
  while (size > 0 && size < base.size() && (base[size] & 0xC0) == 0x80)
    --size;  // between characters of UTF-8
  std::random_device device;
  std::uniform_int_distribution<std::size_t> digit(0, digits.size() - 1);
  int made = -1;
  for (int tries = 0; tries < 100; ++tries) {
    std::string name = std::string(base.substr(0, size)) + ".";
    for (std::size_t i = 0; i < kRandom; ++i) name += digits[digit(device)];
    name += ending;
    made = make((folder / name).string());
    if (made != -1 || errno != EEXIST) break;
  }
  return made;
}

constexpr const char* kStandardInput = "/dev/stdin";

/// Devices and what a process has open are no places for another file; shared memory is. The folder decides, wherever the
/// path comes to it from: /proc/self/cwd/a.csv and /dev/../a.csv are files like others.
bool is_special(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
  const std::string name = (error ? path : folder / path.filename()).string();
  return name.starts_with("/proc/") || (name.starts_with("/dev/") && !name.starts_with("/dev/shm/"));
}

/// The path, or what it links to, whether that is there or not. The path itself if its links have no end.
fs::path followed(const fs::path& path) {
  constexpr int kMostLinks = 40;
  fs::path at = path;
  std::error_code error;
  for (int links = 0; links <= kMostLinks; ++links) {
    if (is_special(at) || !fs::is_symlink(fs::symlink_status(at, error))) return at;
    at = at.parent_path() / fs::read_symlink(at, error);
    if (error) return path;
  }
  return path;
}

/// Makes the file `to` hold what `from` holds. Room for a longer text is taken first, so that a full disk leaves the old
/// one. False, and errno, if it fails.
bool copy_text(int from, int to) {
  struct stat source {};
  struct stat old {};
  if (fstat(from, &source) != 0 || fstat(to, &old) != 0) return false;
  if (source.st_size > old.st_size) {
    const int error = posix_fallocate(to, 0, source.st_size);
    if (error == ENOSPC || error == EFBIG || error == EDQUOT) {
      static_cast<void>(ftruncate(to, old.st_size) == 0);
      errno = error;
      return false;
    }
  }
  std::array<char, std::size_t{1} << 16> buffer;
  for (;;) {
    const ssize_t size = read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return false;
    if (size == 0) break;
    for (ssize_t written = 0; written < size;) {
      const ssize_t more = ::write(to, buffer.data() + written, static_cast<std::size_t>(size - written));
      if (more < 0 && errno != EINTR) return false;
      written += std::max<ssize_t>(more, 0);
    }
  }
  return ftruncate(to, source.st_size) == 0;
}

}  // namespace

/// A file that this process made, under a name that nothing had; removed at the end unless move_to() took it away.
class output_file::temporary_file {
 public:
  /// \param ending  not empty: the file is made in a private folder, and its name ends so
  /// \param mode    permissions, less the umask
  temporary_file(const fs::path& folder, const std::string& base, std::string_view ending, mode_t mode) {
    constexpr int kNew = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const signals_wait wait;
    if (ending.empty()) {
      file_.reset(make_new(folder, base, ".part", [&](const std::string& path) {
        const int file = open(path.c_str(), kNew, mode);
        if (file != -1) path_ = path;
        return file;
      }));
    } else {
      const int made = make_new(folder, base, ".part", [&](const std::string& path) {
        const int status = mkdir(path.c_str(), S_IRWXU);
        if (status == 0) folder_ = path;
        return status;
      });
      if (made == -1) return;
      unfinished_files::add(folder_.c_str());
      // From here on by the folder's number: its name may come to lead to another one.
      opened_.reset(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
      struct stat status {};
      if (opened_.number() == -1 || fstat(opened_.number(), &status) != 0) return;
      if (status.st_uid != geteuid() || (status.st_mode & (S_IWGRP | S_IWOTH)) != 0) {
        errno = EPERM;
        return;
      }
      is_private_ = true;
      unfinished_files::add(&opened_);
      const std::string name = "unfinished" + std::string(ending);
      file_.reset(openat(opened_.number(), name.c_str(), kNew, mode));
      if (file_.number() != -1) path_ = folder_ + "/" + name;
      const fs::path numbered = fmt::format("/proc/self/fd/{}", opened_.number());
      std::error_code ignored;
      by_number_ = fs::exists(numbered, ignored) ? (numbered / name).string() : path_;
    }
    if (file_.number() != -1) unfinished_files::add(path_.c_str());
  }

  ~temporary_file() {
    const signals_wait wait;
    if (!path_.empty() && !moved_) unlink(reachable().c_str());
    if (!path_.empty()) unfinished_files::remove(path_.c_str());
    if (is_private_) {
      empty_folder(opened_.number());
      unfinished_files::remove(&opened_);
    }
    if (!folder_.empty()) {
      rmdir(folder_.c_str());
      unfinished_files::remove(folder_.c_str());
    }
  }
  temporary_file(const temporary_file&) = delete;
  temporary_file& operator=(const temporary_file&) = delete;

  bool is_made() const { return file_.number() != -1; }

  /// The open file; the caller closes it.
  int take() { return file_.release(); }

  /// A path by which this file and no other is reached.
  const std::string& reachable() const { return by_number_.empty() ? path_ : by_number_; }

  /// False, and errno, if the file cannot be renamed so.
  bool move_to(const std::string& path) {
    const signals_wait wait;
    moved_ = std::rename(reachable().c_str(), path.c_str()) == 0;
    return moved_;
  }

 private:
  std::string path_, folder_, by_number_;
  descriptor opened_, file_;
  bool is_private_ = false;  // opened_ is this process's own, with all that is in it
  bool moved_ = false;
};

output_file::output_file(const std::string& path, std::string_view ending)
    : path_(is_standard_output(path) ? "standard output" : path) {
  errno = 0;
  if (is_standard_output(path)) {
    file_.reset(fdopen(dup(STDOUT_FILENO), "wb"));
    if (errno == EINVAL) errno = EBADF;  // open, but not for writing
  } else {
    target_ = followed(path).string();
    struct stat there {};
    const bool exists = stat(target_.c_str(), &there) == 0;
    if (exists && S_ISDIR(there.st_mode)) {
      throw file_error(path_, 0, "is a directory, expected a file to write");
    }
    if (is_special(target_) || (exists && !S_ISREG(there.st_mode))) {
      file_.reset(std::fopen(target_.c_str(), "wbe"));
    } else {
      stage(ending);
    }
  }
  if (!file_) fail(0, ", expected a file to write");
}

output_file::~output_file() = default;

// Leaves file_ null, and errno, if no temporary file can be made, or what is there may not be written.
void output_file::stage(std::string_view ending) {
  struct stat there {};
  errno = 0;
  const bool exists = stat(target_.c_str(), &there) == 0;
  if (!exists && errno != ENOENT) return;
  if (exists && (there.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0) {
    errno = EACCES;  // for root too, to whom access() allows all
    return;
  }
  if (exists && faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) return;
  const fs::path target(target_);
  const mode_t mode = exists ? S_IRUSR | S_IWUSR : 0666;
  temporary_ =
      std::make_unique<temporary_file>(target.parent_path(), target.filename().string(), ending, mode);
  if (!temporary_->is_made()) {
    if (!exists || (errno != EACCES && errno != EPERM && errno != EROFS)) return;
    copies_ = true;
    temporary_ =
        std::make_unique<temporary_file>(fs::temp_directory_path(), target.filename().string(), ending, mode);
    if (!temporary_->is_made()) return;
  }
  const int number = temporary_->take();
  if (exists) {
    copies_ = copies_ || there.st_nlink > 1 || fchown(number, there.st_uid, there.st_gid) != 0 ||
              fchmod(number, there.st_mode & 0777) != 0;
  }
  file_.reset(fdopen(number, "wb"));
}

void output_file::fail(std::size_t line, std::string_view expected) const {
  throw file_error(path_, line, fmt::format("cannot be written ({}){}", system_reason(), expected));
}

const std::string& output_file::temporary_path() const {
  static const std::string none;
  return temporary_ ? temporary_->reachable() : none;
}

void output_file::write(std::string_view text) {
  errno = 0;
  if (line_ == 1 && text.find('\0') != std::string_view::npos) line_ = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail(line_);
  if (line_ > 0) line_ += count_lines(text);
}

void output_file::flush() {
  errno = 0;
  if (std::fflush(file_.get()) != 0) fail(line_);
}

void output_file::close() {
  errno = 0;
  if (file_ && std::fclose(file_.release()) != 0) fail(line_);
}

void output_file::commit() {
  close();
  if (!temporary_) return;
  errno = 0;
  if (!copies_ && !temporary_->move_to(target_)) {
    // The folder refuses, or something is mounted there; the file itself may be written all the same.
    const int reason = errno;
    copies_ =
        (reason == EBUSY || reason == EXDEV || reason == EACCES || reason == EPERM || reason == EROFS) &&
        access(target_.c_str(), F_OK) == 0;
    errno = reason;
    if (!copies_) fail(0);
  }
  if (copies_) {
    const descriptor from(open(temporary_->reachable().c_str(), O_RDONLY | O_CLOEXEC));
    descriptor to(open(target_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
    if (from.number() == -1 || to.number() == -1 || !copy_text(from.number(), to.number()) ||
        ::close(to.release()) != 0) {
      fail(0);
    }
  }
  temporary_.reset();
}

bool is_standard_output(const std::string& path) {
  if (path == "-") return true;
  const std::string name = followed(path).lexically_normal().string();
  return name == "/dev/stdout" || name == "/dev/fd/1" || name == "/proc/self/fd/1";
}

std::string input_path(const std::string& path) {
  return path == "-" ? kStandardInput : path;
}

void expect_different_files(const std::vector<std::string>& options, const std::vector<std::string>& paths) {
  const auto leads_to = [](const std::string& path) -> fs::path {
    std::error_code ignored;
    if (path.empty()) return {};
    if (is_standard_output(path)) return "/dev/stdout";
    // The last link may lead to a file that is not there yet.
    const fs::path place = followed(path);
    if (!is_special(place)) return fs::weakly_canonical(fs::absolute(place), ignored);
    return fs::is_regular_file(place, ignored) ? place : fs::path();  // an open file
  };
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const fs::path place = leads_to(paths[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const fs::path other = leads_to(paths[j]);
      if (place.empty() || other.empty()) continue;
      std::error_code ignored;  // one is not there
      if (place == other || fs::equivalent(place, other, ignored)) {
        throw file_error(
            paths[i] == "-" ? "standard output" : paths[i], 0,
            fmt::format("is given by {} and {}, expected different files", options[j], options[i]));
      }
    }
  }
}

output_directory::output_directory(const std::string& path) {
  std::error_code error;
  fs::path above = fs::absolute(path, error);
  if (!above.has_filename()) above = above.parent_path();  // a slash at its end
  std::vector<fs::path> missing;
  for (; !error && !fs::exists(above, error) && !error; above = above.parent_path()) missing.push_back(above);
  if (!error && !fs::is_directory(above, error)) error = std::make_error_code(std::errc::not_a_directory);
  while (!error && !missing.empty()) {
    const signals_wait wait;
    if (fs::create_directory(missing.back(), error)) {
      made_.push_back(std::make_unique<const std::string>(missing.back().string()));
      unfinished_files::add(made_.back()->c_str());
    }
    missing.pop_back();
  }
  if (error) {
    remove();
    throw file_error(path, 0,
                     fmt::format("cannot be made ({}), expected a directory to write into", error.message()));
  }
}

output_directory::~output_directory() {
  remove();
}

void output_directory::remove() {
  for (; !made_.empty(); made_.pop_back()) {
    rmdir(made_.back()->c_str());
    unfinished_files::remove(made_.back()->c_str());
  }
}

void write_directory(const std::string& path, const std::map<std::string, std::string>& texts) {
  const output_directory place(path);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const std::string name = entry.path().filename().string();
    if (!texts.contains(name) && !name.starts_with('.')) {
      throw file_error(
          path, 0,
          fmt::format(
              "holds {}, expected an empty directory or one with files of the same names as those to write",
              name));
    }
  }
  if (error)
    throw file_error(path, 0,
                     fmt::format("cannot be read ({}), expected a directory to write into", error.message()));
  std::vector<std::unique_ptr<output_file>> files;
  for (const auto& [name, text] : texts) {
    files.push_back(std::make_unique<output_file>((fs::path(path) / name).string()));
    files.back()->write(text);
    files.back()->close();
  }
  for (const auto& file : files) file->commit();
}

}  // namespace blysk
