// The single list of fields that a calculator declares. The meaning of each member of its Input and Result, its unit,
// its bounds and its part (input, result, check, limit) are stated here once; readers, reports and tests follow from
// it.
//
// All numbers given to a Field (bounds, plausible range) are in the field's own unit.
#pragma once

#include "lib/calculator/fields.hpp"
#include "lib/calculator/list.hpp"
#include "lib/calculator/varying.hpp"
#include "lib/quantity/whole.hpp"

#include <limits>
#include <optional>
#include <utility>

namespace loadpath {

struct FieldFault;

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] constexpr bool holds(double x) const {
    return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
  }
  [[nodiscard]] constexpr Range times(double factor) const {
    return {low * factor, high * factor, low_open, high_open};
  }
};

/// The key of a field whose member has another name because its symbol is in use in C++: a mass, which collides with
/// the unit m. Any other difference between key and member is a mistake, and fails a test.
constexpr const char* called(const char* key) { return key; }

/// The possible source of an input that the user does not type.
struct Provider {
  enum class Kind { none, table, companion };
  Kind kind = Kind::none;
  const char* table = "";          // table: "material", also the key of the step that names the row
  const char* column = "";         // table: "R_e"; companion: the input whose source also gives this value ("T")
  const char* size = "";           // table: the result or input that the value depends on ("d")
  const char* unless = "";         // table: the value is not needed where this input is given
  bool may_be_incomplete = false;  // table: rows without the column leave the input as it is
};

/// The words of a choice. Specialise `choices_of` for the enum class.
template <class Enum>
struct ChoiceName {
  Enum value;
  const char* key;
  const char* doc;
  const char* also = "";  // another word for it that is accepted
};

/// The declared words of this value of a choice.
template <class Enum>
constexpr ChoiceName<Enum> choice_of(Enum value) {
  for (const auto& choice : choices_of(value)) {
    if (choice.value == value) return choice;
  }
  return {value, "", ""};
}
/// The word of a project for it.
template <class Enum>
constexpr const char* word_of(Enum value) {
  return choice_of(value).key;
}

/// A quantity or number of an Input or Result. A member of an Input may be Varying, which takes an entire series.
template <class Owner, class Quantity, class Member = Quantity>
struct Field : detail::Described<Field<Owner, Quantity, Member>> {
  using Base = detail::Described<Field<Owner, Quantity, Member>>;
  Member Owner::*at;
  Unit<Quantity> unit;
  Range bounds;     // outside: refused (input), not covered (limit)
  Range plausible;  // outside: a warning
  Range customary;  // input: see customarily_at_least
  Provider provider;
  const char* asked_by = "";         // check or limit: exists only where one of these inputs is given ("N, P")
  bool infinite = false;             // input: a plain number that may be typed as inf
  bool where_set = false;            // check or limit: exists only where the calculator gives it a value
  bool is_criterion = false;         // limit: outside its bounds the part fails
  bool is_sizeless = false;          // check, limit: no size that is searched for changes it
  const char* searched_in = "";      // input: where missing, the smallest value of this stock that passes every check
  bool sought_unasked = false;       // input: searched for where it is missing, too, not only where it is "?"
  bool is_own = false;               // input: no record fills it
  const char* most_of_source = "";   // input: see at_most_that_of_source
  const char* least_of_source = "";  // input: see at_least_that_of_source
  const char* near_source = "";      // input: see near_that_of_source
  const char* made_for = "";         // input: see made_for_same
  bool larger_is_better = false;     // input: "?" is the largest value that passes
  bool kept = false;                 // input: where missing in a search, the result of the same key of the sizing run
  const char* companions = "";       // loads acting together with it on the same part: further keys, "F_t, F_r"
  bool signed_load = false;          // input: its sign decides, so that a magnitude is not an acceptable value
  const char* factors = "";          // result: inputs that it holds already, so that none may apply them again: "K_A"
  bool is_factor = false;   // input: raises a load or lowers a strength; the report lists where each is applied
  bool is_peak = false;     // result: a load of a start or a jam, with k_max of its step
  bool is_of_step = false;  // input: see of_a_step

  constexpr Field(Member Owner::*member, const char* k, Unit<Quantity> u, const char* d)
      : Base{k, d}, at{member}, unit{u} {}

