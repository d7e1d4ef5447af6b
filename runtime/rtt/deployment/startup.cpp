// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads the toolchain's own plugins and typekits when the runtime starts, and releases the loaders when it ends.
#include "ComponentLoader.hpp"

#include <rtt/internal/plugin_loading.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/plugin/PluginLoader.hpp>

namespace RTT::plugin {
namespace {

int loadInstalledPlugins() {
    // The loader reports a broken plugin; the program starts without it.
    PluginLoader::Instance()->loadInstalled();
    return 0;
}

void releaseLoaders() {
    ComponentLoader::Release();
    PluginLoader::Release();
}

bool loadService(const std::string& service, TaskContext* component) {
    return PluginLoader::Instance()->loadService(service, component);
}

bool loadTransport(int protocol) { return PluginLoader::Instance()->loadTransport(protocol); }

/** Installed by a static object, because components may ask for services in programs that have not started the
    runtime. */
const struct PluginLoading {
    PluginLoading() { internal::setPluginLoader(&loadService, &loadTransport); }
    ~PluginLoading() { internal::setPluginLoader(nullptr, nullptr); }
} pluginLoading;

const os::InitFunction atStart(&loadInstalledPlugins, os::StartPlugins);
const os::CleanupFunction atExit(&releaseLoaders, os::StopPlugins);

}  // namespace
}  // namespace RTT::plugin
