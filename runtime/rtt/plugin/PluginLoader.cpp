// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "PluginLoader.hpp"

#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include "detail/plugin_table.hpp"
#include <rtt/plugin/search_path.hpp>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <mutex>

namespace RTT::plugin {
namespace {

/** The transports that are loaded when they are first used, because their libraries are large. */
struct OwnTransport {
    int protocol;
    const char* library;
};
constexpr OwnTransport kOwnTransports[] = {{1, "rtt-transport-corba"}, {2, "rtt-transport-mqueue"}};

bool isOwnTransport(const std::string& file) {
    const std::string name = shortName(file);
    return std::any_of(std::begin(kOwnTransports), std::end(kOwnTransports),
                       [&](const OwnTransport& one) { return name == one.library; });
}

const char* directoryOf(Kind kind) { return kind == Kind::Typekit ? "types" : "plugins"; }

PluginLoader::shared_ptr& instance() {
    // Never destroyed: a static object of the program may end the runtime in its destructor.
    static auto* loader = new PluginLoader::shared_ptr;
    return *loader;
}

std::mutex& instanceMutex() {
    static std::mutex mutex;
    return mutex;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

bool addGlobalService(const LoadedPlugin& plugin) {
    if (!plugin.createService) {
        log(Error) << "plugin '" << plugin.name << "' was found, but it is not a service" << endlog();
        return false;
    }
    const Service::shared_ptr global = internal::GlobalService::Instance();
    return global->hasService(plugin.name) || global->addService(plugin.createService());
}

bool loadInto(const LoadedPlugin& plugin, TaskContext* component, const std::string& owner) {
    try {
        if (component ? plugin.load(component) : addGlobalService(plugin)) return true;
        log(Error) << "service or plugin '" << plugin.name << "' refused to load into " << owner << endlog();
    } catch (const std::exception& error) {
        log(Error) << "service or plugin '" << plugin.name << "' threw while loading into " << owner << ": "
                   << error.what() << endlog();
    } catch (...) {
        log(Error) << "service or plugin '" << plugin.name << "' threw an unknown exception while loading into "
                   << owner << endlog();
    }
    return false;
}

}  // namespace

struct PluginLoader::Impl {
    PluginTable table;
    mutable std::mutex pathMutex;
    std::string path = defaultSearchPath();
    std::map<std::string, std::string> missing;  // transports, with the path in which they were not found

    enum class Transports { All, Others };

    void scan(const std::string& directory, Kind kind, Scan& sum, Transports transports = Transports::All) {
        std::string error;
        for (const std::string& file : librariesIn(directory)) {
            if (transports == Transports::Others && isOwnTransport(file)) continue;
            ++sum.found;
            if (!table.load(file, kind, error)) sum.errors.push_back(file + ": " + error);
        }
    }

    bool scanAll(const std::string& pathList, Kind kind, Transports transports = Transports::All) {
        const Logger::In in("PluginLoader");
        Scan sum;
        for (const std::string& path : splitPathList(pathList))
            for (const std::string& base : withTargetDirectory(path))
                scan(base + "/" + directoryOf(kind), kind, sum, transports);
        for (const std::string& error : sum.errors) log(Error) << "could not load " << error << endlog();
        return sum.found > 0 && sum.errors.empty();
    }

    bool loadFile(const std::string& file, Kind kind) {
        std::string error;
        const bool loaded = table.load(file, kind, error);
        if (!loaded) log(Error) << "could not load " << file << ": " << error << endlog();
        return loaded;
    }

    /** The path of the library with that name; empty if there is none. */
    static std::string fileNamed(const std::string& name, const std::string& pathList, Kind kind) {
        if (isFile(name)) return name;
        for (const std::string& path : splitPathList(pathList))
            for (const std::string& base : withTargetDirectory(path))
                for (const std::string& file : fileNamesOf(name))
                    for (const std::string& found : {base + "/" + directoryOf(kind) + "/" + file, base + "/" + file})
                        if (isFile(found)) return found;
        return {};
    }

    void scanBelow(const std::string& directory, Scan& sum) {
        for (Kind kind : {Kind::Typekit, Kind::Plugin}) scan(directory + "/" + directoryOf(kind), kind, sum);
    }

