#include "device/work_queue.hpp"

#include <utility>

namespace tentpole {

WorkQueue::WorkQueue() : worker_([this] { run_tasks(); }) {}

WorkQueue::~WorkQueue() {
  {
    const std::lock_guard lock(mutex_);
    tasks_ = {};
    is_closing_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

void WorkQueue::submit(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    if (first_exception_) return;  // tasks behind a failed one are dropped, also those submitted later
    tasks_.push(std::move(task));
  }
  changed_.notify_all();
}

void WorkQueue::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return tasks_.empty() && !is_running_; });
  if (first_exception_) std::rethrow_exception(std::exchange(first_exception_, nullptr));
}

void WorkQueue::run_tasks() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_closing_ || !tasks_.empty(); });
    if (is_closing_) return;
    std::function<void()> task = std::move(tasks_.front());
    tasks_.pop();
    is_running_ = true;
    lock.unlock();
    std::exception_ptr exception;
    try {
      task();
    } catch (...) {
      exception = std::current_exception();
    }
    task = nullptr;  // what it captured is gone before wait() returns
    lock.lock();
    is_running_ = false;
    if (exception) {
      first_exception_ = exception;
      tasks_ = {};
    }
    changed_.notify_all();
  }
}

}  // namespace tentpole
