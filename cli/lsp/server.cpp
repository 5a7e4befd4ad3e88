#include "cli/lsp/server.hpp"

#include "cli/commands.hpp"
#include "cli/lsp/framing.hpp"
#include "cli/lsp/messages.hpp"

#include <boost/json.hpp>

#include <utility>

namespace loadpath::cli::lsp {

namespace {

namespace json = boost::json;

void send(json::object message) {
  message["jsonrpc"] = "2.0";
  lsp::send(json::serialize(message));
}

void send_error(const json::value& id, Fail fail, const std::string& text) {
  send({{"id", id}, {"error", json::object{{"code", static_cast<int>(fail)}, {"message", text}}}});
}

bool is_id(const json::value& id) { return id.is_string() || id.is_int64() || id.is_uint64() || id.is_null(); }

/// The capability of the editor: capabilities.textDocument.completion.completionItem.snippetSupport.
bool takes_snippets(const json::object& params) {
  const json::object* at = &params;
  for (const char* key : {"capabilities", "textDocument", "completion", "completionItem"}) {
    const json::value* const next = at->if_contains(key);
    if (next == nullptr || !next->is_object()) return false;
    at = &next->get_object();
  }
  const json::value* const supported = at->if_contains("snippetSupport");
  return supported != nullptr && supported->is_bool() && supported->get_bool();
}

json::object capabilities() {
  constexpr int incremental = 2;
  return {{"positionEncoding", "utf-16"},
          {"textDocumentSync", json::object{{"openClose", true}, {"change", incremental}}},
          {"hoverProvider", true},
          {"completionProvider", json::object{{"triggerCharacters", json::array{"\"", "=", ".", " "}}}},
          {"definitionProvider", true},
          {"documentSymbolProvider", true},
          {"inlayHintProvider", true}};
}

}  // namespace

void Server::receive(const std::string& body) {
  boost::system::error_code error;
  const json::value message = json::parse(body, error);
  if (error) return send_error(nullptr, Fail::parse_error, "the message is not JSON");
  if (!message.is_object()) return send_error(nullptr, Fail::invalid_request, "a message is an object");
  receive_object(message.get_object());
}

void Server::receive_object(const Object& message) {
  const Value* const id = message.if_contains("id");
  const Value* const method = message.if_contains("method");
  const Value own_id = id != nullptr && is_id(*id) ? *id : Value(nullptr);
  if (method == nullptr && id != nullptr && (message.contains("result") || message.contains("error"))) return;
  if (method == nullptr || !method->is_string() || (id != nullptr && !is_id(*id)))
    return send_error(own_id, Fail::invalid_request, "a request has an id and a method");
  const Value* const given = message.if_contains("params");
  const Object params = given != nullptr && given->is_object() ? given->get_object() : Object();
  const std::string name(std::string_view(method->get_string()));
  if (name != "textDocument/didChange") publish();
  if (id != nullptr) return answer(own_id, name, params);
  try {
    take_notice(name, params);
  } catch (const Refusal&) {  // a notification has no answer
  }
}

void Server::answer(const Value& id, const std::string& method, const Object& params) {
  try {
    send({{"id", id}, {"result", result_of(method, params)}});
  } catch (const Refusal& refusal) {
    send_error(id, refusal.code, refusal.what());
  } catch (const std::exception& error) {
    send_error(id, Fail::internal_error, error.what());
  }
}

Server::Value Server::result_of(const std::string& method, const Object& params) {
  if (is_shut_down_) throw Refusal(Fail::invalid_request, "the server is shut down");
  if (method == "initialize") return initialize(params);
  if (!is_initialized_) throw Refusal(Fail::not_initialized, "'initialize' comes first");
  if (method == "shutdown") {
    is_shut_down_ = true;
    return nullptr;
  }
  if (method == "textDocument/documentSymbol") return to_json(symbols_of(file_of(params)));
  if (method == "textDocument/inlayHint") return to_json(hints_in(file_of(params), range_in(params, "range")));
  const bool at_position =
      method == "textDocument/hover" || method == "textDocument/completion" || method == "textDocument/definition";
  if (!at_position) throw Refusal(Fail::method_not_found, "unknown method '" + method + "'");
  const OpenFile& file = file_of(params);
  const std::size_t offset = file.document.offset_of(position_in(params, "position"));
  if (method == "textDocument/hover") return to_json(hover_at(file, offset));
  if (method == "textDocument/completion") return to_json(completions_at(file, offset), takes_snippets_);
  const auto range = definition_at(file, offset);
  return range ? Value(Object{{"uri", file.uri}, {"range", to_json(*range)}}) : Value(nullptr);
}

Server::Value Server::initialize(const Object& params) {
  if (is_initialized_) throw Refusal(Fail::invalid_request, "'initialize' comes once");
  is_initialized_ = true;
  takes_snippets_ = takes_snippets(params);
  return Object{{"capabilities", capabilities()},
                {"serverInfo", Object{{"name", "loadpath"}, {"version", program().substr(program().rfind(' ') + 1)}}}};
}

void Server::take_notice(const std::string& method, const Object& params) {
  if (method == "exit") {
    exit_code_ = is_shut_down_ ? passed : not_passed;
    return;
  }
  if (!is_initialized_ || is_shut_down_) return;
  if (method == "textDocument/didOpen") open(params);
  if (method == "textDocument/didChange") change(params);
  if (method == "textDocument/didClose") close(params);
}

OpenFile& Server::file_of(const Object& params) {
  const std::string uri = text_in(object_in(params, "textDocument"), "uri");
  const auto found = files_.find(uri);
  if (found == files_.end()) throw Refusal(Fail::invalid_params, "'" + uri + "' is not open");
  return found->second;
}

void Server::open(const Object& params) {
  const Object& document = object_in(params, "textDocument");
  const std::string uri = text_in(document, "uri");
  files_.insert_or_assign(uri, OpenFile(uri, text_in(document, "text")));
}

void Server::change(const Object& params) {
  OpenFile& file = file_of(params);
  for (const Value& change : array_in(params, "contentChanges")) {
    if (!change.is_object()) continue;
    const Object& one = change.get_object();
    const std::string text = text_in(one, "text");
    if (one.contains("range"))
      file.document.change(range_in(one, "range"), text);
    else
      file.document = Document(text);
    file.is_dirty = true;
  }
}

void Server::close(const Object& params) {
  const std::string uri = text_in(object_in(params, "textDocument"), "uri");
  if (files_.erase(uri) == 0) return;
  send({{"method", "textDocument/publishDiagnostics"},
        {"params", Object{{"uri", uri}, {"diagnostics", json::array()}}}});
}

void Server::publish() {
  for (auto& [uri, file] : files_) {
    if (!file.is_dirty) continue;
    try {
      refresh(file);
      send({{"method", "textDocument/publishDiagnostics"},
            {"params", Object{{"uri", uri}, {"diagnostics", to_json(diagnostics_of(file))}}}});
    } catch (const std::exception& error) {  // a fault of the program must not end the editor's session
      file.is_dirty = file.is_solved = false;
      send({{"method", "window/logMessage"}, {"params", Object{{"type", 1}, {"message", error.what()}}}});
    }
  }
}

}  // namespace loadpath::cli::lsp

namespace loadpath::cli {

int language_server() {
  lsp::Input input;
  lsp::Server server;
  while (!server.exit_code()) {
    if (!input.has_more()) server.publish();
    const auto body = input.next();
    if (!body) return server.is_in_session() ? not_passed : passed;
    server.receive(*body);
  }
  return *server.exit_code();
}

}  // namespace loadpath::cli
