// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "driver/base/files/interruption.hpp"
#include "driver/base/text/inputs_read.hpp"

namespace slipbench::driver::base {
namespace {

namespace fs = std::filesystem;

/// Number of files that are being written. A folder that was made for one without a name looks
/// empty.
std::atomic<int> files_in_work{0};

std::string reason(int error) { return std::generic_category().message(error); }

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// The file that a name leads to: links are followed, also one to a file that is not there yet.
/// Errors: links in a circle; a link to an open descriptor, such as /dev/stdout, which has no name
/// that a complete file could be given.
tl::expected<fs::path, std::string> behind_links(const fs::path& target) {
  constexpr int kMostLinks = 40;
  fs::path place = target;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
    if (fs::absolute(place, error).lexically_normal().string().starts_with("/proc/")) {
      return tl::unexpected(target.string() + ": is no regular file");
    }
    const fs::path next = fs::read_symlink(place, error);
    if (error || links == kMostLinks) {
      return tl::unexpected(fmt::format("{}: cannot be written: {}", target.string(),
                                        error ? error.message() : reason(ELOOP)));
    }
    // Not normalised: "folder/.." of a folder that is a link is not where the name says.
    place = folder_of(place) / next;
  }
  return place;
}

/// Waits until the names in a folder are on the disk. Where that fails the files are there all the
/// same, or after a power failure those that were there before.
void names_to_disk(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// The nearest of a folder and those it lies in that is there.
fs::path nearest_there(fs::path folder) {
  std::error_code ignored;
  while (!fs::exists(folder, ignored) && !folder.empty()) folder = folder.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// The longest name in a folder, which is there, in bytes.
std::size_t longest_name(const fs::path& folder) {
  const long most = pathconf(folder.c_str(), _PC_NAME_MAX);
  return most > 0 ? static_cast<std::size_t>(most) : NAME_MAX;
}

/// Begin of the hidden names of a file, to which kSuffix characters come.
constexpr std::size_t kSuffix = 6;
fs::path hidden_stem(const fs::path& place) {
  const fs::path folder = folder_of(place);
  const std::string name = place.filename().string();
  // Room for what others add: a file beside it, with a hidden name in turn.
  constexpr std::size_t kRoom = 16;
  const bool fits = name.size() + kSuffix + kRoom <= longest_name(folder) &&
                    place.native().size() + kSuffix + kRoom < PATH_MAX;
  return folder / ("." + (fits ? name : std::string("slipbench")) + ".");
}

/// Returns letters and digits that no other program is likely to take.
std::string random_suffix() {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::array<unsigned char, kSuffix> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    static std::atomic<unsigned int> count{0};
    auto number = static_cast<std::size_t>(getpid()) * 7919U + count++;
    for (unsigned char& byte : bytes) {
      byte = static_cast<unsigned char>(number % kLetters.size());
      number /= kLetters.size();
    }
  }
  std::string text;
  for (const unsigned char byte : bytes) text += kLetters[byte % kLetters.size()];
  return text;
}

std::string input_sentence(const fs::path& target, const std::string& input = {}) {
  return fmt::format("{}: is an input{} and is not overwritten; choose another name or folder",
                     target.string(), input.empty() ? "" : " (" + input + ")");
}

/// The input of a list that `target` is, in a sentence, or nothing.
std::string listed_fault(const fs::path& target, std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    if (is_same_file(target, input)) return input_sentence(target, input);
  }
  return {};
}

/// The file at `place` that must stay, in a sentence, or nothing.
std::string foreign_fault(const fs::path& target, const fs::path& place, const FileMark& mark,
                          bool force, bool renewed) {
  std::error_code ignored;
  const fs::file_status there = fs::status(place, ignored);
  if (fs::is_directory(there)) return fmt::format("{}: is a folder", target.string());
  if (!fs::exists(there)) return {};
  if (!fs::is_regular_file(there)) return fmt::format("{}: is no regular file", target.string());
  if (!renewed && was_read(place)) return input_sentence(target);
  if (force || fs::file_size(place, ignored) == 0 || carries(place, mark)) return {};
  return fmt::format(
      "{}: {}, and is kept; choose another folder or name, or replace it with --force",
      target.string(),
      mark.owner.empty() ? "is there already" : "is there already and is not " + mark.owner);
}

/// Returns what is wrong with writing to `place`, which `target` leads to, or nothing.
std::string obstacle(const fs::path& target, const fs::path& place, const FileMark& mark,
                     const Overwriting& overwriting) {
  std::error_code error;
  if (const fs::path folder = nearest_there(folder_of(place)); !fs::is_directory(folder, error)) {
    return fmt::format("{}: {} is not a folder", target.string(), folder.string());
  } else if (place.filename().native().size() > longest_name(folder) ||
             place.native().size() >= PATH_MAX) {
    return fmt::format("{}: cannot be written: {}", target.string(), reason(ENAMETOOLONG));
  }
  if (std::string fault = listed_fault(target, overwriting.inputs); !fault.empty()) return fault;
  return foreign_fault(target, place, mark, overwriting.force, overwriting.renewed);
}

}  // namespace

