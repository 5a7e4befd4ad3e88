// The language server, asked by a scripted editor.
#include "lib/toml/tree.hpp"
#include "tests/cli/editor.hpp"

#include <algorithm>
#include <random>

using namespace loadpath;
using namespace loadpath::test;
namespace json = boost::json;

namespace {

const std::string shaft = R"toml([values]
T = "900 N*m"

[axle]
calculator = "shaft.torsion"
T = "=values.T"
material = "C45E"
S = 2

[pin]
calculator = "shaft.torsion"
T = "=2 * axle.T"
tau_adm = "30 MPa"
d = "40 mm"
)toml";

std::string text_of(const json::value& value) { return std::string(std::string_view(value.as_string())); }
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The text with a bar in front of the part behind `before`.
std::string with_bar(std::string text, const std::string& before) {
  const std::size_t at = text.find(before);
  REQUIRE(at != std::string::npos);
  return text.insert(at + before.size(), "|");
}

std::string hover_text(const json::value& answer) {
  return answer.is_null() ? "" : text_of(answer.at("contents").at("value"));
}

std::vector<std::string> labels_of(const json::value& answer) {
  std::vector<std::string> labels;
  for (const auto& item : answer.at("items").as_array()) labels.push_back(text_of(item.at("label")));
  return labels;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const json::value& item_of(const json::value& answer, const std::string& label) {
  static const json::value none;
  for (const auto& item : answer.at("items").as_array()) {
    if (text_of(item.at("label")) == label) return item;
  }
  FAIL("there is no " << label);
  return none;
}

std::string hover_at_bar(const std::string& text) {
  Editor editor;
  const int id = editor.ask_at_bar("textDocument/hover", text);
  editor.run();
  return hover_text(editor.answer(id));
}

json::value completed(const std::string& text) {
  Editor editor;
  const int id = editor.ask_at_bar("textDocument/completion", text);
  editor.run();
  return editor.answer(id);
}

json::array told(const std::string& text) {
  Editor editor;
  editor.open(text);
  editor.run();
  return editor.diagnostics();
}

}  // namespace

