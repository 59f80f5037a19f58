#include "cromer/os/process.h"

#include <winsock2.h>
//
#include <fcntl.h>
#include <io.h>
#include <ws2tcpip.h>
//
#include <iphlpapi.h>
//
#include <bcrypt.h>
#include <windows.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace cromer::core::os {
namespace {

std::atomic<void (*)()> interrupted{nullptr};

/// The second one ends the program, as the system does by itself.
BOOL WINAPI on_control(DWORD kind) {
  if (kind != CTRL_C_EVENT && kind != CTRL_BREAK_EVENT) return FALSE;
  void (*const handler)() = interrupted.exchange(nullptr);
  if (!handler) return FALSE;
  handler();
  return TRUE;
}

HANDLE stream_handle(int stream) {
  return ::GetStdHandle(stream == standard_input    ? STD_INPUT_HANDLE
                        : stream == standard_output ? STD_OUTPUT_HANDLE
                                                    : STD_ERROR_HANDLE);
}

UINT console_before = 0;

}  // namespace

void prepare_streams() {
  for (const int stream : {standard_input, standard_output, standard_error}) ::_setmode(stream, _O_BINARY);
  for (const int stream : {standard_output, standard_error})
    if (DWORD mode = 0; ::GetConsoleMode(stream_handle(stream), &mode))
      ::SetConsoleMode(stream_handle(stream), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  // The console is others' too: it is left as it was.
  console_before = ::GetConsoleOutputCP();
  if (console_before != 0 && ::SetConsoleOutputCP(CP_UTF8))
    std::atexit([] { ::SetConsoleOutputCP(console_before); });
}

bool is_terminal(int stream) {
  DWORD mode = 0;
  return ::GetConsoleMode(stream_handle(stream), &mode) != 0;
}

std::size_t terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (!::GetConsoleScreenBufferInfo(stream_handle(standard_error), &info)) return 0;
  return static_cast<std::size_t>(std::max(0, info.srWindow.Right - info.srWindow.Left + 1));
}

void discard_standard_output() {
  if (!std::freopen("NUL", "w", stdout)) std::fclose(stdout);
}

void on_interrupt(void (*handler)()) {
  interrupted = handler;
  ::SetConsoleCtrlHandler(on_control, TRUE);
}

std::filesystem::path program() {
  std::wstring path(32768, L'\0');
  path.resize(::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
  return path;
}

double memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return ::GlobalMemoryStatusEx(&status) ? static_cast<double>(status.ullTotalPhys) : 0;
}

void give_memory_back() { ::_heapmin(); }

int processors() { return static_cast<int>(::GetActiveProcessorCount(ALL_PROCESSOR_GROUPS)); }

std::string host_name() {
  char name[256] = "";
  DWORD size = sizeof name;
  ::GetComputerNameExA(ComputerNameDnsHostname, name, &size);
  return name;
}

// Windows sets no such limit.
std::size_t files_at_most(std::size_t wanted) { return wanted; }

std::vector<std::string> addresses() {
  std::vector<std::string> all;
  ULONG size = 64 << 10;
  std::vector<unsigned char> room(size);
  auto* first = reinterpret_cast<IP_ADAPTER_ADDRESSES*>(room.data());
  constexpr ULONG flags = GAA_FLAG_SKIP_ANYCAST | GAA_FLAG_SKIP_MULTICAST | GAA_FLAG_SKIP_DNS_SERVER;
  if (::GetAdaptersAddresses(AF_INET, flags, nullptr, first, &size) != NO_ERROR) return all;
  for (const auto* adapter = first; adapter; adapter = adapter->Next) {
    if (adapter->OperStatus != IfOperStatusUp || adapter->IfType == IF_TYPE_SOFTWARE_LOOPBACK) continue;
    for (const auto* each = adapter->FirstUnicastAddress; each; each = each->Next) {
      char text[INET_ADDRSTRLEN];
      if (::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(each->Address.lpSockaddr)->sin_addr,
                      text, sizeof text))
        all.emplace_back(text);
    }
  }
  return all;
}

void fill_randomly(std::span<unsigned char> bytes) {
  while (::BCryptGenRandom(nullptr, bytes.data(), static_cast<ULONG>(bytes.size()),
                           BCRYPT_USE_SYSTEM_PREFERRED_RNG) != 0) {
  }
}

std::tm local_time(std::time_t time) {
  std::tm date{};
  ::localtime_s(&date, &time);
  return date;
}

std::tm universal_time(std::time_t time) {
  std::tm date{};
  ::gmtime_s(&date, &time);
  return date;
}

}  // namespace cromer::core::os
