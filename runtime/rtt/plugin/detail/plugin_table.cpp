// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// To load a library: skip if loaded → open → find symbols → same version → name not taken → same target → start it.
#include "plugin_table.hpp"

#include <rtt/Logger.hpp>
#include <rtt/rtt-config.h>
#include <rtt/plugin/version_guard.hpp>
#include <rtt/plugin/search_path.hpp>

#include <algorithm>
#include <exception>

namespace RTT::plugin {
namespace {

bool refuse(std::string& error, const std::string& why) {
    error = why;
    return false;
}

bool isSame(const LoadedPlugin& plugin, const std::string& file, const std::string& name) {
    return plugin.name == name || fileName(plugin.file) == fileName(file) || shortName(plugin.file) == name;
}

const char* kindOf(const LoadedPlugin& plugin) {
    if (plugin.kind == Kind::Typekit) return "typekit";
    return plugin.createService ? "service" : "plugin";
}

/** "plugin 'name' is built for x, this program for y". */
std::string misfit(const LoadedPlugin& plugin, const std::string& itsOwn, const char* ours) {
    return "plugin '" + plugin.name + "' is built for " + itsOwn + ", this program for " + ours;
}

}  // namespace

bool PluginTable::load(const std::string& file, Kind kind, std::string& error) {
    const std::string path = canonicalPath(file);
    Attempts::iterator attempt;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        attempt = attempts_.insert(
            attempts_.end(),
            Attempt{{path, shortName(path), kind, nullptr, nullptr, nullptr}, std::this_thread::get_id(), nullptr});
    }
    bool done = false;
    try {
        done = !isFirst(attempt) || open(attempt, error);
    } catch (const std::exception& thrown) {
        error = "plugin '" + attempt->plugin.name + "' threw while loading: " + thrown.what();
    } catch (...) {
        error = "plugin '" + attempt->plugin.name + "' threw an unknown exception while loading";
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    for (Attempt& other : attempts_)
        if (other.awaited == &*attempt) other.awaited = nullptr;
    attempts_.erase(attempt);
    ended_.notify_all();
    return done;
}

bool PluginTable::open(Attempts::iterator attempt, std::string& error) {
    LoadedPlugin plugin = attempt->plugin;
    SharedLibrary library(plugin.file, SharedLibrary::Global, error);
    if (!library) return false;
    plugin.load = library.function<bool(TaskContext*)>("loadRTTPlugin");
    plugin.createService = library.function<Service::shared_ptr()>("createService");
    plugin.importedAgain = library.function<void()>("onRTTPluginImportedAgain");
    if (!plugin.load) return refuse(error, "not a plugin, it does not export loadRTTPlugin");
    if (const std::string version = library.otherVersion(); !version.empty())
        return refuse(error, misfit(plugin, version, ORO_BUILT_FOR));

    // From here on, code of the plugin runs. Its exceptions, types and services need the library, so it stays loaded
    // even if it refuses in the end.
    auto* name = library.function<std::string()>("getRTTPluginName");
    auto* target = library.function<std::string()>("getRTTTargetName");
    library.keep();
    if (name) plugin.name = name();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        attempt->plugin = plugin;
    }
    if (!isFirst(attempt)) return true;
    if (target && target() != OROCOS_TARGET_NAME)
        return refuse(error, misfit(plugin, "target " + target(), OROCOS_TARGET_NAME));
    if (!plugin.load(nullptr)) return refuse(error, "plugin '" + plugin.name + "' refused to load into this process");
    log(Info) << "loaded " << kindOf(plugin) << " '" << plugin.name << "' from " << plugin.file << endlog();
    const std::lock_guard<std::mutex> lock(mutex_);
    plugins_.push_back(plugin);
    return true;
}

/** True if the attempt belongs to the thread, or waits for one that does: it cannot end before the thread goes on. */
bool PluginTable::isHeldUpBy(const Attempt& attempt, std::thread::id thread) const {
    const Attempt* next = &attempt;
    while (next && next->thread != thread) {
        // Attempts of a thread are nested, so a thread waits in its last one.
        const auto isOfSameThread = [&](const Attempt& other) { return other.thread == next->thread; };
        next = std::find_if(attempts_.rbegin(), attempts_.rend(), isOfSameThread)->awaited;
    }
    return next != nullptr;
}

/**
 * False if a plugin of its name is loaded, or is being loaded by this thread or by one that waits for it. Waits for
 * attempts of other threads.
 */
bool PluginTable::isFirst(Attempts::iterator attempt) {
    std::unique_lock<std::mutex> lock(mutex_);
    const LoadedPlugin& plugin = attempt->plugin;
    const auto rival = [&] {
        return std::find_if(attempts_.begin(), attempt,
                            [&](const Attempt& other) { return isSame(other.plugin, plugin.file, plugin.name); });
    };
    while (rival() != attempt) {
        if (isHeldUpBy(*rival(), attempt->thread)) return false;
        attempt->awaited = &*rival();
        ended_.wait(lock);
        attempt->awaited = nullptr;
    }
    const LoadedPlugin* known = same(plugin.file, plugin.name);
    if (!known) return true;
    const std::string first = known->file;
    lock.unlock();
    // Loading a file again is routine, but users should see that the first file hides another one.
    log(first == plugin.file ? Debug : Info) << "not loading plugin " << plugin.file << ": '" << plugin.name
                                             << "' is already loaded from " << first << endlog();
    return false;
}

const LoadedPlugin* PluginTable::same(const std::string& file, const std::string& name) const {
    for (const LoadedPlugin& plugin : plugins_)
        if (isSame(plugin, file, name)) return &plugin;
    return nullptr;
}

bool PluginTable::contains(const std::string& fileOrName) const {
    const std::string name = shortName(fileOrName);
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto isStarting = [&](const Attempt& attempt) {
        return attempt.thread == std::this_thread::get_id() && isSame(attempt.plugin, fileOrName, name);
    };
    return same(fileOrName, fileOrName) || same(fileOrName, name) ||
           std::any_of(attempts_.begin(), attempts_.end(), isStarting);
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
