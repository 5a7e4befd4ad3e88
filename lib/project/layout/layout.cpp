#include "lib/project/layout/layout.hpp"

#include "lib/project/layout/same.hpp"
#include "lib/project/parts/heading.hpp"
#include "lib/project/parts/parts.hpp"
#include "lib/text/utf8.hpp"
#include "lib/toml/text/pieces.hpp"
#include "lib/toml/text/values.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <map>

namespace loadpath::project {

namespace {

using toml::Group;
using toml::Pair;
using toml::Section;

/// The order of sections: the heading, shared values, tables; then steps and expectations as given.
int rank_of(const Section& section) {
  if (section.header.empty()) return -1;
  const std::string name = toml::first_part(section.name);
  return name == "project" ? 0 : name == "values" ? 1 : name == "tables" ? 2 : 3;
}

/// The keys of a step, in order: calculator, name, its template's parameters, its inputs; then the others.
std::vector<std::string> order_of(const Calculator& calculator, const Template* from) {
  std::vector<std::string> order{"calculator", "template", "title", "note"};
  if (from != nullptr) {
    for (const FieldInfo& field : from->parameters->fields) order.emplace_back(field.key);
  }
  for (const FieldInfo& field : calculator.input->fields) {
    order.emplace_back(field.key);
    for (std::string& other : listed_keys(field.also_called)) order.push_back(std::move(other));
  }
  return order;
}

std::size_t place_in(const std::vector<std::string>& order, const Pair& pair) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), toml::first_part(pair.key)) - order.begin());
}

/// Sorts the keys within each group; those that identify the step are in the first.
void sort_groups(std::vector<Group>& groups, const std::vector<std::string>& order, std::size_t leading) {
  std::vector<Pair> first;
  for (Group& group : groups) {
    const auto moved = std::stable_partition(group.pairs.begin(), group.pairs.end(),
                                             [&](const Pair& pair) { return place_in(order, pair) >= leading; });
    first.insert(first.end(), moved, group.pairs.end());
    group.pairs.erase(moved, group.pairs.end());
  }
  for (std::size_t i = 0; i + 1 < groups.size(); ++i) {  // comments of an emptied group remain
    if (!groups[i].pairs.empty() || i == 0) continue;
    auto& lead = groups[i + 1].lead;
    if (!groups[i].lead.empty() && !lead.empty()) lead.insert(lead.begin(), "");
    lead.insert(lead.begin(), groups[i].lead.begin(), groups[i].lead.end());
    groups[i].lead.clear();
  }
  if (!groups.empty()) groups[0].pairs.insert(groups[0].pairs.begin(), first.begin(), first.end());
  std::erase_if(groups, [](const Group& group) { return group.pairs.empty() && group.lead.empty(); });
  for (Group& group : groups) {
    std::stable_sort(group.pairs.begin(), group.pairs.end(),
                     [&](const Pair& a, const Pair& b) { return place_in(order, a) < place_in(order, b); });
  }
}

/// The field that keys lead to; names of elements lead nowhere. Null if a key is none of them.
const FieldInfo* field_at(std::span<const FieldInfo> fields, const std::vector<std::string>& keys) {
  const FieldInfo* at = nullptr;
  for (const std::string& key : keys) {
    const auto within = at == nullptr ? fields : at->fields;
    if (const FieldInfo* const found = find_input(within, key)) {
      at = found;
    } else if (at == nullptr || at->type != FieldInfo::Type::list) {
      return nullptr;
    }
  }
  return at;
}

