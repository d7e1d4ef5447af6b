// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/GlobalService.hpp>

#include <rtt/internal/FailureReport.hpp>
#include <rtt/internal/ServiceLoader.hpp>

#include <mutex>

namespace RTT {
namespace internal {

namespace {
std::mutex mutex;
Service::shared_ptr& holder() {
    static Service::shared_ptr one;
    return one;
}
}  // namespace

GlobalService::GlobalService() : Service("GlobalService") {
    addOperation("require", &GlobalService::require, this)
        .doc("Makes a process-wide service available; loads the plugin that brings it.")
        .arg("service_name", "The name of the service");
}

bool GlobalService::require(const std::string& service) {
    if (hasService(service)) return true;
    if (!FailureReport::isWanted()) return loadServicePlugin(service, nullptr);
    bool done = false;
    std::string errors;
    {
        KeptErrors kept;
        const FailureReport::Pause others;
        done = loadServicePlugin(service, nullptr);
        if (!done) errors = kept.take();
    }
    return done || !FailureReport::give("could not load service '" + service + "': " + errors);
}

Service::shared_ptr GlobalService::Instance() {
    std::lock_guard<std::mutex> lock(mutex);
    if (!holder()) holder().reset(new GlobalService());
    return holder();
}

void GlobalService::Release() {
    std::lock_guard<std::mutex> lock(mutex);
    holder().reset();
}

}  // namespace internal
}  // namespace RTT
