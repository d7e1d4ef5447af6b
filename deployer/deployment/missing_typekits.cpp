// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "missing_typekits.hpp"

#include "libraries.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <boost/core/demangle.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace OCL::deploy {
namespace {

namespace fs = std::filesystem;

/** The entries of a folder; none if it cannot be read. */
std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::error_code none;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none))
        found.push_back(entry->path());
    std::sort(found.begin(), found.end());
    return found;
}

/** True if the library contains the name of the type in its type information, as each library does that uses values of
    it. */
bool holds(const fs::path& library, const std::type_info& type) {
    std::ifstream in(library, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::string name = type.name();
    return bytes.find(std::string(1, '\0') + name + '\0') != std::string::npos;
}

bool hasTypekit(const fs::path& package, const std::type_info& type) {
    if (package.filename() == OROCOS_TARGET_NAME) return false;  // not a package but the folder of all packages
    const std::vector<fs::path> libraries = entriesOf(package / "types");
    return std::any_of(libraries.begin(), libraries.end(), [&](const fs::path& library) {
        return library.filename().string().find(".so") != std::string::npos &&
               !RTT::plugin::PluginLoader::Instance()->isLoaded(library.string()) && holds(library, type);
    });
}

/** The packages on the search path whose typekits have the type. */
std::vector<std::string> packagesWith(const std::type_info& type) {
    std::set<std::string> names;
    // Plain types are the runtime's own; their names, one letter, may be anywhere in a library.
    if (std::strlen(type.name()) == 1) return {};
    for (const fs::path folder : directoriesIn(RTT::ComponentLoader::Instance()->getComponentPath()))
        for (const fs::path& base : {folder, folder / OROCOS_TARGET_NAME})
            for (const fs::path& package : entriesOf(base))
                if (hasTypekit(package, type)) names.insert(package.filename().string());
    return {names.begin(), names.end()};
}

std::string adviceFor(const std::vector<std::string>& packages) {
    if (packages.empty()) return "an 'Import' statement with the name of the package that has the typekit loads it";
    return "the typekit of package " + oroforge::diag::oneOf(packages) +
           " has it: <simple name=\"Import\" type=\"string\"><value>" + packages.front() + "</value></simple>";
}

}  // namespace

std::string typekitAdvice(const std::type_info& type) { return adviceFor(packagesWith(type)); }

bool MissingTypekits::isTransported(const PortPlan& port) const {
    return std::any_of(plan_.policies.begin(), plan_.policies.end(), [&](const PolicyPlan& policy) {
        return policy.name.value == port.connection.value && policy.policy.transport != 0;
    });
}

const std::vector<std::string>& MissingTypekits::packagesOf(const std::type_info& type) {
    const auto known = found_.find(type.name());
    return known != found_.end() ? known->second : found_.emplace(type.name(), packagesWith(type)).first->second;
}

void MissingTypekits::check(const ComponentPlan& component, const RTT::internal::ComponentDescription& description) {
    for (const auto& port : description.ports) {
        if (RTT::types::TypeInfoRepository::Instance()->getTypeById(port.type)) continue;
        const auto used = std::find_if(component.ports.begin(), component.ports.end(),
                                       [&](const PortPlan& one) { return one.port.value == port.name; });
        const bool isUsed = used != component.ports.end();
        if (reported_.count(port.type->name())) continue;
        const std::vector<std::string>& packages = packagesOf(*port.type);
        if (packages.empty() && !(isUsed && isTransported(*used))) continue;
        reported_.insert(port.type->name());
        sink_
            .warning(isUsed ? used->port.where : component.type.where, "DEP066",
                     "no loaded typekit has the type '" + boost::core::demangle(port.type->name()) + "' of port '" +
                         component.name.value + "." + port.name + "'")
            .hint(adviceFor(packages));
    }
}

}  // namespace OCL::deploy
