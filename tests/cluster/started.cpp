#include "tests/cluster/started.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "tests/support/bytes_of.h"

extern char** environ;

namespace cromer::core::test {

namespace fs = std::filesystem;

namespace CROMER_FILE {

// For the tests and all that they start: where the modules of this build are, and that Open MPI does not give
// back all it takes (cromer's own leaks show where there is one rank).
const bool told = setenv("CROMER_MODULES", CROMER_MODULE_FOLDER, 1) == 0 &&
                  setenv("ASAN_OPTIONS", "detect_leaks=0", 1) == 0;

}  // namespace CROMER_FILE

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "cromer-cluster-XXXXXX").string();
  path_ = mkdtemp(name.data());
}
Folder::~Folder() {
  std::error_code failed;
  fs::remove_all(path_, failed);
}

Started::Started(std::vector<std::string> arguments, const Folder& folder) {
  static int count = 0;
  out_ = folder / ("out" + std::to_string(++count));
  err_ = folder / ("err" + std::to_string(count));
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (posix_spawnp(&child_, argv[0], &actions, nullptr, argv.data(), environ) != 0) std::abort();
  posix_spawn_file_actions_destroy(&actions);
}

Started::~Started() {
  if (status_ >= 0) return;
  kill(child_, SIGKILL);
  wait();
}

void Started::signal(int number) const { kill(child_, number); }

bool Started::running() {
  int status = 0;
  if (status_ < 0 && waitpid(child_, &status, WNOHANG) == child_) status_ = status;
  return status_ < 0;
}

Ended Started::wait() {
  int status = 0;
  if (status_ < 0 && waitpid(child_, &status, 0) == child_) status_ = status;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), bytes_of(out_),
          bytes_of(err_)};
}

Ended run(const std::vector<std::string>& arguments, const Folder& folder) {
  return Started(arguments, folder).wait();
}

std::vector<std::string> on_ranks(int ranks, std::vector<std::string> arguments) {
  std::vector<std::string> all = {"mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                                  "-n",     std::to_string(ranks)};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

bool have_mpirun() { return std::system("command -v mpirun > /dev/null 2>&1") == 0; }

bool exists(const std::string& path) { return fs::exists(path); }

}  // namespace cromer::core::test
