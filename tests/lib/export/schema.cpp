#include "calculators/catalogue.hpp"
#include "lib/export/json.hpp"
#include "lib/toml/tree.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>

using namespace loadpath;
using toml::Tree;
namespace json = boost::json;

namespace {

const json::value& schema() {
  static const json::value value = json::parse(exports::project_schema(calculators()));
  return value;
}

std::string_view type_of(const Tree& tree) {
  switch (tree.type) {
    case Tree::Type::table:
      return "object";
    case Tree::Type::array:
      return "array";
    case Tree::Type::text:
      return "string";
    case Tree::Type::number:
      return std::isfinite(tree.number) && tree.number == std::trunc(tree.number) ? "integer" : "number";
    case Tree::Type::boolean:
      return "boolean";
  }
  return "";
}

bool is_word(const json::value& value, std::string_view word) { return value.is_string() && value.as_string() == word; }

bool is_type(const json::value& wanted, const Tree& tree) {
  if (const auto* words = wanted.if_array()) {
    return std::any_of(words->begin(), words->end(), [&](const json::value& word) { return is_type(word, tree); });
  }
  const std::string_view type = type_of(tree);
  return is_word(wanted, type) || (is_word(wanted, "number") && type == "integer");
}

bool accepts(const json::value& value, const Tree& tree);

/// Target of a "$ref": "#/$defs/shaft.torsion".
const json::value& definition(const json::value& reference) {
  const std::string_view path = reference.as_string();
  return schema().at("$defs").at(path.substr(path.rfind('/') + 1));
}

bool fits(const json::value& pattern, const std::string& text) {
  static std::map<std::string, std::regex> known;
  const std::string key(pattern.as_string());
  const auto found = known.try_emplace(key, key).first;
  return std::regex_search(text, found->second);
}

/// Words, texts and numbers.
bool accepts_leaf(const json::object& rule, const Tree& tree) {
  if (const auto* word = rule.if_contains("const"); word != nullptr && !is_word(*word, tree.text)) return false;
  if (const auto* words = rule.if_contains("enum")) {
    const auto& all = words->as_array();
    if (std::none_of(all.begin(), all.end(), [&](const json::value& w) { return is_word(w, tree.text); })) return false;
  }
  if (const auto* pattern = rule.if_contains("pattern");
      pattern != nullptr && tree.type == Tree::Type::text && !fits(*pattern, tree.text))
    return false;
  if (tree.type != Tree::Type::number) return true;
  const auto* least = rule.if_contains("minimum");
  const auto* most = rule.if_contains("maximum");
  return (least == nullptr || tree.number >= least->to_number<double>()) &&
         (most == nullptr || tree.number <= most->to_number<double>());
}

bool accepts_entries(const json::object& rule, const Tree& tree) {
  if (const auto* required = rule.if_contains("required")) {
    for (const auto& key : required->as_array()) {
      if (tree.find(key.as_string()) == nullptr) return false;
    }
  }
  if (const auto* names = rule.if_contains("propertyNames")) {
    const auto& known = names->at("enum").as_array();
    for (const Tree::Entry& entry : tree.entries) {
      if (std::none_of(known.begin(), known.end(), [&](const json::value& w) { return is_word(w, entry.key); }))
        return false;
    }
  }
  const auto* properties = rule.if_contains("properties");
  const auto* others = rule.if_contains("additionalProperties");
  return std::all_of(tree.entries.begin(), tree.entries.end(), [&](const Tree::Entry& entry) {
    const auto* known = properties == nullptr ? nullptr : properties->as_object().if_contains(entry.key);
    if (known != nullptr) return accepts(*known, entry.value);
    return others == nullptr || accepts(*others, entry.value);
  });
}

/// The part of JSON Schema that the program writes.
bool accepts(const json::value& value, const Tree& tree) {
  if (value.is_bool()) return value.as_bool();
  const json::object& rule = value.as_object();
  if (const auto* type = rule.if_contains("type"); type != nullptr && !is_type(*type, tree)) return false;
  if (const auto* other = rule.if_contains("$ref"); other != nullptr && !accepts(definition(*other), tree))
    return false;
  if (!accepts_leaf(rule, tree)) return false;
  if (const auto* forms = rule.if_contains("anyOf")) {
    const auto& all = forms->as_array();
    if (std::none_of(all.begin(), all.end(), [&](const json::value& form) { return accepts(form, tree); }))
      return false;
  }
  if (const auto* conditions = rule.if_contains("allOf")) {
    const auto& all = conditions->as_array();
    if (!std::all_of(all.begin(), all.end(), [&](const json::value& c) { return accepts(c, tree); })) return false;
  }
  if (const auto* wrong = rule.if_contains("not"); wrong != nullptr && accepts(*wrong, tree)) return false;
  if (const auto* condition = rule.if_contains("if");
      condition != nullptr && accepts(*condition, tree) && !accepts(rule.at("then"), tree))
    return false;
  if (const auto* items = rule.if_contains("items"); items != nullptr && tree.type == Tree::Type::array) {
    if (!std::all_of(tree.items.begin(), tree.items.end(), [&](const Tree& item) { return accepts(*items, item); }))
      return false;
  }
  if (const auto* most = rule.if_contains("maxItems");
      most != nullptr && tree.items.size() > most->to_number<std::size_t>())
    return false;
  return tree.type != Tree::Type::table || accepts_entries(rule, tree);
}

Tree tree_of(const std::string& text) {
  std::vector<Issue> issues;
  Tree tree = toml::read_toml(text, "a.toml", issues);
  REQUIRE(issues.empty());
  return tree;
}

}  // namespace

