#include "lib/export/sweep/store.hpp"

#include "lib/export/json_writer.hpp"
#include "lib/quantity/dimension.hpp"

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace loadpath::exports {

namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "state";
constexpr const char* manifest_name = "manifest.json";
constexpr std::uint64_t state_format = 1;

/// CRC-64 of ECMA-182, taken up where it stopped.
std::uint64_t checked(std::uint64_t before, std::string_view bytes) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0, 0, false, false> crc(before);
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}
std::uint64_t checked(std::uint64_t before, std::span<const double> values) {
  return checked(before, std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
}

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

Fault refused(const fs::path& folder, Message message, Message hint = {}) {
  return {0, 1, say("'{1}': {2}", folder.string(), std::move(message)), std::move(hint)};
}

}  // namespace

SweepStore::SweepStore(fs::path folder, const SweepPlan& plan, StoredSweep sweep, Found none)
    : folder_(std::move(folder)), points_(plan.space.count()), sweep_(std::move(sweep)), found_(std::move(none)) {
  next_ = sweep_.blocks.first;
  if (sweep_.columns) name_columns(plan);
}

/// Inputs, results, and how the whole came out.
void SweepStore::name_columns(const SweepPlan& plan) {
  const auto add = [this](const std::string& name, const std::string& unit, const std::string& si) {
    columns_.push_back({name, unit, si, "columns/" + file_name(columns_.size(), name), 0, {}});
  };
  for (const project::SweptInput& input : plan.inputs) add(input.name, input.unit, si_unit(input.dimension));
  for (const project::SweptResult& column : plan.columns) add(column.name, column.unit, si_unit(column.dimension));
  add("state", "-", "");
  add("utilisation", "-", "");
}

std::uint64_t SweepStore::points_until(std::uint64_t block) const {
  return std::min(block * project::block_size, points_) - sweep_.blocks.first * project::block_size;
}

Message SweepStore::open_columns(std::uint64_t rows) {
  std::error_code error;
  fs::create_directories(folder_ / "columns", error);
  if (error) return say("cannot make '{1}': {2}", (folder_ / "columns").string(), error.message());
  for (Column& column : columns_) {
    auto file = sweep::NpyColumn::open(folder_ / column.file, rows);
    if (!file) return file.fault().message;
    column.numbers = std::move(*file);
  }
  return {};
}

Outcome<SweepStore> SweepStore::create(const fs::path& folder, const SweepPlan& plan, StoredSweep sweep, Found none) {
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_directory(folder, error) || !fs::is_empty(folder, error)))
    return refused(folder, say("there is something already"),
                   say("name a new folder, or go on with what stands there: --resume"));
  SweepStore store(folder, plan, std::move(sweep), std::move(none));
  fs::create_directories(folder, error);
  if (error) return refused(folder, say("{1}", error.message()));
  if (Message wrong = store.open_columns(0); !wrong.empty()) return Fault{0, 1, std::move(wrong), {}};
  if (Message wrong = store.save(); !wrong.empty()) return Fault{0, 1, std::move(wrong), {}};
  return store;
}

Outcome<SweepStore> SweepStore::resume(const fs::path& folder, const SweepPlan& plan, const StoredSweep& sweep,
                                       Found none) {
  std::string bytes;
  std::error_code error;
  if (!fs::exists(folder / state_name, error) || !read_whole(folder / state_name, bytes))
    return refused(folder, say("no sweep stands there"), say("begin it without --resume"));
  SweepStore store(folder, plan, sweep, std::move(none));
  if (!store.load(bytes, true))
    return refused(folder, say("the sweep of another project, of other settings, or of another program stands there"),
                   say("name another folder"));
  const std::uint64_t rows = store.points_until(store.next_);
  if (Message wrong = store.open_columns(rows); !wrong.empty()) return Fault{0, 1, std::move(wrong), {}};
  return store;
}