TEST_SUITE("lsp") {
  TEST_CASE("a session begins, ends, and lists its capabilities") {
    Editor editor;
    editor.run();
    CHECK(editor.code() == 0);
    const auto& can = editor.answer(1).at("capabilities");
    CHECK(can.at("positionEncoding") == "utf-16");
    CHECK(can.at("textDocumentSync").at("change") == 2);
    for (const char* what : {"hoverProvider", "definitionProvider", "documentSymbolProvider", "inlayHintProvider"})
      CHECK(can.at(what) == true);
    CHECK(editor.answer(2).is_null());
  }

  TEST_CASE("an editor that closes without exit, or exits without shutdown, ends it with 1") {
    Editor gone;
    gone.run(false);
    CHECK(gone.code() == 1);
    Editor in_haste;
    in_haste.tell("exit", {});
    in_haste.run(false);
    CHECK(in_haste.code() == 1);
    Editor none(false);
    none.run(false);
    CHECK(none.code() == 0);
  }

  TEST_CASE("an unknown or unreadable message gets the errors of the protocol") {
    Editor early(false);
    const int first = early.ask("textDocument/hover", {});
    early.say("{ no JSON");
    early.say("[]");
    early.say(R"({"jsonrpc": "2.0", "id": 77})");
    early.say(R"({"jsonrpc": "2.0", "id": 78, "result": null})");
    early.run(false);
    CHECK(early.answer(first).at("code") == -32002);
    REQUIRE(early.heard().size() == 4);
    CHECK(early.heard()[1].at("error").at("code") == -32700);
    CHECK(early.heard()[2].at("error").at("code") == -32600);
    CHECK(early.answer(77).at("code") == -32600);
    Editor editor;
    const int unknown = editor.ask("textDocument/teapot", {});
    const int empty = editor.ask("textDocument/hover", {});
    const int twice = editor.ask("initialize", {});
    const int closed =
        editor.ask("textDocument/documentSymbol", {{"textDocument", json::object{{"uri", "file:///b"}}}});
    editor.tell("$/teapot", {});
    editor.tell("textDocument/didChange", {});
    editor.run();
    CHECK(editor.answer(unknown).at("code") == -32601);
    CHECK(editor.answer(empty).at("code") == -32602);
    CHECK(editor.answer(twice).at("code") == -32600);
    CHECK(editor.answer(closed).at("code") == -32602);
    CHECK(editor.code() == 0);
  }

  TEST_CASE("an error is shown at its place, counted in UTF-16, with its help") {
    const json::array all = told(
        "[a]\ncalculator = \"shaft.torsion\"\ntitle = \"\xF0\x9F\x94\xA9\" # \xC3\xA4\nT = \"3 "
        "N*m\"\ntau_adm = \"30 mpa\"\n");
    REQUIRE(all.size() == 1);
    CHECK(all[0].at("severity") == 1);
    CHECK(text_of(all[0].at("message")) == "unknown unit 'mpa'\nhelp: did you mean 'MPa'?");
    CHECK(all[0].at("range") == json::parse(R"({"start": {"line": 4, "character": 14},
      "end": {"line": 4, "character": 17}})"));
    const json::array wide = told(
        "[a]\ncalculator = \"shaft.torsion\"\nT = \"3 N*m\"\ntau_adm = \"30 MPa\"\n"
        "accept = { yield = \"\xF0\x9F\x94\xA9\", teapot = \"b\" }\n");
    REQUIRE_FALSE(wide.empty());
    CHECK(wide[0].at("range").at("start") == json::parse(R"({"line": 4, "character": 25})"));
  }

  TEST_CASE("a text that is not TOML is reported at its place") {
    const json::array all = told("[a]\ncalculator = \"shaft.torsion\"\nT = 900 N*m\n");
    REQUIRE(all.size() == 1);
    CHECK(all[0].at("range").at("start").at("line") == 2);
    CHECK(contains(text_of(all[0].at("message")), "write a quantity in quotes"));
  }

  TEST_CASE("a part that fails is a warning at its step, one that is not assessed an information") {
    const json::array all = told(shaft);
    const auto fails = std::find_if(all.begin(), all.end(), [](const json::value& d) {
      return text_of(d.at("message")).starts_with("FAIL: ") || text_of(d.at("message")).starts_with("fail: ");
    });
    REQUIRE(fails != all.end());
    CHECK(fails->at("severity") == 2);
    CHECK(fails->at("range").at("start").at("line") == 9);
    CHECK(contains(text_of(fails->at("message")), "utilisation"));
  }

  TEST_CASE("changes of parts of the text and of the full text are applied, and a closed file has no errors") {
    Editor editor;
    editor.open(shaft);
    const auto change = [&](json::array changes) {
      editor.tell("textDocument/didChange", {{"textDocument", json::object{{"uri", Editor::address}, {"version", 2}}},
                                             {"contentChanges", std::move(changes)}});
    };
    const json::object document{{"uri", Editor::address}};
    const std::size_t at = shaft.find("30 MPa");
    change(
        {json::object{{"range", json::object{{"start", position_of(shaft, at)}, {"end", position_of(shaft, at + 2)}}},
                      {"text", "300"}}});
    const int hover =
        editor.ask("textDocument/hover", {{"textDocument", document}, {"position", position_of(shaft, at)}});
    change({json::object{{"text", "[a]\n"}}});
    const int symbols = editor.ask("textDocument/documentSymbol", {{"textDocument", document}});
    editor.tell("textDocument/didClose", {{"textDocument", document}});
    editor.run();
    CHECK(contains(hover_text(editor.answer(hover)), "300 MPa"));
    CHECK(editor.answer(symbols).as_array().size() == 1);
    CHECK(editor.diagnostics().empty());
  }

  TEST_CASE("hover over a key shows the meaning of the field, its unit, range and default") {
    const std::string text = hover_at_bar(with_bar(shaft, "tau_ad"));
    CHECK(text.starts_with("**tau_adm**: "));
    CHECK(contains(text, "MPa"));
    CHECK(contains(text, "must be > 0 MPa"));
    CHECK(contains(hover_at_bar(with_bar(shaft, "materia")), "loadpath tables"));
    CHECK(hover_at_bar(with_bar(shaft, "[pi")).starts_with("**shaft.torsion**: "));
  }

  TEST_CASE("hover over a value shows it in other units, an expression, a row") {
    CHECK(contains(hover_at_bar(with_bar(shaft, "\"40 ")), "0.04 m = 40 mm = 1.5748 in"));
    const std::string doubled = hover_at_bar(with_bar(shaft, "=2 * ax"));
    CHECK(contains(doubled, "**= 1800 N\xC2\xB7m** (moment)"));
    CHECK(contains(doubled, "- `axle.T`: "));
    const std::string row = hover_at_bar(with_bar(shaft, "\"C4"));
    CHECK(row.starts_with("**C45E**: "));
    CHECK(contains(row, "- `R_e`: "));
    CHECK(hover_at_bar(with_bar(shaft, "S = 2\n")).empty());
  }

  TEST_CASE("keys are completed by those that the step does not have yet, also in a text that does not parse") {
    const json::value all = completed("[a]\ncalculator = \"shaft.torsion\"\nT = \"3 N*m\"\nta|\n[b]\nd = \"");
    const auto labels = labels_of(all);
    for (const char* key : {"tau_adm", "d", "material", "title", "accept"}) CHECK(has(labels, key));
    CHECK_FALSE(has(labels, "T"));
    CHECK_FALSE(has(labels, "template"));
    const auto& edit = item_of(all, "tau_adm").at("textEdit");
    CHECK(edit.at("newText") == "tau_adm = \"$1 MPa\"");
    CHECK(edit.at("range") == json::parse(R"({"start": {"line": 3, "character": 0},
      "end": {"line": 3, "character": 2}})"));
    CHECK(labels_of(completed("[a]\n|")) == std::vector<std::string>{"calculator"});
    CHECK(has(labels_of(completed("[project]\n|")), "checked"));
  }

  TEST_CASE("keys of elements and of templates are completed") {
    const std::string lever = "[m]\ncalculator = \"mechanism.planar\"\n";
    CHECK(has(labels_of(completed(lever + "[m.links.rod]\nma|")), "mass"));
    CHECK(has(labels_of(completed(lever + "loads = [{ name = \"F\", li|")), "link"));
    CHECK(has(labels_of(completed(lever + "template = \"|\"")), "slider_crank"));
    CHECK(has(labels_of(completed(lever + "template = \"slider_crank\"\n|")), "r"));
  }

  TEST_CASE("calculators, words, rows and stocks are completed") {
    CHECK(has(labels_of(completed("[a]\ncalculator = \"shaft.|")), "shaft.torsion"));
    const json::value bare = completed("[a]\ncalculator = |");
    CHECK(item_of(bare, "gear.pair").at("textEdit").at("newText") == "\"gear.pair\"");
    const std::string column = "[tables.materials.mine]\nsource = \"s\"\n[a]\ncalculator = \"column.buckling\"\n";
    CHECK(has(labels_of(completed(column + "ends = \"|\"")), "pinned_pinned"));
    const auto rows = labels_of(completed(column + "material = \"|\""));
    CHECK(has(rows, "mine"));
    CHECK(has(rows, "C45E"));
    CHECK(has(labels_of(completed(column + "d = { stock = \"|")), "R20"));
  }

  TEST_CASE("a number is followed by the units of its field") {
    const json::value all = completed("[a]\ncalculator = \"shaft.torsion\"\nT = \"2,5 k|");
    CHECK(has(labels_of(all), "N*m"));
    CHECK(has(labels_of(all), "lbf*in"));
    CHECK_FALSE(has(labels_of(all), "mm"));
    CHECK(item_of(all, "kN*m").at("textEdit").at("range").at("start") == json::parse(R"({"line": 2, "character": 9})"));
  }

  TEST_CASE("behind = steps, values and functions are completed, and behind a step its results") {
    const auto first = labels_of(completed(with_bar(shaft, "\"=2 * ")));
    for (const char* name : {"axle", "values.T", "peak"}) CHECK(has(first, name));
    CHECK_FALSE(has(first, "pin"));
    CHECK(has(labels_of(completed(with_bar(shaft, "\"=values."))), "T"));
    const json::value of_step = completed(
        "[a]\ncalculator = \"shaft.torsion\"\nT = \"3 N*m\"\ntau_adm = \"30 MPa\"\n"
        "[b]\ncalculator = \"shaft.torsion\"\nd = \"=a.|");
    CHECK(has(labels_of(of_step), "d_min"));
    CHECK(text_of(item_of(of_step, "d_min").at("sortText")) < text_of(item_of(of_step, "tau_max").at("sortText")));
  }

  TEST_CASE("a reference leads to its step, its key, its value, its row") {
    const auto line_of = [](const std::string& text) {
      Editor editor;
      const int id = editor.ask_at_bar("textDocument/definition", text);
      editor.run();
      const json::value& answer = editor.answer(id);
      return answer.is_null() ? -1 : answer.at("range").at("start").at("line").to_number<int>();
    };
    CHECK(line_of(with_bar(shaft, "=2 * ax")) == 3);
    CHECK(line_of(with_bar(shaft, "=2 * axle.T")) == 5);
    CHECK(line_of(with_bar(shaft, "=values.T")) == 1);
    CHECK(line_of(with_bar(shaft, "C4")) == -1);
    CHECK(line_of("[tables.materials.\"C 4\"]\n" + with_bar(shaft, "C4").replace(shaft.find("C45E"), 5, "C|4")) == 0);
  }

  TEST_CASE("values of expressions, of searches and of shared values are shown in the line") {
    Editor editor;
    editor.open(shaft);
    const int id = editor.ask(
        "textDocument/inlayHint",
        {{"textDocument", json::object{{"uri", Editor::address}}},
         {"range", json::parse(R"({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}})")}});
    editor.run();
    const auto& hints = editor.answer(id).as_array();
    REQUIRE(hints.size() == 2);
    CHECK(hints[0].at("label") == "= 900 N*m");
    CHECK(hints[0].at("position") == json::parse(R"({"line": 5, "character": 15})"));
    CHECK(hints[1].at("label") == "= 1800 N\xC2\xB7m");
  }

  TEST_CASE("steps are the symbols of a file, with their tables inside") {
    Editor editor;
    editor.open("[project]\ntitle = \"a\"\n[m]\ncalculator = \"mechanism.planar\"\n[m.links.rod]\nmass = \"1 kg\"\n");
    const int id =
        editor.ask("textDocument/documentSymbol", {{"textDocument", json::object{{"uri", Editor::address}}}});
    editor.run();
    const auto& symbols = editor.answer(id).as_array();
    REQUIRE(symbols.size() == 2);
    CHECK(symbols[1].at("name") == "m");
    CHECK(symbols[1].at("detail") == "mechanism.planar");
    CHECK(symbols[1].at("children").at(0).at("name") == "links.rod");
  }

  TEST_CASE("an answer comes while the editor keeps the pipe open") {
    Editor editor;
    editor.open(shaft);
    const Desk desk;
    desk.put("said", editor.said());
    const Ran ran = desk.shell(
        "mkfifo in out; loadpath lsp < in > out & exec 3> in; cat said >&3; "
        "timeout 600 head -c 600 < out | grep -q publishDiag; echo heard $?; exec 3>&-; wait");
    CHECK(contains(ran.out, "heard 0"));
  }

  TEST_CASE("two hundred broken texts and requests on them neither stop nor stall it") {
    std::mt19937 random(1);  // the same everywhere
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
    std::vector<std::string> texts;
    for (const char* name : {"shouldered-shaft", "fan-belt", "press-link", "air-receiver", "gear-stage",
                             "conveyor-drive", "strut-sweep", "slotted-lever"}) {
      texts.emplace_back();
      REQUIRE(toml::read_file(std::string(LOADPATH_ROOT "/examples/") + name + "/project.toml", texts.back()));
    }
    Editor editor;
    std::size_t asked = 0;
    constexpr std::string_view letters = "[]{}\"'=.,#\n \\?0aT\t";
    for (int i = 0; i < 200; ++i) {
      std::string text = texts[below(texts.size())];
      std::size_t at = below(text.size());
      while ((static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) --at;
      if (i % 2 == 0) text.resize(at);
      for (int slip = 0; i % 2 == 1 && slip < 3; ++slip) {
        const std::size_t where = below(text.size());
        if (static_cast<unsigned char>(text[where]) < 0x80U) text[where] = letters[below(letters.size())];
      }
      editor.open(text);
      const json::object where{{"textDocument", json::object{{"uri", Editor::address}}},
                               {"position", json::object{{"line", below(80)}, {"character", below(60)}}}};
      for (const char* method : {"hover", "completion", "definition", "documentSymbol"}) {
        editor.ask(std::string("textDocument/") + method, where);
        ++asked;
      }
    }
    editor.run();
    CHECK(editor.code() == 0);
    std::size_t answers = 0;
    for (const json::value& message : editor.heard()) {
      CHECK_FALSE(message.as_object().contains("error"));
      if (message.as_object().contains("result")) ++answers;
    }
    CHECK(answers == asked + 2);  // and the first and the last
  }
}
