// SPDX-License-Identifier: Apache-2.0
// The plug-in that reads and writes tables as HDF5.
#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "driver/table/hdf5_plugin.hpp"

namespace slipbench::driver::table {
namespace {

/// An identifier of HDF5 with what closes it.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// Closes it before its time; false where something was not written.
  bool close_now() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

constexpr std::string_view kUnits = "# columns: ";

/// So many rows are in memory at once, or as many as have so many numbers.
constexpr std::size_t kTogether = 16384;
constexpr std::size_t kMostNumbers = 4'000'000;

bool write_text(hid_t object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(1, text.size()));
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute.get(), type.get(), text.c_str()) >= 0;
}

std::string read_text(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  if (!type || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) {
    return {};
  }
  std::string text(H5Tget_size(type.get()), '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0) return {};
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

/// Returns whether a dataset has whole numbers, which may be too large for a double, or nothing
/// where a double does not hold what it has.
std::optional<bool> is_whole(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind == H5T_INTEGER) return true;
  if (kind == H5T_FLOAT && H5Tget_size(type.get()) <= sizeof(double)) return false;
  return std::nullopt;
}

std::string write(const std::filesystem::path& path, const TableHead& head,
                  std::span<const std::string> units, std::uint64_t rows,
                  const std::function<std::size_t(std::span<double>)>& read) {
  std::string fault = "cannot be written as HDF5";
  const Handle options(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  // Columns stay in the order of the table.
  H5Pset_link_creation_order(options.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, options.get(), H5P_DEFAULT), H5Fclose);
  if (!file || !write_text(file.get(), "provenance", head.lines)) return fault;
  const hsize_t size[] = {rows};
  const Handle space(H5Screate_simple(1, size, nullptr), H5Sclose);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_layout(layout.get(), H5D_CONTIGUOUS);
  H5Pset_fill_time(layout.get(), H5D_FILL_TIME_NEVER);
  H5Pset_obj_track_times(layout.get(), false);  // the same rows are the same bytes
  std::vector<Handle> columns;
  for (std::size_t c = 0; c < head.columns.size(); ++c) {
    columns.emplace_back(H5Dcreate2(file.get(), head.columns[c].c_str(), H5T_IEEE_F64LE,
                                    space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT),
                         H5Dclose);
    if (!columns.back())
      return fault + fmt::format(": no dataset can be called '{}'", head.columns[c]);
    if (!units[c].empty() && !write_text(columns.back().get(), "unit", units[c])) return fault;
  }
  const std::size_t width = columns.size();
  std::vector<double> block(std::clamp<std::size_t>(kMostNumbers / width, 1, kTogether) * width);
  std::vector<double> column(kTogether);
  std::uint64_t done = 0;
  while (const std::size_t count = read(block)) {
    const hsize_t begin[] = {done};
    const hsize_t extent[] = {count};
    const Handle memory(H5Screate_simple(1, extent, nullptr), H5Sclose);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin, nullptr, extent, nullptr);
    for (std::size_t c = 0; c < width; ++c) {
      for (std::size_t k = 0; k < count; ++k) column[k] = block[k * width + c];
      if (H5Dwrite(columns[c].get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT,
                   column.data()) < 0) {
        return fault;
      }
    }
    done += count;
  }
  if (done != rows || H5Fflush(file.get(), H5F_SCOPE_LOCAL) < 0) return fault;
  // The last of it is written where the file is closed, with all that is in it.
  columns.clear();
  return file.close_now() ? std::string() : fault;
}

