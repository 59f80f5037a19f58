// What the server of the lab answers: its page and its interface.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "apps/serve/guard.h"
#include "apps/serve/http_server.h"
#include "apps/serve/live_session.h"
#include "apps/serve/task_queue.h"

namespace cromer::core::serve {

/// Every request that the guard lets pass is answered; see docs/recording.md.
class Lab {
 public:
  /// `page` is the file; "" where there is none.
  Lab(LiveSession& session, Guard guard, std::string page)
      : session_(session), guard_(std::move(guard)), page_(std::move(page)) {}

  void handle(const HttpRequest& request, const HttpServer::Respond& respond);

 private:
  using Respond = HttpServer::Respond;
  void record(const HttpRequest& request, const Respond& respond);
  void stop(const Respond& respond);
  void recording(const std::string& name, const Respond& respond);
  HttpAnswer page();

  LiveSession& session_;
  Guard guard_;
  std::string page_;
  std::shared_ptr<const std::string> page_bytes_;  ///< the page as it was at page_time_; empty: none
  std::filesystem::file_time_type page_time_{};
  std::string page_policy_;
  // What waits for devices, one after the other; a stop does not wait for a start.
  TaskQueue starts_, stops_;
};

}  // namespace cromer::core::serve
