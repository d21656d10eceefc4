#include "core/results/student_page.hpp"

#include "core/calls/plain_json.hpp"
#include "core/image/base64.hpp"
#include "core/report/page_base_css.hpp"
#include "core/report/page_parts.hpp"
#include "core/report/page_tools_js.hpp"
#include "core/report/page_views_css.hpp"
#include "core/report/page_views_js.hpp"
#include "core/results/counted.hpp"
#include "core/results/results_base_css.hpp"
#include "core/results/results_base_js.hpp"
#include "core/results/shown.hpp"
#include "core/results/student_page_html.hpp"
#include "core/scene/read_file.hpp"

#include <algorithm>

namespace raylab {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool stays_inside(const fs::path& path) {
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

/// A PNG file as the address of an <img>; empty if there is none.
std::string data_uri(const fs::path& folder, const std::string& name) {
  constexpr std::uintmax_t most_bytes = 64U << 20U;
  if (name.empty() || !stays_inside(name)) return "";
  const FileText file = read_file(folder / name, most_bytes);
  if (!file.text || !file.text->starts_with("\x89PNG\r\n\x1a\n")) return "";
  return "data:image/png;base64," + base64(*file.text);
}

void embed_images(SubmissionResult& submission, const fs::path& folder) {
  for (StageResult& stage : submission.stages)
    for (ImageResult& image : stage.images)
      for (std::string* const file : {&image.image, &image.reference, &image.heat}) *file = data_uri(folder, *file);
}

/// The data of the page: what the student may see, with the sums of what is hidden.
Json data_of(const SubmissionResult& submission, const fs::path& folder) {
  SubmissionResult shown = shown_to_student(submission);
  embed_images(shown, folder);
  Json data = Json::parse(to_json(shown));
  data["newRunNote"] = new_run_note;
  data["needsNewRun"] = needs_new_run(submission);
  for (std::size_t i = 0; i < shown.stages.size(); ++i)
    data["stages"][i]["course"] = Json::parse(to_json(hidden_points(submission.stages[i])));
  return data;
}

}  // namespace

std::string student_page(const SubmissionResult& submission, const fs::path& folder) {
  const auto [head, after_style] = split(student_page_html, "{{style}}");
  const auto [markup, after_data] = split(after_style, "{{data}}");
  const auto [module, script] = split(after_data, "{{script}}");
  std::string page(head);
  for (const std::string_view css : {page_base_css, page_views_css, results_base_css}) page += css;
  page += markup;
  page += script_json(data_of(submission, folder));
  page += module;
  for (const std::string_view js : {page_tools_js, page_views_js, results_base_js}) page += js;
  return page += script;
}

}  // namespace raylab