    /** Loads the library of that name, and everything in the package of that name. */
    bool loadNamed(const std::string& name, const std::string& pathList, Kind kind) {
        const Logger::In in("PluginLoader");
        bool found = table.contains(name), good = true;
        if (const std::string file = found ? std::string() : fileNamed(name, pathList, kind); !file.empty()) {
            found = true;
            good = loadFile(file, kind);
        }
        Scan package;
        for (const std::string& path : splitPathList(name.empty() ? std::string() : pathList))
            for (const std::string& base : withTargetDirectory(path)) scanBelow(base + "/" + name, package);
        for (const std::string& error : package.errors) log(Error) << "could not load " << error << endlog();
        if (found || package.found > 0) return good && package.errors.empty();
        log(Error) << "no " << (kind == Kind::Typekit ? "typekit" : "plugin") << " or package named '" << name
                   << "' in " << pathList << endlog();
        return false;
    }
};

PluginLoader::PluginLoader() : impl_(new Impl) {}

PluginLoader::~PluginLoader() = default;

PluginLoader::shared_ptr PluginLoader::Instance() {
    const std::lock_guard<std::mutex> lock(instanceMutex());
    if (!instance()) instance().reset(new PluginLoader);
    return instance();
}

void PluginLoader::Release() {
    const std::lock_guard<std::mutex> lock(instanceMutex());
    instance().reset();
}

void PluginLoader::loadInstalled() {
    const std::string path = getPluginPath();
    (void)impl_->scanAll(path, Kind::Plugin);
    (void)impl_->scanAll(path, Kind::Typekit, Impl::Transports::Others);
}

bool PluginLoader::loadTransport(int protocol) {
    for (const OwnTransport& one : kOwnTransports) {
        if (one.protocol != protocol || impl_->table.contains(one.library)) continue;
        const std::string path = getPluginPath();
        {
            const std::lock_guard<std::mutex> lock(impl_->pathMutex);
            if (impl_->missing[one.library] == path) return false;  // reported already
        }
        if (loadTypekit(one.library, path)) return true;
        const std::lock_guard<std::mutex> lock(impl_->pathMutex);
        impl_->missing[one.library] = path;
    }
    return false;
}

bool PluginLoader::loadTypekits(const std::string& path_list) { return impl_->scanAll(path_list, Kind::Typekit); }
bool PluginLoader::loadPlugins(const std::string& path_list) { return impl_->scanAll(path_list, Kind::Plugin); }

bool PluginLoader::loadTypekit(const std::string& name, const std::string& path_list) {
    return impl_->loadNamed(name, path_list.empty() ? getPluginPath() : path_list, Kind::Typekit);
}

bool PluginLoader::loadPlugin(const std::string& name, const std::string& path_list) {
    return impl_->loadNamed(name, path_list.empty() ? getPluginPath() : path_list, Kind::Plugin);
}

bool PluginLoader::loadLibrary(const std::string& path) {
    const Logger::In in("PluginLoader");
    std::string error;
    const bool loaded = loadLibrary(path, error);
    if (!loaded) log(Error) << "could not load library '" << path << "': " << error << endlog();
    return loaded;
}

bool PluginLoader::loadLibrary(const std::string& path, std::string& error) {
    const Logger::In in("PluginLoader");
    const std::string directory = fileName(parentPath(absolutePath(path)));
    for (Kind kind : {Kind::Typekit, Kind::Plugin})
        if (directory == directoryOf(kind)) return impl_->table.load(path, kind, error);
    error = "its directory is named '" + directory + "', expected 'types' or 'plugins'";
    return false;
}

PluginLoader::Scan PluginLoader::importDirectory(const std::string& directory) {
    const Logger::In in("PluginLoader");
    Scan sum;
    impl_->scanBelow(directory, sum);
    return sum;
}

void PluginLoader::importAgain(const std::string& package) {
    const Logger::In in("PluginLoader");
    for (const LoadedPlugin& plugin : impl_->table.all()) {
        if (!plugin.importedAgain || fileName(parentPath(parentPath(plugin.file))) != package) continue;
        try {
            plugin.importedAgain();
        } catch (const std::exception& error) {
            log(Error) << "plugin '" << plugin.name << "' threw when it was imported again: " << error.what()
                       << endlog();
        }
    }
}

bool PluginLoader::loadService(const std::string& servicename, TaskContext* tc) {
    const Logger::In in("PluginLoader");
    const std::string owner = tc ? "TaskContext " + tc->getName() : std::string("GlobalService");
    LoadedPlugin plugin;
    if (!impl_->table.find(servicename, plugin)) {
        log(Error) << "no such service or plugin: '" << servicename << "'; services are: " << joined(listServices())
                   << endlog();
        return false;
    }
    log(Info) << "loading service or plugin '" << servicename << "' into " << owner << endlog();
    return loadInto(plugin, tc, owner);
}

bool PluginLoader::isLoaded(const std::string& file) const { return impl_->table.contains(file); }

std::vector<std::string> PluginLoader::listServices() const {
    std::vector<std::string> names;
    for (const LoadedPlugin& plugin : impl_->table.all())
        if (plugin.createService) names.push_back(plugin.name);
    return names;
}

std::vector<std::string> PluginLoader::listPlugins() const {
    std::vector<std::string> names;
    for (const LoadedPlugin& plugin : impl_->table.all())
        if (plugin.kind == Kind::Plugin) names.push_back(plugin.name);
    return names;
}

std::vector<std::string> PluginLoader::listTypekits() const {
    std::vector<std::string> names;
    for (const LoadedPlugin& plugin : impl_->table.all())
        if (plugin.kind == Kind::Typekit) names.push_back(plugin.name);
    return names;
}

std::string PluginLoader::getPluginPath() const {
    const std::lock_guard<std::mutex> lock(impl_->pathMutex);
    return impl_->path;
}

void PluginLoader::setPluginPath(const std::string& newpath) {
    const std::lock_guard<std::mutex> lock(impl_->pathMutex);
    impl_->path = newpath;
}

}  // namespace RTT::plugin
