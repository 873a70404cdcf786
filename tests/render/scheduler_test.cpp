// SPDX-License-Identifier: MIT
#include "renderer/job/scheduler.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <limits>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "renderer/job/fp_environment.hpp"

using namespace cobble;

TEST_CASE("every worker runs once a round, all at the same time") {
    for (const std::uint32_t threads : {1U, 2U, 5U}) {
        const auto scheduler = renderer::make_thread_scheduler(threads);
        REQUIRE(scheduler->workers() == threads);
        for (int round = 0; round < 50; ++round) {
            std::atomic<std::uint32_t> arrived = 0;
            std::mutex mutex;
            std::set<std::uint32_t> seen;
            scheduler->run([&](std::uint32_t worker) {
                {
                    const std::lock_guard lock(mutex);
                    CHECK(seen.insert(worker).second);
                }
                // Only ends if all are in here together.
                ++arrived;
                while (arrived < threads) std::this_thread::yield();
            });
            CHECK(seen.size() == threads);
        }
    }
}

TEST_CASE("the serial scheduler is the caller") {
    const auto scheduler = renderer::make_serial_scheduler();
    CHECK(scheduler->workers() == 1);
    std::thread::id id;
    scheduler->run([&](std::uint32_t) { id = std::this_thread::get_id(); });
    CHECK(id == std::this_thread::get_id());
}

TEST_CASE("background work is done by the time that it says so") {
    for (const bool threads : {false, true}) {
        const auto scheduler =
            threads ? renderer::make_thread_scheduler(2) : renderer::make_serial_scheduler();
        std::atomic<bool> go = !threads;
        int result = 0;
        const auto background = scheduler->start([&] {
            while (!go) std::this_thread::yield();
            result = 42;
        });
        const auto now = std::chrono::steady_clock::now();
        CHECK(background->wait_until(now) == !threads);
        go = true;
        CHECK(background->wait_until(now + std::chrono::seconds(60)));
        CHECK(result == 42);
    }
    // Dropped, it is waited for.
    std::atomic<bool> ended = false;
    renderer::make_thread_scheduler(1)->start([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ended = true;
    });
    CHECK(ended);
}

TEST_CASE("what a worker throws reaches the caller once all have returned") {
    const auto caught = [](const auto& function) {
        try {
            function();
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        } catch (const std::bad_alloc&) {
            return std::string("memory");
        }
        return std::string();
    };
    const auto scheduler = renderer::make_thread_scheduler(4);
    REQUIRE(scheduler->workers() == 4);
    for (std::uint32_t thrower = 0; thrower < 4; ++thrower) {
        std::atomic<std::uint32_t> returned = 0;
        CHECK(caught([&] {
                  scheduler->run([&](std::uint32_t worker) {
                      if (worker == thrower) throw std::bad_alloc();
                      std::this_thread::sleep_for(std::chrono::milliseconds(2));
                      ++returned;
                  });
              }) == "memory");
        CHECK(returned == 3);
    }
    CHECK(caught([&] {
              scheduler->run([](std::uint32_t worker) {
                  if (worker > 0) throw std::runtime_error(std::to_string(worker));
              });
          }) == "1");
    // A round that went wrong leaves nothing behind.
    std::atomic<std::uint32_t> returned = 0;
    CHECK(caught([&] { scheduler->run([&](std::uint32_t) { ++returned; }); }).empty());
    CHECK(returned == 4);

    for (const bool threads : {false, true}) {
        const auto beside =
            threads ? renderer::make_thread_scheduler(2) : renderer::make_serial_scheduler();
        const auto background = beside->start([] { throw std::bad_alloc(); });
        const auto soon = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        CHECK(caught([&] { background->wait_until(soon); }) == "memory");
    }
    // Dropped, it takes what it threw along.
    CHECK(caught([&] { scheduler->start([] { throw std::bad_alloc(); }); }).empty());
}

TEST_CASE("a task has its own rounding and denormals, and leaves the host's as they were") {
    const int before = std::fegetround();
    std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040U);  // flush to zero, denormals are zero
    const std::uint32_t host = _mm_getcsr();
#endif
    volatile double smallest = std::numeric_limits<double>::min();
    volatile double third = 0;
    {
        const renderer::FpEnvironment environment;
        CHECK(std::fegetround() == FE_TONEAREST);
        third = smallest / 3;
        CHECK(third > 0);
    }
    CHECK(std::fegetround() == FE_UPWARD);
#if defined(__SSE2__)
    CHECK((_mm_getcsr() & ~0x3fU) == (host & ~0x3fU));
    _mm_setcsr(host & ~0x8040U);
#endif
    std::fesetround(before);
}
