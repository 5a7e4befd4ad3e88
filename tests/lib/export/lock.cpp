// The lock of a folder of a sweep: one writer, and a look at its progress never turns a writer away.
#include "lib/export/sweep/lock.hpp"

#include "tests/cli/process.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <fstream>
#include <string>
#include <thread>
#include <unistd.h>

using loadpath::exports::FolderLock;

TEST_SUITE("lock of a folder") {
  TEST_CASE("one writer at a time, in the same process too, and its name") {
    const loadpath::test::Desk desk;
    CHECK(!FolderLock::writer_of(desk.folder()));
    {
      const auto first = FolderLock::to_write(desk.folder());
      REQUIRE(first);
      CHECK(!FolderLock::to_write(desk.folder()));
      CHECK(!FolderLock::to_read(desk.folder()));
      const auto writer = FolderLock::writer_of(desk.folder());
      REQUIRE(writer);
      CHECK(writer->message.text().find(std::to_string(::getpid())) != std::string::npos);
    }
    CHECK(!FolderLock::writer_of(desk.folder()));
    CHECK(FolderLock::to_write(desk.folder()));
  }

  TEST_CASE("readers exclude a writer, not each other") {
    const loadpath::test::Desk desk;
    { std::ofstream(desk.folder() / FolderLock::file_name); }
    const auto reader = FolderLock::to_read(desk.folder());
    CHECK(reader);
    CHECK(FolderLock::to_read(desk.folder()));
    CHECK(!FolderLock::to_write(desk.folder()));
    CHECK(!FolderLock::writer_of(desk.folder()));
  }

  TEST_CASE("a thousand writers begin while others look who writes") {
    const loadpath::test::Desk desk;
    std::atomic<bool> ends = false;
    std::thread looks([&] {
      while (!ends) static_cast<void>(FolderLock::writer_of(desk.folder()));
    });
    int refused = 0;
    for (int i = 0; i < 1000; ++i) refused += !FolderLock::to_write(desk.folder());
    ends = true;
    looks.join();
    CHECK(refused == 0);
  }
}
