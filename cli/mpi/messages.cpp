#include "cli/mpi/messages.hpp"

#include <cstring>
#include <stdexcept>

namespace loadpath::cli {

namespace {

using project::BlockRange;
using project::SolvedBlock;

/// Numbers and texts one behind the other; texts and columns as they lie in memory.
class Packer {
 public:
  void put(std::uint64_t number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void put(double number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void put(std::string_view text) {
    put(std::uint64_t{text.size()});
    bytes_.append(text);
  }
  void put(const std::vector<double>& column) {
    put(std::uint64_t{column.size()});
    bytes_.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(double));
  }
  void put(const std::vector<std::vector<double>>& columns) {
    put(std::uint64_t{columns.size()});
    for (const auto& column : columns) put(column);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() { return plain<std::uint64_t>(); }
  double real() { return plain<double>(); }
  std::string_view text() { return cut(number()); }
  std::vector<double> column() {
    std::vector<double> values(count(sizeof(double)));
    const std::string_view from = cut(values.size() * sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), from.data(), from.size());
    return values;
  }
  std::vector<std::vector<double>> columns() {
    std::vector<std::vector<double>> all(count(sizeof(std::uint64_t)));
    for (auto& one : all) one = column();
    return all;
  }
  /// The number of items of at least so many bytes.
  std::size_t count(std::size_t each) {
    const std::uint64_t found = number();
    if (found > bytes_.size() / each) broken();
    return static_cast<std::size_t>(found);
  }
  [[noreturn]] static void broken() { throw std::runtime_error("a message from another rank is broken"); }

 private:
  template <class T>
  T plain() {
    T value;
    std::memcpy(&value, cut(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view cut(std::uint64_t size) {
    if (size > bytes_.size()) broken();
    const std::string_view piece = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(piece.size());
    return piece;
  }

  std::string_view bytes_;
};

void put(Packer& packer, BlockRange blocks) {
  packer.put(blocks.first);
  packer.put(blocks.last);
}

BlockRange blocks_of(Unpacker& unpacker) {
  const std::uint64_t first = unpacker.number();
  return {first, unpacker.number()};
}

}  // namespace

std::string bytes_of(const Order& order) {
  Packer packer;
  packer.put(order.shared.text);
  packer.put(order.shared.identity);
  packer.put(std::uint64_t{order.rows});
  return packer.take();
}

Order order_from(std::string_view bytes) {
  Unpacker unpacker(bytes);
  Order order;
  order.shared.text = unpacker.text();
  order.shared.identity = unpacker.text();
  order.rows = unpacker.number() != 0;
  return order;
}

std::string bytes_of(const Handshake& handshake) {
  Packer packer;
  packer.put(handshake.parts);
  packer.put(handshake.name);
  packer.put(handshake.wrong);
  return packer.take();
}

Handshake handshake_from(std::string_view bytes) {
  Unpacker unpacker(bytes);
  Handshake handshake;
  handshake.parts = unpacker.number();
  handshake.name = unpacker.text();
  handshake.wrong = unpacker.text();
  return handshake;
}

std::string bytes_of(BlockRange blocks) {
  Packer packer;
  put(packer, blocks);
  return packer.take();
}

BlockRange blocks_from(std::string_view bytes) {
  Unpacker unpacker(bytes);
  return blocks_of(unpacker);
}

std::string bytes_of(const Solved& solved) {
  Packer packer;
  put(packer, solved.part.blocks);
  packer.put(solved.seconds);
  sweep::Writer writer;
  solved.part.found.store(writer);
  packer.put(writer.bytes());
  packer.put(std::uint64_t{solved.part.rows.size()});
  for (const SolvedBlock& block : solved.part.rows) {
    packer.put(block.first);
    packer.put(std::uint64_t{block.count});
    packer.put(block.inputs);
    packer.put(block.results);
  }
  return packer.take();
}

Solved solved_from(std::string_view bytes, const project::SweepStatistics& none) {
  Unpacker unpacker(bytes);
  Solved solved;
  solved.part.blocks = blocks_of(unpacker);
  solved.seconds = unpacker.real();
  solved.part.found = none;
  sweep::Reader reader(unpacker.text());
  solved.part.found.load(reader);
  if (reader.failed() || !reader.at_end()) Unpacker::broken();
  solved.part.rows.resize(unpacker.count(sizeof(std::uint64_t)));
  for (SolvedBlock& block : solved.part.rows) {
    block.first = unpacker.number();
    block.count = static_cast<std::size_t>(unpacker.number());
    block.inputs = unpacker.columns();
    block.results = unpacker.columns();  // the results count refusals
  }
  return solved;
}

}  // namespace loadpath::cli
