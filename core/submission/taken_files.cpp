#include "core/submission/taken_files.hpp"

#include "core/render/stage_table.hpp"
#include "core/scene/diagnostic.hpp"
#include "core/submission/stage_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr off_t most_bytes = 1 << 20;  // of a file; the solution's longest has six thousand

/// An open descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

/// Of what is opened, not of what has that name a moment later.
std::string why_refused(const Descriptor& file) {
  if (file.get() < 0)
    return errno == ELOOP ? "is a link: hand in the file itself" : std::string("cannot be opened: ") + std::strerror(errno);
  struct stat about {};
  if (fstat(file.get(), &about) != 0) return std::strerror(errno);
  if (!S_ISREG(about.st_mode)) return "is no file, but a folder, a pipe or a device";
  if (about.st_size > most_bytes)
    return "is too large: " + std::to_string(about.st_size) + " bytes, where at most " + std::to_string(most_bytes) +
           " are taken";
  return {};
}

std::string content(const Descriptor& file) {
  std::string text(static_cast<std::size_t>(most_bytes), '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t got = read(file.get(), text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  text.resize(size);
  return text;
}

/// The folder itself, or its one subfolder that is a submission.
fs::path real_folder(const fs::path& folder, std::vector<std::string>& notes) {
  if (is_submission(folder)) return folder;
  std::vector<fs::path> found;
  std::error_code ignored;  // one that cannot be read is told of where it is opened
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.symlink_status().type() == fs::file_type::directory && is_submission(entry.path()))
      found.push_back(entry.path());
  if (found.size() != 1) return folder;
  notes.push_back("its files lie in the folder " + printable(found.front().filename().string()));
  return found.front();
}

}  // namespace

bool is_submission(const fs::path& folder) {
  std::error_code ignored;
  for (const StageInfo& stage : stage_list())
    if (fs::symlink_status(folder / stage_file(stage.number), ignored).type() != fs::file_type::not_found) return true;
  return false;
}

TakenFiles take_files(const fs::path& given) {
  TakenFiles taken;
  const fs::path folder = real_folder(given, taken.notes);
  const Descriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() < 0) {
    taken.notes.push_back(std::string("its folder cannot be read: ") + std::strerror(errno));
    for (const StageInfo& stage : stage_list()) taken.refused[stage.number] = taken.notes.back();
    return taken;
  }
  for (const StageInfo& stage : stage_list()) {
    const std::string name = stage_file(stage.number);
    const Descriptor file(openat(opened.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (file.get() < 0 && errno == ENOENT) continue;
    if (std::string why = why_refused(file); !why.empty()) {
      taken.notes.push_back(name + " " + why);
      taken.refused[stage.number] = name + " " + why;
    } else {
      taken.texts[stage.number] = content(file);
    }
  }
  if (taken.texts.empty() && taken.refused.empty()) taken.notes.push_back("it has none of the stages' files");
  return taken;
}

}  // namespace raylab
