#include "cli/lsp/framing.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace loadpath::cli::lsp {

namespace {

constexpr std::size_t longest = std::size_t{64} << 20U;  // length of a message

std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return all;
}

/// "Content-Length: 120": 120; nothing for another line, or without a number.
std::optional<std::size_t> length_in(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || lower(line.substr(0, colon)) != "content-length") return std::nullopt;
  line.remove_prefix(std::min(line.find_first_not_of(" \t", colon + 1), line.size()));
  std::size_t length = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), length);
  return read.ec == std::errc() && read.ptr != line.data() ? std::optional(length) : std::nullopt;
}

}  // namespace

bool Input::read_more() {
  bytes_.erase(0, at_);
  at_ = 0;
  std::array<char, 65536> block{};
  const ssize_t count = read(STDIN_FILENO, block.data(), block.size());
  if (count <= 0) return false;
  bytes_.append(block.data(), static_cast<std::size_t>(count));
  return true;
}

bool Input::has_line(std::size_t& end) const {
  end = bytes_.find('\n', at_);
  return end != std::string::npos;
}

std::optional<std::string> Input::next() {
  std::optional<std::size_t> length;
  for (bool in_head = true; in_head;) {
    std::size_t end = 0;
    while (!has_line(end)) {
      if (bytes_.size() - at_ > longest || !read_more()) return std::nullopt;
    }
    std::string_view line = std::string_view(bytes_).substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (const auto given = length_in(line)) length = given;
    in_head = !line.empty();
    at_ = end + 1;
  }
  if (!length || *length > longest) return "";
  while (bytes_.size() - at_ < *length) {
    if (!read_more()) return std::nullopt;
  }
  std::string body = bytes_.substr(at_, *length);
  at_ += *length;
  return body;
}

bool Input::has_more() const {
  if (at_ < bytes_.size()) return true;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 0) > 0;
}

bool send(std::string_view body) {
  std::cout << "Content-Length: " << body.size() << "\r\n\r\n" << body << std::flush;
  return static_cast<bool>(std::cout);
}

}  // namespace loadpath::cli::lsp
