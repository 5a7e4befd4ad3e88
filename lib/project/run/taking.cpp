// What a run takes whole from other steps: words, lists, rows of tables.
#include "lib/project/run/run.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// "[2].R" or ".pump.R": the element, and what stands behind it.
std::pair<std::string, std::string> split_element(const std::string& path) {
  const std::size_t end = path.starts_with('[') ? path.find(']') + 1 : path.find('.', 1);
  return {path.substr(0, end), path.substr(std::min(end + 1, path.size()))};
}

/// ".pump": the name of a new element, where it has one.
void name_element(const FieldInfo& list, void* element, const std::string& here) {
  const FieldInfo* const name = find_field(list.fields, "name");
  if (name != nullptr && name->type == FieldInfo::Type::name && here.starts_with('.'))
    name->set_text(element, std::string_view(here).substr(1));
}

}  // namespace

bool Run::take_from_others(std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  for (const Taken& taken : step_.input().reading.taken) {
    if (taken.field != nullptr && taken.field->type == FieldInfo::Type::list)
      take_list(taken, issues);
    else
      take_word(taken, issues);
  }
  for (const Varied& varied : step_.input().reading.varied) {
    if (!varied.leaf) take_row(varied.path, varied.words[varied.at], issues);
  }
  return issues.size() == before;
}

void Run::take_word(const Taken& taken, std::vector<Issue>& issues) {
  const std::string word = known_.word(taken.source);
  if (word.empty()) {
    if (!taken.may_lack) leave_open(taken);
    return;
  }
  const auto refuse = [&](Message message) {
    issues.push_back({place_in(taken.place, taken.source, 0, taken.source.size()),
                      step_.name() + "." + taken.path,
                      std::move(message),
                      {},
                      Severity::error});
  };
  if (taken.field == nullptr) {
    std::vector<Issue> found;
    take_row(taken.path, word, found);
    if (!found.empty()) refuse(say("{1} = {2}: {3}", taken.source, word, found.front().message));
  } else if (!set_word(map_leaf(taken.path), word)) {
    refuse(say("{1} = {2} is no word for '{3}'", taken.source, word, taken.path));
  }
  origins_[taken.path] = {say("= {1}", taken.source), {}, false};
}

void Run::leave_open(const Taken& taken) { not_given_ = say("'{1}' is not available: {2}", taken.path, taken.source); }

void Run::take_row(const std::string& group, const std::string& row, std::vector<Issue>& issues) {
  rows_[group].text = row;
  const auto of_group = [&](const Provided& p) { return !p.row.empty() && p.field->provider.table == group; };
  for (const Provided& provided : provided_) {  // what the next row lacks is not what the last one had
    if (of_group(provided)) map_leaf(provided.path).set(find_leaf(step_.input().reading.record, provided.path).get());
  }
  std::erase_if(provided_, of_group);
  for (Provided& provided : provided_by_rows(step_.input(), {{group, rows_[group]}}, issues))
    provided_.push_back(std::move(provided));
  origins_.merge(fill_lists(step_.input(), {{group, rows_[group]}}, record_));
}

void Run::refuse_length(const Taken& taken, std::vector<Issue>& issues) const {
  issues.push_back(
      {place_in(taken.place, taken.source, 0, taken.source.size()),
       step_.name() + "." + taken.path,
       say("at most {1} {2}; '{3}' has more", std::to_string(taken.field->capacity), taken.field->key, taken.source),
       {},
       Severity::error});
}

/// Elements by number or name, leaves by their keys; a series stays one. All elements are there before a leaf of one is
/// kept.
void Run::take_list(const Taken& taken, std::vector<Issue>& issues) {
  void* const owner = find_member(record_.type->fields, record_.data.get(), taken.path).owner;
  const auto given = known_.within(taken.source);
  std::vector<std::string> elements;
  for (const auto& [behind, entry] : given) {
    const std::string here = split_element(behind).first;
    if (!elements.empty() && elements.back() == here) continue;
    if (elements.size() == taken.field->capacity) return refuse_length(taken, issues);
    elements.push_back(here);
    name_element(*taken.field, taken.field->push(owner), here);
  }
  if (elements.empty()) return leave_open(taken);
  std::size_t element = 0;
  for (const auto& [behind, entry] : given) {
    const auto [here, key] = split_element(behind);
    if (here != elements[element]) ++element;
    const std::string path = taken.path + element_path(*taken.field, owner, element) + "." + key;
    const Leaf leaf = map_leaf(path);
    if (!leaf || leaf.field->role != Role::input) continue;
    if (leaf.field->is_word()) set_word(leaf, entry->word);
    if (leaf.field->is_number() && !entry->value.si.empty())
      add_input({path, leaf, entry->value, {say("= {1}", taken.source + behind), {}, false}});
  }
}

}  // namespace loadpath::project