  [[nodiscard]] constexpr Field within(double low, double high) const { return bounded({low, high, false, false}); }
  [[nodiscard]] constexpr Field positive() const { return bounded({0.0, bounds.high, true, bounds.high_open}); }
  [[nodiscard]] constexpr Field at_least(double low) const {
    return bounded({low, bounds.high, false, bounds.high_open});
  }
  [[nodiscard]] constexpr Field below(double high) const { return bounded({bounds.low, high, bounds.low_open, true}); }
  [[nodiscard]] constexpr Field usually(double low, double high) const {
    Field f = *this;
    f.plausible = {low, high, false, false};
    return f;
  }
  /// The minimum of common practice, of a required safety factor; a smaller value needs a justification, whether or not
  /// a check would pass without it.
  [[nodiscard]] constexpr Field customarily_at_least(double low) const {
    Field f = *this;
    f.customary.low = low;
    return f;
  }
  /// The maximum of common practice, of an allowable stress or speed; a larger value needs a justification.
  [[nodiscard]] constexpr Field customarily_at_most(double high) const {
    Field f = *this;
    f.customary.high = high;
    return f;
  }
  /// A result of the calculation of another part; a value that no step calculates needs a justification.
  [[nodiscard]] constexpr Field of_a_step() const {
    Field f = *this;
    f.is_of_step = true;
    return f;
  }
  /// From the row of a table that the step names (`material = "C45E"`), at the size given by another field.
  [[nodiscard]] constexpr Field from(const char* table, const char* column, const char* size = "",
                                     const char* unless = "") const {
    return provided({Provider::Kind::table, table, column, size, unless, false});
  }
  /// From a row that may have no such column at any size: the input then stays as if no row were named.
  [[nodiscard]] constexpr Field where_it_has() const {
    Field f = *this;
    f.provider.may_be_incomplete = true;
    return f;
  }
  /// A load component of the source of another input: for a driving moment, the force on its joint.
  [[nodiscard]] constexpr Field coming_with(const char* input) const {
    return provided({Provider::Kind::companion, "", input, "", "", false});
  }
  [[nodiscard]] constexpr Field check(const char* input = "") const {
    Field f = this->as(Role::check);
    f.asked_by = input;
    return f;
  }
  [[nodiscard]] constexpr Field limit(double low, double high, const char* input = "") const {
    Field f = within(low, high).as(Role::limit);
    f.asked_by = input;
    return f;
  }
  /// A limit that is itself the criterion: zero tip clearance is a failure, not a gap in the method.
  [[nodiscard]] constexpr Field criterion() const {
    Field f = *this;
    f.is_criterion = true;
    return f;
  }
  /// A check or limit that no size changes which is searched for, of the loads or of another part: where one fails it,
  /// all do.
  [[nodiscard]] constexpr Field sizeless() const {
    Field f = *this;
    f.is_sizeless = true;
    return f;
  }
  /// A plain number whose infinity means something: the ratio of a stress cycle that ends in zero.
  [[nodiscard]] constexpr Field may_be_infinite() const {
    Field f = *this;
    f.infinite = true;
    return f;
  }
  /// A check or limit that concerns some inputs only: the calculator leaves it unset for the others.
  [[nodiscard]] constexpr Field where_it_applies() const {
    Field f = *this;
    f.where_set = true;
    return f;
  }
  /// A size that is searched for where it is missing, and where it is "?".
  [[nodiscard]] constexpr Field searched(const char* stock) const {
    Field f = findable(stock);
    f.sought_unasked = true;
    return f;
  }
  /// A size that can be searched for: "?".
  [[nodiscard]] constexpr Field findable(const char* stock) const {
    Field f = *this;
    f.searched_in = stock;
    return f;
  }
  /// An input of this part only, even if a record has the same key: the diameter of the shaft under a gear.
  [[nodiscard]] constexpr Field own() const {
    Field f = *this;
    f.is_own = true;
    return f;
  }
  /// At most the largest of these dimensions of the step that values are taken from, "d, d_max"; a larger value needs
  /// a justification.
  [[nodiscard]] constexpr Field at_most_that_of_source(const char* keys) const {
    Field f = *this;
    f.most_of_source = keys;
    return f;
  }
  /// Not smaller than that of the step that values are taken from; a smaller value needs a justification. "rho?p_i":
  /// p_i there, if rho is given here.
  [[nodiscard]] constexpr Field at_least_that_of_source(const char* keys) const {
    Field f = *this;
    f.least_of_source = keys;
    return f;
  }
  /// That of the step that values are taken from: a value on the unsafe side, whichever that is, needs a justification.
  [[nodiscard]] constexpr Field near_that_of_source(const char* keys) const {
    Field f = *this;
    f.near_source = keys;
    return f;
  }
  /// A value that another step has calculated for a part with these inputs, "l, E, I_y: I" where that calls it
  /// otherwise; those of this step may not be on the unsafe side without a justification.
  [[nodiscard]] constexpr Field made_for_same(const char* keys) const {
    Field f = *this;
    f.made_for = keys;
    return f;
  }
  /// A length, a speed of which "?" is the largest value that passes.
  [[nodiscard]] constexpr Field most() const {
    Field f = *this;
    f.larger_is_better = true;
    return f;
  }
  [[nodiscard]] constexpr Field kept_in_search() const {
    Field f = *this;
    f.kept = true;
    return f;
  }
  /// One component of the load on a part; `keys` are the others, which a step that takes only this one leaves
  /// unassessed. "T_1|T_2": one of them, the torque of the shaft that takes it.
  [[nodiscard]] constexpr Field with(const char* keys) const {
    Field f = *this;
    f.companions = keys;
    return f;
  }
  /// A load whose sign decides: tension or compression.
  [[nodiscard]] constexpr Field keeps_sign() const {
    Field f = *this;
    f.signed_load = true;
    return f;
  }
  /// A load that already includes these factors: a step that takes it must not apply them again.
  [[nodiscard]] constexpr Field holding(const char* keys) const {
    Field f = *this;
    f.factors = keys;
    return f;
  }
  /// A peak load: includes k_max of its step.
  [[nodiscard]] constexpr Field at_peak() const {
    Field f = *this;
    f.is_peak = true;
    return f;
  }
  [[nodiscard]] constexpr Field factor() const {
    Field f = *this;
    f.is_factor = true;
    return f;
  }

