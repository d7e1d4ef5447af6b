// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads plugins and knows those that are loaded into this process.
#ifndef OROFORGE_PLUGIN_TABLE_HPP
#define OROFORGE_PLUGIN_TABLE_HPP

#include <rtt/Service.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <condition_variable>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace RTT::plugin {

enum class Kind { Plugin, Typekit };

struct LoadedPlugin {
    std::string file;  // canonical path
    std::string name;  // what getRTTPluginName returns; the short name if there is no such function
    Kind kind;
    bool (*load)(TaskContext*);
    Service::shared_ptr (*createService)();  // null: not a service
    void (*importedAgain)() = nullptr;       // null: of no interest to it
};

class PluginTable {
public:
    /**
     * Loads one library into the process. True if it, or another of its name, is loaded now; otherwise `error` says why
     * not. Waits for threads that are loading a plugin of the same name. A plugin whose start-up code loads the plugin
     * itself gets true, and so does one of two plugins that load each other in two threads.
     */
    bool load(const std::string& file, Kind kind, std::string& error);

    /** True if it is loaded, or this thread is in its start-up code. */
    bool contains(const std::string& fileOrName) const;
    /** Finds the plugin of that name; false if there is none. Services are preferred to other plugins. */
    bool find(const std::string& name, LoadedPlugin& plugin) const;
    std::vector<LoadedPlugin> all() const;

private:
    struct Attempt {
        LoadedPlugin plugin;
        std::thread::id thread;
        const Attempt* awaited = nullptr;  // this one waits for it to end
    };
    typedef std::list<Attempt> Attempts;

    bool open(Attempts::iterator attempt, std::string& error);
    bool isFirst(Attempts::iterator attempt);
    bool isHeldUpBy(const Attempt& attempt, std::thread::id thread) const;
    const LoadedPlugin* same(const std::string& file, const std::string& name) const;

    mutable std::mutex mutex_;  // guards all below; never held while code of a plugin runs
    std::vector<LoadedPlugin> plugins_;
    Attempts attempts_;  // in the order in which they began; each waits only for earlier ones
    std::condition_variable ended_;
};

}  // namespace RTT::plugin

#endif
