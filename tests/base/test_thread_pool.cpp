#include <atomic>
#include <csignal>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <pthread.h>

#include "elsie/base/thread_pool.h"

using elsie::base::ThreadPool;

TEST_CASE("A crew does each item once, whatever the number of threads") {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    CAPTURE(threads);
    ThreadPool pool(threads);
    CHECK(pool.threads() == threads);
    for (const std::size_t items : {0, 1, 7, 8, 9, 1000}) {
      CAPTURE(items);
      std::vector<int> done(items);
      std::atomic<bool> numbers_fit{true};
      pool.divide(items, 8, [&](const ThreadPool::Share& share) {
        if (share.thread >= threads) numbers_fit = false;
        for (std::size_t i = share.first; i < share.end; ++i) ++done[i];
      });
      CHECK(numbers_fit);
      CHECK(done == std::vector<int>(items, 1));
    }
  }
}

TEST_CASE("Few items stay with the owner, in one share") {
  ThreadPool pool(4);
  std::size_t shares = 0;
  pool.divide(8, 8, [&](const ThreadPool::Share& share) {
    ++shares;
    CHECK(share.thread == 0);
  });
  CHECK(shares == 1);
}

TEST_CASE("What a share throws reaches the owner: that of the first items, after all are done") {
  ThreadPool pool(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::atomic<int>> done(640);
    const auto work = [&](const ThreadPool::Share& share) {
      for (std::size_t i = share.first; i < share.end; ++i) {
        ++done[i];
        if (i == 100 || i == 600) throw std::runtime_error(std::to_string(i));
      }
    };
    CHECK_THROWS_WITH(pool.divide(done.size(), 8, work), "100");
    // Only the rest of the two shares is left out.
    CHECK(std::accumulate(done.begin(), done.end(), 0) > 560);
  }
  int calls = 0;
  pool.divide(1, 1, [&](const ThreadPool::Share&) { ++calls; });
  CHECK(calls == 1);
}

TEST_CASE("Signals from outside go to the owner") {
  ThreadPool pool(2);
  std::atomic<int> open{0};
  std::atomic<bool> helped{false};
  while (!helped) {
    pool.divide(100, 1, [&](const ThreadPool::Share& share) {
      if (share.thread == 0) return;
      sigset_t blocked;
      pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
      if (!sigismember(&blocked, SIGTERM) || !sigismember(&blocked, SIGINT)) ++open;
      if (sigismember(&blocked, SIGSEGV)) ++open;
      helped = true;
    });
  }
  CHECK(open == 0);
}

TEST_CASE("During its work a helper works for the owner, and before and after for itself") {
  const int owner = ThreadPool::worked_for();
  ThreadPool pool(2);
  std::atomic<bool> helped{false}, fits{true};
  while (!helped) {
    pool.divide(100, 1, [&](const ThreadPool::Share& share) {
      if (ThreadPool::worked_for() != owner) fits = false;
      if (share.thread > 0) helped = true;
    });
  }
  CHECK(fits);
  CHECK(ThreadPool::worked_for() == owner);
  int other = owner;
  std::thread([&] { other = ThreadPool::worked_for(); }).join();
  CHECK(other != owner);
}