std::string input_fault(const fs::path& target, std::span<const std::string> inputs) {
  if (std::string fault = listed_fault(target, inputs); !fault.empty()) return fault;
  return was_read(target) ? input_sentence(target) : std::string();
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  if (fs::exists(a, error) || fs::exists(b, error)) return false;
  const auto place = [&](const fs::path& path) {
    const fs::path followed = behind_links(path).value_or(path);
    return fs::weakly_canonical(folder_of(followed), error) / followed.filename();
  };
  return place(a) == place(b);
}

FolderLocks::FolderLocks(std::span<const fs::path> files) {
  // In one order for all: two programs never wait for each other in a circle.
  std::set<fs::path> sorted;
  std::error_code ignored;
  for (const fs::path& file : files) {
    sorted.insert(fs::weakly_canonical(folder_of(behind_links(file).value_or(file)), ignored));
  }
  for (const fs::path& folder : sorted) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) continue;
    flock(descriptor, LOCK_EX);
    descriptors_.push_back(descriptor);
  }
}

FolderLocks::~FolderLocks() {
  for (const int descriptor : descriptors_) close(descriptor);
}

std::string target_fault(const fs::path& wanted, const FileMark& mark,
                         const Overwriting& overwriting) {
  const fs::path target = wanted.lexically_normal();
  const auto place = behind_links(target);
  return place ? obstacle(target, *place, mark, overwriting) : place.error();
}

std::string make_folders(const fs::path& folder) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return {};
  if (std::string fault = make_folders(folder.parent_path()); !fault.empty()) return fault;
  bool made = false;
  {
    const InterruptionPause pause;
    made = fs::create_directory(folder, error);
    if (made) register_file(folder.string());
  }
  if (error) return fmt::format("{}: cannot be made: {}", folder.string(), error.message());
  if (made) names_to_disk(folder_of(folder));
  return {};
}

tl::expected<OutputFile, std::string> OutputFile::create(const fs::path& wanted,
                                                         const FileMark& mark,
                                                         const Overwriting& overwriting) {
  OutputFile file;
  file.target_ = wanted.lexically_normal();
  auto place = behind_links(file.target_);
  if (!place) return tl::unexpected(std::move(place.error()));
  file.place_ = std::move(*place);
  std::string fault = obstacle(file.target_, file.place_, mark, overwriting);
  if (fault.empty()) fault = make_folders(folder_of(file.place_));
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  file.mark_ = mark;
  file.force_ = overwriting.force;
  file.renewed_ = overwriting.renewed;
  if (!file.begin_unnamed()) {
    if (auto begun = file.begin_named(); !begun) return tl::unexpected(std::move(begun.error()));
  }
  file.buffer_.reserve(kFlushSize + kFlushSize / 4);
  return file;
}

std::string OutputFile::fault(int error) const {
  return fmt::format("{}: cannot be written: {}", target_.string(), reason(error));
}

/// Creates the file without a name; false where that cannot be done, or where /proc, by which it
/// is named in the end, does not show it.
bool OutputFile::begin_unnamed() {
  constexpr mode_t kReadWrite = 0666;
  const int descriptor =
      open(folder_of(place_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kReadWrite);
  if (descriptor < 0) return false;
  // By the number of the process, a child finds it as well.
  std::error_code error;
  const fs::path process = fs::read_symlink("/proc/self", error);
  fs::path path = fs::path("/proc") / process / "fd" / std::to_string(descriptor);
  struct stat made {};
  struct stat shown {};
  if (fstat(descriptor, &made) != 0 || stat(path.c_str(), &shown) != 0 ||
      made.st_ino != shown.st_ino || made.st_dev != shown.st_dev) {
    ::close(descriptor);
    return false;
  }
  descriptor_ = descriptor;
  temporary_ = std::move(path);
  ++files_in_work;
  return true;
}

/// Creates the file under a hidden name.
tl::expected<void, std::string> OutputFile::begin_named() {
  std::string name = hidden_stem(place_).string() + std::string(kSuffix, 'X');
  {
    const InterruptionPause pause;
    descriptor_ = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) return tl::unexpected(fault(errno));
    temporary_ = name;
    named_ = true;
    registered_ = register_file(name);
    ++files_in_work;
  }
  // mkostemp gives the owner alone the right to read; a result is as readable as any new file.
  const mode_t mask = umask(0);
  umask(mask);
  constexpr mode_t kReadWrite = 0666;
  fchmod(descriptor_, kReadWrite & ~mask);
  return {};
}

