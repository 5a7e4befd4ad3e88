// Names and values of inputs and results in few words.
#pragma once

#include "lib/account/account.hpp"
#include "lib/project/project.hpp"
#include "lib/report/document.hpp"

#include <string>
#include <string_view>

namespace loadpath::report {

/// The description up to its first condition: "service factor of the basis"; of an element after its name.
std::string short_name(const account::Entry& entry);
/// Names of Greek letters as letters: "stress ratio σ_min/σ_max".
std::string with_greek(std::string_view words);
/// The symbol of a path as text: "K_A" of "K_A", "d" of "pieces.seat.d".
std::string short_symbol(const std::string& path);
/// The value with few digits: "11 kW", "13.75 kN"; of a series the value of the largest magnitude.
std::string short_value(const account::Entry& entry);
/// The origin with the key of its source: "given", "default", "from gears", "C45E [Lucefin-C45E]".
std::string short_origin(const account::Entry& entry);
/// Whether the value is a result or an input of another step, or is computed from one.
bool comes_from_step(const account::Entry& entry);
/// The title of a component's only step without its article: "Locating bearing, 6209" of "left"; the name if the title
/// is longer than that or not unique, or several steps are one component.
std::string titled(const project::Project& project, const std::string& component, double most_letters);
/// A text that is not broken between lines.
std::string unbroken(std::string text);

}  // namespace loadpath::report
