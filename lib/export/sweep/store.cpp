#include "lib/export/sweep/store.hpp"

#include "lib/export/json_writer.hpp"
#include "lib/export/sweep/folder.hpp"
#include "lib/quantity/dimension.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace loadpath::exports {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t state_format = 1;

std::string hexadecimal(std::uint64_t number) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; number >>= 4) text[i] = digits[number & 15];
  return text;
}

/// A part of a file's name, of letters that every system takes.
std::string file_name(std::size_t number, const std::string& name) {
  std::string text = std::to_string(number + 1) + "-";
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (plain || !text.ends_with('_')) text += plain ? c : '_';
  }
  return text.substr(0, 100) + ".npy";
}

void put_text(sweep::Writer& writer, const std::string& text) {
  writer.put(std::uint64_t{text.size()});
  for (const char c : text) writer.put(std::uint64_t{static_cast<unsigned char>(c)});
}

std::string read_text(sweep::Reader& reader) {
  std::string text;
  for (std::uint64_t left = reader.count(1); left > 0; --left) text += static_cast<char>(reader.number());
  return text;
}

bool read_whole(const fs::path& path, std::string& bytes) {
  std::ifstream in(path, std::ios::binary);
  bytes.assign(std::istreambuf_iterator<char>(in), {});
  return in.good() || in.eof();
}

/// The first lines in which two texts differ, cut short.
Message difference(std::string_view there, std::string_view here) {
  while (!there.empty() && !here.empty()) {
    const auto next = [](std::string_view& text) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      return line;
    };
    const std::string_view theirs = next(there), ours = next(here);
    constexpr std::size_t width = 80;
    if (theirs != ours)
      return say("'{1}' there, '{2}' here", std::string(theirs.substr(0, width)), std::string(ours.substr(0, width)));
  }
  return say("one ends where the other continues");
}

}  // namespace

std::string fingerprint(std::string_view identity) { return hexadecimal(checked(0, identity)); }

SweepStore::SweepStore(fs::path folder, const SweepPlan& plan, StoredSweep sweep, SweepStatistics none)
    : folder_(std::move(folder)), points_(plan.space.count()), sweep_(std::move(sweep)), found_(std::move(none)) {
  next_ = sweep_.blocks.first;
  if (sweep_.columns) name_columns(plan);
}

/// Inputs, results, and the overall verdict.
void SweepStore::name_columns(const SweepPlan& plan) {
  const auto add = [this](const std::string& name, const std::string& unit, const std::string& si) {
    columns_.push_back({name, unit, si, "columns/" + file_name(columns_.size(), name), 0, {}});
  };
  for (const project::SweptInput& input : plan.inputs) add(input.name, input.unit, si_unit(input.dimension));
  results_ = plan.kept_results();
  for (const std::size_t k : plan.output_columns()) {
    const project::SweptResult& column = plan.columns[k];
    add(column.name, column.unit, si_unit(column.dimension));
  }
  add("state", "-", "");
  add("utilisation", "-", "");
}

std::uint64_t SweepStore::points_until(std::uint64_t block) const {
  const std::uint64_t first = std::min(sweep_.blocks.first * project::block_size, points_);
  return std::min(block * project::block_size, points_) - first;
}

Message SweepStore::open_columns(std::uint64_t rows) {
  std::error_code error;
  fs::create_directories(folder_ / "columns", error);
  if (error) return say("cannot make '{1}': {2}", (folder_ / "columns").string(), error.message());
  for (Column& column : columns_) {
    if (rows != 0 && !fs::exists(folder_ / column.file, error))
      return say("'{1}' is missing", (folder_ / column.file).string());
    auto file = sweep::NpyColumn::open(folder_ / column.file, rows);
    if (!file) return file.fault().message;
    column.numbers = std::move(*file);
  }
  return {};
}

/// The first state of a new sweep.
Message SweepStore::begin() {
  std::error_code error;
  fs::remove_all(folder_ / "columns", error);  // remains of a process killed before it had a state
  if (Message wrong = open_columns(0); !wrong.empty()) return wrong;
  return save();
}