class Hdf5Table : public TableReader {
 public:
  std::string open(const std::filesystem::path& path) {
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0) return "is no HDF5 file, or cannot be read";
    head_.lines = read_text(file_, "provenance");
    const bool ordered =
        H5Literate(file_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, this) >= 0;
    if (!ordered) {
      head_.columns.clear();
      units_.clear();
      if (H5Literate(file_, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, this) < 0)
        fault_ = "cannot be read";
    }
    if (!fault_.empty()) return fault_;
    // Another program's file: the units are told as a result tells them.
    if (head_.lines.find(kUnits) == std::string::npos && !units_.empty()) {
      head_.lines += fmt::format("{}{}\n", kUnits, fmt::join(units_, ", "));
    }
    return columns_.empty() ? "has no datasets of one dimension at its root" : "";
  }
  Hdf5Table() = default;
  Hdf5Table(const Hdf5Table&) = delete;
  Hdf5Table& operator=(const Hdf5Table&) = delete;
  ~Hdf5Table() override {
    columns_.clear();
    if (file_ >= 0) H5Fclose(file_);
  }

  const TableHead& head() const override { return head_; }

  tl::expected<std::size_t, std::string> read(std::span<double> numbers) override {
    const std::size_t width = columns_.size();
    const auto count = static_cast<std::size_t>(
        std::min<hsize_t>({rows_ - done_, numbers.size() / width, kTogether}));
    if (count == 0) return 0;
    const hsize_t begin[] = {done_};
    const hsize_t extent[] = {count};
    const Handle memory(H5Screate_simple(1, extent, nullptr), H5Sclose);
    std::vector<double> column(count);
    for (std::size_t c = 0; c < width; ++c) {
      const Handle space(H5Dget_space(columns_[c].get()), H5Sclose);
      H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin, nullptr, extent, nullptr);
      if (H5Dread(columns_[c].get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT,
                  column.data()) < 0) {
        return tl::unexpected<std::string>("dataset '" + head_.columns[c] + "' cannot be read");
      }
      // Every whole number up to here is a double.
      constexpr double kLast = 9007199254740992.0;
      const auto beyond = [](double number) { return number >= kLast || number <= -kLast; };
      if (whole_[c] && std::any_of(column.begin(), column.end(), beyond)) {
        return tl::unexpected<std::string>("dataset '" + head_.columns[c] +
                                           "' has whole numbers from 2^53 on, beyond doubles");
      }
      for (std::size_t k = 0; k < count; ++k) numbers[k * width + c] = column[k];
    }
    done_ += count;
    return count;
  }

 private:
  static herr_t add(hid_t group, const char* name, const H5L_info_t* link, void* self) {
    Hdf5Table& table = *static_cast<Hdf5Table*>(self);
    if (link->type != H5L_TYPE_HARD) {
      table.fault_ =
          fmt::format("'{}' is a link, perhaps to another file, which is not read", name);
      return 0;
    }
    H5O_info_t info;
    if (H5Oget_info_by_name2(group, name, &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0) return -1;
    if (info.type != H5O_TYPE_DATASET) return 0;
    Handle column(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
    const Handle creation(H5Dget_create_plist(column.get()), H5Pclose);
    if (H5Pget_external_count(creation.get()) != 0 ||
        H5Pget_layout(creation.get()) == H5D_VIRTUAL) {
      table.fault_ =
          fmt::format("the numbers of '{}' are in another file, which is not read", name);
      return 0;
    }
    const Handle space(H5Dget_space(column.get()), H5Sclose);
    hsize_t size = 0;
    if (H5Sget_simple_extent_ndims(space.get()) != 1) return 0;
    H5Sget_simple_extent_dims(space.get(), &size, nullptr);
    if (!table.columns_.empty() && size != table.rows_) {
      table.fault_ =
          fmt::format("dataset '{}' has {} rows, others have {}", name, size, table.rows_);
    }
    const std::optional<bool> whole = is_whole(column.get());
    if (!whole) {
      table.fault_ = fmt::format("dataset '{}' is not of numbers that a double holds", name);
    }
    const std::string unit = read_text(column.get(), "unit");
    if (!unit.empty() && unit.find_first_of("\n],") == std::string::npos) {
      table.units_.push_back(fmt::format("{} [{}]", name, unit));
    }
    table.rows_ = size;
    table.whole_.push_back(whole.value_or(false));
    table.columns_.push_back(std::move(column));
    table.head_.columns.emplace_back(name);
    return 0;
  }

  hid_t file_ = -1;
  std::vector<Handle> columns_;
  std::vector<bool> whole_;  ///< of each column: its numbers are whole
  TableHead head_;
  std::vector<std::string> units_;  ///< "CP1 [mm]", of columns that have one
  std::string fault_;
  hsize_t rows_ = 0;
  hsize_t done_ = 0;
};

tl::expected<std::unique_ptr<TableReader>, std::string> open(const std::filesystem::path& file) {
  auto table = std::make_unique<Hdf5Table>();
  if (std::string fault = table->open(file); !fault.empty()) {
    return tl::unexpected(std::move(fault));
  }
  return table;
}

}  // namespace
}  // namespace slipbench::driver::table

extern "C" const slipbench::driver::table::Hdf5Plugin* slipbench_hdf5() {
  using namespace slipbench::driver::table;
  // A file that could not be written would be tried again at the end of the program, which crashes.
  H5dont_atexit();
  // What goes wrong is told by sentences.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static constexpr Hdf5Plugin kPlugin{SLIPBENCH_VERSION, write, open};
  return &kPlugin;
}
