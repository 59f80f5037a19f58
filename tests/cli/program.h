// The program under test, run in a folder of its own.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cromer::core::test {

/// What a finished process leaves: exit status (-signal where a signal ended it), standard output and error.
struct Finished {
  int status = 0;
  std::string out, err;

  /// Standard output as JSON; a discarded value, which fails every look into it, if it is none.
  nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
};

/// A fresh folder, removed with the object, in which the program runs.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return path_ + "/" + name; }
  void write(const std::string& name, const std::string& bytes) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  /// Names of all files and folders in it, sorted; those that catch the program's output are not counted.
  std::vector<std::string> names() const;

  Finished run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }
  /// With standard error at a terminal of so many columns.
  Finished run_at_terminal(const std::vector<std::string>& arguments, unsigned short columns) const;
  /// `standard_error`: a descriptor in the place of the file that catches it.
  pid_t start(const std::vector<std::string>& arguments, int standard_error = -1) const;
  /// How many files the program may have open; 0 for as many as this one.
  rlim_t descriptors = 0;
  /// A file that takes its standard output in the place of the one that is read.
  std::string standard_output;
  /// At most a minute, ten under a sanitizer; then the process is killed, and its status is -9.
  Finished wait(pid_t process) const;

 private:
  std::string path_;
};

/// Waits until the process has a handler of its own for the signal; false if that does not happen.
bool wait_for_handler(pid_t process, int signal);

/// Words as a shell takes them, quoted by " or '.
std::vector<std::string> words_of(const std::string& line);

/// A damped oscillation as a logger would write it, `samples` at 100 a second.
std::string recording(int samples, double decay_rate = 0.05);

}  // namespace cromer::core::test
