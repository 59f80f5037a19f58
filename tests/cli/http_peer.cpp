#include "http_peer.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "live_devices.h"

namespace cromer::core::test {

std::string request(int port, const std::string& first_line, const std::string& headers,
                    const std::string& body) {
  const bool has_host = headers.find("Host:") != std::string::npos;
  return first_line + " HTTP/1.1\r\n" + (has_host ? "" : "Host: 127.0.0.1:" + std::to_string(port) + "\r\n") +
         headers + (body.empty() ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n") +
         "Connection: close\r\n\r\n" + body;
}

std::string ask(int port, const std::string& bytes, double seconds) {
  const Peer peer(port);
  peer.send(bytes);
  return peer.receive(seconds);
}

int status_of(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.c_str() + 9) : 0;
}

std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

Served::Served(const Folder& folder, std::vector<std::string> more) : folder_(folder) {
  folder.write("page.html", "<!DOCTYPE html><html><head><title>stand-in for the lab</title></head></html>\n");
  more.insert(more.begin(), {"serve", "--port", "0", "--page", "page.html"});
  process_ = folder.start(more);
  for (int i = 0; i < 1000 && address_.find('\n') == std::string::npos; ++i) {
    sleep_until(now() + 0.01);
    if (folder.has(".standard-output")) address_ = folder.read(".standard-output");
  }
  address_ = address_.substr(0, address_.find('\n'));
  const auto colon = address_.rfind(':');
  if (colon != std::string::npos) port_ = std::atoi(address_.c_str() + colon + 1);
}

Served::~Served() {
  ::kill(process_, SIGTERM);
  folder_.wait(process_);
}

double Served::memory() const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return HUGE_VAL;
}

bool Served::is_up() const {
  return ::kill(process_, 0) == 0 && ::waitpid(process_, nullptr, WNOHANG) == 0 &&
         status_of(ask(port_, request(port_, "GET /"))) == 200;
}

}  // namespace cromer::core::test
