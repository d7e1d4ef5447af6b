// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/plugin_loading.hpp>

#include <rtt/Logger.hpp>

#include <atomic>

namespace RTT::internal {

namespace {
std::atomic<ServiceLoaderHook> serviceLoader{nullptr};
std::atomic<TransportLoaderHook> transportLoader{nullptr};
}  // namespace

void setPluginLoader(ServiceLoaderHook services, TransportLoaderHook transports) {
    serviceLoader = services;
    transportLoader = transports;
}

bool loadServicePlugin(const std::string& service, TaskContext* component) {
    if (const ServiceLoaderHook load = serviceLoader) return load(service, component);
    log(Error) << "service '" << service << "' cannot be loaded: this program has no plugin loader" << endlog();
    return false;
}

bool loadTransportPlugin(int protocol) {
    const TransportLoaderHook load = transportLoader;
    return load && load(protocol);
}

}  // namespace RTT::internal
