#include "lib/table/reader.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::table {

namespace {

constexpr std::string_view words[] = {"name",    "aliases", "near", "standard", "kind",   "note",
                                      "by_size", "sources", "cite", "recalled", "because"};

bool is_word(std::string_view key) { return std::find(std::begin(words), std::end(words), key) != std::end(words); }

bool has(const std::vector<Value>& values, std::string_view key) {
  return std::any_of(values.begin(), values.end(), [&](const Value& v) { return v.key == key; });
}

}  // namespace

bool Reader::read_row(const Tree& tree, const Frame& frame, Row& row) {
  const std::size_t before = issues_.size();
  row.name = text_of(tree, "name", "", true);
  row.note = text_of(tree, "note", row.name);
  if (const auto* aliases = tree.find("aliases")) row.aliases = texts(aliases->value, row.name + ".aliases");
  if (const auto* near = tree.find("near")) row.near = texts(near->value, row.name + ".near");
  if (const auto* because = tree.find("because")) {
    for (const Tree::Entry& reason : because->value.entries)
      row.because[reason.key] = text_of(because->value, reason.key, row.name);
  }
  read_values(tree, frame, row);
  let_defaults(frame, row);
  return issues_.size() == before;
}

void Reader::let_defaults(const Frame& frame, Row& row) {
  if (row.standard.empty()) row.standard = frame.defaults.standard;
  if (row.kind.empty()) row.kind = frame.defaults.kind;
  for (const Value& value : frame.defaults.values) {
    if (!has(row.values, value.key)) row.values.push_back(value);
  }
}

void Reader::read_values(const Tree& tree, const Frame& frame, Row& row) {
  row.standard = text_of(tree, "standard", row.name);
  row.kind = text_of(tree, "kind", row.name);
  const Credit credit = read_credit(tree, row.name);
  for (const auto& entry : tree.entries) {
    if (!is_word(entry.key)) add_value(entry, frame, row.name, {&credit, &frame.credit}, row.values);
  }
  if (const auto* steps = tree.find("by_size")) read_steps(steps->value, frame, row, credit);
  check_recalled(tree, row, credit);
}

void Reader::read_steps(const Tree& tree, const Frame& frame, Row& row, const Credit& credit) {
  for (const Tree& item : tree.items) {
    Step step = read_step(item, frame, row.name, credit);
    const double last = row.by_size.empty() ? 0.0 : row.by_size.back().size_max;
    if (!(step.size_max > last))
      complain(item.place, row.name + ".by_size", say("sizes must be positive and ascending"));
    row.by_size.push_back(std::move(step));
  }
}

Step Reader::read_step(const Tree& tree, const Frame& frame, const std::string& row, const Credit& credit) {
  Step step;
  const Credit own = read_credit(tree, row);
  const Credit form{{}, {}, {}, true};  // a size needs no source: it is the form of the table
  for (const auto& entry : tree.entries) {
    if (entry.key == "size_max") {
      std::vector<Value> sizes;
      add_value(entry, frame, row, {&form}, sizes);
      if (!sizes.empty()) step.size_max = sizes[0].si;
    } else if (!is_word(entry.key)) {
      add_value(entry, frame, row, {&own, &credit, &frame.credit}, step.values);
    }
  }
  return step;
}

const Reader::ReadColumn* Reader::column_of(const Tree::Entry& entry, const Frame& frame, const std::string& row) {
  const auto named = [&](const ReadColumn& read) { return read.column.key == entry.key; };
  const auto found = std::find_if(frame.units.begin(), frame.units.end(), named);
  if (found != frame.units.end()) return &*found;
  Texts known(std::begin(words), std::end(words));
  for (const ReadColumn& read : frame.units) known.push_back(read.column.key);
  complain(entry.place, row + "." + entry.key, say("'{1}' has no unit in 'units'", entry.key),
           did_you_mean(entry.key, known));
  return nullptr;
}

void Reader::add_value(const Tree::Entry& entry, const Frame& frame, const std::string& row,
                       const std::vector<const Credit*>& credits, std::vector<Value>& values) {
  const ReadColumn* column = column_of(entry, frame, row);
  if (column == nullptr) return;
  const std::string& key = entry.key;
  if (entry.value.type != Tree::Type::number || !std::isfinite(entry.value.number)) {
    return complain(entry.value.place, row + "." + key, say("{1} must be a number", key),
                    say("it is read in {1}, as given in 'units'", column->column.unit));
  }
  Value value{key, column->unit.to_si(entry.value.number), {}};
  for (const Credit* credit : credits) {
    const auto cited = credit->cited.find(key);
    value.sources = cited != credit->cited.end() ? cited->second : Texts{};
    const bool recalled = credit->all_recalled || credit->recalled.count(key) != 0;
    if (value.sources.empty() && !recalled) value.sources = credit->sources;
    if (!value.sources.empty() || recalled) return values.push_back(std::move(value));
  }
  complain(entry.place, row + "." + key, say("{1} of '{2}' has no source", key, row),
           say("name it in 'sources' or 'cite', or in 'recalled' where none was seen"));
}

void Reader::check_recalled(const Tree& tree, const Row& row, const Credit& credit) {
  Texts named(credit.recalled.begin(), credit.recalled.end());
  for (const auto& [key, sources] : credit.cited) named.push_back(key);
  for (const std::string& key : named) {
    const auto in_step = [&](const Step& step) { return has(step.values, key); };
    if (has(row.values, key) || std::any_of(row.by_size.begin(), row.by_size.end(), in_step)) continue;
    complain(tree.place, row.name, say("'{1}' has no value of {2}", row.name, key));
  }
}

Reader::Credit Reader::read_credit(const Tree& tree, const std::string& row) {
  Credit credit;
  if (const auto* named = tree.find("sources")) credit.sources = sources(named->value, row + ".sources");
  if (const auto* cite = tree.find("cite")) {
    for (const auto& [source, place, keys] : cite->value.entries) {
      cited_.push_back({source, place});
      for (const std::string& key : texts(keys, row + ".cite")) credit.cited[key].push_back(source);
    }
  }
  if (const auto* recalled = tree.find("recalled")) {
    credit.all_recalled = recalled->value.type == Tree::Type::boolean && recalled->value.text == "true";
    if (!credit.all_recalled) {
      const Texts keys = texts(recalled->value, row + ".recalled");
      credit.recalled = {keys.begin(), keys.end()};
    }
  }
  return credit;
}

}  // namespace loadpath::table
