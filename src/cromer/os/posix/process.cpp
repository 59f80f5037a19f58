#include "cromer/os/process.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cromer::core::os {
namespace {

std::atomic<void (*)()> interrupted{nullptr};

extern "C" void cromer_on_signal(int) { interrupted.load()(); }

void heed(int signal) {
  struct sigaction action {};
  action.sa_handler = cromer_on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // the second one ends the program
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void prepare_streams() {}

bool is_terminal(int stream) { return ::isatty(stream) == 1; }

std::size_t terminal_width() {
  winsize size{};
  const bool known = is_terminal(standard_error) && ::ioctl(standard_error, TIOCGWINSZ, &size) == 0;
  return known ? size.ws_col : 0;
}

void discard_standard_output() {
  if (!std::freopen("/dev/null", "w", stdout)) std::fclose(stdout);
}

void on_interrupt(void (*handler)()) {
  interrupted = handler;
  heed(SIGINT);
  heed(SIGTERM);
  ::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is told like a full disk
}

std::filesystem::path program() {
#ifdef __APPLE__
  char path[4096];
  std::uint32_t size = sizeof path;
  return ::_NSGetExecutablePath(path, &size) == 0 ? path : "";
#else
  std::error_code failed;
  return std::filesystem::read_symlink("/proc/self/exe", failed);
#endif
}

double memory() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void give_memory_back() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

int processors() { return static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)); }

std::string host_name() {
  char name[256] = "";
  ::gethostname(name, sizeof(name) - 1);
  return name;
}

std::size_t files_at_most(std::size_t wanted) {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return std::min<std::size_t>(256, wanted);
  files.rlim_cur = std::max(files.rlim_cur, std::min<rlim_t>(files.rlim_max, wanted));
  ::setrlimit(RLIMIT_NOFILE, &files);
  ::getrlimit(RLIMIT_NOFILE, &files);
  return static_cast<std::size_t>(std::min<rlim_t>(files.rlim_cur, wanted));
}

std::vector<std::string> addresses() {
  std::vector<std::string> all;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return all;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(first, ::freeifaddrs);
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET) continue;
    if (!(each->ifa_flags & IFF_UP) || (each->ifa_flags & IFF_LOOPBACK)) continue;
    char text[INET_ADDRSTRLEN];
    if (::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(each->ifa_addr)->sin_addr, text,
                    sizeof text))
      all.emplace_back(text);
  }
  return all;
}

void fill_randomly(std::span<unsigned char> bytes) {
  // getentropy(3) gives at most so many at once.
  for (std::size_t begin = 0; begin < bytes.size(); begin += 256)
    while (::getentropy(bytes.data() + begin, std::min<std::size_t>(256, bytes.size() - begin)) != 0) {
    }
}

std::tm local_time(std::time_t time) {
  std::tm date{};
  ::localtime_r(&time, &date);
  return date;
}

std::tm universal_time(std::time_t time) {
  std::tm date{};
  ::gmtime_r(&time, &date);
  return date;
}

}  // namespace cromer::core::os
