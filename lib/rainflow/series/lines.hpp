// The lines of a source, out of large blocks.
#pragma once

#include "lib/rainflow/series/source.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace loadpath::rainflow {

class Lines {
 public:
  explicit Lines(std::unique_ptr<Source> source) : source_(std::move(source)), buffer_(longest) {}

  /// The next line without its end, which is LF or CR LF, valid until the next call. None at the end of the source,
  /// or with a reason in fault().
  std::optional<std::string_view> next() {
    const void* const found = std::memchr(buffer_.data() + at_, '\n', end_ - at_);
    return found != nullptr ? taken(static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()), 1)
                            : more();
  }
  /// Returns the latest line once more.
  void again() { at_ = start_, --number_; }

  /// The number of the latest line, from 1.
  [[nodiscard]] std::uint64_t number() const { return number_; }
  [[nodiscard]] const std::optional<Fault>& fault() const { return fault_; }

 private:
  static constexpr std::size_t longest = std::size_t{1} << 20U;  // bytes of a line, and of one read

  std::string_view taken(std::size_t end, std::size_t length_of_end) {
    start_ = at_, at_ = end + length_of_end, ++number_;
    if (end > start_ && buffer_[end - 1] == '\r') --end;
    return {buffer_.data() + start_, end - start_};
  }
  std::optional<std::string_view> more();

  std::unique_ptr<Source> source_;
  std::vector<char> buffer_;
  std::size_t start_ = 0, at_ = 0, end_ = 0;
  std::uint64_t number_ = 0;
  bool ended_ = false;
  std::optional<Fault> fault_;
};

}  // namespace loadpath::rainflow
