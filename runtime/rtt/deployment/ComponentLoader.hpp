// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_COMPONENT_LOADER_HPP
#define ORO_COMPONENT_LOADER_HPP

#include <rtt/Component.hpp>
#include <rtt/rtt-config.h>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {

/**
 * Loads component libraries and creates components from them.
 *
 * A path list holds directories separated by ':' or ';'. Libraries are opened with RTLD_NOW | RTLD_LOCAL. If two
 * libraries register a component type of the same name, the first is used and the second is reported once. A library's
 * types do not include those of component libraries that it links.
 *
 * No function here is real-time: all read the file system or allocate, and may block. They may be called from any
 * thread; component constructors run in the calling thread, without a lock held.
 */
class RTT_API ComponentLoader {
public:
    typedef boost::shared_ptr<ComponentLoader> shared_ptr;

    /** The one loader of the process. The first call reads RTT_COMPONENT_PATH. */
    static shared_ptr Instance();
    /**
     * Drops the process' reference, so that the next loader begins with nothing imported. Does nothing while components
     * exist that the loader made. Component libraries stay loaded in any case.
     */
    static void Release();

    virtual ~ComponentLoader();
    ComponentLoader(const ComponentLoader&) = delete;
    ComponentLoader& operator=(const ComponentLoader&) = delete;

    /**
     * Imports the components, typekits and plugins in each directory of the list and in its `<target>` sub-directory;
     * packages below them are not imported.
     * @return true if anything was imported; a search path that holds only packages is not an error.
     * @throw std::runtime_error if a library could not be loaded, after all were tried; the errors are logged.
     */
    virtual bool import(const std::string& path_list);

    /**
     * Imports a package: a library file, an absolute directory, or a name that is looked up in the current directory
     * and then in the path list (empty: getComponentPath()); the first directory that has it wins. If none has it, it
     * is looked up as a ROS package (ros_packages.hpp): its libraries are imported, after those of all packages on
     * which it depends. An imported package or a known component type is not imported again.
     * @return false if nothing was found.
     * @throw std::runtime_error if a library could not be loaded, after all were tried; the errors are logged.
     */
    virtual bool import(const std::string& package, const std::string& path_list);

    /** As above, but neither throws nor logs errors: false with the reasons in `error` if anything could not be
        imported. */
    bool import(const std::string& package, const std::string& path_list, std::string& error);

    /**
     * Imports a package that nobody asked for by name: from the search path, not from the current directory. On failure
     * returns false with the reasons in `error`. Its typekits and plugins are loaded now. A component library that has
     * the names of its types in its file, as the macros write them, is loaded when one of the types is needed; what
     * keeps it from being loaded is the reason why the component cannot be created. import() of the package loads all
     * of it.
     */
    bool importInstalled(const std::string& package, std::string& error);

    /**
     * Imports a ROS package as rtt_ros::import() does: after the packages that its package.xml names as
     * `plugin_depend`, and those of these, each once. A package without libraries is no failure. False with the reasons
     * in `error` if anything could not be imported; the others are imported all the same.
     */
    bool importRos(const std::string& package, std::string& error);

    /** Loads one component library file. True also if it is loaded already. */
    bool loadLibrary(const std::string& path);
    /** As above, but stores the reason of a failure in `error` instead of logging it. */
    bool loadLibrary(const std::string& path, std::string& error);
    /**
     * Unloads a library and forgets its types; packages to which it belongs can be imported again. False if the file is
     * not loaded, or if a component exists that loadComponent made from it. The loader cannot see what else needs the
     * code of the library: components made by a function of getFactories() or by the library itself, operation callers
     * and send handles of its operations, data sources and samples of its types. Delete or disconnect them first. Waits
     * until no thread is in the data path.
     */
    bool unloadLibrary(const std::string& filepath);
    /**
     * Unloads a library, on the same conditions, and loads it again. Also false if it stays in memory because something
     * else holds it; its types then stay as they were. If the file cannot be loaded again, it stays unloaded, and
     * packages to which it belongs can be imported again.
     */
    bool reloadLibrary(const std::string& filepath);

    /**
     * Creates a component. Null, with the reason logged, if the type is unknown, the name is in use in this loader, or
     * the constructor throws. The component is deleted by unloadComponent.
     */
    TaskContext* loadComponent(const std::string& name, const std::string& type);
    /** As above, but stores the reason of a failure in `error` instead of logging it. */
    TaskContext* loadComponent(const std::string& name, const std::string& type, std::string& error);
    /** Deletes a component made by loadComponent; its library stays loaded. False for a foreign or null component. */
    bool unloadComponent(TaskContext* tc);

    /** True if the name is an imported package, a loaded library or a known component type. */
    bool isImported(const std::string& type_name) const;
    /** Names of the components that exist, in order of creation. */
    std::vector<std::string> listComponents() const;
    /** Names of the types that can be created, sorted, including those linked into the program. */
    std::vector<std::string> listComponentTypes() const;
    /** Names of the types of a loaded library that can be created; empty for other files. */
    std::vector<std::string> listComponentTypes(const std::string& library) const;

    /** The search path. Initially RTT_COMPONENT_PATH and `orocos` beside the runtime's library. */
    std::string getComponentPath() const;
    /** Replaces the search path; imports nothing. */
    void setComponentPath(const std::string& newpath);

    /** The types that can be created now and their functions, by name; the program's included. Valid as long as the
        loader. */
    const FactoryMap& getFactories() const;
    /** The function of one type, null if it cannot be created. Of libraries that wait to be loaded, only that of the
        type is loaded. */
    ComponentLoaderSignature factoryOf(const std::string& type_name) const;
    /** Registers a type, or replaces one of the same name. */
    void addFactory(const std::string& type_name, ComponentLoaderSignature factory);

private:
    struct Impl;
    ComponentLoader();
    std::unique_ptr<Impl> impl_;
};

}  // namespace RTT

#endif
