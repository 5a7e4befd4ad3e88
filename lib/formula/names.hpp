// The meanings of the names of the language: constants, units of the C++ formulas, and symbols with their subscripts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::formula {

/// The SI value of pi or of a unit: mm, N_m.
std::optional<double> constant(std::string_view name);

/// The unit that a name of the C++ formulas is, as its text ("N*m" for N_m), or nothing.
std::string_view unit_named(std::string_view name);

/// "kg·m²/s" falls into "kg·m" raised to "2" and "/s".
struct UnitRun {
  std::string letters;
  std::string exponent;  // "−1"; may be empty
};
std::vector<UnitRun> unit_runs(std::string_view pretty);

/// The 3 of "pow<3>".
int template_number(std::string_view function);

struct Greek {
  std::string_view name;
  std::string_view letter;
  std::string_view tex;
};

/// A run of letters or digits that is set in one face.
struct Glyphs {
  std::string text;  // ASCII
  const Greek* greek = nullptr;
  bool italic = false;

  [[nodiscard]] std::string letters() const { return greek != nullptr ? std::string(greek->letter) : text; }
};
using Word = std::vector<Glyphs>;

/// tau_adm_1: τ with the subscripts "adm" and "1". D_star: D with a raised star.
struct Symbol {
  Glyphs base;
  std::vector<Word> subscripts;
  bool star = false;
};
Symbol symbol(std::string_view name);

}  // namespace loadpath::formula
