// The shapes of the protocol in JSON.
#pragma once

#include "cli/lsp/completion.hpp"
#include "cli/lsp/diagnostics.hpp"
#include "cli/lsp/hints.hpp"
#include "cli/lsp/hover.hpp"
#include "cli/lsp/symbols.hpp"

#include <boost/json/fwd.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// Numbers defined by JSON-RPC and the protocol.
enum class Fail : int {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  not_initialized = -32002
};

/// Why a request gets an error for an answer.
struct Refusal : std::runtime_error {
  Refusal(Fail fail, const std::string& text) : std::runtime_error(text), code(fail) {}
  Fail code;
};

/// A member of parameters; a Refusal if there is none of the type.
const boost::json::object& object_in(const boost::json::object& all, std::string_view key);
const boost::json::array& array_in(const boost::json::object& all, std::string_view key);
std::string text_in(const boost::json::object& all, std::string_view key);
Position position_in(const boost::json::object& all, std::string_view key);
Range range_in(const boost::json::object& all, std::string_view key);

boost::json::object to_json(const Range& range);
boost::json::array to_json(const std::vector<Diagnostic>& all);
boost::json::value to_json(const std::optional<Hover>& hover);
boost::json::object to_json(const Completions& completions, bool with_snippets);
boost::json::array to_json(const std::vector<Hint>& hints);
boost::json::array to_json(const std::vector<Symbol>& symbols);

}  // namespace loadpath::cli::lsp
