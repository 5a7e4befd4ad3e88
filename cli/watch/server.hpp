// One page for the browser of the user who runs the program: on the loopback address only, behind a random word for
// each run.
#pragma once

#include "cli/watch/page.hpp"

#include <boost/asio/io_context.hpp>

#include <memory>
#include <string>

namespace loadpath::cli {

class Server {
 public:
  /// Listens on 127.0.0.1, at a free port where it is 0. Throws boost::system::system_error where that port is taken.
  Server(boost::asio::io_context& context, unsigned short port);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// "http://127.0.0.1:41235/6b1f.../"
  [[nodiscard]] std::string address() const;
  /// Shows a revision to every page that is open, and to those that are opened later.
  void publish(Revision revision);

  struct State;  // common to its connections

 private:
  std::shared_ptr<State> state_;
};

}  // namespace loadpath::cli
