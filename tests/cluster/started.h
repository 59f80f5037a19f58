// Programs that a test starts, kills and waits for.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace cromer::core::test {

/// A folder of its own for a test, removed at its end.
class Folder {
 public:
  Folder();
  ~Folder();
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

struct Ended {
  int status = 0;  ///< 128 + signal where a signal ended it
  std::string out, err;
};

class Started {
 public:
  Started(std::vector<std::string> arguments, const Folder& folder);
  ~Started();
  void signal(int number) const;
  pid_t process() const { return child_; }
  bool running();
  Ended wait();

 private:
  std::string out_, err_;
  pid_t child_ = 0;
  int status_ = -1;
};

Ended run(const std::vector<std::string>& arguments, const Folder& folder);

/// mpirun with so many ranks on this machine, whoever we are and however few processors there are.
std::vector<std::string> on_ranks(int ranks, std::vector<std::string> arguments);
bool have_mpirun();

bool exists(const std::string& path);

}  // namespace cromer::core::test
