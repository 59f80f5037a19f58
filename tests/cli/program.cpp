#include "program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/support/xml.h"

#include "tests/support/bytes_of.h"

namespace cromer::core::test {
namespace {

constexpr const char* out_name = ".standard-output";
constexpr const char* err_name = ".standard-error";

void redirect(int descriptor, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, descriptor);
  close(file);
}

}  // namespace

Folder::Folder() {
  std::string pattern = std::filesystem::temp_directory_path().string() + "/cromer-cli-XXXXXX";
  path_ = mkdtemp(pattern.data());
}

// Whatever a test has drawn and written is a document that others can read.
Folder::~Folder() {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_, ignored)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".svg" && ending != ".html") continue;
    const std::string document = bytes_of(entry.path());
    EXPECT_EQ(ending == ".svg" ? xml_fault(document) : html_fault(document), "") << entry.path();
  }
  std::filesystem::remove_all(path_, ignored);
}

void Folder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path(name), std::ios::binary) << bytes;
}

std::string Folder::read(const std::string& name) const { return bytes_of(path(name)); }

bool Folder::has(const std::string& name) const { return std::filesystem::exists(path(name)); }

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (name != out_name && name != err_name) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

Finished Folder::run_at_terminal(const std::vector<std::string>& arguments, unsigned short columns) const {
  const int device = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  grantpt(device);
  unlockpt(device);
  const int terminal = open(ptsname(device), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  tcgetattr(terminal, &settings);
  cfmakeraw(&settings);
  tcsetattr(terminal, TCSANOW, &settings);
  const winsize size{24, columns, 0, 0};
  ioctl(terminal, TIOCSWINSZ, &size);
  Finished end = wait(start(arguments, terminal));
  char bytes[4096];
  for (ssize_t got = 0; (got = ::read(device, bytes, sizeof bytes)) > 0;)
    end.err.append(bytes, static_cast<std::size_t>(got));
  close(terminal);
  close(device);
  return end;
}

pid_t Folder::start(const std::vector<std::string>& arguments, int standard_error) const {
  // Another program may be named: one with a line changed (tests/mutation/run).
  const char* named = std::getenv("CROMER_PROGRAM");
  std::vector<std::string> words{named ? named : CROMER_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t process = fork();
  if (process != 0) return process;
  if (const rlimit most{descriptors, descriptors}; descriptors > 0) setrlimit(RLIMIT_NOFILE, &most);
  if (chdir(path_.c_str()) != 0) _exit(126);
  redirect(STDOUT_FILENO, standard_output.empty() ? path(out_name) : standard_output);
  redirect(STDERR_FILENO, path(err_name));
  if (standard_error >= 0) dup2(standard_error, STDERR_FILENO);
  execv(argv.front(), argv.data());
  _exit(127);
}

/// [s] for one run. A sanitizer slows it tenfold.
#ifdef CROMER_SANITIZED
constexpr int patience = 600;
#else
constexpr int patience = 60;
#endif

Finished Folder::wait(pid_t process) const {
  int status = 0;
  bool ended = false;
  for (int i = 0; i < 100 * patience && !ended; ++i) {
    ended = waitpid(process, &status, WNOHANG) == process;
    if (!ended) usleep(i < 100 ? 1000 : 10000);
  }
  if (!ended) {
    kill(process, SIGKILL);
    waitpid(process, &status, 0);
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return {code, bytes_of(path(out_name)), bytes_of(path(err_name))};
}

bool wait_for_handler(pid_t process, int signal) {
  const std::string file = "/proc/" + std::to_string(process) + "/status";
  for (int i = 0; i < 2000; ++i) {
    const std::string text = bytes_of(file);
    const auto at = text.find("SigCgt:");
    if (at != std::string::npos) {
      const unsigned long long caught = std::strtoull(text.c_str() + at + 7, nullptr, 16);
      if (caught >> (signal - 1) & 1u) return true;
    }
    usleep(5000);
  }
  return false;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  char quote = 0;
  bool within = false;
  for (const char c : line) {
    if (quote == 0 && c == ' ') {
      within = false;
    } else {
      if (!within) words.emplace_back();
      within = true;
      if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = 0;
      } else {
        words.back() += c;
      }
    }
  }
  return words;
}

std::string recording(int samples, double decay_rate) {
  std::string text = "Time (s),Position (m)\n";
  char row[64];
  for (int i = 0; i < samples; ++i) {
    const double t = i / 100.0;
    std::snprintf(row, sizeof row, "%.2f,%.5f\n", t,
                  0.2 + 0.05 * std::exp(-decay_rate * t) * std::cos(6 * t));
    text += row;
  }
  return text;
}

}  // namespace cromer::core::test
