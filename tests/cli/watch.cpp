// `loadpath watch`: what it says, what it serves, and to whom.
#include "tests/browser/browser.hpp"
#include "tests/cli/watching.hpp"
#include "tests/waiting.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <doctest/doctest.h>

using namespace loadpath::test;

namespace {

namespace asio = boost::asio;

const std::string shaft =
    "[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"200 N*m\"\nd = \"40 mm\"\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = shaft;
  return text.replace(text.find(from), from.size(), to);
}

/// As many editors save: a half-written file is never visible.
void save(const Desk& desk, const std::string& name, const std::string& text) {
  desk.put(name + ".new", text);
  std::filesystem::rename(desk.folder() / (name + ".new"), desk.folder() / name);
}

std::string port_of(const std::string& address) { return address.substr(17, address.find('/', 17) - 17); }
std::string path_of(const std::string& address) { return address.substr(address.find('/', 17)); }

/// Answer to a request, as it arrives.
std::string answer(const std::string& address, const std::string& request) {
  asio::io_context context;
  asio::ip::tcp::socket socket(context);
  socket.connect({asio::ip::address_v4::loopback(), static_cast<unsigned short>(std::stoi(port_of(address)))});
  std::string text;
  boost::system::error_code end;  // too long an answer is not read to its end
  asio::write(socket, asio::buffer(request), end);
  asio::read(socket, asio::dynamic_buffer(text), end);
  return text;
}

std::string get(const std::string& address, const std::string& path, const std::string& method = "GET",
                std::string host = "") {
  if (host.empty()) host = "127.0.0.1:" + port_of(address);
  return answer(address, method + " " + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
}

std::string status(const std::string& text) { return text.substr(9, 3); }

}  // namespace

