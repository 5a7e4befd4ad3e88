#include "lib/report/answer.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

namespace loadpath::report {

namespace {

using account::Entry;
using project::Project;
using project::Step;

constexpr int digits = 4;

/// A value that is not broken between lines, with the sign that is longer than a hyphen.
std::string set(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at)) text.replace(at, 1, "\u00A0");
  const std::string minus = "\u00A0-";
  for (std::size_t at = text.find(minus); at != std::string::npos; at = text.find(minus, at))
    text.replace(at, minus.size(), "\u00A0\u2212");
  return text;
}

/// A number, a word, or for a series its value of the largest magnitude.
std::string short_text(const Entry& entry) {
  if (!entry.word.empty()) return entry.word;
  if (entry.values().si.empty()) return {};
  if (!entry.values().is_series() || is_constant(entry.values()))
    return format_quantity(entry.values().si.front(), entry.unit, digits);
  const double low = minimum(entry.values()).value, high = maximum(entry.values()).value;
  return say("up to {1}", format_quantity(std::fabs(low) > std::fabs(high) ? low : high, entry.unit, digits)).text();
}

/// A row of a table may leave a size out that other rows have: a square tube has no diameter.
bool is_known(const Entry& entry) {
  return !entry.word.empty() || (!entry.values().si.empty() && !std::isnan(entry.values().si.front()));
}

/// A size with its symbol; a long path gets a line of its own, because a column for it would leave no space for the
/// reasons.
std::string size_text(const Entry& entry) {
  constexpr std::size_t short_path = 8;
  const std::string text = short_text(entry);
  if (!entry.word.empty()) return set(text);
  return entry.path + (entry.path.size() > short_path ? " " : "\u00A0") + set("= " + text);
}

/// Whether a field or one of its parts satisfies it: in most calculators none does.
bool has(std::span<const FieldInfo> fields, bool (*is_such)(const FieldInfo&)) {
  return std::ranges::any_of(fields, [&](const FieldInfo& f) { return is_such(f) || has(f.fields, is_such); });
}
bool is_searched(const FieldInfo& field) { return *field.searched_in != '\0'; }
bool is_chosen(const FieldInfo& field) { return field.is_chosen; }

/// The sizes of a part: searched inputs, and given ones that might have been searched.
std::vector<const Entry*> sizes_of(const Step& step) {
  std::vector<const Entry*> sizes = chosen(step.account());
  const auto& fields = step.input().calculator->input->fields;  // a result may have the same key
  if (!has(fields, is_searched)) return sizes;
  for (const Entry& entry : step.account().inputs) {
    const FieldInfo* const field = find_field_at(fields, entry.path);
    const bool is_size =
        field != nullptr && is_searched(*field) && !entry.origin.searched && entry.origin.sources.empty();
    if (is_size && is_known(entry)) sizes.push_back(&entry);
  }
  return sizes;
}

/// Whether a row gives the shape of the part, not its material: it fills a length, an area.
bool is_shape(const Step& step, std::string_view group) {
  const auto& fields = step.input().calculator->input->fields;
  return std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& field) {
    if (field.provider.kind != Provider::Kind::table || field.provider.table != group) return false;
    Dimension rest = field.dimension;
    rest.twelfths[Dimension::length] = 0;
    return rest.is_number() && !field.dimension.is_number();
  });
}

/// The rows of tables that give the part its shape: "section" "IPE 200".
std::vector<std::pair<std::string, std::string>> rows_of(const Step& step) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [group, row] : step.input().rows) {
    if (is_shape(step, group) && !row.text.empty()) rows.emplace_back(group, row.text);
  }
  return rows;
}

/// The results of the step's choices: a section, a drive.
std::vector<const Entry*> decided_on(const Step& step) {
  std::vector<const Entry*> decided;
  if (step.input().calculator->result == nullptr) return decided;  // a mechanism decides on none
  const auto& fields = step.input().calculator->result->fields;
  if (!has(fields, is_chosen)) return decided;
  for (const Entry& entry : step.account().results) {
    const FieldInfo* const field = find_field_at(fields, entry.path);
    if (field != nullptr && is_chosen(*field) && (!entry.word.empty() || is_known(entry))) decided.push_back(&entry);
  }
  return decided;
}

