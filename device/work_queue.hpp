#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>

namespace tentpole {

/// One worker thread that runs tasks one after another in the order of submission, so that the host meshes batch i + 1
/// while the device solves batch i. Why a thread and not `target nowait`: docs/decisions/0002-work-queue.md.
class WorkQueue {
 public:
  WorkQueue();
  /// Waits for the running task; tasks that have not begun are dropped (an exception is unwinding, or nobody called
  /// wait() and so nobody needs them).
  ~WorkQueue();
  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  /// Returns at once. What the task refers to must live until wait() has returned.
  void submit(std::function<void()> task);

  /// Returns when all submitted tasks have run. If a task threw, the tasks behind it were dropped, since they may need
  /// its results, and wait() throws that first exception; the queue is then empty and ready for new tasks.
  void wait();

 private:
  void run_tasks();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::function<void()>> tasks_;
  std::exception_ptr first_exception_;
  bool is_running_ = false;
  bool is_closing_ = false;
  std::thread worker_;  // last: it starts when all else is there
};

}  // namespace tentpole
