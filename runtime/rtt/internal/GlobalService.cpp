// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/GlobalService.hpp>

#include <rtt/internal/calls/failed.hpp>
#include <rtt/internal/plugin_loading.hpp>

#include <mutex>

namespace RTT::internal {

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
    return hasService(service) ||
           toldOr("could not load service '" + service + "'", [&] { return loadServicePlugin(service, nullptr); });
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

}  // namespace RTT::internal