std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < key.size();) {
    const bool quoted = key[from] == '"' || key[from] == '\'';
    const std::size_t to = std::min(quoted ? toml::behind_text(key, from) : key.find('.', from), key.size());
    parts.push_back(quoted ? key.substr(from + 1, to - from - 2) : key.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

/// The owner of a section: a step's calculator and template, as far as known.
struct Owner {
  const Calculator* calculator = nullptr;
  const Template* from = nullptr;
  std::vector<std::string> inner;  // keys below it: "loads" for [shaft.loads]
};

Owner owner_of(const Section& section, const toml::Tree& tree, Calculators calculators) {
  Owner owner;
  owner.inner = parts_of(section.name);
  if (owner.inner.empty()) return owner;
  const auto* const step = is_reserved(owner.inner[0]) ? nullptr : tree.find(owner.inner[0]);
  owner.inner.erase(owner.inner.begin());
  const auto* const id = step == nullptr ? nullptr : step->value.find("calculator");
  if (id == nullptr) return owner;
  owner.calculator = find_calculator(calculators, id->value.text);
  const auto* const named = step->value.find("template");
  if (owner.calculator != nullptr && named != nullptr) owner.from = find_template(*owner.calculator, named->value.text);
  return owner;
}

/// A quantity in its plain form, where a field takes one.
std::string value_of(const Pair& pair, const Owner& owner) {
  return toml::laid_out(pair.value, [&](const std::vector<std::string>& inner, const std::string& text) {
    if (owner.calculator == nullptr) return text;
    std::vector<std::string> keys = owner.inner;
    for (const std::string& key : parts_of(pair.key)) keys.push_back(key);
    keys.insert(keys.end(), inner.begin(), inner.end());
    const FieldInfo* field = field_at(owner.calculator->input->fields, keys);
    if (field == nullptr && owner.from != nullptr) field = field_at(owner.from->parameters->fields, keys);
    const bool takes_quantity = field != nullptr && (field->type == FieldInfo::Type::quantity ||
                                                     (field->type == FieldInfo::Type::list && field->positional));
    return takes_quantity ? plain_quantity(text) : text;
  });
}

/// The text, line by line.
class Writer {
 public:
  void lines(const std::vector<std::string>& all) {
    for (const std::string& line : all) text_ += line + "\n";
  }
  void blank() {
    if (!text_.empty() && !text_.ends_with("\n\n")) text_ += "\n";
  }
  void header(const Section& section) {
    text_ += section.header + (section.comment.empty() ? "" : "  " + section.comment) + "\n";
  }

  /// Comments of neighbouring lines are aligned.
  void group(const Group& group, const Owner& owner) {
    lines(group.lead);
    if (!group.lead.empty() && !group.pairs.empty()) blank();
    std::vector<std::string> written;
    for (const Pair& pair : group.pairs) written.push_back(pair.key + " = " + value_of(pair, owner));
    for (std::size_t i = 0; i < written.size(); ++i) {
      lines(group.pairs[i].before);
      text_ += written[i];
      if (!group.pairs[i].comment.empty())
        text_ += std::string(column_of(group.pairs, written, i) - width(written[i]), ' ') + group.pairs[i].comment;
      text_ += "\n";
    }
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  /// The width of the last line.
  static std::size_t width(const std::string& written) {
    return code_points(written.substr(written.rfind('\n') + 1)).size();  // npos + 1 is 0
  }
  /// The column of a line's comment: after the longest of the neighbouring lines that have one too. Values of several
  /// lines, or a long one, are not aligned with others.
  static std::size_t column_of(const std::vector<Pair>& pairs, const std::vector<std::string>& written,
                               std::size_t at) {
    constexpr std::size_t longest = 48;
    const auto joins = [&](std::size_t i) {
      return !pairs[i].comment.empty() && written[i].find('\n') == std::string::npos && width(written[i]) <= longest;
    };
    std::size_t from = at, to = at + 1;
    if (joins(at)) {
      while (from > 0 && joins(from - 1) && pairs[from].before.empty()) --from;
      while (to < pairs.size() && joins(to) && pairs[to].before.empty()) ++to;
    }
    std::size_t widest = 0;
    for (std::size_t i = from; i < to; ++i) widest = std::max(widest, width(written[i]));
    return widest + 2;
  }

  std::string text_;
};

void sort_keys(Section& section, const Owner& owner) {
  if (section.header == "[project]") return sort_groups(section.groups, heading_names(), 0);
  if (owner.calculator == nullptr || !owner.inner.empty() || section.header.empty()) return;
  constexpr std::size_t leading = 3;  // calculator, template, title
  sort_groups(section.groups, order_of(*owner.calculator, owner.from), leading);
}

std::string written(toml::Pieces& pieces, const toml::Tree& tree, Calculators calculators) {
  std::stable_sort(pieces.sections.begin(), pieces.sections.end(),
                   [](const Section& a, const Section& b) { return rank_of(a) < rank_of(b); });
  Writer out;
  out.lines(pieces.preamble);
  if (pieces.apart) out.blank();
  for (std::size_t i = 0; i < pieces.sections.size(); ++i) {
    Section& section = pieces.sections[i];
    const Owner owner = owner_of(section, tree, calculators);
    sort_keys(section, owner);
    if (i > 0) out.blank();
    out.lines(section.before);
    if (!section.header.empty()) out.header(section);
    for (std::size_t g = 0; g < section.groups.size(); ++g) {
      if (g > 0) out.blank();
      out.group(section.groups[g], owner);
    }
    if (!section.tail.empty()) out.blank();
    out.lines(section.tail);
  }
  return out.take();
}

}  // namespace

std::string layout_of(std::string_view text, const std::string& file, Calculators calculators,
                      std::vector<Issue>& issues) {
  const toml::Tree tree = toml::read_toml(text, file, issues);
  if (has_errors(issues)) return {};
  toml::Pieces pieces = toml::pieces_of(text);
  std::string laid_out = written(pieces, tree, calculators);
  std::vector<Issue> wrong;
  const toml::Tree again = toml::read_toml(laid_out, file, wrong);
  if (!has_errors(wrong) && say_the_same(tree, again)) return laid_out;
  issues.push_back({{file, 0, 0, 1},
                    "",
                    say("formatting would change its meaning, so it is left unchanged"),
                    say("a table of a step belongs directly after it"),
                    Severity::error});
  return {};
}

}  // namespace loadpath::project
