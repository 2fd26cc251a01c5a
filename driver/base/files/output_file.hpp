// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/files/file_mark.hpp"
#include "driver/base/text/hash.hpp"

namespace slipbench::driver::base {

/// Tells whether two names mean one file, be it there or not; links are followed.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns why `target` must not be written: it is one of the files that are read, or was read
/// (inputs_read.hpp). A sentence, or nothing.
std::string input_fault(const std::filesystem::path& target, std::span<const std::string> inputs);

/// Files that a new one may take the place of, besides an empty file and one with its own mark.
struct Overwriting {
  std::span<const std::string> inputs = {};  ///< never these, by whatever name
  bool force = false;                        ///< anything else, too
  bool renewed = false;                      ///< one that was read before, too
};

/// Of a file that is read under its temporary name and then dropped.
inline constexpr Overwriting kNeverNamed{.force = true};

/// Returns why nothing can be written to `target`, as OutputFile::create would find it; a sentence,
/// or nothing. Makes nothing and writes nothing.
std::string target_fault(const std::filesystem::path& target, const FileMark& mark,
                         const Overwriting& overwriting = {});

/// Makes a folder and those it lies in. Those that are still empty when a file that was to be
/// written is dropped, or when the program is interrupted, are removed again. A sentence if it
/// cannot be made, or nothing.
std::string make_folders(const std::filesystem::path& folder);

/// Makes programs that complete files in the same folders wait for each other, as long as it
/// exists; where the file system has no locks they do not.
class FolderLocks {
 public:
  /// Locks the folders of files that are about to be completed, links followed.
  explicit FolderLocks(std::span<const std::filesystem::path> files);
  ~FolderLocks();
  FolderLocks(const FolderLocks&) = delete;
  FolderLocks& operator=(const FolderLocks&) = delete;

 private:
  std::vector<int> descriptors_;
};

/// A file that appears under its name only when it is complete: it is written without a name in the
/// same folder (O_TMPFILE), and `commit` brings it to the disk and names it. So a program that is
/// killed leaves no other file behind, but for the moment in which one takes the place of another:
/// then a complete file may be left under a hidden name of its own, ".NAME.XXXXXX"; files that are
/// named together get their names one after the other. Where the file system or a library wants a
/// name, it is written under such a one from the start, which is left only by a program that is
/// killed. A name that is a link stays one: the file that it leads to is written, beside itself.
/// Dropped before that, interrupted or failed, it leaves nothing behind. Errors are sentences that
/// name the file and the system's reason; after the first one, writing does nothing. It takes the
/// place of nothing but what its mark and Overwriting let it, also if another file has come to that
/// place while it was written.
class OutputFile {
 public:
  /// Makes the folder, too, if it is missing. Errors: a folder that is no folder, or cannot be made
  /// or written to; a target that exists and is no regular file (a folder, a device, a descriptor
  /// such as /dev/stdout); links in a circle; a target that is an input or a file of another
  /// origin; a name or path that is too long.
  static tl::expected<OutputFile, std::string> create(const std::filesystem::path& target,
                                                      const FileMark& mark,
                                                      const Overwriting& overwriting = {});

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// The buffer, for appending to; `flush_if_full` after each piece keeps it small.
  std::string& buffer() { return buffer_; }
  void flush_if_full() {
    if (buffer_.size() >= kFlushSize) flush();
  }
  void append(std::string_view text) {
    buffer_ += text;
    flush_if_full();
  }

  /// Replaces the first bytes, which were there already, by as many.
  void replace_start(std::string_view text);

  /// Writes what is left, for others to read by the temporary path.
  tl::expected<void, std::string> close();

  /// Makes it anew under a hidden name, for a library that writes it and wants one; before anything
  /// is written.
  tl::expected<void, std::string> need_name();

  /// The hash of all that was appended, once it is closed; what `replace_start` and libraries write
  /// has no part in it.
  const StreamHash& hash() const { return hash_; }
  /// Bytes so far, those in the buffer among them.
  std::uintmax_t size() const;
  /// The name it was asked for by.
  const std::filesystem::path& target() const { return target_; }
  const FileMark& mark() const { return mark_; }
  /// The path by which this program and its children reach it until it is named or dropped.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  friend tl::expected<void, std::string> commit(std::span<OutputFile* const> files);
  friend tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                                const FolderLocks& locks);

  static constexpr std::size_t kFlushSize = std::size_t{256} << 10U;

  OutputFile() = default;
  bool begin_unnamed();
  tl::expected<void, std::string> begin_named();
  void flush();
  tl::expected<void, std::string> to_disk();
  tl::expected<void, std::string> name_beside();
  bool link_as(const std::filesystem::path& name);
  tl::expected<void, std::string> take_place();
  void give_back();
  tl::expected<void, std::string> copy_to_name();
  void forget();
  void drop();
  std::string fault(int error) const;

  std::filesystem::path target_;
  std::filesystem::path place_;  ///< where it will be, links followed
  std::filesystem::path temporary_;
  std::string buffer_;
  StreamHash hash_;
  std::string error_;
  FileMark mark_;
  bool force_ = false;
  bool renewed_ = false;
  bool named_ = false;  ///< the temporary path is a name in the folder
  /// State of the place: untouched, named anew, exchanged with the hidden name, or replaced.
  enum class Placed : unsigned char { kNot, kNew, kExchanged, kReplaced } placed_ = Placed::kNot;
  int descriptor_ = -1;
  int registered_ = -1;
};

/// Completes files that belong together, all or none: writes what is left, waits until it is on the
/// disk, gives what they replace, but for the first, hidden names and then names them one after the
/// other. Two programs that complete files in one folder do so one after the other. A program that
/// is killed on the way leaves files of the old set or of the new one, never of both. The error is
/// that of the first file that has one; then none is under its name, and what was there is there
/// again (where the file system cannot exchange two names, but for the first).
tl::expected<void, std::string> commit(std::span<OutputFile* const> files);
/// The same for a caller that holds the locks of the files' folders already, to look at what is
/// there before it is replaced.
tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                       const FolderLocks& locks);

/// Writes a text as a file of no mark.
tl::expected<void, std::string> save_text(const std::filesystem::path& target,
                                          std::string_view text, const Overwriting& overwriting);

}  // namespace slipbench::driver::base
