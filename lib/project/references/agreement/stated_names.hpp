// The words of a name of [values]: "T_start" is a torque at a start, "p_ext" an external pressure.
#pragma once

#include "lib/project/project.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace loadpath::project {

/// Whether one of the words between its underscores is among these, in small or capital letters.
bool has_word(std::string_view name, std::initializer_list<std::string_view> words);

/// Whether all of them are.
bool has_only_words(std::string_view name, std::initializer_list<std::string_view> words);

/// Whether a name means a peak: of a start, a jam, a shock.
bool is_of_peak(std::string_view name);

/// Whether a name means a limit, a capacity or another state than that of service: "F_adm", "T_idle", "P_motor".
bool is_of_other_state(std::string_view name);

/// Whether a word is in the name or the title of a step, or names an element of its lists: "punch" of "Flywheel of a
/// punch".
bool is_named(const Step& step, std::string_view word);

/// Whether the word is in the title of the project, or in the name or title of one of its steps.
bool is_named(const Project& project, std::string_view word);

/// Whether the last word of a name is a part of this machine, by the names and titles of the file, or its design load:
/// "P_fan" of a "V-belt drive of a fan", "N_Ed". Those of other states are not.
bool is_of_machine(std::string_view name, const Project& project);

/// The factors of the step, K_A and gamma_F, that a design load of this name includes: "P_design", "F_Ed"; 1 of others.
double factors_included(std::string_view name, const Step& step, const Project& project);

/// Whether a name means a speed above that of service: "n_over", "n_trip".
bool is_of_overspeed(std::string_view name);

/// Whether a name means a vacuum or an external pressure: "p_vac", "vacuum", "p_ext".
bool is_of_vacuum(std::string_view name);

/// Whether a name means a required life: "life", "service_life", "L_req".
bool is_of_life(std::string_view name);

/// "values.S_D = 1.8 acts on no step, and S is 1.5 here", for the input under this key.
ReducedLoad not_taken(const std::string& name, const std::string& stated, const std::string& key,
                      const std::string& here);

}  // namespace loadpath::project
