#include "core/submission/compiler.hpp"

#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/partial_file.hpp"
#include "core/render/stage_table.hpp"
#include "core/scene/read_file.hpp"
#include "core/submission/child_process.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// The compiler that built raylab, or the one that CXX in the environment names.
std::string compiler() {
  if (const std::string own = variable("CXX"); !own.empty()) return own;
  return fs::exists(RAYLAB_COMPILER) ? RAYLAB_COMPILER : "c++";
}

fs::path cache_folder() {
  if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return fs::path(cache) / "raylab";
  if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache" / "raylab";
  return fs::temp_directory_path() / "raylab-cache";
}

/// One that every user can read: in a sandbox root becomes another one.
fs::path shared_cache_folder() {
  return geteuid() == 0 && variable("XDG_CACHE_HOME").empty() ? "/var/cache/raylab" : cache_folder();
}

/// Removes from a folder of the cache what nobody has made anew for a month.
void forget_old(const fs::path& folder) {
  const auto limit = fs::file_time_type::clock::now() - std::chrono::hours(24 * 30);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.last_write_time(ignored) < limit) fs::remove_all(entry.path(), ignored);
}

const char* const exporting_file = "export_tasks.cpp";
constexpr std::uintmax_t most_bytes = 1U << 20U;  // of a stage's file, and of what a compiler says of it

std::string content(const fs::path& path) {
  const FileText file = read_file(path, most_bytes);
  if (!file.text) throw std::runtime_error(path.string() + ": " + file.error);
  return *file.text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + ' ';
  return text;
}

std::string joined_contents(const std::map<std::string, std::string>& files) {
  std::string all;
  for (const auto& [name, text] : files) all += name + text;
  return all;
}

/// What the compiler says it is. Throws std::runtime_error if there is none.
std::string compiler_version() {
  const std::string name = compiler();
  try {
    if (const Finished version = run_program({name, "--version"}); version.good) return version.output;
  } catch (const std::runtime_error&) {  // it cannot be started
  }
  throw std::runtime_error(name + ": is no C++ compiler that runs here; install one (g++), or name it in CXX");
}

/// All that a stage's file can include of raylab, and what exports its tasks: "stages/01_rays/stage.hpp" and its content.
std::map<std::string, std::string> contracts() {
  const fs::path root = data_folder("stages").parent_path();
  std::map<std::string, std::string> all;
  for (const fs::path& folder : {root / "core" / "math", root / "stages"})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".hpp" || entry.path().filename() == exporting_file)
        all[fs::relative(entry.path(), root).string()] = content(entry.path());
  return all;
}

// Of one strange file: a usual one takes a second and 200 MB.
constexpr SandboxLimits compile_limits{std::int64_t{2} << 30U, 30, std::int64_t{64} << 20U};
constexpr RunLimits compile_run{std::chrono::seconds(60), std::size_t{64} << 10U};

/// As a string literal of C++.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// Without the names of temporary files, which are others each time.
std::string without_files_in(const fs::path& folder, std::string text) {
  for (std::size_t at = text.find(folder.string()); at != std::string::npos; at = text.find(folder.string(), at)) {
    const std::size_t end = std::min(text.find_first_of(" :;,'\")\n", at), text.size());
    text.replace(at, end - at, "(a file)");
  }
  return text;
}

/// What most files of a stage include anyway.
const char* const common_headers = R"(#include "core/math/camera.hpp"
#include "core/math/contract.hpp"
#include "core/math/hit.hpp"
#include "core/math/lights.hpp"
#include "core/math/material.hpp"
#include "core/math/ray.hpp"
#include "core/math/sample.hpp"
#include "core/math/seen.hpp"
#include "core/math/shapes.hpp"
#include "core/math/task_export.hpp"
#include "core/math/vec3.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <typeinfo>
#include <vector>
)";

}  // namespace

StageCompiler::StageCompiler(const CompilerOptions& options) : options_(options) {
  command_ = {compiler(),
              "-std=c++20",
              "-O2",
              "-g1",
              "-fPIC",
              "-fvisibility=hidden",
              "-ffp-contract=off",
              "-Wall",
              "-Wextra",
              "-Wno-unused-parameter",
              "-Wno-missing-field-initializers",
              "-DRAYLAB_IMPLEMENTATION=submission"};
  if (options.sanitize) {
    command_.insert(command_.end(), {"-D_GLIBCXX_ASSERTIONS", "-fsanitize=address,undefined", "-fno-sanitize-recover=all",
                                     "-fno-omit-frame-pointer"});
    command_[2] = "-O1";
  }
  static const std::map<std::string, std::string> headers = contracts();  // read once, however many images there are
  static const std::string version = compiler_version();
  const fs::path cache = options.sandbox ? shared_cache_folder() : cache_folder();
  root_ = data_folder("stages").parent_path();
  folder_ = cache / text_hash(joined(command_) + root_.string() + version + joined_contents(headers));
  made_ = options.sandbox ? options.sandbox->room() : folder_;
  fs::create_directories(folder_);
  if (options.sandbox) {
    // There are only the system's folders there, and what its user may read.
    command_.front() = fs::canonical(find_program(command_.front())).string();
    root_ = folder_ / "include";
    for (const auto& [name, text] : headers)
      if (!fs::exists(root_ / name)) write_file(root_ / name, text);
  }
  command_.push_back("-I" + root_.string());
  forget_old(cache);
  forget_old(folder_);
}