TEST_SUITE("watch") {
  TEST_CASE("every save that changes the file is solved; errors are reported, and the page keeps the last report") {
    const Desk desk;
    desk.put("a.toml", shaft);
    Watching watching(desk, "a.toml");
    const std::string page = path_of(watching.address());
    CHECK(get(watching.address(), page).find("data-news=\"1 solved\"") != std::string::npos);
    save(desk, "a.toml", with("30 MPa", "30 MPaa"));
    CHECK(watching.says("2: cannot be solved"));
    CHECK(get(watching.address(), page + "problem").find("a.toml:3:15: error: unknown unit 'MPaa'") !=
          std::string::npos);
    CHECK(desk.get("errors").find("unknown unit 'MPaa'") != std::string::npos);
    const std::string kept = get(watching.address(), page);
    CHECK(kept.find("data-news=\"2 problem\"") != std::string::npos);
    CHECK(kept.find("<h1>") != std::string::npos);
    save(desk, "a.toml", with("200 N*m", "300 N*m"));
    CHECK(watching.says("3: "));
    std::filesystem::remove(desk.folder() / "a.toml");
    CHECK(watching.says("4: "));
    CHECK(get(watching.address(), page + "problem").find("cannot read 'a.toml'") != std::string::npos);
    save(desk, "a.toml", shaft);
    CHECK(watching.says("5: "));
    CHECK(get(watching.address(), page + "problem").ends_with("\r\n\r\n"));
    desk.put("a.toml", with("200 N*m", "417 N*m"));  // in place: what is half written may be read once
    CHECK(becomes([&] { return get(watching.address(), page).find("417\u00a0N") != std::string::npos; }));
    CHECK(watching.end() == 0);
  }

  TEST_CASE("a file that is saved unchanged is not solved again, and a file that the project reads is watched, too") {
    const Desk desk;
    REQUIRE(desk.shell("cp '" LOADPATH_ROOT "/examples/load-history/'* .").code == 0);
    const Watching watching(desk, "project.toml");
    save(desk, "project.toml", desk.get("project.toml"));
    save(desk, "force.csv", desk.get("force.csv") + "\n");
    CHECK(watching.says("2: "));
    save(desk, "project.toml", desk.get("project.toml") + "# said\n");
    CHECK(watching.says("3: "));
    CHECK(desk.get("said").find("\n4: ") == std::string::npos);
  }

  TEST_CASE("only this machine, only its own page, read-only") {
    const Desk desk;
    desk.put("a.toml", shaft);
    Watching watching(desk, "a.toml");
    const std::string page = path_of(watching.address());
    CHECK(page.size() == 34);
    CHECK(status(get(watching.address(), page)) == "200");
    CHECK(status(get(watching.address(), page, "HEAD")) == "200");
    CHECK(get(watching.address(), page, "HEAD").ends_with("\r\n\r\n"));
    CHECK(status(get(watching.address(), page, "GET", "localhost:" + port_of(watching.address()))) == "200");
    CHECK(status(get(watching.address(), page, "GET", "evil.example")) == "403");
    CHECK(status(get(watching.address(), page, "POST")) == "405");
    for (const std::string& path : {std::string("/"), std::string("/favicon.ico"), page + "../", page + "a.toml",
                                    page.substr(0, 33) + "x/", page.substr(0, 33)})
      CHECK(status(get(watching.address(), path)) == "404");
    CHECK(answer(watching.address(), std::string(100'000, 'x') + "\r\n\r\n").find(" 200 ") == std::string::npos);
    CHECK(status(get(watching.address(), page)) == "200");
    const Desk beside;
    beside.put("a.toml", shaft);
    const Watching another(beside, "a.toml");
    CHECK(path_of(another.address()) != page);
  }

  TEST_CASE("files that cannot be watched") {
    const Desk desk;
    desk.put("a.toml", shaft);
    for (const std::string file : {"-", "no.toml"}) CHECK(desk.run({"watch", file}).code == 2);
    const Watching watching(desk, "a.toml");
    const Ran taken = desk.run({"watch", "a.toml", "--port", port_of(watching.address())});
    CHECK(taken.code == 2);
    CHECK(taken.error.find("cannot listen at port") != std::string::npos);
    CHECK(desk.run({"watch", "a.toml", "--port", "70000"}).code == 2);
  }
}

TEST_SUITE("watch in a browser") {
  TEST_CASE("the open page is updated in place, errors are shown over it, and it shows when the program has ended") {
    if (browser_there().empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    desk.put("a.toml", shaft);
    Watching watching(desk, "a.toml");
    Browser browser;
    browser.look(1280, 400);
    browser.open(watching.address());
    browser.value(
        "window.kept = 1; document.querySelectorAll('details').forEach((d) => { d.open = true; }); "
        "scrollTo(0, 250)");
    save(desk, "a.toml", with("200 N*m", "231 N*m"));
    CHECK(browser.becomes_true("document.querySelector('main').textContent.includes('231')"));
    CHECK(browser.value("window.kept") == 1);  // no page was reloaded
    CHECK(browser.value("scrollY") == 250);
    CHECK(browser.value("[...document.querySelectorAll('details')].every((d) => d.open)") == true);
    save(desk, "a.toml", with("30 MPa", "30 MPaa"));
    CHECK(browser.becomes_true("document.querySelector('#watch').textContent.includes('a.toml:3:15')"));
    CHECK(browser.value("document.querySelector('#watch').checkVisibility()") == true);
    CHECK(browser.value("document.querySelector('main').textContent.includes('231')") == true);
    save(desk, "a.toml", shaft);
    CHECK(browser.becomes_true("!document.querySelector('#watch').checkVisibility()"));
    CHECK(browser.value("document.querySelector('main').textContent.includes('231')") == false);
    watching.end();
    CHECK(browser.becomes_true("document.querySelector('#watch').textContent.includes('has ended')"));
  }

  TEST_CASE("a mechanism stays at its position, and keeps moving") {
    if (browser_there().empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    desk.put("a.toml", Desk().shell("cat '" LOADPATH_ROOT "/examples/slotted-lever/project.toml'").out);
    Watching watching(desk, "a.toml");
    Browser browser;
    browser.look(1280, 800);
    browser.open(watching.address());
    const std::string slider = "document.querySelector('.motion input[type=range]')";
    browser.value(slider + ".value = 5; " + slider + ".dispatchEvent(new Event('input'))");
    const auto moved = browser.value("document.querySelector('.motion').innerHTML.length");
    save(desk, "a.toml", desk.get("a.toml") + "\n# saved\n");
    CHECK(browser.becomes_true("document.getElementById('live') === null"));  // the new page has come
    CHECK(browser.value(slider + ".value") == "5");
    const std::string axis = "document.querySelector('.motion [data-axis]').textContent";
    const auto was = browser.value(axis);
    browser.value(slider + ".value = 9; " + slider + ".dispatchEvent(new Event('input'))");
    CHECK(browser.value(axis) != was);
    CHECK(moved.is_int64());
  }
}
