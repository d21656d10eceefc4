#include "bench/report/journal.hpp"

#include <chrono>
#include <cstddef>
#include <ctime>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace raylab::bench {
namespace {

std::string now() {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  char text[32];
  const std::tm* const utc = std::gmtime(&seconds);
  return std::string(text, utc == nullptr ? 0 : std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", utc));
}

/// The lines of a file but for one that was cut off, which is removed from it.
std::vector<std::string> whole_lines(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  in.close();
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    lines.push_back(text.substr(start, end - start));
  if (start != text.size()) std::filesystem::resize_file(path, start);
  return lines;
}

/// The names of the fields in which two objects differ, also those of objects in them.
std::string differences(const Json& before, const Json& now) {
  std::string names;
  for (const auto& [name, value] : now.items()) {
    const Json was = before.value(name, Json());
    if (was == value) continue;
    const bool deeper = was.is_object() && value.is_object();
    names += (names.empty() ? "" : ", ") + (deeper ? differences(was, value) : name);
  }
  return names;
}

}  // namespace

Journal::Journal(std::filesystem::path path, const Json& identity) : path_(std::move(path)), date_(now()) {
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path());
  const bool begun = std::filesystem::exists(path_) && read(identity);
  out_.open(path_, std::ios::binary | std::ios::app);
  if (!begun) append({{"format", "raylab bench journal 1"}, {"date", date_}, {"identity", identity}});
}

bool Journal::read(const Json& identity) {
  const std::vector<std::string> lines = whole_lines(path_);
  if (lines.empty()) return false;
  try {
    const Json header = Json::parse(lines.front());
    if (header.at("identity") != identity)
      throw std::runtime_error(path_.string() + ": holds an interrupted run that differs from this one in: " +
                               differences(header.at("identity"), identity) +
                               ". Repeat that run to finish it, delete the file, or choose another folder");
    date_ = header.at("date");
    for (std::size_t k = 1; k < lines.size(); ++k) {
      const Json line = Json::parse(lines[k]);
      results_[line.at("unit")] = line.at("result");
      seconds_ += line.at("seconds").get<double>();
    }
  } catch (const Json::exception&) {
    throw std::runtime_error(path_.string() + ": is no journal of raylab bench: delete it or choose another folder");
  }
  return true;
}

void Journal::add(const std::string& unit, Json result, double seconds) {
  append({{"unit", unit}, {"seconds", seconds}, {"result", result}});
  results_[unit] = std::move(result);
  seconds_ += seconds;
}

void Journal::append(const Json& line) {
  out_ << line.dump() << std::endl;
  if (!out_) throw std::runtime_error(path_.string() + ": cannot be written: is the disk full, or the folder read-only?");
}

void Journal::remove() {
  out_.close();
  std::filesystem::remove(path_);
}

}  // namespace raylab::bench
