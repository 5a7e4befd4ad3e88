// The language server: JSON-RPC 2.0 and the Language Server Protocol 3.17, without anything that is known of projects.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <boost/json/fwd.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::cli::lsp {

class Server {
 public:
  /// Answers one message; its notifications follow the answer.
  void receive(const std::string& body);
  /// Sends the diagnostics of files that have changed since.
  void publish();
  /// Whether an editor has initialised the session, and not yet shut it down.
  [[nodiscard]] bool is_in_session() const { return is_initialized_ && !is_shut_down_; }
  /// The exit code, once exit was requested; nothing before.
  [[nodiscard]] std::optional<int> exit_code() const { return exit_code_; }

 private:
  using Object = boost::json::object;
  using Value = boost::json::value;

  void receive_object(const Object& message);
  void answer(const Value& id, const std::string& method, const Object& params);
  Value result_of(const std::string& method, const Object& params);
  Value initialize(const Object& params);
  void take_notice(const std::string& method, const Object& params);
  void open(const Object& params);
  void change(const Object& params);
  void close(const Object& params);
  OpenFile& file_of(const Object& params);

  std::map<std::string, OpenFile> files_;
  bool is_initialized_ = false, is_shut_down_ = false;
  bool takes_snippets_ = false;
  std::optional<int> exit_code_;
};

}  // namespace loadpath::cli::lsp
