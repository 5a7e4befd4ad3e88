#include "lib/rainflow/counter.hpp"
#include "lib/rainflow/series/read_series.hpp"
#include "tests/cli/process.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::rainflow;

namespace {

using Series = std::vector<double>;

class Bytes : public Source {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
  Outcome<std::size_t> read(std::span<char> room) override {
    const std::size_t count = std::min(room.size(), bytes_.size() - at_);
    std::copy_n(bytes_.data() + at_, count, room.data());
    at_ += count;
    return count;
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

/// The result of reading, or its error message.
struct Read {
  Series values;
  std::string message, hint;
  std::size_t at = 0;

  void end_with(const Fault& fault) { message = fault.message.text(), hint = fault.hint.text(), at = fault.at; }
};

Read read(std::unique_ptr<Source> source, const Form& form) {
  Read result;
  const auto reader = read_series(std::move(source), form);
  if (!reader) {
    result.end_with(reader.fault());
    return result;
  }
  for (;;) {
    const auto part = (*reader)->next();
    if (!part) result.end_with(part.fault());
    if (!part || part->empty()) return result;
    result.values.insert(result.values.end(), part->begin(), part->end());
  }
}

Read csv(const std::string& text, const std::string& column = "", std::optional<char> separator = {}) {
  return read(std::make_unique<Bytes>(text), {.format = Format::csv, .column = column, .separator = separator});
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

Read binary(Format format, const std::string& bytes, const std::string& column = "") {
  return read(std::make_unique<Bytes>(bytes), {.format = format, .column = column, .separator = {}});
}

/// As NumPy writes it: the header is filled with blanks to a multiple of 64 bytes.
std::string npy(const std::string& type, const std::string& shape, const std::string& data, char version = 1,
                const std::string& fortran = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  const std::size_t start = version == 1 ? 10 : 12;
  while ((start + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += version;
  bytes += '\0';
  bytes += static_cast<char>(header.size() % 256);
  bytes += static_cast<char>(header.size() / 256);
  if (version > 1) bytes += std::string(2, '\0');
  return bytes + header + data;
}

}  // namespace

TEST_SUITE("rainflow series") {
  TEST_CASE("one column, with and without a header") {
    const Series values{1.5, -2, 3e3, 0.25};
    CHECK(csv("1.5\n-2\n3e3\n.25\n").values == values);
    CHECK(csv("sigma\n1.5\n-2\n3e3\n+0.25").values == values);
    CHECK(csv("# made on Monday\r\n\r\n\"sigma, MPa\"\r\n 1.5 \r\n\"-2\"\r\n# pause\r\n3e3\r\n  .25").values == values);
    CHECK(csv("\xef\xbb\xbf"
              "1.5\n-2\n3e3\n.25")
              .values == values);
    CHECK(csv("\xef\xbb\xbfx\n1.5\n-2\n3e3\n.25\n\n\n", "x").values == values);
  }

  TEST_CASE("a column by its name or its number, between any separators") {
    const Series values{10, 20, 30};
    for (const std::string separator : {",", ";", "\t", " ", "  ", " , ", " ; "}) {
      std::string text = "t" + separator + "F_x" + separator + "F_y\n";
      for (int i = 1; i <= 3; ++i) text += std::to_string(i) + separator + std::to_string(10 * i) + separator + "7.5\n";
      CHECK(csv(text, "F_x").values == values);
      CHECK(csv(text, "2").values == values);
      CHECK(csv(text, "t").values == Series{1, 2, 3});
      CHECK(csv(text, "3").values == Series{7.5, 7.5, 7.5});
    }
    CHECK(csv("  1   10\n 2\t20 \n3 30\n", "2").values == values);
    CHECK(csv("\"t, s\";\"a;b\"\n1;10\n2;20\n3;30", "a;b").values == values);
    CHECK(csv("1,x,10\n2,,20\n3,\"y,z\",30", "3").values == values);
    CHECK(csv("a b\n10\n20\n30", "a b", ',').values == values);
    CHECK(csv("2nd;1e3;F\n1;2;10\n1;2;20\n1;2;30", "F").values == values);
  }

  TEST_CASE("numbers are those of the C++ library to the bit") {
    std::mt19937_64 random(4);
    std::string text;
    Series expected;
    for (int i = 0; i < 20000; ++i) {
      const double x =
          std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 120) - 100) * (i % 2 == 0 ? 1 : -1);
      char digits[64];
      const auto format = i % 3 == 0 ? std::chars_format::fixed : std::chars_format::general;
      const auto end = std::to_chars(digits, digits + sizeof digits, x, format, static_cast<int>(random() % 17)).ptr;
      text.append(digits, end) += '\n';
      double value = 0.0;
      std::from_chars(digits, end, value);
      expected.push_back(value);
    }
    CHECK(csv(text).values == expected);
    CHECK(csv("1e-400\n-1e-400\n123456789012345\n0.00000000000001\n1.\n-.5\n").values ==
          Series{0.0, -0.0, 123456789012345.0, 1e-14, 1.0, -0.5});
  }

  TEST_CASE("a text longer than a block is read in parts") {
    std::string text = "n;value\n";
    Series expected;
    for (int i = 0; i < 300000; ++i) {
      text += std::to_string(i) + ';' + std::to_string(i % 1000) + ".5\n";
      expected.push_back(i % 1000 + 0.5);
    }
    REQUIRE(text.size() > 3U << 20U);
    CHECK(csv(text, "value").values == expected);
    text += "300000;oops";
    const Read broken = csv(text, "2");
    CHECK(broken.at == 300002);
    CHECK(broken.message == "line 300002: 'oops' in column 2 is not a finite number");
  }

  TEST_CASE("errors in a text are reported with their line") {
    const Read nan = csv("1\n2\n\nnan\n3\n");
    CHECK(nan.message == "line 4: 'nan' in column 1 is not a finite number");
    CHECK(nan.at == 4);
    for (const std::string bad : {"inf", "1e999", "1.5 MPa", "0x10", "--1", "+-1", "1e", ".", "-", "1.2.3", "1_000"})
      CHECK(csv("x\n1\n" + bad + "\n", "x", ',').message == "line 3: '" + bad + "' in column 1 is not a finite number");
    CHECK(csv("t;F\n1;2,5,1\n", "F").message == "line 2: '2,5,1' in column 2 is not a finite number");
    CHECK(csv("1,2\n").message == "line 1 has 2 columns: state which, by its name or its number from 1");
    CHECK(csv("1,2\n").hint == "separate the columns with ';' if a comma is the decimal mark");
    CHECK(csv("1 2\n3\n", "2").message == "line 2 has no number in column 2");
    CHECK(csv("1,2\n3,\n", "2").message == "line 2 has no number in column 2");
    CHECK(csv("1,2\n", "3").message == "line 1 has 2 columns, and no column 3");
    CHECK(csv("1,2\n", "0").message == "line 1 has 2 columns, and no column 0");
    const Read unknown = csv("time,force\n1,2\n", "forc");
    CHECK(unknown.message == "line 1: unknown column 'forc'");
    CHECK(unknown.hint == "did you mean 'force'?");
    CHECK(csv("F,F\n1,2\n", "F").message == "line 1: two columns are called 'F'");
    CHECK(csv("1\n\x1b[31m\n").message == "line 2: '?[31m' in column 1 is not a finite number");
    CHECK(csv("1\n" + std::string(2U << 20U, '7')).message == "line 2 is longer than a mebibyte");
    CHECK(csv("1\n" + std::string(100, 'x')).message ==
          "line 2: '" + std::string(40, 'x') + "...' in column 1 is not a finite number");
  }

  TEST_CASE("an empty text is an empty series") {
    for (const std::string text : {"", "\n\n", "# nothing\n", "sigma\n"}) {
      CHECK(csv(text).message.empty());
      CHECK(csv(text).values.empty());
    }
  }

  TEST_CASE("arrays of NumPy") {
    const Series values{1.5, -2, 3e3, 0.25, 1e-300, 7};
    const std::vector<float> floats{1.5F, -2.0F, 3e3F, 0.25F};
    for (const char version : {'\1', '\2', '\3'})
      CHECK(binary(Format::npy, npy("<f8", "(6,)", bytes_of(values), version)).values == values);
    CHECK(binary(Format::npy, npy("<f4", "(4,)", bytes_of(floats))).values == Series{1.5, -2, 3e3, 0.25});
    CHECK(binary(Format::npy, npy("<f8", "(3, 2)", bytes_of(values)), "2").values == Series{-2, 0.25, 7});
    CHECK(binary(Format::npy, npy("<f8", "(2, 3)", bytes_of(values)), "1").values == Series{1.5, 0.25});
    CHECK(binary(Format::npy, npy("<f8", "(6, 1)", bytes_of(values))).values == values);
    CHECK(binary(Format::npy, npy("<f8", "(0,)", "")).values.empty());
    CHECK(binary(Format::npy, npy("<f8", "(6,)", bytes_of(values), 1, "True")).values ==
          values);  // of one column alike
  }

  TEST_CASE("errors in an array are reported") {
    const Series values{1, 2, 3, 4, 5, 6};
    const std::string data = bytes_of(values);
    const auto message = [](const std::string& bytes, const std::string& column = "") {
      return binary(Format::npy, bytes, column).message;
    };
    CHECK(message("1\n2\n3\n4\n5\n6\n") == "byte 0: not a .npy file of NumPy");
    CHECK(message("") == "byte 0: not a .npy file of NumPy");
    CHECK(message(npy("<f8", "(6,)", data).substr(0, 40)) == "byte 0: not a .npy file of NumPy");
    CHECK(message(npy(">f8", "(6,)", data)) ==
          "the numbers of the array are '>f8'; float64 and float32, little-endian, are read");
    CHECK(message(npy("<i4", "(6,)", data)) ==
          "the numbers of the array are '<i4'; float64 and float32, little-endian, are read");
    CHECK(message(npy("<f8", "(3, 2)", data, 1, "True"), "1") ==
          "the array is in Fortran's order, column after column; C order is read");
    CHECK(message(npy("<f8", "(3, 2)", data)) == "the array has 2 columns: state which, by its number from 1");
    CHECK(message(npy("<f8", "(3, 2)", data), "3") == "column '3' is not one of the array's 2, counted from 1");
    CHECK(message(npy("<f8", "(3, 2)", data), "x") == "column 'x' is not one of the array's 2, counted from 1");
    CHECK(message(npy("<f8", "()", data)) == "the array has 0 dimensions; one or two are read");
    CHECK(message(npy("<f8", "(1, 2, 3)", data)) == "the array has 3 dimensions; one or two are read");
    CHECK(message(npy("<f8", "(3, 0)", data)) == "the array has 0 columns; 1 to 65536 are read");
    for (const char* const shape : {"(-6,)", "(6.0,)", "(2 3)", "(6L,)", "(,)", "6", "(99999999999999999999,)"})
      CHECK_MESSAGE(message(npy("<f8", shape, data)).find("is not a shape of an array") != std::string::npos, shape);
    for (const char* const type : {"|b1", ">f4", "<f2", "<c16", "|S8", "|O"})
      CHECK(message(npy(type, "(6,)", data)).find("float64 and float32, little-endian, are read") != std::string::npos);
    CHECK(message(npy("<f8", "(7,)", data)) == "byte 176: the file ends after 6 of 7 rows");
    CHECK(message(npy("<f8", "(7,)", data + "abc")) == "byte 179: the file ends after 6 of 7 rows");
  }

  TEST_CASE("plain numbers in the byte order of the machine") {
    Series values;
    for (int i = 0; i < 50000; ++i) values.push_back(0.5 * i);
    const std::vector<float> floats{1.5F, -2.0F};
    CHECK(binary(Format::f64, bytes_of(values)).values == values);
    CHECK(binary(Format::f32, bytes_of(floats)).values == Series{1.5, -2});
    CHECK(binary(Format::f64, "").values.empty());
    const Read cut = binary(Format::f64, bytes_of(values) + "1234");
    CHECK(cut.message == "byte 400004: the file ends within a number of 8 bytes");
    CHECK(cut.at == 400004);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      values[40000] = bad;
      const Read refused = binary(Format::f64, bytes_of(values));
      CHECK(refused.message == "byte 320000: value 40001 is not a finite number");
      CHECK(refused.at == 320000);
    }
  }

  TEST_CASE("any bytes are read, or refused with a message, and never as NaN") {
    const std::string text = "# t;F\nt;\"F;x\"\n1;2.5\n2; -3e2\n\n3;7\n",
                      array = npy("<f8", "(2, 2)", bytes_of(Series{1, 2, 3, 4}));
    std::mt19937 random(9);
    for (int i = 0; i < (test::sanitized ? 4000 : 20000); ++i) {
      const bool is_text = i % 2 == 0;
      std::string bytes = is_text ? text : array;
      for (int k = static_cast<int>(random() % 4); k >= 0; --k)
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      bytes.resize(bytes.size() - random() % 8);
      const Read result = is_text ? csv(bytes, i % 4 == 0 ? "F;x" : "2") : binary(Format::npy, bytes, "2");
      for (const double x : result.values) REQUIRE(std::isfinite(x));
    }
  }

  TEST_CASE("a history is counted as it is read") {
    std::string text = "t;sigma\n";
    Series history;
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
      history.push_back(static_cast<double>(random() % 1000) / 8.0);
      text += std::to_string(i) + ';' + std::to_string(history.back()) + '\n';
    }
    CycleList read_ones, known_ones;
    Counter of_read({}, read_ones), of_known({}, known_ones);
    const auto reader = read_series(std::make_unique<Bytes>(text), {.column = "sigma", .separator = {}});
    REQUIRE(reader);
    for (auto part = (*reader)->next(); part && !part->empty(); part = (*reader)->next()) REQUIRE(!of_read.feed(*part));
    REQUIRE(!of_known.feed(history));
    of_read.finish(), of_known.finish();
    CHECK(of_read.samples() == 20000);
    REQUIRE(read_ones.cycles().size() == known_ones.cycles().size());
    for (std::size_t i = 0; i < known_ones.cycles().size(); ++i) {
      CHECK(read_ones.cycles()[i].range == known_ones.cycles()[i].range);
      CHECK(read_ones.cycles()[i].mean == known_ones.cycles()[i].mean);
    }
  }

  TEST_CASE("files are opened, and errors are reported with the reason") {
    const test::Desk desk;
    const auto path = desk.folder() / "series.csv";
    std::ofstream(path) << "x\n1\n2\n";
    auto source = open_source(path.string());
    REQUIRE(source);
    CHECK(read(std::move(*source), {}).values == Series{1, 2});
    std::filesystem::remove(path);
    CHECK(open_source(path.string()).fault().message.text() ==
          "'" + path.string() + "' cannot be read: No such file or directory");
    CHECK(open_source("/").fault().message.text() == "'/' cannot be read: Is a directory");
    CHECK(open_source("-"));
  }

  TEST_CASE("the extension gives the format") {
    CHECK(format_of("loads.csv") == Format::csv);
    CHECK(format_of("a.b/loads.npy") == Format::npy);
    CHECK(format_of("x.f32") == Format::f32);
    CHECK(format_of("x.f64") == Format::f64);
    CHECK(!format_of("loads"));
    CHECK(!format_of("-"));
  }
}
