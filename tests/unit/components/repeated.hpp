// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_COMPONENTS_REPEATED_HPP
#define OROFORGE_TESTS_COMPONENTS_REPEATED_HPP

#include <atomic>
#include <functional>
#include <thread>

namespace components_test {

/** Calls a function again and again. */
class Repeated {
public:
    explicit Repeated(std::function<void()> work)
        : thread_([this, work] {
              while (!ended_) {
                  work();
                  std::this_thread::yield();
              }
          }) {}
    ~Repeated() {
        ended_ = true;
        thread_.join();
    }

private:
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

}  // namespace components_test

#endif
