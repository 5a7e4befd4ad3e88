#include "tests/cli/editor.hpp"

#include <algorithm>
#include <cstdlib>

namespace loadpath::test {

namespace json = boost::json;

json::object position_of(const std::string& text, std::size_t at) {
  const std::string before = text.substr(0, at);
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {{"line", std::count(before.begin(), before.end(), '\n')}, {"character", before.size() - start}};
}

Editor::Editor(bool begins) {
  if (!begins) return;
  ask("initialize", {{"processId", nullptr},
                     {"rootUri", nullptr},
                     {"capabilities", json::parse(R"({"textDocument": {"completion": {"completionItem":
                     {"snippetSupport": true}}}})")}});
  tell("initialized", {});
}

void Editor::say(const std::string& body) {
  said_ += "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

int Editor::ask(const std::string& method, json::object params) {
  say(json::serialize(
      json::object{{"jsonrpc", "2.0"}, {"id", next_}, {"method", method}, {"params", std::move(params)}}));
  return next_++;
}

void Editor::tell(const std::string& method, json::object params) {
  say(json::serialize(json::object{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
}

void Editor::open(const std::string& text, const std::string& uri) {
  tell("textDocument/didOpen",
       {{"textDocument", json::object{{"uri", uri}, {"languageId", "loadpath"}, {"version", 1}, {"text", text}}}});
}

int Editor::ask_at_bar(const std::string& method, std::string text) {
  const std::size_t bar = text.find('|');
  REQUIRE(bar != std::string::npos);
  text.erase(bar, 1);
  const std::string uri = "file:///text-" + std::to_string(++texts_) + ".toml";
  open(text, uri);
  return ask(method, {{"textDocument", json::object{{"uri", uri}}}, {"position", position_of(text, bar)}});
}

void Editor::run(bool says_good_bye) {
  if (says_good_bye) {
    ask("shutdown", {});
    tell("exit", {});
  }
  ran_ = Desk().run({"lsp"}, said_);
  read();
}

void Editor::read() {
  const std::string& out = ran_.out;
  for (std::size_t at = 0; at < out.size();) {
    constexpr std::string_view head = "Content-Length: ";
    REQUIRE(out.substr(at, head.size()) == head);
    const auto length = static_cast<std::size_t>(std::atoi(out.c_str() + at + head.size()));
    const std::size_t body = out.find("\r\n\r\n", at) + 4;
    heard_.push_back(json::parse(out.substr(body, length)));
    CHECK(heard_.back().at("jsonrpc") == "2.0");
    at = body + length;
  }
}

const json::value& Editor::answer(int id) const {
  static const json::value none;
  for (const json::value& message : heard_) {
    const auto& object = message.as_object();
    const auto* own = object.if_contains("id");
    if (own == nullptr || *own != json::value(id)) continue;
    return object.contains("result") ? object.at("result") : object.at("error");
  }
  FAIL("no answer to " << id);
  return none;
}

json::array Editor::diagnostics(const std::string& uri) const {
  json::array last;
  for (const json::value& message : heard_) {
    const auto* method = message.as_object().if_contains("method");
    if (method == nullptr || *method != json::value("textDocument/publishDiagnostics")) continue;
    if (message.at("params").at("uri") == json::value(uri)) last = message.at("params").at("diagnostics").as_array();
  }
  return last;
}

}  // namespace loadpath::test
