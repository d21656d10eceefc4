#include "core/submission/workspace.hpp"

#include "core/image/data_folder.hpp"
#include "core/render/stage_table.hpp"
#include "core/submission/stage_files.hpp"

#include <fstream>
#include <functional>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr const char* handbook_docs[] = {"driver.md", "errata.md", "glossary.md", "model.md", "tolerance.md"};

void copy_in(const fs::path& from, const fs::path& to) {
  if (!fs::exists(from)) throw std::runtime_error(from.string() + ": is missing; install raylab again");
  fs::create_directories(to.parent_path());
  fs::copy(from, to, fs::copy_options::recursive);
}

/// A page whose links are changed to where things lie in a workspace.
void copy_page(const fs::path& from, const fs::path& to, const char* links, const char* changed) {
  std::ifstream in(from, std::ios::binary);
  if (!in) throw std::runtime_error(from.string() + ": is missing; install raylab again");
  std::ostringstream text;
  text << in.rdbuf();
  fs::create_directories(to.parent_path());
  std::ofstream out(to, std::ios::binary);
  out << std::regex_replace(text.str(), std::regex(links), changed);
  if (!out.flush()) throw std::runtime_error(to.string() + ": cannot be written");
}

/// The handbook lies one folder deeper than its pages in the project, beside scenes and references.
void copy_to_handbook(const fs::path& from, const fs::path& to) {
  copy_page(from, to, "\\.\\./(scenes|reference/renders)", "../../$1");
}

void add_handbook(const fs::path& handbook) {
  const fs::path stages = data_folder("stages");
  copy_to_handbook(stages / "README.md", handbook / "stages" / "README.md");
  copy_in(stages / "figures", handbook / "stages" / "figures");
  for (const StageInfo& stage : stage_list()) {
    const fs::path room = handbook / "stages" / stage.folder;
    copy_to_handbook(stages / stage.folder / "README.md", room / "README.md");
    copy_in(stages / stage.folder / "stage.hpp", room / "stage.hpp");
  }
  for (const char* const page : handbook_docs) copy_to_handbook(data_folder("docs") / page, handbook / "docs" / page);
}

void add_solutions(const fs::path& folder, const std::vector<int>& stages) {
  const fs::path solution = data_folder("reference/solution");
  if (!stages.empty() && !fs::is_directory(solution))
    throw std::runtime_error(
        "--solutions: this raylab holds the solution only compiled; one that is built from the project's "
        "sources can give it away");
  for (const int stage : stages) copy_in(solution / stage_file(stage), folder / "solutions" / stage_file(stage));
}

/// What clangd and other editors' helpers need to know. headers: where raylab's are.
void add_compile_flags(const fs::path& folder, const fs::path& headers) {
  std::ofstream(folder / "compile_flags.txt")
      << "-xc++\n-std=c++20\n-Wall\n-DRAYLAB_IMPLEMENTATION=submission\n-I" << headers.string() << '\n';
}

void add_references(const fs::path& folder) {
  const fs::path renders = data_folder("reference/renders");
  copy_in(renders, folder / "reference" / "renders");
  const fs::path page = folder / "reference" / "renders" / "README.md";
  fs::remove(page);
  copy_page(renders / "README.md", page, "\\.\\./docs/", "../handbook/docs/");
}

void fill(const fs::path& folder, const std::vector<int>& solutions) {
  fs::create_directories(folder);
  for (const StageInfo& stage : stage_list())
    copy_in(data_folder("stages") / stage.folder / "starter.cpp", folder / stage_file(stage.number));
  copy_in(data_folder("stages") / "WORKSPACE.md", folder / "README.md");
  add_handbook(folder / "handbook");
  copy_in(data_folder("scenes"), folder / "scenes");
  add_references(folder);
  add_solutions(folder, solutions);
  add_compile_flags(folder, data_folder("stages").parent_path());
}

/// For other people's machines, on which raylab is installed from its package.
void fill_handout(const fs::path& folder, const fs::path& package) {
  fill(folder, {});
  add_compile_flags(folder, "/usr/share/raylab");
  copy_in(data_folder("course") / "INSTALL.md", folder / "INSTALL.md");
  if (!package.empty()) copy_in(package, folder / package.filename());
}

/// Makes a folder that is not there yet, or is empty: whole or not at all.
void make_folder(const fs::path& folder, const std::function<void(const fs::path&)>& fill_it) {
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder)))
    throw std::runtime_error(folder.string() + ": is there already, and not empty: name a new folder");
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path target = whole.has_filename() ? whole : whole.parent_path();
  const fs::path partial = target.parent_path() / (".raylab-new-" + std::to_string(std::random_device{}()));
  try {
    fill_it(partial);
    fs::remove(target);  // an empty folder
    fs::rename(partial, target);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    throw;
  }
}

}  // namespace

void make_workspace(const fs::path& folder, const std::vector<int>& solutions) {
  make_folder(folder, [&](const fs::path& partial) { fill(partial, solutions); });
}

void make_handout(const fs::path& folder, const fs::path& package) {
  make_folder(folder, [&](const fs::path& partial) { fill_handout(partial, package); });
}

}  // namespace raylab