Outcome<SweepStore> SweepStore::create(const fs::path& folder, const SweepPlan& plan, StoredSweep sweep,
                                       SweepStatistics none) {
  const auto taken = [&] {
    return refused(folder, say("a file or folder of this name already exists"),
                   say("name a new folder, or continue the stored sweep: --resume"));
  };
  std::error_code error;
  if (fs::exists(folder, error) && !is_unbegun(folder)) {
    const auto writer = FolderLock::writer_of(folder);
    return writer ? *writer : taken();
  }
  SweepStore store(folder, plan, std::move(sweep), std::move(none));
  fs::create_directories(folder, error);
  if (error) return refused(folder, say("{1}", error.message()));
  auto lock = FolderLock::to_write(folder);
  if (!lock) return lock.fault();
  if (!is_unbegun(folder)) return taken();
  store.lock_ = std::move(*lock);
  if (Message wrong = store.begin(); !wrong.empty()) return Fault{0, 1, std::move(wrong), {}};
  return store;
}

Outcome<SweepStore> SweepStore::resume(const fs::path& folder, const SweepPlan& plan, const StoredSweep& sweep,
                                       SweepStatistics none) {
  const auto none_there = [&] {
    return refused(folder, say("no sweep in this folder"), say("start it without --resume"));
  };
  std::error_code error;
  const auto has_state = [&] { return fs::exists(folder / state_name, error); };
  if (!has_state() && !is_unbegun(folder)) return none_there();
  SweepStore store(folder, plan, sweep, std::move(none));
  auto lock = FolderLock::to_write(folder);
  if (!lock) return lock.fault();
  store.lock_ = std::move(*lock);
  Message wrong;
  if (!has_state()) {
    wrong = store.begin();
    return wrong.empty() ? Outcome<SweepStore>(std::move(store)) : Fault{0, 1, std::move(wrong), {}};
  }
  const std::string bytes = store.read_state(wrong);
  if (wrong.empty()) wrong = store.load(bytes);
  if (!wrong.empty()) return refused(folder, std::move(wrong), say("start in another folder"));
  const BlockRange there = store.sweep_.blocks, asked = sweep.blocks;
  if (there.first != asked.first || there.last != asked.last) {
    const std::string points = points_of(there, store.points_);
    return refused(folder, say("it is another share: points {1}, not {2}", points, points_of(asked, store.points_)),
                   say("continue it: --shard {1}; or name another folder", points));
  }
  wrong = store.open_columns(store.points_until(store.next_));
  if (wrong.empty()) wrong = store.check_columns();
  if (!wrong.empty()) return Fault{0, 1, std::move(wrong), say("start in another folder")};
  return store;
}

Message SweepStore::check_columns() const {
  for (const Column& column : columns_) {
    std::uint64_t check = 0;
    Message wrong = sweep::read_npy(folder_ / column.file, [&](std::span<const double> values) {
      check = checked(check, values);
      return true;
    });
    if (!wrong.empty()) return wrong;
    if (check != column.check) return not_what_was_written(folder_ / column.file);
  }
  return {};
}

Message SweepStore::append(std::size_t column, std::span<const double> values) {
  Column& to = columns_[column];
  to.check = checked(to.check, values);
  return to.numbers.append(values) ? Message{} : say("cannot write '{1}'", (folder_ / to.file).string());
}

Message SweepStore::take(const SweptPart& part) {
  for (const project::SolvedBlock& block : part.rows) {
    std::size_t column = 0;
    const auto add = [&](const std::vector<double>& values) { return append(column++, values); };
    for (const auto& values : block.inputs) {
      if (columns_.empty()) break;
      if (Message wrong = add(values); !wrong.empty()) return wrong;
    }
    for (const std::size_t result : results_) {
      if (Message wrong = add(block.results[result]); !wrong.empty()) return wrong;
    }
  }
  next_ = part.blocks.last;
  return found_.merge(part.found) ? Message{} : say("a part was computed twice");
}

