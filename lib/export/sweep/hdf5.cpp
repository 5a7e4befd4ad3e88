#include "lib/export/sweep/hdf5.hpp"

#include <algorithm>
#include <hdf5.h>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::exports {

namespace {

constexpr std::size_t rows_at_once = 8192;  // rows of a column: 64 KiB

/// An object of the library, closed at the end.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() { end(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }

  /// False if the library could not.
  bool end() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }
  [[nodiscard]] bool is_open() const { return id_ >= 0; }
  [[nodiscard]] hid_t operator*() const { return id_; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(*type, std::max<std::size_t>(bytes, 1));
  H5Tset_cset(*type, H5T_CSET_UTF8);
  H5Tset_strpad(*type, H5T_STR_NULLPAD);
  return type;
}

bool put(hid_t of, const char* name, hid_t type, const Handle& space, const void* value) {
  const Handle attribute(H5Acreate2(of, name, type, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.is_open() && H5Awrite(*attribute, type, value) >= 0;
}

bool put(hid_t of, const char* name, const std::string& text) {
  const Handle type = text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
  const std::string bytes = text.empty() ? std::string(1, '\0') : text;
  return put(of, name, *type, space, bytes.data());
}

bool put(hid_t of, const char* name, std::uint64_t number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  return put(of, name, H5T_STD_U64LE, space, &number);
}

/// Texts of one length, padded with zeros.
bool put(hid_t of, const char* name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  for (const std::string& text : texts) bytes += text + std::string(longest - text.size(), '\0');
  const hsize_t count = texts.size();
  const Handle type = text_type(longest), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  return put(of, name, *type, space, bytes.data());
}

/// A name of a dataset: '/' would make it one within a group.
std::string link_name(std::string name, const std::vector<std::string>& taken) {
  std::replace(name.begin(), name.end(), '/', '_');
  std::string free = name;
  for (int i = 2; std::find(taken.begin(), taken.end(), free) != taken.end(); ++i)
    free = name + "_" + std::to_string(i);
  return free;
}

std::string unit_or_one(const Dimension& dimension) {
  const std::string unit = si_unit(dimension);
  return unit.empty() ? "1" : unit;
}

Message unwritten(const std::filesystem::path& path) { return say("cannot write '{1}'", path.string()); }

}  // namespace

struct Hdf5File::Parts {
  struct Column {
    Handle data;
    std::vector<double> waiting;
  };

  std::filesystem::path path;
  Handle file;
  std::vector<Column> columns;
  std::vector<std::string> names;
  std::vector<std::size_t> results;  // results with a column
  std::uint64_t written = 0;         // rows

  bool describe(const SweepPlan& plan, const StoredSweep& sweep);
  bool add(const std::string& name, const std::string& unit, const std::string& shown_in,
           const std::vector<std::string>& words, std::uint64_t rows);
  bool add_columns(const SweepPlan& plan);
  bool write();
};

bool Hdf5File::Parts::describe(const SweepPlan& plan, const StoredSweep& sweep) {
  return put(*file, "program", sweep.program) && put(*file, "project", sweep.file) &&
         put(*file, "input", fingerprint(sweep.identity)) && put(*file, "seed", sweep.seed) &&
         put(*file, "points", plan.space.count());
}

bool Hdf5File::Parts::add(const std::string& name, const std::string& unit, const std::string& shown_in,
                          const std::vector<std::string>& words, std::uint64_t rows) {
  const hsize_t size = rows;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose), how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(*how, false);
  names.push_back(link_name(name, names));
  Handle data(H5Dcreate2(*file, names.back().c_str(), H5T_IEEE_F64LE, *space, H5P_DEFAULT, *how, H5P_DEFAULT),
              H5Dclose);
  if (!data.is_open()) return false;
  const std::uint64_t number = columns.size();
  const bool is_described = put(*data, "name", name) && put(*data, "unit", unit) &&
                            put(*data, "shown_in", shown_in.empty() ? "-" : shown_in) && put(*data, "number", number) &&
                            (words.empty() || put(*data, "words", words));
  columns.push_back({std::move(data), {}});
  columns.back().waiting.reserve(rows_at_once);
  return is_described;
}

bool Hdf5File::Parts::add_columns(const SweepPlan& plan) {
  const std::uint64_t rows = plan.space.count();
  for (const project::SweptInput& input : plan.inputs) {
    if (!add(input.name, unit_or_one(input.dimension), input.unit, input.words, rows)) return false;
  }
  results = plan.kept_results();
  for (const std::size_t k : plan.output_columns()) {
    const project::SweptResult& result = plan.columns[k];
    if (!add(result.name, unit_or_one(result.dimension), result.unit, {}, rows)) return false;
  }
  return add("state", "1", "-", {}, rows) && add("utilisation", "1", "-", {}, rows);
}

/// Appends the buffered rows to the file.
bool Hdf5File::Parts::write() {
  const hsize_t start = written, count = columns.front().waiting.size();
  if (count == 0) return true;
  const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  for (Column& column : columns) {
    const Handle space(H5Dget_space(*column.data), H5Sclose);
    if (H5Sselect_hyperslab(*space, H5S_SELECT_SET, &start, nullptr, &count, nullptr) < 0 ||
        H5Dwrite(*column.data, H5T_NATIVE_DOUBLE, *memory, *space, H5P_DEFAULT, column.waiting.data()) < 0)
      return false;
    column.waiting.clear();
  }
  written += count;
  return true;
}

Hdf5File::Hdf5File() = default;
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

bool Hdf5File::is_there() { return true; }

Outcome<Hdf5File> Hdf5File::create(const std::filesystem::path& path, const SweepPlan& plan, const StoredSweep& sweep) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported here
  Hdf5File made;
  made.parts_ = std::make_unique<Parts>();
  Parts& parts = *made.parts_;
  parts.path = path;
  parts.file = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!parts.file.is_open() || !parts.describe(plan, sweep) || !parts.add_columns(plan))
    return Fault{0, 1, unwritten(path), {}};
  return made;
}

Message Hdf5File::append(const project::SolvedBlock& block) {
  std::size_t k = 0;
  const auto add = [&](const std::vector<double>& values) {
    std::vector<double>& waiting = parts_->columns[k++].waiting;
    waiting.insert(waiting.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(block.count));
  };
  for (const auto& values : block.inputs) add(values);
  for (const std::size_t result : parts_->results) add(block.results[result]);
  const bool full = parts_->columns.front().waiting.size() + project::block_size > rows_at_once;
  return !full || parts_->write() ? Message{} : unwritten(parts_->path);
}

Message Hdf5File::close() {
  bool well = parts_->write();
  for (Parts::Column& column : parts_->columns) well = column.data.end() && well;
  well = parts_->file.end() && well;
  return well ? Message{} : unwritten(parts_->path);
}

}  // namespace loadpath::exports
