// What the server of the lab answers: its page and its interface.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "apps/serve/guard.h"
#include "apps/serve/http_server.h"
#include "apps/serve/live_session.h"

namespace cromer::core::serve {

/// One thread for tasks that may take long, one after the other.
class TaskQueue {
 public:
  TaskQueue() : thread_([this] { work(); }) {}
  /// Waits for the task at work; those still waiting are not begun.
  ~TaskQueue() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    more_.notify_one();
    thread_.join();
  }
  void add(std::function<void()> task) {
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(std::move(task));
    }
    more_.notify_one();
  }

 private:
  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      more_.wait(lock, [this] { return stop_ || !tasks_.empty(); });
      if (stop_) return;
      const auto task = std::move(tasks_.front());
      tasks_.pop_front();
      lock.unlock();
      task();
    }
  }

  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<std::function<void()>> tasks_;
  bool stop_ = false;
  std::thread thread_;
};

/// Every request that the guard lets pass is answered; see docs/recording.md.
class Lab {
 public:
  /// `page` is the file; "" stands for the page that the program carries, if it does.
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