std::string SweepStore::state() const {
  sweep::Writer writer;
  writer.put(state_format);
  put_text(writer, sweep_.identity);
  for (const std::uint64_t number : {sweep_.blocks.first, sweep_.blocks.last, next_}) writer.put(number);
  writer.put(std::uint64_t{columns_.size()});
  for (const Column& column : columns_) writer.put(column.check);
  found_.store(writer);
  std::string bytes = writer.bytes();
  sweep::Writer end;
  end.put(checked(0, bytes));
  return bytes + end.bytes();
}

std::string SweepStore::read_state(Message& wrong) const {
  std::string bytes;
  if (!read_whole(folder_ / state_name, bytes)) wrong = say("its state cannot be read");
  return bytes;
}

/// The error in the bytes of a state: damaged, or of another sweep.
Message SweepStore::load(std::string_view bytes) {
  constexpr std::size_t end = sizeof(std::uint64_t);
  Message damaged = say("its state is damaged");
  if (bytes.size() < end) return damaged;
  sweep::Reader check(bytes.substr(bytes.size() - end));
  bytes.remove_suffix(end);
  if (check.number() != checked(0, bytes)) return damaged;
  sweep::Reader reader(bytes);
  if (reader.number() != state_format) return say("its state is of another version of the program");
  const std::string identity = read_text(reader);
  if (identity != sweep_.identity)
    return say("the folder holds another sweep: {1}", difference(identity, sweep_.identity));
  return load_known(reader) ? Message{} : damaged;
}

bool SweepStore::load_known(sweep::Reader& reader) {
  sweep_.blocks.first = reader.number();
  sweep_.blocks.last = reader.number();
  next_ = reader.number();
  if (reader.number() != columns_.size()) return false;
  for (Column& column : columns_) column.check = reader.number();
  found_.load(reader);
  const BlockRange& blocks = sweep_.blocks;
  const std::uint64_t all = (points_ + project::block_size - 1) / project::block_size;
  const bool in_order = blocks.first <= next_ && next_ <= blocks.last && blocks.last <= all;
  return !reader.failed() && reader.at_end() && in_order;
}

std::string SweepStore::manifest() const {
  JsonWriter json;
  json.open_object();
  json.member("program", sweep_.program);
  json.member("project", sweep_.file);
  json.member("input", fingerprint(sweep_.identity));
  json.member("seed", static_cast<std::int64_t>(sweep_.seed));
  json.member("points", static_cast<std::int64_t>(points_));
  json.member("first", static_cast<std::int64_t>(std::min(sweep_.blocks.first * project::block_size, points_)));
  json.member("end", static_cast<std::int64_t>(std::min(sweep_.blocks.last * project::block_size, points_)));
  json.member("rows", static_cast<std::int64_t>(points_until(next_)));
  json.member("state", next_ == sweep_.blocks.last ? "done" : "begun");
  json.key("columns").open_array();
  for (const Column& column : columns_) {
    json.open_object();
    json.member("name", column.name);
    json.member("unit", column.si_unit.empty() ? std::string("1") : column.si_unit);
    json.member("shown_in", column.unit.empty() ? std::string("-") : column.unit);
    json.member("file", column.file);
    json.member("crc64", hexadecimal(column.check));
    json.close_object();
  }
  json.close_array();
  json.close_object();
  return json.take();
}

/// Written to a temporary file and renamed, so that it is always complete.
Message SweepStore::put(const std::string& name, const std::string& bytes) const {
  const fs::path aside = folder_ / aside_of(name);
  const auto wrong = [&] { return say("cannot write '{1}': {2}", (folder_ / name).string(), std::strerror(errno)); };
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(aside.c_str(), "wb"), &std::fclose);
    if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
        !sweep::flush_to_disk(file.get()))
      return wrong();
  }
  std::error_code error;
  fs::rename(aside, folder_ / name, error);
  return error ? say("cannot write '{1}': {2}", (folder_ / name).string(), error.message()) : Message{};
}

Message SweepStore::save() {
  for (Column& column : columns_) {
    if (!column.numbers.flush()) return say("cannot write '{1}'", (folder_ / column.file).string());
  }
  if (Message wrong = put(state_name, state()); !wrong.empty()) return wrong;
  return put(manifest_name, manifest());
}

}  // namespace loadpath::exports