Outcome<SweepStore> SweepStore::merge(const std::vector<fs::path>& shards, const fs::path& folder,
                                      const SweepPlan& plan, StoredSweep sweep, const Found& none) {
  std::vector<SweepStore> all;
  for (const fs::path& path : shards) {
    std::string bytes;
    std::error_code error;
    SweepStore shard(path, plan, sweep, none);
    if (!fs::exists(path / state_name, error) || !read_whole(path / state_name, bytes))
      return refused(path, say("no sweep stands there"));
    if (!shard.load(bytes, false)) return refused(path, say("it is no shard of this sweep"));
    if (shard.left().count() != 0)
      return refused(
          path,
          say("it is not done: {1} points are left",
              std::to_string(shard.points_until(shard.sweep_.blocks.last) - shard.points_until(shard.next_))),
          say("go on with it: --resume"));
    all.push_back(std::move(shard));
  }
  std::sort(all.begin(), all.end(),
            [](const SweepStore& a, const SweepStore& b) { return a.sweep_.blocks.first < b.sweep_.blocks.first; });
  std::uint64_t next = sweep.blocks.first;  // nothing is made where something is missing
  for (const SweepStore& shard : all) {
    if (shard.sweep_.blocks.first < next) return refused(shard.folder_, say("its points are in another shard too"));
    if (shard.sweep_.blocks.first > next) break;
    next = shard.sweep_.blocks.last;
  }
  if (next != sweep.blocks.last)
    return refused(folder, say("the points from {1} on are in no shard", std::to_string(next * project::block_size)));
  auto merged = create(folder, plan, sweep, none);
  if (!merged) return merged;
  Message wrong;
  for (const SweepStore& shard : all) {
    if (wrong.empty()) wrong = merged->append_shard(shard);
  }
  if (wrong.empty()) wrong = merged->save();
  if (wrong.empty()) return merged;
  std::error_code error;  // create() has made all of it
  fs::remove_all(folder, error);
  return Fault{0, 1, std::move(wrong), {}};
}

Message SweepStore::append(std::size_t column, std::span<const double> values) {
  Column& to = columns_[column];
  to.check = checked(to.check, values);
  return to.numbers.append(values) ? Message{} : say("cannot write '{1}'", (folder_ / to.file).string());
}

Message SweepStore::append_shard(const SweepStore& shard) {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const fs::path path = shard.folder_ / columns_[k].file;
    std::uint64_t rows = 0, check = 0;
    Message wrong;
    const Message unread = sweep::read_npy(path, [&](std::span<const double> values) {
      rows += values.size();
      check = checked(check, values);
      wrong = append(k, values);
      return wrong.empty();
    });
    if (!unread.empty()) return unread;
    if (!wrong.empty()) return wrong;
    if (rows != shard.found_.points() || check != shard.columns_[k].check)
      return say("'{1}' is not what was written", path.string());
  }
  if (!found_.merge(shard.found_)) return say("'{1}': its points are in another shard too", shard.folder_.string());
  next_ = shard.next_;
  return {};
}

Message SweepStore::take(const SweptPart& part) {
  for (const project::SolvedBlock& block : part.rows) {
    std::size_t column = 0;
    const auto add = [&](const std::vector<double>& values) { return append(column++, values); };
    const std::size_t results = columns_.empty() ? 0 : columns_.size() - block.inputs.size();
    for (const auto& values : block.inputs) {
      if (columns_.empty()) break;
      if (Message wrong = add(values); !wrong.empty()) return wrong;
    }
    for (std::size_t k = 0; k < results; ++k) {
      if (Message wrong = add(block.results[k]); !wrong.empty()) return wrong;
    }
  }
  next_ = part.blocks.last;
  return found_.merge(part.found) ? Message{} : say("a part was found twice");
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

/// False where the bytes are damaged or tell of another sweep.
bool SweepStore::load(std::string_view bytes, bool same_blocks) {
  constexpr std::size_t end = sizeof(std::uint64_t);
  if (bytes.size() < end) return false;
  sweep::Reader check(bytes.substr(bytes.size() - end));
  bytes.remove_suffix(end);
  if (check.number() != checked(0, bytes)) return false;
  sweep::Reader reader(bytes);
  if (reader.number() != state_format || read_text(reader) != sweep_.identity) return false;
  const BlockRange blocks{reader.number(), reader.number()};
  if (same_blocks && (blocks.first != sweep_.blocks.first || blocks.last != sweep_.blocks.last)) return false;
  sweep_.blocks = blocks;
  next_ = reader.number();
  if (reader.number() != columns_.size()) return false;
  for (Column& column : columns_) column.check = reader.number();
  found_.load(reader);
  return !reader.failed() && reader.at_end();
}

std::string SweepStore::manifest() const {
  JsonWriter json;
  json.open_object();
  json.member("program", sweep_.program);
  json.member("project", sweep_.file);
  json.member("input", hexadecimal(checked(0, sweep_.identity)));
  json.member("seed", static_cast<std::int64_t>(sweep_.seed));
  json.member("points", static_cast<std::int64_t>(points_));
  json.member("first", static_cast<std::int64_t>(sweep_.blocks.first * project::block_size));
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

/// Written aside, and put in place whole.
Message SweepStore::put(const std::string& name, const std::string& bytes) const {
  const fs::path aside = folder_ / ("." + name + ".part");
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
