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
 * A path list holds directories separated by ':' or ';'. Libraries are opened with RTLD_NOW | RTLD_LOCAL. The first
 * library that registers a component type keeps it; a later one of the same name is reported once and not used. Only a
 * library's own types count, not those of component libraries it links.
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
     * Drops the process' reference, so that the next loader begins with nothing imported; not while components exist that
     * it made, for somebody uses it then. Component libraries stay loaded in any case.
     */
    static void Release();

    virtual ~ComponentLoader();
    ComponentLoader(const ComponentLoader&) = delete;
    ComponentLoader& operator=(const ComponentLoader&) = delete;

    /**
     * Imports the components, typekits and plugins that lie in each directory of the list and in its `<target>`
     * sub-directory; packages below them are not imported.
     * @return true if anything was imported; a search path that holds packages only is no error.
     * @throw std::runtime_error after all have been tried, if a library could not be loaded; the errors are logged.
     */
    virtual bool import(const std::string& path_list);

    /**
     * Imports a package: a library file, an absolute directory, or a name that is looked up in the current directory
     * and then in the path list (empty: getComponentPath()); the first directory that has it wins. What is not there is
     * looked for as a ROS package below ROS_PACKAGE_PATH: its `lib/orocos` is imported, after that of all packages on which
     * it depends. An imported package or a known component type is not imported again.
     * @return false if nothing was found.
     * @throw std::runtime_error after all libraries have been tried, if one could not be loaded; the errors are logged.
     */
    virtual bool import(const std::string& package, const std::string& path_list);

    /** As above, but throws and logs no error: false with the reasons in `error` if anything could not be imported. */
    bool import(const std::string& package, const std::string& path_list, std::string& error);

    /**
     * Imports a package from the search path; false with the reasons in `error`. What lies in the current directory is not
     * looked at: for packages that nobody has asked for.
     */
    bool importInstalled(const std::string& package, std::string& error);

    /** Loads one component library file. Already loaded: true. */
    bool loadLibrary(const std::string& path);
    /** As above; the reason of a failure is stored in `error` instead of being logged. */
    bool loadLibrary(const std::string& path, std::string& error);
    /**
     * Unloads a library and forgets its types; packages it belongs to can be imported again. False if the file is not
     * loaded, or a component exists that loadComponent made from it. The loader does not know of anything else that needs
     * the library's code: components made by a function of getFactories() or by the library itself, operation callers and
     * send handles of its operations, data sources and samples of its types. Delete or disconnect them first. Waits for
     * the data path of all threads.
     */
    bool unloadLibrary(const std::string& filepath);
    /**
     * Unloads and loads a library again, on the same conditions. False, too, if it stays in memory meanwhile, because
     * something else holds it; then its types stay as they were. If the file cannot be loaded again, it stays unloaded, and
     * packages it belongs to can be imported again.
     */
    bool reloadLibrary(const std::string& filepath);

    /**
     * Creates a component. Null, with the reason logged, if the type is unknown, the name is in use in this loader, or
     * the constructor throws. The component is deleted by unloadComponent.
     */
    TaskContext* loadComponent(const std::string& name, const std::string& type);
    /** As above; the reason of a failure is stored in `error` instead of being logged. */
    TaskContext* loadComponent(const std::string& name, const std::string& type, std::string& error);
    /** Deletes a component made by loadComponent; its library stays loaded. False for a foreign or null component. */
    bool unloadComponent(TaskContext* tc);

    /** True if the name is an imported package, a loaded library or a known component type. */
    bool isImported(const std::string& type_name) const;
    /** Names of the components that exist, in order of creation. */
    std::vector<std::string> listComponents() const;
    /** Names of the types that can be created, sorted; those linked into the program included. */
    std::vector<std::string> listComponentTypes() const;
    /** Names of the types that a loaded library has and that can be created; empty for other files. */
    std::vector<std::string> listComponentTypes(const std::string& library) const;

    /** The search path. Initially RTT_COMPONENT_PATH and `orocos` beside the runtime's library. */
    std::string getComponentPath() const;
    /** Replaces the search path; imports nothing. */
    void setComponentPath(const std::string& newpath);

    /** The types that can be created now and how, by name; the program's own included. Valid as long as the loader. */
    const FactoryMap& getFactories() const;
    /** Registers a type by hand; replaces one of the same name. */
    void addFactory(const std::string& type_name, ComponentLoaderSignature factory);

private:
    struct Impl;
    ComponentLoader();
    std::unique_ptr<Impl> impl_;
};

}  // namespace RTT

#endif