tl::expected<void, std::string> OutputFile::need_name() {
  if (named_) return {};
  forget();
  return begin_named();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      place_(std::move(other.place_)),
      temporary_(std::move(other.temporary_)),
      buffer_(std::move(other.buffer_)),
      hash_(other.hash_),
      error_(std::move(other.error_)),
      mark_(std::move(other.mark_)),
      force_(other.force_),
      renewed_(other.renewed_),
      named_(std::exchange(other.named_, false)),
      placed_(other.placed_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      registered_(std::exchange(other.registered_, -1)) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() { drop(); }

/// Lets go of what is there under the temporary path; its hidden name may be gone already.
void OutputFile::forget() {
  if (descriptor_ < 0) return;
  ::close(std::exchange(descriptor_, -1));
  --files_in_work;
  forget_file(std::exchange(registered_, -1));
  named_ = false;
  temporary_.clear();
}

void OutputFile::drop() {
  const InterruptionPause pause;
  if (named_) unlink(temporary_.c_str());
  forget();
  if (files_in_work == 0) remove_empty_folders();
}

void OutputFile::flush() {
  const char* data = buffer_.data();
  std::size_t left = error_.empty() ? buffer_.size() : 0;
  while (left > 0) {
    const ssize_t written = write(descriptor_, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = fault(errno);
      break;
    }
    data += written;
    left -= static_cast<std::size_t>(written);
  }
  hash_.add(buffer_);
  buffer_.clear();
}

std::uintmax_t OutputFile::size() const {
  std::error_code error;
  const std::uintmax_t written = fs::file_size(temporary_, error);
  return buffer_.size() + (error ? 0 : written);
}

void OutputFile::replace_start(std::string_view text) {
  flush();
  if (!error_.empty()) return;
  const ssize_t written = pwrite(descriptor_, text.data(), text.size(), 0);
  if (written >= 0 && static_cast<std::size_t>(written) == text.size()) return;
  error_ = fault(written < 0 ? errno : ENOSPC);
}

tl::expected<void, std::string> OutputFile::close() {
  flush();
  // Some file systems tell a failed write only where a descriptor is closed. The file itself has to
  // stay open, or it is gone; a copy that is closed tells as much.
  const int copy = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  if (copy >= 0 && ::close(copy) != 0 && error_.empty()) error_ = fault(errno);
  if (!error_.empty()) return tl::unexpected(error_);
  return {};
}

/// Waits until the bytes are on the disk: a name that is there after a power failure has them all.
tl::expected<void, std::string> OutputFile::to_disk() {
  // A file system that cannot wait says so by one of these.
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) {
    return tl::unexpected(fault(errno));
  }
  return {};
}

/// Gives a file without a name one that nobody has yet; false with errno set.
bool OutputFile::link_as(const fs::path& name) {
  const auto link = [&] {
    return linkat(AT_FDCWD, temporary_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (link()) return true;
  // The program that made the folder, and found it empty at its end, has removed it.
  return errno == ENOENT && make_folders(folder_of(place_)).empty() && link();
}

/// Copies a complete file to a hidden name, where the file system names no file a second time.
tl::expected<void, std::string> OutputFile::copy_to_name() {
  const int source = std::exchange(descriptor_, -1);
  --files_in_work;
  auto copied = begin_named();
  off_t at = 0;
  std::string piece(kFlushSize, '\0');
  while (copied && error_.empty()) {
    const ssize_t count = pread(source, piece.data(), piece.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) error_ = fault(errno);
    if (count <= 0) break;
    at += count;
    buffer_.assign(piece, 0, static_cast<std::size_t>(count));
    flush();
  }
  ::close(source);
  if (!copied) return copied;
  if (auto closed = close(); !closed) return closed;
  return to_disk();
}

/// Gives a complete file a hidden name beside its place.
tl::expected<void, std::string> OutputFile::name_beside() {
  if (named_) return {};
  const std::string stem = hidden_stem(place_).string();
  constexpr int kMostTrials = 100;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    fs::path name = stem + random_suffix();
    if (link_as(name)) {
      registered_ = register_file(name.string());
      temporary_ = std::move(name);
      named_ = true;
      return {};
    }
    if (errno != EEXIST) break;
  }
  if (errno == EPERM || errno == EOPNOTSUPP || errno == ENOSYS || errno == EMLINK ||
      errno == EACCES) {
    return copy_to_name();
  }
  return tl::unexpected(fault(errno));
}

/// Gives a complete file its own name: at once where nothing has that yet, else from its hidden
/// name. give_back can take it away again where the file system knows how.
tl::expected<void, std::string> OutputFile::take_place() {
  if (!named_ && link_as(place_)) {
    placed_ = Placed::kNew;
    return {};
  }
  if (auto named = name_beside(); !named) return named;
  const auto rename_by = [&](unsigned int flags) {
    return renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), flags) == 0;
  };
  if (rename_by(RENAME_NOREPLACE)) {
    placed_ = Placed::kNew;
  } else if (errno == EEXIST && rename_by(RENAME_EXCHANGE)) {
    placed_ = Placed::kExchanged;
  } else if (rename(temporary_.c_str(), place_.c_str()) == 0) {
    placed_ = Placed::kReplaced;
  } else {
    return tl::unexpected(fault(errno));
  }
  return {};
}

