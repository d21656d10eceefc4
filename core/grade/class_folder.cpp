#include "core/grade/class_folder.hpp"

#include "core/calls/plain_json.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/partial_file.hpp"
#include "core/results/roster.hpp"
#include "core/scene/diagnostic.hpp"
#include "core/scene/read_file.hpp"
#include "core/submission/stage_files.hpp"
#include "core/submission/taken_files.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 16U << 20U;  // of a result
const char* const seed_file = "seed.txt";
const char* const result_file = "result.json";
const char* const seconds_file = "seconds.json";
const char* const roster_file = "roster.csv";
const char* const run_file = "run.json";

std::optional<std::string> text_of(const fs::path& path) { return read_file(path, most_bytes).text; }

void add(const fs::path& folder, std::vector<Submitted>& all) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  all.push_back({(whole.has_filename() ? whole : whole.parent_path()).filename().string(), folder, {}});
}

/// The folders of finished submissions.
std::vector<fs::path> finished_folders(const fs::path& folder) {
  std::vector<fs::path> all;
  if (!fs::is_directory(folder / "submissions")) return all;
  for (const auto& entry : fs::directory_iterator(folder / "submissions"))
    if (fs::is_regular_file(entry.path() / result_file)) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

std::vector<Submitted> find_submissions(const std::vector<std::string>& folders, const std::string& seed) {
  std::vector<Submitted> all;
  for (const fs::path folder : folders) {
    if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": is no folder");
    if (is_submission(folder)) {
      add(folder, all);
      continue;
    }
    const std::size_t before = all.size();
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.symlink_status().type() == fs::file_type::directory &&
          (is_submission(entry.path()) || !ClassFolder::seed_of(entry.path())))
        add(entry.path(), all);
    if (all.size() == before)
      throw std::runtime_error(folder.string() + ": is no submission, which has files like " + stage_file(1) +
                               ", and has no folders that could be one");
  }
  std::sort(all.begin(), all.end(), [](const Submitted& a, const Submitted& b) { return a.name < b.name; });
  std::set<std::string> ids;
  for (Submitted& submitted : all) {
    constexpr std::size_t digits = 12;
    submitted.id = text_hash(seed + '\n' + submitted.name).substr(0, digits);
    if (!ids.insert(submitted.id).second)
      throw std::runtime_error("two submissions are called " + raylab::quoted(submitted.name) +
                               ": grade them apart, or rename one");
  }
  return all;
}

std::vector<Submitted> shard(const std::vector<Submitted>& all, std::size_t k, std::size_t n) {
  std::vector<Submitted> part;
  for (std::size_t i = k; i < all.size(); i += n) part.push_back(all[i]);
  return part;
}

ClassFolder::ClassFolder(fs::path folder, const std::string& seed) : folder_(std::move(folder)), seed_(seed) {
  const std::optional<std::string> known = seed_of(folder_);
  if (known && *known != seed)
    throw std::runtime_error(folder_.string() + ": was graded with the seed " + *known + ", and not " + seed +
                             ": name another folder, or leave --seed out");
  if (!known && fs::exists(folder_) && !fs::is_empty(folder_))
    throw std::runtime_error(folder_.string() + ": holds something else: name a new folder");
  fs::create_directories(folder_);
  fs::permissions(folder_, fs::perms::owner_all);
  if (!known) write_file(folder_ / seed_file, seed + '\n');
}

std::optional<std::string> ClassFolder::seed_of(const fs::path& folder) {
  std::optional<std::string> text = text_of(folder / seed_file);
  if (text) text->erase(text->find_last_not_of('\n') + 1);
  return text;
}

std::optional<SubmissionResult> ClassFolder::finished(const std::string& id, const std::string& inputs) const {
  const std::optional<std::string> text = text_of(submission(id) / result_file);
  if (!text) return {};
  try {
    auto result = from_json<SubmissionResult>(*text);
    if (result.inputs == inputs) return result;
  } catch (const InputError&) {  // an older raylab's
  }
  return {};
}

void ClassFolder::finish(const SubmissionResult& result, double seconds) const {
  write_file(submission(result.id) / seconds_file, to_json(seconds) + '\n');
  write_file(submission(result.id) / result_file, to_json(result) + '\n');
}

std::vector<SubmissionResult> ClassFolder::results() const {
  std::vector<SubmissionResult> all;
  for (const fs::path& folder : finished_folders(folder_)) {
    const std::optional<std::string> text = text_of(folder / result_file);
    if (!text) throw std::runtime_error((folder / result_file).string() + ": cannot be read");
    all.push_back(from_json<SubmissionResult>(*text));
  }
  return all;
}

std::vector<std::pair<std::string, double>> ClassFolder::seconds() const {
  std::vector<std::pair<std::string, double>> all;
  for (const fs::path& folder : finished_folders(folder_))
    if (const auto text = text_of(folder / seconds_file))
      all.emplace_back(folder.filename().string(), from_json<double>(*text));
  return all;
}

void ClassFolder::enroll(const std::vector<RosterEntry>& entries) const {
  std::vector<RosterEntry> all = roster();
  for (const RosterEntry& entry : entries) {
    std::erase_if(all, [&](const RosterEntry& known) { return known.id == entry.id; });
    all.push_back(entry);
  }
  std::sort(all.begin(), all.end(), [](const RosterEntry& a, const RosterEntry& b) { return a.id < b.id; });
  write_file(folder_ / roster_file, roster_csv(all));
}

std::vector<RosterEntry> ClassFolder::roster() const {
  const std::optional<std::string> text = text_of(folder_ / roster_file);
  return text ? parse_roster(*text) : std::vector<RosterEntry>{};
}

ClassRun ClassFolder::run() const {
  const std::optional<std::string> text = text_of(folder_ / run_file);
  if (!text) throw std::runtime_error(folder_.string() + ": has no " + run_file + ": grade it first");
  return from_json<ClassRun>(*text);
}

void ClassFolder::write_run(const ClassRun& run) const { write_file(folder_ / run_file, to_json(run) + '\n'); }

void ClassFolder::take_over(const ClassFolder& other) const {
  if (other.seed() != seed())
    throw std::runtime_error(other.path().string() + ": was graded with another seed than " + path().string());
  if (to_json(other.run()) != to_json(run()))
    throw std::runtime_error(other.path().string() + ": was graded by another raylab or in another sandbox than " +
                             path().string() + ", so the marks need not agree");
  for (const fs::path& folder : finished_folders(other.path())) {
    const fs::path own = submission(folder.filename().string());
    fs::remove_all(own);
    fs::create_directories(own.parent_path());
    fs::copy(folder, own, fs::copy_options::recursive);
  }
  enroll(other.roster());
}

}  // namespace raylab
