// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads the toolchain's own plugins and typekits when the runtime starts, and releases the loaders when it ends.
#include "ComponentLoader.hpp"

#include <rtt/internal/service_loader.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/plugin/PluginLoader.hpp>

namespace RTT::plugin {
namespace {

int loadInstalledPlugins() {
    const PluginLoader::shared_ptr loader = PluginLoader::Instance();
    // The loader reports a broken plugin; the program starts without it.
    loader->loadPlugins(loader->getPluginPath());
    loader->loadTypekits(loader->getPluginPath());
    return 0;
}

void releaseLoaders() {
    ComponentLoader::Release();
    PluginLoader::Release();
}

bool loadService(const std::string& service, TaskContext* component) {
    return PluginLoader::Instance()->loadService(service, component);
}

/** Installed by a static object, because components may ask for services in programs that have not started the
    runtime. */
const struct ServiceLoading {
    ServiceLoading() { internal::setServiceLoader(&loadService); }
    ~ServiceLoading() { internal::setServiceLoader(nullptr); }
} serviceLoading;

const os::InitFunction atStart(&loadInstalledPlugins, os::StartPlugins);
const os::CleanupFunction atExit(&releaseLoaders, os::StopPlugins);

}  // namespace
}  // namespace RTT::plugin
