// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libraries.hpp"

#include "failure.hpp"

#include <diag/type_match.hpp>
#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <filesystem>

namespace OCL::deploy {

using oroforge::diag::didYouMeanType;
using RTT::ComponentLoader;
using RTT::plugin::PluginLoader;

bool isRemoteType(const std::string& type) {
    return type == "CORBA" || type == "TaskContextProxy" || type == "IORFile" || type == "IOR";
}

std::string componentTypeOf(const std::string& word, std::string& error) {
    if (!isRemoteType(word) && word.find(".so") == std::string::npos) return word;
    const ComponentLoader::shared_ptr loader = ComponentLoader::Instance();
    const std::vector<std::string> known = loader->listComponentTypes();
    if (std::find(known.begin(), known.end(), word) != known.end()) return word;
    if (isRemoteType(word)) {
        error = "type '" + word +
                "' means a component of another process, and this deployer has no CORBA; cdeployer and deployer-corba "
                "have it";
        return word;
    }
    std::error_code none;
    if (!std::filesystem::is_regular_file(word, none)) {
        // No component type has such a name.
        if (word.find('/') != std::string::npos || word.substr(word.size() - 3) == ".so")
            error = "there is no library file '" + word + "'";
        return word;
    }
    if (!loader->loadLibrary(word, error)) {
        error = "could not load library '" + word + "': " + error;
        return word;
    }
    const std::vector<std::string> types = loader->listComponentTypes(word);
    if (types.size() == 1) return types.front();
    error = "library '" + word + "' has " + std::to_string(types.size()) + " component types, name one of them:";
    for (const std::string& type : types) error += " " + type;
    return word;
}

std::string unknownType(const std::string& type) {
    const std::vector<std::string> known = ComponentLoader::Instance()->listComponentTypes();
    if (std::find(known.begin(), known.end(), type) != known.end()) return {};
    const std::string likely = didYouMeanType(type, known);
    return "unknown component type '" + type + "'" +
           (likely.empty() ? "; import the package that has it first" : likely);
}

bool importPackage(const std::string& package) {
    std::string error;
    bool done = false;
    {
        const RTT::internal::FailureReport::Pause others;
        done = ComponentLoader::Instance()->import(package, std::string(), error);
    }
    return done || failed("could not import '" + package + "': " + error);
}

bool loadLibrary(const std::string& file, std::string& error) {
    // Its folder tells whether it is a plugin or a component library.
    std::error_code none;
    const std::string directory = std::filesystem::absolute(file, none).parent_path().filename().string();
    if (directory == "types" || directory == "plugins") return PluginLoader::Instance()->loadLibrary(file, error);
    return ComponentLoader::Instance()->loadLibrary(file, error);
}

std::vector<std::string> directoriesIn(const std::string& paths) {
    std::vector<std::string> all;
    for (std::size_t begin = 0; begin <= paths.size();) {
        const std::size_t end = std::min(paths.find_first_of(":;", begin), paths.size());
        if (end != begin) all.push_back(paths.substr(begin, end - begin));
        begin = end + 1;
    }
    return all;
}

std::vector<std::string> missingDirectories(const std::string& paths) {
    std::vector<std::string> missing;
    std::error_code none;
    for (const std::string& directory : directoriesIn(paths))
        if (!std::filesystem::is_directory(directory, none)) missing.push_back(directory);
    return missing;
}

KeptSearchPath::KeptSearchPath()
    : components_(ComponentLoader::Instance()->getComponentPath()),
      plugins_(PluginLoader::Instance()->getPluginPath()) {}

KeptSearchPath::~KeptSearchPath() {
    ComponentLoader::Instance()->setComponentPath(components_);
    PluginLoader::Instance()->setPluginPath(plugins_);
}

void addSearchPath(const std::string& paths) {
    const ComponentLoader::shared_ptr components = ComponentLoader::Instance();
    const PluginLoader::shared_ptr plugins = PluginLoader::Instance();
    components->setComponentPath(components->getComponentPath() + ":" + paths);
    plugins->setPluginPath(plugins->getPluginPath() + ":" + paths);
}

void importPath(const std::string& paths) {
    for (const std::string& directory : missingDirectories(paths))
        RTT::log(RTT::Warning) << "there is no directory '" << directory << "' to search" << RTT::endlog();
    addSearchPath(paths);
    ComponentLoader::Instance()->import(paths);
}

}  // namespace OCL::deploy