std::vector<std::string> size_words(const Step& step) {
  std::vector<std::string> words;
  for (const auto& [group, row] : rows_of(step)) words.push_back(row);
  for (const Entry* entry : decided_on(step)) words.push_back(entry->word.empty() ? size_text(*entry) : entry->word);
  for (const Entry* entry : sizes_of(step)) words.push_back(size_text(*entry));
  return words;
}

std::string listed(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

std::string sizes_text(const Step& step) { return listed(size_words(step)); }

/// The reasons for these: the remark of the search, "given" if nothing was searched for.
std::string reasons_text(const Step& step) {
  std::string all;
  for (const Entry* entry : chosen(step.account())) {
    std::string text = entry->origin.text.text();
    for (const std::string& key : entry->origin.sources) text += " [" + key + "]";
    if (all.find(text) == std::string::npos) all += (all.empty() ? "" : "; ") + text;
  }
  return all.empty() && !sizes_text(step).empty() ? say("given").text() : all;
}

/// The modes of one step, assessed as strictly as the project is.
Modes modes_of(const Step& step, const Modes& all) {
  Modes own;
  std::copy_if(all.begin(), all.end(), std::back_inserter(own), [&](const Mode& m) { return m.step == step.name(); });
  return own;
}

using Tone = draw::Flow::Tone;
Tone tone_of(State state) {
  switch (state) {
    case State::pass:
    case State::accepted:
      return Tone::sound;
    case State::fail:
      return Tone::failing;
    case State::open:
      return Tone::quiet;
    case State::not_judged:
    case State::not_covered:
    case State::not_available:
      return Tone::doubtful;
  }
  return Tone::quiet;
}

/// The values that one step takes from others, by the step of origin, each once.
class Taking {
 public:
  explicit Taking(const Step& step) : step_(step) {
    for (const project::Operand& operand : step.input().reading.operands) take(operand);
    for (const project::Taken& taken : step.input().reading.taken) {
      if (!taken.of_record) add(taken.source, named(taken.path));
    }
    for (const project::Taken& record : step.input().reading.records) add(record.source, named_record(record));
  }

  [[nodiscard]] const std::map<std::string, std::vector<std::string>>& labels() const { return labels_; }

 private:
  void take(const project::Operand& operand) {
    if (operand.of_record) return;
    for (const auto& reference : operand.expression.references()) add(reference.path, named(operand.path));
  }

  void add(const std::string& source, const std::string& label) {
    auto& labels = labels_[source.substr(0, source.find('.'))];
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
  }

  [[nodiscard]] const Entry* entry(const std::string& path) const {
    const auto& inputs = step_.account().inputs;
    const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const Entry& e) { return e.path == path; });
    return found == inputs.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::string named(const std::string& path) const {
    const Entry* const found = entry(path);
    const std::string value = found == nullptr ? "" : short_text(*found);
    return value.empty() ? path : set(path + " = " + value);
  }

  /// Names a record by its leading number; its other values are implied.
  [[nodiscard]] std::string named_record(const project::Taken& record) const {
    for (const project::Operand& operand : step_.input().reading.operands) {
      if (!operand.of_record) continue;
      const auto& references = operand.expression.references();
      const bool is_of = std::any_of(references.begin(), references.end(), [&](const auto& reference) {
        return reference.path.starts_with(record.source + ".");
      });
      const Entry* const found = is_of ? entry(operand.path) : nullptr;
      const bool counts = found != nullptr && !found->values().si.empty() && !short_text(*found).empty() &&
                          std::fabs(maximum(found->values()).value) + std::fabs(minimum(found->values()).value) > 0.0;
      if (counts) return named(operand.path) + ", …";
    }
    return record.path.empty() ? record.source : record.path;
  }

  const Step& step_;
  std::map<std::string, std::vector<std::string>> labels_;
};