/// A file of the cache that the compiler makes, with these arguments, if it is not there yet.
fs::path StageCompiler::prepared(const std::string& name, const std::vector<std::string>& arguments) const {
  const fs::path path = folder_ / name;
  if (fs::exists(path)) return path;
  PartialFile file(path);
  std::vector<std::string> command = command_;
  command.insert(command.end(), arguments.begin(), arguments.end());
  command.insert(command.end(), {"-o", file.temporary().string()});
  const Finished finished = run_program(command);
  if (!finished.good) throw std::runtime_error("the lab's own headers do not compile:\n" + finished.output);
  file.commit();
  return path;
}

void StageCompiler::prepare() const {
  for (const StageInfo& stage : stage_list()) exports(stage.number);
}

/// What every file includes first, precompiled.
fs::path StageCompiler::header() const {
  const fs::path path = folder_ / "common.hpp";
  if (!fs::exists(path)) write_file(path, common_headers);
  prepared("common.hpp.gch", {"-x", "c++-header", path.string()});
  return path;
}

/// The object that hands out a stage's tasks.
fs::path StageCompiler::exports(int stage) const {
  const std::string folder(stage_info(stage).folder);
  std::string macro = "RAYLAB_TASKS_" + folder;
  std::transform(macro.begin(), macro.end(), macro.begin(), [](unsigned char c) { return std::toupper(c); });
  return prepared(folder + ".o", {"-include", header().string(), "-DRAYLAB_STAGE_HEADER=\"stages/" + folder + "/stage.hpp\"",
                                  "-DRAYLAB_STAGE_TASKS=" + macro, "-c", (root_ / "stages" / exporting_file).string()});
}

StageCompiler::Built StageCompiler::build(int stage, const fs::path& source) const {
  return build_text(stage, content(source), source.string());
}

StageCompiler::Built StageCompiler::build_text(int stage, const std::string& text, const std::string& shown) const {
  const std::string name = text_hash(shown + '\n' + text) + ".so";
  const fs::path said = made_ / (name + ".txt");
  if (fs::exists(made_ / name)) return {made_ / name, fs::exists(said) ? content(said) : ""};

  const fs::path common = header(), exporter = exports(stage);
  // A copy, so that it finds no other files of its folder: a submission is its stages' files and nothing else.
  PartialFile library(made_ / name), copy(made_ / (name + ".cpp"));
  {
    std::ofstream stream(copy.temporary(), std::ios::binary);
    stream << "#line 1 " << quoted(shown) << '\n' << text;
  }
  const Finished finished =
      compile({options_.color ? "-fdiagnostics-color=always" : "-fdiagnostics-color=never", "-include", common.string(),
               "-shared", "-x", "c++", copy.temporary().string(), "-x", "none", exporter.string(), "-Wl,-z,defs"},
              copy.temporary(), library.temporary());
  if (!finished.good) throw DoesNotCompile(finished.output);
  if (!finished.output.empty()) write_file(said, finished.output);
  library.commit();
  return {made_ / name, finished.output};
}

/// Makes `library` of `text`, which is among the arguments.
Finished StageCompiler::compile(std::vector<std::string> arguments, const fs::path& text, const fs::path& library) const {
  arguments.insert(arguments.begin(), command_.begin(), command_.end());
  if (options_.sanitize) std::erase(arguments, "-Wl,-z,defs");  // the sanitizers' functions are the worker's
  const Sandbox* const sandbox = options_.sandbox;
  if (!sandbox) {
    arguments.insert(arguments.end(), {"-o", library.string()});
    return run_program(arguments);
  }
  const fs::path folder = sandbox->writable_folder(), made = folder / "stage.so";
  arguments.insert(arguments.end(), {"-o", made.string()});
  const Finished finished =
      run_program(sandbox->command({arguments, {folder_, text}, folder, true, compile_limits}), compile_run);
  const bool good = finished.good && fs::is_regular_file(fs::symlink_status(made));
  if (good) fs::copy_file(made, library, fs::copy_options::overwrite_existing);
  fs::remove_all(folder);
  return {good, without_files_in(sandbox->room(), finished.output)};
}

std::vector<std::string> StageCompiler::worker_environment() const {
  if (!options_.sanitize) return {};
  std::string preload;
  for (const char* const runtime : {"libasan.so", "libubsan.so"}) {
    std::string path = run_program({command_.front(), std::string("-print-file-name=") + runtime}).output;
    path.erase(path.find_last_not_of('\n') + 1);
    if (!path.starts_with('/'))
      throw std::runtime_error("--sanitize: " + command_.front() + " has no " + runtime + ": use g++, by CXX=g++");
    preload += (preload.empty() ? "" : ":") + path;
  }
  return {"LD_PRELOAD=" + preload, "ASAN_OPTIONS=detect_leaks=0:print_legend=0:abort_on_error=1:handle_abort=1",
          "UBSAN_OPTIONS=print_stacktrace=1:abort_on_error=1"};
}

}  // namespace raylab
