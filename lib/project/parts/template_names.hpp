// Templates that a wrong word of a project can have been meant for.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// "did you mean 'slider_crank'?" for "slider_cranc" and "crank_slider"; else all of them.
Message template_near(const std::string& id, const std::vector<std::string>& ids);

/// How to use the template that was named as a calculator, "mechanism.slider_crank"; empty if it is none.
Message template_meant(const std::string& id, Catalogue catalogue);

/// Parameters of templates in a step that names none: one error names the templates, in place of those about the
/// unknown keys and the missing inputs. `before`: the number of issues before the step was read.
void name_templates(const StepInput& input, std::size_t before, std::vector<Issue>& issues);

}  // namespace loadpath::project
