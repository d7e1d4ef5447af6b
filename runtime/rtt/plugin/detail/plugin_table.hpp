// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The plugins loaded into this process and the steps that load one.
#ifndef OROFORGE_PLUGIN_TABLE_HPP
#define OROFORGE_PLUGIN_TABLE_HPP

#include <rtt/Service.hpp>
#include "shared_library.hpp"

#include <mutex>
#include <string>
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
     * else `error` says why not.
     */
    bool load(const std::string& file, Kind kind, std::string& error);

    bool contains(const std::string& fileOrName) const;
    /** The plugin of that name; false if there is none. Services go before others of the same name. */
    bool find(const std::string& name, LoadedPlugin& plugin) const;
    std::vector<LoadedPlugin> all() const;

private:
    bool skip(const std::string& file, const std::string& name) const;
    const LoadedPlugin* same(const std::string& file, const std::string& name) const;

    mutable std::mutex mutex_;  // guards plugins_; never held while code of a plugin runs
    std::vector<LoadedPlugin> plugins_;
};

}  // namespace RTT::plugin

#endif
