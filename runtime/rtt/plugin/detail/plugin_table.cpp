// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One library: skip if there → open → has the symbols → name not taken → same target → accepts the process → keep.
#include "plugin_table.hpp"

#include <rtt/Logger.hpp>
#include <rtt/rtt-config.h>
#include "search_path.hpp"

#include <exception>

namespace RTT::plugin {
namespace {

bool refuse(std::string& error, const std::string& why) {
    error = why;
    return false;
}

/** Runs the plugin's own start-up code; its exceptions end here. */
bool acceptsProcess(const LoadedPlugin& plugin, std::string& error) {
    try {
        return plugin.load(nullptr) || refuse(error, "plugin '" + plugin.name + "' refused to load into this process");
    } catch (const std::exception& thrown) {
        return refuse(error, "plugin '" + plugin.name + "' threw while loading: " + thrown.what());
    } catch (...) {
        return refuse(error, "plugin '" + plugin.name + "' threw an unknown exception while loading");
    }
}

}  // namespace

bool PluginTable::load(const std::string& file, Kind kind, std::string& error) {
    const std::string path = canonicalPath(file);
    if (skip(path, shortName(path))) return true;

    SharedLibrary library(path, SharedLibrary::Global, error);
    if (!library) return false;
    LoadedPlugin plugin{path, shortName(path), kind, library.function<bool(TaskContext*)>("loadRTTPlugin"),
                        library.function<Service::shared_ptr()>("createService")};
    if (!plugin.load) return refuse(error, "not a plugin, it does not export loadRTTPlugin");
    if (auto* name = library.function<std::string()>("getRTTPluginName")) plugin.name = name();
    if (skip(path, plugin.name)) return true;
    if (auto* target = library.function<std::string()>("getRTTTargetName"); target && target() != OROCOS_TARGET_NAME)
        return refuse(error, "plugin '" + plugin.name + "' is built for target " + target() +
                                 ", this program for " OROCOS_TARGET_NAME);
    if (!acceptsProcess(plugin, error)) return false;

    library.keep();
    log(Info) << "loaded "
              << (kind == Kind::Typekit  ? "typekit"
                  : plugin.createService ? "service"
                                         : "plugin")
              << " '" << plugin.name << "' from " << path << endlog();
    const std::lock_guard<std::mutex> lock(mutex_);
    plugins_.push_back(plugin);
    return true;
}

bool PluginTable::skip(const std::string& file, const std::string& name) const {
    std::string first;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const LoadedPlugin* other = same(file, name);
        if (!other) return false;
        first = other->file;
    }
    // The same file again is routine; another one that is hidden by the first deserves to be seen.
    log(first == file ? Debug : Info) << "not loading plugin " << file << ": '" << name << "' is already loaded from "
                                      << first << endlog();
    return true;
}

const LoadedPlugin* PluginTable::same(const std::string& file, const std::string& name) const {
    for (const LoadedPlugin& plugin : plugins_)
        if (plugin.name == name || fileName(plugin.file) == fileName(file) || shortName(plugin.file) == name)
            return &plugin;
    return nullptr;
}

bool PluginTable::contains(const std::string& fileOrName) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return same(fileOrName, fileOrName) || same(fileOrName, shortName(fileOrName));
}

bool PluginTable::find(const std::string& name, LoadedPlugin& plugin) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const LoadedPlugin* found = nullptr;
    for (const LoadedPlugin& candidate : plugins_)
        if (candidate.name == name && (!found || (candidate.createService && !found->createService)))
            found = &candidate;
    if (found) plugin = *found;
    return found != nullptr;
}

std::vector<LoadedPlugin> PluginTable::all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return plugins_;
}

}  // namespace RTT::plugin
