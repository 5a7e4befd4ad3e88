// Inputs that take many values; the field decides on the permitted values.
#include "lib/calculator/choice_words.hpp"
#include "lib/project/read/reader.hpp"
#include "lib/project/read/spread.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

using Type = FieldInfo::Type;

static bool all_whole(const sweep::Axis& axis) {
  constexpr std::uint64_t most = 1'000'000;  // no field takes more integers
  if (axis.size() > most) return false;
  for (std::uint64_t i = 0; i < axis.size(); ++i) {
    if (axis.at(i) != std::floor(axis.at(i))) return false;
  }
  return true;
}

/// One value of several, with the field's own checks; false if it is refused.
bool Reader::read_one(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path, double& si) {
  const auto errors = [this] {
    return std::count_if(issues_.begin(), issues_.end(), [](const Issue& i) { return i.severity == Severity::error; });
  };
  const auto before = errors();
  if (const auto number = number_of(tree, [](const std::string&) { return nullptr; }))
    return read_one(*number, field, owner, path, si);
  if (field.type == Type::count)
    read_count(tree, field, owner, path);
  else if (tree.type == Tree::Type::text && tree.text.starts_with('='))
    say_at(tree.place, path, say("values of a range must be written out"), say("make the other field the range"));
  else
    read_literal(tree.type == Tree::Type::number ? format_exact(tree.number) : tree.text, tree, field, owner, path);
  si = field.get(owner);
  return errors() == before;
}

Refuse Reader::refusing(const std::string& path) {
  return [this, path](const Place& place, Message message, Message hint) {
    say_at(place, path, std::move(message), std::move(hint));
  };
}

void Reader::read_grid_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  auto axis = read_grid(
      tree, field.dimension, [&](const Tree& one, double& si) { return read_one(one, field, owner, path, si); },
      refusing(path));
  if (!axis) return;
  if (field.type == Type::count && !all_whole(*axis))
    return say_at(tree.place, path, say("a value in between is not an integer"), say("take a step of 1"));
  field.set(owner, axis->at(0));
  reading_.typed[path].text = tree.text;
  reading_.varied.push_back(
      {.path = path, .leaf = {&field, owner}, .place = tree.place, .shared = tree.shared, .axis = std::move(*axis)});
}

/// A field with a distribution has the middle of it where one value is taken.
void Reader::read_uncertain_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  auto law = read_uncertain(
      tree, field.dimension, [&](const Tree& one, double& si) { return read_one(one, field, owner, path, si); },
      refusing(path));
  if (!law) return;
  const double middle = law->mean();
  if (!field.bounds.holds(middle))
    return say_at(tree.place, path,
                  say("the mean of {1}, {2}: {3}", path, format_quantity(middle, field.unit), bounds_message(field)));
  field.set(owner, middle);
  reading_.typed[path].mean_of_uncertain = true;
  reading_.varied.push_back(
      {.path = path, .leaf = {&field, owner}, .place = tree.place, .shared = tree.shared, .distribution = *law});
}

/// { each = "R40", from = ..., to = ... }: its sizes are known where the tables are.
void Reader::read_stock(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  refuse_others(tree, {"each", "from", "to"}, path);
  Varied varied{.path = path, .leaf = {&field, owner}, .place = tree.find("each")->value.place, .shared = tree.shared};
  varied.stock = stock_of(tree);
  if (varied.stock.empty())
    return say_at(varied.place, path, say("'each' names a stock: a text"), say("`loadpath tables stocks` lists them"));
  for (const auto& [key, end] : {std::pair{"from", &varied.from}, {"to", &varied.to}}) {
    const auto* const entry = tree.find(key);
    if (entry != nullptr && !read_one(entry->value, field, owner, path, *end)) return;
  }
  field.set(owner, field.factor);  // set to any value
  reading_.varied.push_back(std::move(varied));
}

void Reader::read_words(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  Varied varied{.path = path, .leaf = {&field, owner}, .place = tree.place, .shared = tree.shared};
  std::vector<double> numbers;
  for (const Tree& item : tree.items) {
    const bool is_word = item.type == Tree::Type::text;
    const auto number = is_word ? number_of_word(field, item.text) : std::nullopt;
    if (!number)
      return say_at(item.place, path,
                    say("{1} is not a valid value of '{2}'",
                        is_word ? "'" + item.text + "'" : std::string(toml::word_for(item.type)), path),
                    word_near(item.text, field));
    varied.words.emplace_back(field.choices[static_cast<std::size_t>(*number)].key);
    numbers.push_back(*number);
  }
  if (varied.words.empty())
    return say_at(tree.place, path, say("a list of words needs at least one"), there_is(words_to_choose(field)));
  field.set(owner, numbers.front());
  varied.axis = *sweep::Axis::list(std::move(numbers));
  reading_.varied.push_back(std::move(varied));
}

}  // namespace loadpath::project