std::string name_of(const Step& step) { return step.input().title.empty() ? step.name() : step.input().title; }

draw::Flow::Part part_of(const Step& step, const Modes& all) {
  const Modes modes = modes_of(step, all);
  const State state = modes.empty() ? State::open : overall(modes);
  constexpr std::size_t most_sizes = 2;  // in the width of a box
  std::string below;
  const std::vector<std::string> sizes = size_words(step);
  for (std::size_t i = 0; i < std::min(most_sizes, sizes.size()); ++i) below += (i == 0 ? "" : ", ") + sizes[i];
  if (sizes.size() > most_sizes) below += ", …";
  if (below.empty()) below = step.input().calculator->title;
  return {name_of(step), std::move(below), modes.empty() ? "" : account::shown(state).text(), tone_of(state)};
}

}  // namespace

namespace {

/// Adds a step to the part that describes the same body; false if there is none.
bool join_body(const ChosenPart& part, std::vector<ChosenPart>& parts) {
  const auto same = std::find_if(parts.begin(), parts.end(), [&](const ChosenPart& other) {
    return !part.body.empty() && other.body == part.body;
  });
  if (same == parts.end()) return false;
  same->step = part.body;
  if (part.sizes != same->sizes) same->sizes += (same->sizes.empty() || part.sizes.empty() ? "" : ", ") + part.sizes;
  if (part.reasons != same->reasons) same->reasons += "; " + part.reasons;
  const auto used = [](const ChosenPart& p) { return p.governing ? p.governing->utilisation.value_or(0.0) : -1.0; };
  if (used(part) > used(*same)) same->governing = part.governing;
  same->state = account::worse(same->state, part.state);
  return true;
}

}  // namespace

std::vector<ChosenPart> chosen_parts(const Project& project) {
  std::vector<ChosenPart> parts;
  const Modes all = project::modes(project);
  for (const auto& step : project.steps) {
    const Modes modes = modes_of(*step, all);
    ChosenPart part{step->name(),        step->input().body.text, sizes_text(*step),
                    reasons_text(*step), explaining(modes),       modes.empty() ? State::open : overall(modes)};
    if (part.governing && !part.governing->utilisation) part.governing.reset();
    if (join_body(part, parts)) continue;
    if (!part.sizes.empty() || part.governing) parts.push_back(std::move(part));
  }
  return parts;
}

Table chosen_table(const Project& project) {
  Table table{say("Sized and selected values"),
              {say("part"), say("size"), say("basis"), say("governs"), say("utilisation"), say("verdict")},
              {}};
  for (const ChosenPart& part : chosen_parts(project)) {
    const auto& mode = part.governing;
    const Cell governs = mode ? Cell(say("{1}; {2}", mode->title, account::reason(*mode))) : Cell("–");
    const Cell value = mode ? Cell(Quantity{mode->utilisation.value_or(NAN), "-", 3}) : Cell("–");
    table.rows.push_back({part.step, part.sizes.empty() ? "–" : part.sizes, part.reasons, governs, value, part.state});
  }
  return table;
}

draw::Flow load_path(const Project& project) {
  draw::Flow flow;
  const Modes all = project::modes(project);
  std::map<std::string, std::size_t> places;
  for (const std::size_t i : project.order) {
    const project::Step& step = *project.steps[i];
    const std::size_t to = flow.parts.size();
    places[step.name()] = to;
    flow.parts.push_back(part_of(step, all));
    const Taking taking(step);
    for (const auto& [from, labels] : taking.labels()) {
      const auto source = places.find(from);
      if (source == places.end() || source->second == to) continue;
      for (const std::string& label : labels) flow.arrows.push_back({source->second, to, label});
    }
  }
  if (flow.arrows.empty()) flow.parts.clear();
  return flow;
}

}  // namespace loadpath::report
