// A Chromium that a test looks through: pages as they are laid out, after their scripts.
#pragma once

#include <boost/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <sys/types.h>

namespace loadpath::test {

/// The first browser on the path, or an empty text.
std::string browser_there();

/// One window, led by the DevTools protocol over pipes. Every failure of it is a REQUIRE that fails.
class Browser {
 public:
  Browser();
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// The width and height of the viewport, in CSS pixels; `dark`: as with a dark desktop.
  void look(int width, int height, bool dark = false);
  /// Shows the page as printed: the styles for print, at the width of the printed area.
  void look_as_print(int width);
  /// Opens an address and waits until it is loaded, including its fonts.
  void open(const std::string& address);
  /// The value of an expression in the page; a promise is waited for.
  boost::json::value value(const std::string& expression);
  /// Waits until an expression is true; false if it is not within minutes.
  bool becomes_true(const std::string& expression);

 private:
  boost::json::value ask(std::string_view method, boost::json::object parameters, bool of_page = true);
  std::string read_message();

  std::filesystem::path profile_;
  std::string session_, pending_;
  pid_t child_ = 0;
  int to_ = -1, from_ = -1;
  int last_ = 0;
};

}  // namespace loadpath::test
