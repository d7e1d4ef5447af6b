// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/service_loader.hpp>

#include <rtt/Logger.hpp>

#include <atomic>

namespace RTT::internal {

namespace {
std::atomic<ServiceLoaderHook> loader{nullptr};
}

void setServiceLoader(ServiceLoaderHook hook) { loader = hook; }

bool loadServicePlugin(const std::string& service, TaskContext* component) {
    if (ServiceLoaderHook load = loader) return load(service, component);
    log(Error) << "service '" << service << "' cannot be loaded: this program has no plugin loader" << endlog();
    return false;
}

}  // namespace RTT::internal
