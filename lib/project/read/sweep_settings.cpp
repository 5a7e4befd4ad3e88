#include "lib/project/read/sweep_settings.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using toml::Tree;

class Reader {
 public:
  Reader(SweepSettings& settings, std::vector<Issue>& issues) : settings_(settings), issues_(issues) {}

  void read(const Tree::Entry& entry) {
    if (entry.key == "results") return read_texts(entry.value, settings_.results);
    if (entry.key == "samples") return read_whole(entry, 1.0, settings_.samples);
    if (entry.key == "seed") return read_whole(entry, 0.0, settings_.seed);
    if (entry.key == "sampling") return read_sampling(entry);
    if (entry.key == "zip") return read_zip(entry.value);
    if (entry.key == "correlations") return read_correlations(entry.value);
    const std::vector<std::string> keys{"results", "samples", "seed", "sampling", "zip", "correlations"};
    refuse(entry.place, say("'{1}' is not a field here", entry.key), did_you_mean(entry.key, keys, there_is(keys)));
  }

 private:
  void refuse(const Place& place, Message message, Message hint = {}) {
    issues_.push_back({place, "project.sweep", std::move(message), std::move(hint), Severity::error});
  }

  /// A list of texts, or one.
  void read_texts(const Tree& tree, std::vector<Placed>& texts) {
    if (tree.type == Tree::Type::text) return texts.push_back({tree.text, tree.place});
    if (tree.type != Tree::Type::array) return refuse(tree.place, say("a list of texts is expected"));
    for (const Tree& item : tree.items) {
      if (item.type != Tree::Type::text)
        return refuse(item.place, say("a text is expected, not {1}", toml::word_for(item.type)));
      texts.push_back({item.text, item.place});
    }
  }

  void read_whole(const Tree::Entry& entry, double least, std::uint64_t& target) {
    constexpr double most = 1e15;
    const double n = entry.value.number;
    if (entry.value.type != Tree::Type::number || n != std::floor(n) || n < least || n > most)
      return refuse(entry.value.place, say("'{1}' must be an integer", entry.key), say("write {1} = 1000", entry.key));
    target = static_cast<std::uint64_t>(n);
  }

  void read_sampling(const Tree::Entry& entry) {
    const bool known = entry.value.text == "random" || entry.value.text == "latin";
    if (entry.value.type != Tree::Type::text || !known)
      return refuse(entry.value.place, say("'sampling' is one of: random, latin"));
    settings_.latin = entry.value.text == "latin";
  }

  void read_zip(const Tree& tree) {
    if (tree.type != Tree::Type::array) return refuse(tree.place, say("'zip' is a list of lists of inputs"));
    for (const Tree& item : tree.items) {
      settings_.zip.emplace_back();
      read_texts(item, settings_.zip.back());
    }
  }

  void read_correlations(const Tree& tree) {
    if (tree.type != Tree::Type::array)
      return refuse(tree.place, say("'correlations' is a list"), say("write [{ of = [\"a.T\", \"b.F\"], r = 0.8 }]"));
    for (const Tree& item : tree.items) {
      const auto* of = item.find("of");
      const auto* r = item.find("r");
      std::vector<Placed> names;
      if (of != nullptr) read_texts(of->value, names);
      if (names.size() != 2 || r == nullptr || r->value.type != Tree::Type::number)
        return refuse(item.place, say("a correlation is of two inputs"),
                      say("write { of = [\"a.T\", \"b.F\"], r = 0.8 }"));
      settings_.correlations.push_back({names[0], names[1], r->value.number});
    }
  }

  SweepSettings& settings_;
  std::vector<Issue>& issues_;
};

}  // namespace

void read_sweep_settings(const Tree& table, SweepSettings& settings, std::vector<Issue>& issues) {
  if (table.type != Tree::Type::table) {
    issues.push_back({table.place, "project.sweep", say("'sweep' is a table of settings"), {}, Severity::error});
    return;
  }
  Reader reader(settings, issues);
  for (const Tree::Entry& entry : table.entries) reader.read(entry);
}

}  // namespace loadpath::project
