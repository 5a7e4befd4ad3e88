#include "lib/project/read/records.hpp"

#include "lib/project/read/spread.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using toml::Tree;

/// Records taken in turn: the path to them, the records, and their names.
struct Turn {
  std::vector<std::size_t> way;  // entries and items, from the table on
  std::string name;              // "links.rod"
  std::vector<Tree> records;
  std::vector<std::string> words;
  Place place;
  std::string shared;
};

/// "n = 1200 rpm, x = 20 mm": a record as people read it.
std::string text_of(const Tree& tree) {
  std::string text;
  switch (tree.type) {
    case Tree::Type::number:
      return format_exact(tree.number);
    case Tree::Type::array:
      for (const Tree& item : tree.items) text += (text.empty() ? "" : ", ") + text_of(item);
      return "[" + text + "]";
    case Tree::Type::table:
      for (const Tree::Entry& entry : tree.entries)
        text += (text.empty() ? "" : ", ") + entry.key + " = " +
                (entry.value.type == Tree::Type::table ? "{" + text_of(entry.value) + "}" : text_of(entry.value));
      return text;
    default:
      return tree.text;
  }
}

bool is_record(const Tree& tree) { return tree.type == Tree::Type::table || tree.type == Tree::Type::array; }

/// The records of { each = ... }; none if it is a stock, or no such table.
std::vector<std::pair<std::string, Tree>> records_of(const Tree& tree) {
  std::vector<std::pair<std::string, Tree>> all;
  if (tree.type != Tree::Type::table || tree.entries.size() != 1 || tree.entries[0].key != "each") return all;
  const Tree& each = tree.entries[0].value;
  for (const Tree& item : each.items) all.emplace_back(text_of(item), item);
  if (each.type == Tree::Type::table) {
    for (const Tree::Entry& entry : each.entries) all.emplace_back(entry.key, entry.value);
  }
  const bool are_records =
      std::all_of(all.begin(), all.end(), [](const auto& record) { return is_record(record.second); });
  return are_records ? all : decltype(all){};
}

void find_turns(const Tree& tree, const std::string& name, std::vector<std::size_t>& way, std::vector<Turn>& found) {
  auto records = records_of(tree);
  if (!records.empty()) {
    Turn turn{way, name, {}, {}, tree.place, tree.shared};
    for (auto& [word, record] : records) {
      turn.words.push_back(std::move(word));
      turn.records.push_back(std::move(record));
    }
    found.push_back(std::move(turn));
    return;
  }
  for (std::size_t i = 0; i < tree.entries.size() + tree.items.size(); ++i) {
    const bool is_entry = i < tree.entries.size();
    const std::string key = is_entry ? tree.entries[i].key : "[" + std::to_string(i + 1 - tree.entries.size()) + "]";
    way.push_back(i);
    std::string whole = name;
    if (is_entry && !name.empty()) whole += ".";
    find_turns(is_entry ? tree.entries[i].value : tree.items[i - tree.entries.size()], whole += key, way, found);
    way.pop_back();
  }
}

Tree& tree_at(Tree& table, const std::vector<std::size_t>& way) {
  Tree* at = &table;
  for (const std::size_t i : way)
    at = i < at->entries.size() ? &at->entries[i].value : &at->items[i - at->entries.size()];
  return *at;
}

/// The first text of a record that is known only later, or is itself several values.
const Tree* not_written_out(const Tree& tree) {
  if (tree.type == Tree::Type::text && (tree.text.starts_with('=') || tree.text == "?")) return &tree;
  const bool several = tree.type == Tree::Type::table && (is_uncertain(tree) || tree.find("each") != nullptr ||
                                                          (is_grid(tree) && tree.find("to") != nullptr));
  if (several) return &tree;
  for (const Tree& item : tree.items) {
    if (const Tree* wrong = not_written_out(item)) return wrong;
  }
  for (const Tree::Entry& entry : tree.entries) {
    if (const Tree* wrong = not_written_out(entry.value)) return wrong;
  }
  return nullptr;
}

using Numbers = std::vector<std::pair<std::string, Leaf>>;

bool has_number(const FieldInfo& field) {
  return field.type == FieldInfo::Type::quantity || field.type == FieldInfo::Type::count ||
         field.type == FieldInfo::Type::choice;
}

/// A name or a formula in which two readings differ; empty if none does.
std::string other_text(const Reading& a, const Reading& b) {
  std::vector<std::pair<std::string, std::string>> texts[2];
  for (std::size_t side = 0; side < 2; ++side) {
    for_each_leaf((side == 0 ? a : b).record, [&](const std::string& path, const Leaf& leaf) {
      if (!has_number(*leaf.field)) texts[side].emplace_back(path, leaf.field->text(leaf.owner));
    });
  }
  const auto [first, second] = std::mismatch(texts[0].begin(), texts[0].end(), texts[1].begin(), texts[1].end());
  return first == texts[0].end() ? std::string() : first->first;
}