 private:
  [[nodiscard]] constexpr Field bounded(Range r) const {
    Field f = *this;
    f.bounds = r;
    return f;
  }
  [[nodiscard]] constexpr Field provided(Provider p) const {
    Field f = this->may_be_missing();
    f.provider = p;
    return f;
  }
};

/// An integer.
template <class Owner>
struct Count : detail::Described<Count<Owner>> {
  Whole Owner::*at;
  int low;
  int high;
  constexpr Count(Whole Owner::*member, const char* k, int least, int most, const char* d)
      : detail::Described<Count<Owner>>{k, d}, at{member}, low{least}, high{most} {}
};

/// A name: of an element, or of something that another part of the input declares.
template <class Owner>
struct NameField : detail::Described<NameField<Owner>> {
  Name Owner::*at;
  const char* searched_in = "";
  constexpr NameField(Name Owner::*member, const char* k, const char* d)
      : detail::Described<NameField<Owner>>{k, d}, at{member} {}
  /// "?": the first kind of the rows of a table group, in the order of their sizes, with which every check passes.
  [[nodiscard]] constexpr NameField findable(const char* group) const {
    NameField f = *this;
    f.searched_in = group;
    return f;
  }
};

/// A quantity as a formula of one variable (lib/quantity/expression/law.hpp): a text that the calculator reads, or one
/// that reads itself.
template <class Owner, class Text>
struct FormulaField : detail::Described<FormulaField<Owner, Text>> {
  Text Owner::*at;
  constexpr FormulaField(Text Owner::*member, const char* k, const char* d)
      : detail::Described<FormulaField<Owner, Text>>{k, d}, at{member} {}
};

/// A choice of a few words; `choices_of(Enum{})` is declared next to the enum class and gives an array of ChoiceName.
template <class Owner, class Enum>
struct Choice : detail::Described<Choice<Owner, Enum>> {
  Enum Owner::*at;
  constexpr Choice(Enum Owner::*member, const char* k, const char* d)
      : detail::Described<Choice<Owner, Enum>>{k, d}, at{member} {}
};

/// A record of another step, "=pick.best", that fills those of the neighbouring fields that are not typed.
template <class Owner>
struct RecordField : detail::Described<RecordField<Owner>> {
  constexpr RecordField(const char* k, const char* d)
      : detail::Described<RecordField<Owner>>{k, d, std::nullopt, true} {}
};

/// A nested aggregate with fields of its own. Positional: may also be written as an array of its first fields.
template <class Owner, class Part>
struct Group : detail::Described<Group<Owner, Part>> {
  Part Owner::*at;
  bool positional = false;
  bool is_handed_over = false;  // result: for other steps to take as a record; shown there, not here
  constexpr Group(Part Owner::*member, const char* k, const char* d)
      : detail::Described<Group<Owner, Part>>{k, d}, at{member} {}
  [[nodiscard]] constexpr Group as_array() const {
    Group g = *this;
    g.positional = true;
    return g;
  }
  [[nodiscard]] constexpr Group handed_over() const {
    Group g = *this;
    g.is_handed_over = true;
    return g;
  }
};

/// A list of aggregates with fields of their own: a List, or a std::vector, which has no bound. An element may carry a
/// NameField "name".
template <class Owner, class Items>
struct ListField : detail::Described<ListField<Owner, Items>> {
  Items Owner::*at;
  bool positional = false;
  Provider provider;
  constexpr ListField(Items Owner::*member, const char* k, const char* d)
      : detail::Described<ListField<Owner, Items>>{k, d}, at{member} {}
  /// The values of a row that the step names at all its sizes, for elements of a size and a value.
  [[nodiscard]] constexpr ListField from_sizes(const char* table, const char* column, const char* unless) const {
    ListField l = this->may_be_missing();
    l.provider = {Provider::Kind::table, table, column, "", unless, true};
    return l;
  }
  [[nodiscard]] constexpr ListField as_arrays() const {
    ListField l = *this;
    l.positional = true;
    return l;
  }
};

/// A rule between fields: alternatives, order, sums, and customs, whose violation only warns. `fields` names them,
/// separated by ", ". `particulars`, if any, adds the details of a violation that the text leaves open: element,
/// amount, remedy. An empty path or message there means that of the rule. A rule that only warns may name the failure
/// modes whose verdicts show it: an assumption in place of an input.
template <class Input>
struct Rule {
  bool (*holds)(const Input&);
  const char* fields;
  const char* text;
  FieldFault (*particulars)(const Input&) = nullptr;
  bool only_warns = false;
  const char* modes = "";
};

}  // namespace loadpath
