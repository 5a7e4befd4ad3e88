// An editor connected to `loadpath lsp`: its messages are collected, sent at once, and the answers are read.
#pragma once

#include "tests/cli/process.hpp"

#include <boost/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

class Editor {
 public:
  explicit Editor(bool begins = true);

  /// A request; the number that answers it.
  int ask(const std::string& method, boost::json::object params);
  void tell(const std::string& method, boost::json::object params);
  /// A message as it is, with its head.
  void say(const std::string& body);
  void open(const std::string& text, const std::string& uri = address);
  /// A request about the place of a `|` in the text that is opened for it.
  int ask_at_bar(const std::string& method, std::string text);
  /// Ends the session, runs the server with all messages, and keeps its answers.
  void run(bool says_good_bye = true);

  /// The result of a request; the error if there is none.
  [[nodiscard]] const boost::json::value& answer(int id) const;
  /// The diagnostics of an address that came last.
  [[nodiscard]] boost::json::array diagnostics(const std::string& uri = address) const;
  [[nodiscard]] const std::vector<boost::json::value>& heard() const { return heard_; }
  [[nodiscard]] int code() const { return ran_.code; }
  [[nodiscard]] const std::string& said() const { return said_; }

  static constexpr const char* address = "file:///a.toml";

 private:
  void read();

  std::string said_;
  int next_ = 1, texts_ = 0;
  Ran ran_;
  std::vector<boost::json::value> heard_;
};

/// The position of a byte of a text, as the protocol counts; the text is ASCII.
boost::json::object position_of(const std::string& text, std::size_t at);

}  // namespace loadpath::test