Numbers numbers_of(const Reading& reading) {
  Numbers numbers;
  for (const Record* record : {&reading.parameters, &reading.record}) {
    if (record->type == nullptr) continue;
    for_each_leaf(*record, [&](const std::string& path, const Leaf& leaf) {
      if (has_number(*leaf.field)) numbers.emplace_back(path, leaf);
    });
  }
  return numbers;
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

class Turning {
 public:
  Turning(const Tree& table, std::vector<Turn> turns, std::string prefix, const ReadOne& read,
          std::vector<Issue>& issues)
      : table_(table), prefix_(std::move(prefix)), read_(read), issues_(issues), turns_(std::move(turns)) {
    for (const Turn& turn : turns_) tree_at(table_, turn.way) = turn.records.front();
  }

  Reading read();

 private:
  bool are_written_out();
  bool refuse(const Place& place, const Turn& turn, Message message, Message hint);
  bool take(const Turn& turn, Reading& first);

  Tree table_;
  std::string prefix_;
  const ReadOne& read_;
  std::vector<Issue>& issues_;
  std::vector<Turn> turns_;
};

bool Turning::refuse(const Place& place, const Turn& turn, Message message, Message hint) {
  issues_.push_back({place, prefix_ + turn.name, std::move(message), std::move(hint), Severity::error});
  return false;
}

bool Turning::are_written_out() {
  for (const Turn& turn : turns_) {
    for (const Tree& record : turn.records) {
      if (const Tree* wrong = not_written_out(record))
        return refuse(wrong->place, turn, say("values of records taken in turn must be written out"),
                      say("make it a range of its own, outside these records"));
    }
  }
  return true;
}

/// Reads the other records of a place; the numbers in which they differ from the first go through their values.
bool Turning::take(const Turn& turn, Reading& first) {
  const Numbers numbers = numbers_of(first);
  std::vector<std::vector<double>> values(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) values[k].push_back(numbers[k].second.get());
  for (std::size_t r = 1; r < turn.records.size(); ++r) {
    Tree table = table_;
    tree_at(table, turn.way) = turn.records[r];
    std::vector<Issue> found;
    const Reading other = read_(table, found);
    if (has_errors(found)) {
      issues_.insert(issues_.end(), found.begin(), found.end());
      return false;
    }
    const Numbers others = numbers_of(other);
    const bool alike = std::equal(numbers.begin(), numbers.end(), others.begin(), others.end(),
                                  [](const auto& a, const auto& b) { return a.first == b.first; });
    const auto holds = [&](const auto& typed) { return other.typed.contains(typed.first); };
    if (!alike || first.typed.size() != other.typed.size() ||
        !std::all_of(first.typed.begin(), first.typed.end(), holds))
      return refuse(turn.records[r].place, turn, say("records taken in turn must have the same fields"),
                    say("give what the first of them gives, no more and no less"));
    if (const std::string text = other_text(first, other); !text.empty())
      return refuse(turn.records[r].place, turn,
                    say("'{1}' is a text, which does not change from point to point", text),
                    say("records taken in turn may differ only in numbers and choices"));
    for (std::size_t k = 0; k < numbers.size(); ++k) values[k].push_back(others[k].second.get());
  }
  bool differ = turn.records.size() == 1;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto is_first = [&](double v) { return same_number(v, values[k].front()); };
    if (std::all_of(values[k].begin(), values[k].end(), is_first)) continue;
    differ = true;
    auto axis = sweep::Axis::list(values[k]);
    if (!axis) return refuse(turn.place, turn, say("'{1}' has no number in each record", numbers[k].first), {});
    Varied varied{.path = numbers[k].first, .leaf = numbers[k].second, .place = turn.place};
    varied.shared = turn.shared.empty() ? prefix_ + turn.name : turn.shared;
    varied.axis = std::move(*axis);
    varied.words = turn.words;
    first.varied.push_back(std::move(varied));
  }
  return differ || refuse(turn.place, turn, say("these records do not differ in any number"), {});
}

Reading Turning::read() {
  const bool whole = are_written_out();
  Reading first = read_(table_, issues_);
  if (!whole || has_errors(issues_)) return first;
  for (const Turn& turn : turns_) {
    if (!take(turn, first)) break;
  }
  return first;
}

}  // namespace

Reading read_in_turn(const Tree& table, const std::string& prefix, const ReadOne& read, std::vector<Issue>& issues) {
  std::vector<Turn> turns;
  std::vector<std::size_t> way;
  find_turns(table, "", way, turns);
  if (turns.empty()) return read(table, issues);
  return Turning(table, std::move(turns), prefix, read, issues).read();
}

}  // namespace loadpath::project
