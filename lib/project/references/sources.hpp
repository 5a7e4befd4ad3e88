// Quantities that a step and the steps it takes values from have in common: teeth of a stage, diameter of a shaft,
// pressure in a vessel. lib/project/run compares them.
#pragma once

#include "lib/project/step.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

struct Project;

/// A step that values are taken from, and the element of its list.
struct Source {
  std::string step;
  std::string
      place;  // index: "2" in "train.shafts[2].T"; empty if several are named, or the last is left: "train.P_out"
  bool is_assumed = false;                      // no reference names a place: "1"
  std::map<std::string, std::string> elements;  // of lists by name: joints -> "B" in "press.joints.B.F"
};
std::vector<Source> sources_of(const Reading& reading);

/// The names of all steps that it refers to, and of those that loads and records come from.
std::set<std::string> steps_named_in(const Reading& reading);
std::set<std::string> steps_loading(const Reading& reading);

/// The path of a key there, in which '#' is the place, "stages[#].z_1", or the name of an element, "joints.#.omega";
/// empty if that is unknown.
std::string path_in(const Source& source, std::string key);

/// The same source with all places that it may mean, the assumed one first.
std::vector<Source> alternatives(const Source& source);
/// The same source with every place of its lists.
std::vector<Source> places_of(const Source& source);

/// How a field compares with those of the sources (lib/calculator/field.hpp).
enum class Comparison { same, at_most, at_least, near };
struct ComparedKeys {
  Comparison comparison;
  const char* keys;
};

/// The keys that a field has there; empty if it is not compared.
std::vector<ComparedKeys> keys_in_sources(const FieldInfo& field);

/// The keys of such a list; of those with a condition, "rho?p_i" or "!rho?p_i", only where this input is given or not.
std::vector<std::string> keys_where_given(const char* list, const Record& record);

/// The inputs that a value of another step is made for: here, and there ("I_y", "I").
std::vector<std::pair<std::string, std::string>> inputs_made_for(const FieldInfo& field);

/// The path of the ratio by which a load that is a magnitude reverses its direction, next to it.
std::string path_of_reversal(const std::string& load);

/// Paths in other steps that inputs of this one are compared with: of records that have them too, and of sources.
void for_each_compared(const StepInput& step, const std::function<void(const std::string& path)>& visit);

/// The material of a step, typed or taken from another step; empty if it has none.
std::string named_material(const Step& step, const Project& project);

}  // namespace loadpath::project
