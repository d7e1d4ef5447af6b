// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/GlobalEngine.hpp>

#include <rtt/Activity.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/os/StartStopManager.hpp>

#include <memory>
#include <mutex>

namespace RTT {
namespace internal {

namespace {

struct Holder {
    Holder() : activity(&engine, "GlobalEngine") { activity.start(); }
    ~Holder() {
        activity.stop();
        activity.run(nullptr);
    }
    ExecutionEngine engine;
    Activity activity;
};

std::mutex mutex;
std::unique_ptr<Holder>& holder() {
    static std::unique_ptr<Holder> one;
    return one;
}

// __os_exit() ends the thread before it takes away what the thread may use.
const os::CleanupFunction releaseAtExit(&GlobalEngine::Release, os::StopEngines);

}  // namespace

ExecutionEngine* GlobalEngine::Instance() {
    std::lock_guard<std::mutex> lock(mutex);
    if (!holder()) holder() = std::make_unique<Holder>();
    return &holder()->engine;
}

void GlobalEngine::Release() {
    std::lock_guard<std::mutex> lock(mutex);
    holder().reset();
}

}  // namespace internal
}  // namespace RTT
