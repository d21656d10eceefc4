#include "core/results/class_page.hpp"

#include "core/calls/plain_json.hpp"
#include "core/report/page_base_css.hpp"
#include "core/report/page_parts.hpp"
#include "core/report/page_tools_js.hpp"
#include "core/results/class_page_html.hpp"
#include "core/results/results_base_css.hpp"
#include "core/results/results_base_js.hpp"

namespace raylab {

std::string class_page(const ClassResults& results, const std::vector<RosterEntry>& roster, const Seconds& seconds) {
  const auto [head, after_style] = split(class_page_html, "{{style}}");
  const auto [markup, after_data] = split(after_style, "{{data}}");
  const auto [module, script] = split(after_data, "{{script}}");
  const std::string data = to_json(summary_of(results, roster, seconds));
  std::string page(head);
  for (const std::string_view css : {page_base_css, results_base_css}) page += css;
  page += markup;
  page += script_json(nlohmann::ordered_json::parse(data));
  for (const std::string_view js : {module, page_tools_js, results_base_js, script}) page += js;
  return page;
}

}  // namespace raylab
