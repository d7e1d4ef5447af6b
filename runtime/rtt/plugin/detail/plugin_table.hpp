// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The plugins loaded into this process and the steps that load one.
#ifndef OROFORGE_PLUGIN_TABLE_HPP
#define OROFORGE_PLUGIN_TABLE_HPP

#include <rtt/Service.hpp>
#include "shared_library.hpp"

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
    std::string name;  // what getRTTPluginName says, else the short name
    Kind kind;
    bool (*load)(TaskContext*);
    Service::shared_ptr (*createService)();  // null: not a service
};

class PluginTable {
public:
    /**
     * Loads one library into the process. True if it is loaded now, also when another of its name was there before;
     * else `error` says why not. Waits for threads that are loading a plugin of the same name; a plugin that in its own
     * start-up code asks for itself gets true. So does one of two plugins that ask for each other in two threads.
     */
    bool load(const std::string& file, Kind kind, std::string& error);

    /** True if it is loaded, or this thread is just starting it. */
    bool contains(const std::string& fileOrName) const;
    /** The plugin of that name; false if there is none. Services go before others of the same name. */
    bool find(const std::string& name, LoadedPlugin& plugin) const;
    std::vector<LoadedPlugin> all() const;

private:
    struct Attempt {
        LoadedPlugin plugin;
        std::thread::id thread;
        const Attempt* awaited = nullptr;  // the one whose end this one waits for
    };
    typedef std::list<Attempt> Attempts;

    bool open(Attempts::iterator attempt, std::string& error);
    bool isFirst(Attempts::iterator attempt);
    bool isHeldUpBy(const Attempt& attempt, std::thread::id thread) const;
    const LoadedPlugin* same(const std::string& file, const std::string& name) const;

    mutable std::mutex mutex_;  // guards all below; never held while code of a plugin runs
    std::vector<LoadedPlugin> plugins_;
    Attempts attempts_;  // in order of their beginning; one waits only for those before it
    std::condition_variable ended_;
};

}  // namespace RTT::plugin

#endif
