#include "cli/lsp/messages.hpp"

#include <boost/json.hpp>

#include <algorithm>

namespace loadpath::cli::lsp {

namespace {

namespace json = boost::json;

const json::value& member(const json::object& all, std::string_view key) {
  const json::value* const found = all.if_contains(key);
  if (found == nullptr) throw Refusal(Fail::invalid_params, "'" + std::string(key) + "' is missing");
  return *found;
}

[[noreturn]] void refuse(std::string_view key, const char* what) {
  throw Refusal(Fail::invalid_params, "'" + std::string(key) + "' is not " + what);
}

std::size_t count_in(const json::object& all, std::string_view key) {
  const json::value& value = member(all, key);
  if (!value.is_int64() || value.as_int64() < 0) refuse(key, "an integer of 0 or more");
  return static_cast<std::size_t>(value.as_int64());
}

json::object to_json(const Position& position) { return {{"line", position.line}, {"character", position.character}}; }

json::object markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

json::object to_json(const Completion& item, const Range& range, bool with_snippets) {
  const bool is_snippet = with_snippets && !item.snippet.empty();
  const std::string& text = is_snippet ? item.snippet : item.text.empty() ? item.label : item.text;
  json::object all{{"label", item.label},
                   {"kind", static_cast<int>(item.kind)},
                   {"sortText", std::to_string(item.rank) + item.label},
                   {"filterText", item.label},
                   {"insertTextFormat", is_snippet ? 2 : 1},
                   {"textEdit", json::object{{"range", to_json(range)}, {"newText", text}}}};
  if (!item.detail.empty()) all["detail"] = item.detail;
  if (!item.meaning.empty()) all["documentation"] = item.meaning;
  return all;
}

json::object to_json(const Symbol& symbol) {
  constexpr int is_object = 19;  // as the protocol counts kinds
  json::object all{{"name", symbol.name},
                   {"kind", is_object},
                   {"range", to_json(symbol.all)},
                   {"selectionRange", to_json(symbol.at_name)},
                   {"children", to_json(symbol.within)}};
  if (!symbol.detail.empty()) all["detail"] = symbol.detail;
  return all;
}

}  // namespace

const json::object& object_in(const json::object& all, std::string_view key) {
  const json::value& value = member(all, key);
  if (!value.is_object()) refuse(key, "an object");
  return value.get_object();
}

const json::array& array_in(const json::object& all, std::string_view key) {
  const json::value& value = member(all, key);
  if (!value.is_array()) refuse(key, "an array");
  return value.get_array();
}

std::string text_in(const json::object& all, std::string_view key) {
  const json::value& value = member(all, key);
  if (!value.is_string()) refuse(key, "a string");
  return std::string(std::string_view(value.get_string()));
}

Position position_in(const json::object& all, std::string_view key) {
  const json::object& position = object_in(all, key);
  return {count_in(position, "line"), count_in(position, "character")};
}

Range range_in(const json::object& all, std::string_view key) {
  const json::object& range = object_in(all, key);
  return {position_in(range, "start"), position_in(range, "end")};
}

json::object to_json(const Range& range) { return {{"start", to_json(range.start)}, {"end", to_json(range.end)}}; }

json::array to_json(const std::vector<Diagnostic>& all) {
  json::array list;
  for (const Diagnostic& d : all)
    list.push_back(json::object{{"range", to_json(d.range)},
                                {"severity", static_cast<int>(d.weight)},
                                {"source", "loadpath"},
                                {"message", d.message}});
  return list;
}

json::value to_json(const std::optional<Hover>& hover) {
  if (!hover) return nullptr;
  return json::object{{"contents", markdown(hover->text)}, {"range", to_json(hover->range)}};
}

json::object to_json(const Completions& completions, bool with_snippets) {
  json::array items;
  for (const Completion& item : completions.items) items.push_back(to_json(item, completions.range, with_snippets));
  return {{"isIncomplete", false}, {"items", std::move(items)}};
}

json::array to_json(const std::vector<Hint>& hints) {
  json::array list;
  for (const Hint& hint : hints) {
    json::object one{{"position", to_json(hint.position)}, {"label", hint.text}, {"paddingLeft", true}};
    if (!hint.more.empty()) one["tooltip"] = hint.more;
    list.push_back(std::move(one));
  }
  return list;
}

json::array to_json(const std::vector<Symbol>& symbols) {
  json::array list;
  for (const Symbol& symbol : symbols) list.push_back(to_json(symbol));
  return list;
}

}  // namespace loadpath::cli::lsp
