#include "cli/lsp/references.hpp"

#include "cli/lsp/target.hpp"
#include "cli/lsp/words.hpp"
#include "lib/project/parts/parts.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <map>

namespace loadpath::cli::lsp {

namespace {

using Type = FieldInfo::Type;

/// A path of a step that others may take, and its description.
struct Offer {
  std::string path;
  std::string detail;
  std::string meaning;
  bool fits = false;
};

bool is_part_of_path(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '[' || c == ']';
}

bool alike(const Dimension& a, const FieldInfo* field) {
  return field != nullptr && field->type == Type::quantity && a.without_angle() == field->dimension.without_angle();
}

/// Adds the values of a solved step.
void add_solved(const project::Step& step, const FieldInfo* field, std::vector<Offer>& offers) {
  for (const auto* entries : {&step.account().results, &step.account().inputs}) {
    for (const account::Entry& entry : *entries) {
      const std::string value = entry.word.empty() ? text_of(entry.value, entry.unit) : entry.word;
      offers.push_back({entry.path, value, entry.doc, alike(entry.value.signature.dimension, field)});
    }
  }
}

/// Adds the paths common to steps of the calculator: fields, and those of tables; for lists those of the first
/// element.
void add_declared(std::span<const FieldInfo> fields, const std::string& prefix, const FieldInfo* wanted,
                  std::vector<Offer>& offers) {
  for (const FieldInfo& field : fields) {
    const std::string path = prefix + field.key;
    if (field.type == Type::record) continue;
    if (field.has_fields())
      add_declared(field.fields, path + (field.type == Type::list ? "[1]." : "."), wanted, offers);
    else
      offers.push_back(
          {path, field.type == Type::quantity ? field.unit : "", field.doc, alike(field.dimension, wanted)});
  }
}

std::vector<Offer> offers_of(const OpenFile& file, const std::string& name, const FieldInfo* field) {
  std::vector<Offer> offers;
  const Calculator* const calculator = calculator_of(file.outline, file.document.text(), name);
  if (calculator == nullptr) return offers;
  const project::Step* const step = file.solved == nullptr ? nullptr : file.solved->find(name);
  if (step != nullptr && step->input().calculator == calculator) {
    add_solved(*step, field, offers);
  } else {
    if (calculator->result != nullptr) add_declared(calculator->result->fields, "", field, offers);
    for (const ResultPattern& p : calculator->patterns()) offers.push_back({p.path, p.unit, p.doc, false});
    add_declared(calculator->input->fields, "", field, offers);
  }
  return offers;
}

/// The next part of every path that begins with the typed text: "links." of "links.rod.N".
void add_next_parts(const std::vector<Offer>& offers, std::string_view typed, bool wants_record,
                    std::vector<Completion>& items) {
  std::map<std::string, std::size_t> known;
  for (const Offer& offer : offers) {
    if (!offer.path.starts_with(typed)) continue;
    const std::string rest = offer.path.substr(typed.size());
    const std::size_t dot = rest.find('.');
    const bool is_whole = dot == std::string::npos;
    const auto [found, is_new] = known.try_emplace(rest.substr(0, dot), items.size());
    if (is_new)
      items.push_back(
          {.label = found->first, .kind = is_whole ? Kind::field : Kind::structure, .rank = wants_record ? 0 : 2});
    Completion& item = items[found->second];
    if (is_whole) {
      item.detail = offer.detail;
      item.meaning = offer.meaning;
      item.rank = offer.fits ? 0 : 3;
    } else if (offer.fits) {
      item.rank = std::min(item.rank, 1);
    }
  }
}

/// The first parts: steps, values, functions.
std::vector<Completion> first_parts(const OpenFile& file, const std::string& own) {
  std::vector<Completion> items;
  std::vector<std::string> listed{own};
  const std::string_view text = file.document.text();
  for (const Header& header : file.outline.headers) {
    const std::string& name = header.path[0];
    const bool is_tables = name == "values" || name == "tables";
    const Calculator* const calculator = calculator_of(file.outline, text, name);
    if (std::find(listed.begin(), listed.end(), name) != listed.end() || (!is_tables && calculator == nullptr))
      continue;
    listed.push_back(name);
    items.push_back(
        {.label = name, .kind = Kind::module, .detail = calculator == nullptr ? "" : calculator->id, .rank = 0});
  }
  for (const Item& item : file.outline.items) {
    if (item.path[0] == "values" && item.path.size() == 2)
      items.push_back({.label = "values." + item.path[1], .detail = std::string(item.in(text)), .rank = 1});
  }
  for (const std::string& name : expression::function_names())
    items.push_back({.label = name, .kind = Kind::function, .text = name + "(", .snippet = name + "($1)", .rank = 4});
  return items;
}

std::vector<Completion> values_of(const OpenFile& file) {
  std::vector<Completion> items;
  for (const Item& item : file.outline.items) {
    if (item.path[0] == "values" && item.path.size() == 2)
      items.push_back({.label = item.path[1], .detail = std::string(item.in(file.document.text()))});
  }
  return items;
}

}  // namespace

Completions references_at(const OpenFile& file, const Spot& spot, std::size_t offset, const FieldInfo* field) {
  const std::string_view text = file.document.text();
  std::size_t begin = offset;
  while (begin > spot.begin && is_part_of_path(text[begin - 1])) --begin;
  const std::string_view typed = text.substr(begin, offset - begin);
  const std::size_t dot = typed.find('.'), last = typed.rfind('.');
  if (dot == std::string_view::npos) return {file.document.range_of(begin, offset), first_parts(file, spot.path[0])};
  Completions all{file.document.range_of(begin + last + 1, offset), {}};
  const std::string name(typed.substr(0, dot));
  if (name == "values") {
    all.items = values_of(file);
    return all;
  }
  const bool wants_record = field != nullptr && (field->type == Type::record || field->has_fields());
  add_next_parts(offers_of(file, name, field), typed.substr(dot + 1, last - dot), wants_record, all.items);
  return all;
}

}  // namespace loadpath::cli::lsp