/// Puts back what was at the place of the file.
void OutputFile::give_back() {
  if (placed_ == Placed::kNew && !named_) {
    unlink(place_.c_str());
  } else if (placed_ == Placed::kNew) {
    rename(place_.c_str(), temporary_.c_str());
  } else if (placed_ == Placed::kExchanged) {
    renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE);
  }
  placed_ = Placed::kNot;
}

tl::expected<void, std::string> commit(std::span<OutputFile* const> files) {
  std::vector<fs::path> places;
  for (const OutputFile* file : files) places.push_back(file->place_);
  const FolderLocks locks(places);
  return commit(files, locks);
}

tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                       const FolderLocks& /*locks*/) {
  for (OutputFile* file : files) {
    if (auto closed = file->close(); !closed) return closed;
  }
  for (OutputFile* file : files) {
    if (auto kept = file->to_disk(); !kept) return kept;
  }
  for (const OutputFile* file : files) {
    std::string fault =
        foreign_fault(file->target_, file->place_, file->mark_, file->force_, file->renewed_);
    if (!fault.empty()) return tl::unexpected(std::move(fault));
  }
  std::set<fs::path> folders;
  for (const OutputFile* file : files) folders.insert(folder_of(file->place_));
  const InterruptionPause pause;
  // Those behind the first make room before it is replaced, so that a program that is killed on the
  // way leaves files of one set, never some of each.
  std::vector<std::pair<fs::path, fs::path>> aside;
  tl::expected<void, std::string> placed;
  const auto make_room = [&](const OutputFile& file) -> tl::expected<void, std::string> {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file.place_, ignored))) return {};
    fs::path name = hidden_stem(file.place_).string() + random_suffix();
    if (renameat2(AT_FDCWD, file.place_.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) != 0 &&
        rename(file.place_.c_str(), name.c_str()) != 0) {
      return tl::unexpected(file.fault(errno));
    }
    aside.emplace_back(std::move(name), file.place_);
    return {};
  };
  for (std::size_t i = 1; i < files.size() && placed; ++i) placed = make_room(*files[i]);
  std::size_t taken = 0;
  for (; taken < files.size() && placed; ++taken) placed = files[taken]->take_place();
  if (!placed) {
    while (taken-- > 0) files[taken]->give_back();
    for (const auto& [name, place] : aside) rename(name.c_str(), place.c_str());
    return placed;
  }
  for (const auto& [name, place] : aside) unlink(name.c_str());
  for (OutputFile* file : files) {
    if (file->placed_ == OutputFile::Placed::kExchanged) unlink(file->temporary_.c_str());
    file->forget();
  }
  for (const fs::path& folder : folders) names_to_disk(folder);
  return {};
}

tl::expected<void, std::string> save_text(const fs::path& target, std::string_view text,
                                          const Overwriting& overwriting) {
  auto file = OutputFile::create(target, {}, overwriting);
  if (!file) return tl::unexpected(std::move(file.error()));
  file->append(text);
  OutputFile* const alone[] = {&*file};
  return commit(alone);
}

}  // namespace slipbench::driver::base
