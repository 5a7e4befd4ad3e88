// Makes the erased Calculator of a calculator class. Included by the source of each calculator.
//
//   struct SolidShaft {
//     static constexpr auto id = "...", title = "...", scope = "...", source = "...", synonyms = "...", example =
//     "..."; static constexpr auto headline = "C = {C}", subject = "rating life";  // the second may be left out struct
//     Input { ... };  struct Result { ... }; static constexpr Fields inputs{Field{...}...}, results{Field{...}...};
//     static constexpr std::array rules{Rule<Input>{...}...};
//     static constexpr std::array modes{Mode<Input>{...}...};  // in which its part can fail
//     template <class Tracer> static Result evaluate(const Input&, Tracer&);   // defined in the source
//     static constexpr std::array forms{Form{"T, tau_adm"}};   // that sweeps are compiled for (form.hpp)
//     static constexpr bool is_inlined = true;                 // sweeps inline evaluate: longer to compile
//     static constexpr bool takes_series = false;              // where it decides on one thing for all its loads
//     static constexpr bool turns = true;                      // of a part that turns
//     static constexpr auto sized = "pieces";                  // a list whose sizes are found together; with
//                                                              // arrange, raise, cost, place, unsound (sizing.hpp)
//     static constexpr std::array notch_claims{NotchClaim{...}...};  // stresses at a notch, limits for one
//     static constexpr std::array senses{SenseClaim{...}...};  // inputs that state whether a load reverses
//     static constexpr std::array meanings{Meaning{...}...};   // meanings of values of like dimension
//     static constexpr std::array bounds{Bound<Input>{...}...};  // bounds of typed inputs
//     static std::vector<figure::Figure> figures(const Input&, const Result&);
//   };
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record_of.hpp"
#include "lib/calculator/survey_of.hpp"
#include "lib/calculator/sweep_of.hpp"

namespace loadpath {

namespace detail {

template <class C>
inline constexpr auto rule_infos = [] {
  std::array<RuleInfo, C::rules.size()> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i)
    infos[i] = {C::rules[i].fields, C::rules[i].text, C::rules[i].only_warns, C::rules[i].modes};
  return infos;
}();

template <class Input>
FieldFault fault_of(const Rule<Input>& rule, const Input& in) {
  FieldFault fault = rule.particulars == nullptr ? FieldFault{} : rule.particulars(in);
  if (fault.message.empty()) fault.message = say(rule.text);
  return fault;
}

template <class C>
constexpr Sizing sizing_of() {
  using Input = typename C::Input;
  return {C::sized,
          [](const void* in, std::span<OpenSize> all, std::size_t way) {
            return C::arrange(*static_cast<const Input*>(in), all, way);
          },
          [](const void* in, std::span<OpenSize> all) { return C::raise(*static_cast<const Input*>(in), all); },
          [](const void* in) { return C::cost(*static_cast<const Input*>(in)); },
          [](const void* in, std::string_view list, const void* element) {
            return C::place(*static_cast<const Input*>(in), list, element);
          },
          [](const void* in, std::span<const OpenSize> all, std::size_t which) {
            return C::unsound(*static_cast<const Input*>(in), all, which);
          }};
}

}  // namespace detail

template <class C>
constexpr Calculator calculator_of() {
  using Input = typename C::Input;
  using Result = typename C::Result;
  Calculator c;
  c.id = C::id;
  c.title = C::title;
  c.scope = C::scope;
  c.synonyms = C::synonyms;
  c.source = C::source;
  c.example = C::example;
  if constexpr (requires { C::headline; }) c.headline = C::headline;
  if constexpr (requires { C::details; }) c.details = C::details;
  if constexpr (requires { C::subject; }) c.subject = C::subject;
  c.input = &record_type<Input, C::inputs>;
  c.result = &record_type<Result, C::results, Role::result>;
  c.rules = detail::rule_infos<C>;
  c.holds = [](std::size_t rule, const void* in) { return C::rules[rule].holds(*static_cast<const Input*>(in)); };
  c.fault_of = [](std::size_t rule, const void* in) {
    return detail::fault_of(C::rules[rule], *static_cast<const Input*>(in));
  };
  if constexpr (requires { C::modes; }) {
    c.modes = mode_infos<C>;
    c.applies = &applies_of<C>;
  }
  c.evaluate = [](const void* in, void* out) {
    NoTrace trace;
    *static_cast<Result*>(out) = C::evaluate(*static_cast<const Input*>(in), trace);
  };
  c.explain = [](const void* in, void* out, Trace& trace) {
    *static_cast<Result*>(out) = C::evaluate(*static_cast<const Input*>(in), trace);
  };
  if constexpr (requires(const Input& in, const Result& out) { C::figures(in, out); }) {
    c.figures = [](const void* in, const void* out) {
      return C::figures(*static_cast<const Input*>(in), *static_cast<const Result*>(out));
    };
  }
  if constexpr (requires { C::forms; }) c.forms = C::forms;
  c.survey = &detail::survey<C>;
  c.loop = &detail::loop_of<C>;
  c.sweep = [](void* in, std::span<const InputColumn> columns, std::span<const ResultColumn> out, std::size_t count) {
    detail::loop_of<C>(in, columns, out)(in, columns, out, count);
  };
  if constexpr (requires { C::sized; }) c.sizing = detail::sizing_of<C>();
  if constexpr (requires(const Input& in) { C::amount(in); })
    c.sizing.cost = [](const void* in) { return C::amount(*static_cast<const Input*>(in)); };
  if constexpr (requires { C::meanings; }) c.meanings = C::meanings;
  if constexpr (requires { C::senses; }) c.senses = C::senses;
  if constexpr (requires { C::notch_claims; }) c.notches = C::notch_claims;
  if constexpr (requires { C::bounds; }) {
    c.bounds = bound_infos<C>;
    c.bound = [](std::size_t i, const void* in, std::size_t element) {
      return C::bounds[i].at(*static_cast<const Input*>(in), element);
    };
  }
  if constexpr (requires { C::takes_series; }) c.takes_series = C::takes_series;
  if constexpr (requires { C::turns; }) c.turns = C::turns;
  if constexpr (requires { C::is_one_drive; }) c.is_one_drive = C::is_one_drive;
  if constexpr (requires { C::life; }) c.life = C::life;
  if constexpr (requires { C::has_flanks; }) c.has_flanks = C::has_flanks;
  return c;
}

template <class C>
const Calculator& erased() {
  static constexpr Calculator calculator = calculator_of<C>();
  return calculator;
}

}  // namespace loadpath
