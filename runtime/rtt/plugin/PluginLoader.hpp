// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PLUGIN_LOADER_HPP
#define ORO_PLUGIN_LOADER_HPP

#include <rtt/rtt-config.h>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;

namespace plugin {

/**
 * Loads service, typekit and transport plugins into the process and into components.
 *
 * A path list holds directories separated by ':' or ';'. Below each directory p, plugins are in `p/plugins` and
 * `p/<target>/plugins`, typekits and transports in `p/types` and `p/<target>/types`. If two libraries have the same
 * file name, plugin name or short name (file name without `lib`, target and suffix), the first path wins: the second
 * library is skipped, which counts as success.
 *
 * Libraries are opened with RTLD_NOW | RTLD_GLOBAL and stay loaded until the process ends, because types and services
 * made from them may live as long. No function here is real-time: all read the file system and may block; all may be
 * called from any thread. Errors are logged and returned as false, never thrown.
 */
class RTT_API PluginLoader {
public:
    typedef boost::shared_ptr<PluginLoader> shared_ptr;

    /** The result of a directory scan: the number of libraries, and "file: reason" for each that could not be
        loaded. */
    struct Scan {
        unsigned found = 0;
        std::vector<std::string> errors;
    };

    /** The one loader of the process. The first call reads RTT_COMPONENT_PATH. */
    static shared_ptr Instance();
    /** Drops the process' reference; plugins stay loaded. Called at __os_exit. */
    static void Release();

    ~PluginLoader();
    PluginLoader(const PluginLoader&) = delete;
    PluginLoader& operator=(const PluginLoader&) = delete;

    /** What the runtime loads when it starts: all plugins and typekits of getPluginPath(), except for the toolchain's
        own transports, which loadTransport() loads when they are first used. */
    void loadInstalled();
    /** Loads the toolchain's own transport for a protocol. False if it has none, or if that is loaded already. */
    bool loadTransport(int protocol);
    /** Loads all typekits and transports below each directory. True if there were any and all could be loaded. */
    bool loadTypekits(const std::string& path_list);
    /**
     * Loads one typekit by name ("robot-typekit" for `librobot-typekit-<target>.so`), and, if the name is that of a
     * package, everything in `p/name/{types,plugins}` and `p/<target>/name/{types,plugins}`, for each p of the list.
     * Empty list: getPluginPath(). False if there is neither, or something cannot be loaded.
     */
    bool loadTypekit(const std::string& name, const std::string& path_list = std::string());
    /** Loads all plugins below each directory. True if there were any and all could be loaded. */
    bool loadPlugins(const std::string& path_list);
    /** Loads one plugin by name, as loadTypekit() does. */
    bool loadPlugin(const std::string& name, const std::string& path_list = std::string());
    /** Loads one library file; its directory must be named `types` or `plugins`. */
    bool loadLibrary(const std::string& path);
    /** As above, but stores the reason of a failure in `error` instead of logging it. */
    bool loadLibrary(const std::string& path, std::string& error);
    /** Loads `directory/types` and `directory/plugins`, to import a package. Returns errors instead of logging them. */
    Scan importDirectory(const std::string& directory);
    /** Calls `extern "C" void onRTTPluginImportedAgain()` of the loaded plugins of a package that export it, because a
        user has imported the package again: what they could not do at first may be possible now. */
    void importAgain(const std::string& package);

    /**
     * Adds the service or plugin to a component, or to GlobalService if the component is null. False if there is none
     * of that name, or if it refuses or throws.
     */
    bool loadService(const std::string& servicename, TaskContext* tc);

    /** True if a library with that file name, plugin name or short name is loaded; directories are ignored. */
    bool isLoaded(const std::string& file) const;

    /** Names of the loaded plugins that provide a service. */
    std::vector<std::string> listServices() const;
    /** Names of all loaded plugins other than typekits; services included. */
    std::vector<std::string> listPlugins() const;
    /** Names of all loaded typekits and transports. */
    std::vector<std::string> listTypekits() const;

    /** The search path. Initially RTT_COMPONENT_PATH and `orocos` beside the runtime's library. */
    std::string getPluginPath() const;
    /** Replaces the search path; loads nothing. */
    void setPluginPath(const std::string& newpath);

private:
    struct Impl;
    PluginLoader();
    std::unique_ptr<Impl> impl_;
};

}  // namespace plugin
}  // namespace RTT

#endif
