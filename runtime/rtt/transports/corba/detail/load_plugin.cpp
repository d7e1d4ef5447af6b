// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/load_plugin.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/transports/corba/detail/end_point.hpp>

#include <stdexcept>
#include <string>

namespace RTT::corba::detail {

namespace {

bool loadPlugin(const std::string& path) {
    const Logger::In in("TaskContextServer");
    if (othersCanConnect()) {
        log(Error) << "another process asks for library '" << path
                   << "', which is not loaded: other computers can connect to this process" << endlog();
        throw std::runtime_error("library '" + path +
                                 "' is not loaded: other computers can connect to the process, which loads libraries "
                                 "only if its end points are 127.0.0.1");
    }
    std::string why;
    const bool loaded = plugin::PluginLoader::Instance()->loadLibrary(path, why);
    if (loaded)
        log(Info) << "library '" << path << "' is loaded, for which another process asks" << endlog();
    else
        log(Error) << "another process asks for library '" << path << "', which cannot be loaded: " << why << endlog();
    return loaded;
}

}  // namespace

const OperationInterface& operationsOfEveryService() {
    static auto* const service = [] {
        auto* const made = new Service::shared_ptr(Service::Create("everyService"));
        (*made)
            ->addOperation("loadPlugin", &loadPlugin)
            .doc("Loads a library into this process.")
            .arg("plugin_path", "file of the library, in a folder 'plugins' or 'types'");
        return made;
    }();
    return **service;
}

}  // namespace RTT::corba::detail