TEST_SUITE("schema") {
  TEST_CASE("it is a JSON Schema") {
    CHECK(schema().at("$schema") == "https://json-schema.org/draft/2020-12/schema");
    CHECK(schema().at("type") == "object");
    CHECK(schema().at("properties").as_object().contains("project"));
  }

  TEST_CASE("it has a step for each calculator, with its fields") {
    const json::value& step = schema().at("additionalProperties");
    CHECK(step.at("properties").at("calculator").at("enum").as_array().size() == calculators().size());
    CHECK(step.at("allOf").as_array().size() == calculators().size());
    for (const Calculator* calculator : calculators()) {
      const auto& properties = schema().at("$defs").at(calculator->id).at("properties").as_object();
      CHECK(properties.at("calculator").at("const") == calculator->id);
      for (const FieldInfo& field : calculator->input->fields) {
        CAPTURE(field.key);
        CHECK(properties.contains(field.key));
        CHECK_FALSE(properties.at(field.key).at("description").as_string().empty());
      }
    }
  }

  TEST_CASE("it states what \"?\" finds: sizes of a stock, and the largest load that passes") {
    const auto told = [](const char* calculator, const char* field) {
      const json::value& found = schema().at("$defs").at(calculator).at("properties").at(field).at("description");
      return std::string(std::string_view(found.as_string()));
    };
    CHECK(told("chain.roller", "P").ends_with("; \"?\" finds the largest that passes"));
    CHECK(told("shaft.torsion", "d").ends_with("; \"?\" searches in R40"));
    CHECK(told("column.buckling", "l").ends_with("; \"?\" finds the largest that passes"));
    CHECK(told("column.buckling", "N").find('?') == std::string::npos);  // its sign decides
    CHECK(told("chain.roller", "K_A").find('?') == std::string::npos);
  }

  TEST_CASE("it accepts every project of the repository") {
    for (const char* folder : {"examples", "reference"}) {
      for (const auto& file :
           std::filesystem::recursive_directory_iterator(std::filesystem::path(LOADPATH_ROOT) / folder)) {
        if (file.path().extension() != ".toml") continue;
        CAPTURE(file.path().string());
        std::string text;
        REQUIRE(toml::read_file(file.path().string(), text));
        CHECK(accepts(schema(), tree_of(text)));
      }
    }
  }

  TEST_CASE("it accepts the example of each calculator") {
    for (const Calculator* calculator : calculators()) {
      CAPTURE(calculator->id);
      CHECK(accepts(schema(), tree_of(calculator->example)));
    }
  }

  TEST_CASE("it knows the templates: their words, and the parameters of each") {
    const std::string start = "[press]\ncalculator = \"mechanism.planar\"\n";
    for (const Calculator* calculator : calculators()) {
      for (const Template* t : calculator->templates) {
        CAPTURE(t->id);
        CHECK(accepts(schema(), tree_of(t->example)));
      }
    }
    CHECK_FALSE(accepts(schema(), tree_of(start + "template = \"slidercrank\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "template = \"slider_crank\"\nx_C = \"3 mm\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "template = \"slider_crank\"\nr = 3\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "r = \"3 mm\"\n")));
  }

  TEST_CASE("it refuses what the program refuses") {
    const std::string start = "[axle]\ncalculator = \"shaft.torsion\"\n";
    CHECK(accepts(schema(), tree_of(start + "T = \"9 N*m\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "T = 9\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "tau_amd = \"9 MPa\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "fixed = \"lft\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[axle]\ncalculator = \"shaft.torsoin\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[axle]\nT = \"9 N*m\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[project]\ntitel = \"x\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "accept = { yeild = \"x\" }\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "display = { dd = \"in\" }\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "T = { stok = \"R40\" }\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[p]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 41.5\nm_n = \"2 mm\"\n")));
  }

  TEST_CASE("it requires what the program requires, of lists and groups too") {
    const std::string over = "[o]\ncalculator = \"shaft.overhung\"\nT = \"9 N*m\"\na = \"50 mm\"\n";
    CHECK_FALSE(accepts(schema(), tree_of(over + "sigma_adm = \"60 MPa\"\n")));
    CHECK(accepts(schema(), tree_of(over + "sigma_adm = \"60 MPa\"\nF = \"1 kN\"\n")));
    const std::string axle = "[a]\ncalculator = \"shaft.torsion\"\n";
    CHECK_FALSE(accepts(schema(), tree_of(axle + "torques = [{ x = \"0 mm\" }]\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[t]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\n")));
  }

  TEST_CASE("a quantity has a unit of its dimension, or one that is composed") {
    const std::string start = "[axle]\ncalculator = \"shaft.torsion\"\n";
    for (const char* d :
         {"40 mm", "40mm", "1-1/2 in", "1/2 in", "2,5 cm", "= 2 * other.d", "?", "40 мм", "4e-2 m", ".5 ft"}) {
      CAPTURE(d);
      CHECK(accepts(schema(), tree_of(start + "d = \"" + d + "\"\n")));
    }
    for (const char* d : {"40", "40 MPa", "forty mm", "40 kg", "", "40 N"}) {
      CAPTURE(d);
      CHECK_FALSE(accepts(schema(), tree_of(start + "d = \"" + d + "\"\n")));
    }
    CHECK(accepts(schema(), tree_of(start + "T = \"900 N*m\"\nG = \"81000 N/mm²\"\ntheta_adm = \"0.25 deg/m\"\n")));
    CHECK(accepts(schema(), tree_of(start + "d = { stock = \"R20\" }\nK_A = 1.5\nS = \"1,5\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(start + "K_A = \"much\"\n")));
  }

  TEST_CASE("it knows the tables of a project's own") {
    const std::string row = "[tables.materials.M]\nsource = \"x\"\n";
    CHECK(
        accepts(schema(), tree_of(row + "E = \"210 GPa\"\nby_size = [{ size_max = \"16 mm\", R_e = \"265 MPa\" }]\n")));
    CHECK_FALSE(accepts(schema(), tree_of(row + "Re = \"265 MPa\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of(row + "R_e = \"265 mm\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[tables.materials.M]\nE = \"210 GPa\"\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[tables.v_belts.M]\nsource = \"x\"\n")));
    CHECK(accepts(schema(), tree_of("[tables.series.S]\nsource = \"x\"\nunit = \"mm\"\nsizes = [1, 2]\n")));
    CHECK(accepts(schema(), tree_of("[project]\ntables = [\"own.toml\"]\n")));
    CHECK_FALSE(accepts(schema(), tree_of("[project]\ntables = \"own.toml\"\n")));
  }

  TEST_CASE("a row may be searched for in a stock, and the rows of a list may be in a file") {
    const std::string rod = "[rod]\ncalculator = \"column.buckling\"\nN = \"9 kN\"\nl = \"1 m\"\nE = \"210 GPa\"\n";
    CHECK(accepts(schema(), tree_of(rod + "section = { stock = \"sections/ipe\" }\n")));
    CHECK_FALSE(accepts(schema(), tree_of(rod + "section = { stok = \"sections/ipe\" }\n")));
    const std::string press =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\n"
        "l = \"200 mm\"\n[press.courses.law]\nover_time = ";
    CHECK(accepts(schema(), tree_of(press + "[[\"0 s\", 0], [\"1 s\", 1]]\n")));
    CHECK(accepts(schema(), tree_of(press + "{ file = \"law.csv\" }\n")));
    CHECK_FALSE(accepts(schema(), tree_of(press + "{ file = 3 }\n")));
  }

  TEST_CASE("it offers the names of rows, and takes others too") {
    const auto& forms = schema().at("$defs").at("material").at("anyOf").as_array();
    const auto& names = forms[0].at("enum").as_array();
    CHECK(std::any_of(names.begin(), names.end(), [](const json::value& name) { return is_word(name, "S235JR"); }));
    CHECK(accepts(schema(), tree_of("[axle]\ncalculator = \"shaft.torsion\"\nmaterial = \"my own\"\n")));
  }
}
