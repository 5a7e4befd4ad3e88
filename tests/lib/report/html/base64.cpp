#include "lib/report/html/base64.hpp"

#include <doctest/doctest.h>

using loadpath::report::base64;

TEST_SUITE("report") {
  TEST_CASE("the test vectors of RFC 4648 are reproduced") {
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe\x00" + std::string()) == "//4=");
  }
}
