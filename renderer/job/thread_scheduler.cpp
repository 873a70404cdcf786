// SPDX-License-Identifier: MIT
// Workers that live as long as the scheduler: a job takes many short steps, and starting a thread
// for each would cost more than the step's overhead.
#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {
namespace {

class OnThread final : public Background {
  public:
    explicit OnThread(std::function<void()> work) : work_(std::move(work)) {
        try {
            thread_ = std::thread([this] { run(); });
        } catch (const std::system_error&) {
            run();
        }
    }
    ~OnThread() override {
        if (thread_.joinable()) thread_.join();
    }

    bool wait_until(std::chrono::steady_clock::time_point deadline) override {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_until(lock, deadline, [this] { return ended_; })) return false;
        if (failure_) std::rethrow_exception(failure_);
        return true;
    }

  private:
    void run() {
        try {
            work_();
        } catch (...) {
            failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }

    std::function<void()> work_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool ended_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

class ThreadScheduler final : public Scheduler {
  public:
    explicit ThreadScheduler(std::uint32_t threads) {
        // All memory first: once a thread runs, nothing may leave this constructor.
        failures_.resize(threads);
        threads_.reserve(threads);
        // The caller is worker 0. A system that gives fewer threads than asked gets fewer workers.
        try {
            for (std::uint32_t worker = 1; worker < threads; ++worker) {
                threads_.emplace_back([this, worker] { serve(worker); });
            }
        } catch (const std::system_error&) {
        } catch (const std::bad_alloc&) {
        }
    }

    ~ThreadScheduler() override {
        {
            const std::lock_guard lock(mutex_);
            closing_ = true;
        }
        start_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

    [[nodiscard]] std::uint32_t workers() const override {
        return static_cast<std::uint32_t>(threads_.size()) + 1;
    }

    void run(const std::function<void(std::uint32_t)>& work) override {
        {
            const std::lock_guard lock(mutex_);
            work_ = &work;
            running_ = threads_.size();
            ++round_;
        }
        start_.notify_all();
        attempt(work, 0);
        std::unique_lock lock(mutex_);
        finished_.wait(lock, [this] { return running_ == 0; });
        work_ = nullptr;
        std::exception_ptr first;
        for (std::exception_ptr& failure : failures_) {
            if (!first) first = failure;
            failure = nullptr;
        }
        if (first) std::rethrow_exception(first);
    }

    std::unique_ptr<Background> start(std::function<void()> work) override {
        return std::make_unique<OnThread>(std::move(work));
    }

  private:
    /// An exception that left a thread's function would end the process.
    void attempt(const std::function<void(std::uint32_t)>& work, std::uint32_t worker) {
        try {
            work(worker);
        } catch (...) {
            failures_[worker] = std::current_exception();
        }
    }

    void serve(std::uint32_t worker) {
        std::uint64_t round_done = 0;
        std::unique_lock lock(mutex_);
        for (;;) {
            start_.wait(lock, [&] { return closing_ || round_ != round_done; });
            if (closing_) return;
            round_done = round_;
            const std::function<void(std::uint32_t)>& work = *work_;
            lock.unlock();
            attempt(work, worker);
            lock.lock();
            if (--running_ == 0) finished_.notify_one();
        }
    }

    std::mutex mutex_;
    std::condition_variable start_;
    std::condition_variable finished_;
    const std::function<void(std::uint32_t)>* work_ = nullptr;
    std::uint64_t round_ = 0;
    std::size_t running_ = 0;
    bool closing_ = false;
    std::vector<std::exception_ptr> failures_;  ///< by worker, of this round
    std::vector<std::thread> threads_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_scheduler(std::uint32_t threads) {
    if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
    // More workers than this serve nobody: tiles run out and memory for stacks does not.
    constexpr std::uint32_t kMostThreads = 1024;
    return std::make_unique<ThreadScheduler>(std::min(threads, kMostThreads));
}

}  // namespace cobble::renderer
