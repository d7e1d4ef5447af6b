// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/view.hpp>

#include <cctype>
#include <map>
#include <regex>
#include <set>

#include <model/cpp_type.hpp>
#include <model/doc_text.hpp>
#include <model/literal.hpp>
#include <model/names.hpp>
#include <view/cpp_text.hpp>
#include <view/interface_view.hpp>
#include <view/skeleton_view.hpp>
#include <xml/escape.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

std::string orElse(const model::Text& text, const char* fallback) { return text.given() ? text.value : fallback; }

json people(const std::vector<model::Person>& persons) {
    json list = json::array();
    for (const model::Person& person : persons) {
        list.push_back(
            {{"name", xml::escapeText(person.name.value)}, {"email", xml::escapeAttribute(person.email.value)}});
    }
    return list;
}

json maintainersOf(const model::Package& package) {
    json list = people(package.maintainers);
    // package.xml must have at least one maintainer.
    if (list.empty()) list.push_back({{"name", "Unknown"}, {"email", "unknown@example.org"}});
    return list;
}

/// Returns the CPF word for a type; empty for types that CPF has no word for.
std::string cpfType(const std::string& type) {
    switch (model::classify(type)) {
        case model::TypeClass::Boolean: return "boolean";
        case model::TypeClass::Signed: return model::integerBits(type) == 32 ? "long" : "";
        case model::TypeClass::Unsigned: return model::integerBits(type) == 32 ? "ulong" : "";
        case model::TypeClass::Float: return "float";
        case model::TypeClass::Double: return "double";
        case model::TypeClass::Character: return "char";
        case model::TypeClass::String: return "string";
        case model::TypeClass::Other: break;
    }
    return {};
}

json deployedProperties(const model::Component& component) {
    json list = json::array();
    for (const model::Property& property : component.properties) {
        const std::string type = cpfType(property.type.value);
        if (!property.defaultValue.given() || type.empty()) continue;
        std::string value = property.defaultValue.value;
        const std::string literal = type == "string" ? model::stringLiteral(value)
                                    : type == "char" ? "'" + value + "'"
                                                     : value;
        if (type == "boolean") value = value == "true" ? "1" : "0";
        list.push_back(
            {{"name", property.name.value}, {"type", type}, {"value", xml::escapeText(value)}, {"literal", literal}});
    }
    return list;
}

struct Connection {
    std::string type;
    const model::Port* input = nullptr;
    std::vector<std::string> inputs;   ///< instances with such an input
    std::vector<std::string> outputs;  ///< instances with such an output
    bool isConnectable() const { return input != nullptr && !outputs.empty(); }
};

/// Ports of one name and type, at least one output and one input, make a connection with that name.
std::map<std::string, Connection> connectionsOf(const model::Package& package) {
    std::map<std::string, Connection> connections;
    for (const auto& component : package.components) {
        const std::string instance = instanceName(model::lastName(component.className.value));
        for (const auto& port : component.ports) {
            const std::string type = model::normalised(port.type.value);
            Connection& connection =
                connections.emplace(port.name.value, Connection{type, nullptr, {}, {}}).first->second;
            if (connection.type != type) continue;
            const bool output = port.direction == model::Direction::Out;
            (output ? connection.outputs : connection.inputs).push_back(instance);
            if (!output && (connection.input == nullptr || port.policy)) connection.input = &port;
        }
    }
    return connections;
}

int policyNumber(const std::string& type) { return type == "buffer" ? 1 : type == "circular_buffer" ? 2 : 0; }

json connectionViews(const std::map<std::string, Connection>& connections) {
    json list = json::array();
    for (const auto& [name, connection] : connections) {
        if (!connection.isConnectable()) continue;
        const auto& policy = connection.input->policy;
        json size = policy && policy->size ? json(policy->size->text) : json(nullptr);
        json links = json::array();
        for (const std::string& output : connection.outputs) {
            for (const std::string& input : connection.inputs) {
                links.push_back({{"from", output + "." + name}, {"to", input + "." + name}});
            }
        }
        list.push_back({{"name", name},
                        {"policyType", policy ? policyNumber(policy->type) : 0},
                        {"size", size},
                        {"links", links}});
    }
    return list;
}

json deployedPorts(const model::Component& component, const std::map<std::string, Connection>& connections) {
    json list = json::array();
    for (const model::Port& port : component.ports) {
        const Connection& connection = connections.at(port.name.value);
        if (connection.isConnectable() && connection.type == model::normalised(port.type.value)) {
            list.push_back({{"name", port.name.value}});
        }
    }
    return list;
}

json componentEntries(const model::Package& package) {
    const auto connections = connectionsOf(package);
    json list = json::array();
    for (const model::Component& component : package.components) {
        const std::string name = model::lastName(component.className.value);
        json entry{{"class", name}, {"qualified", component.className.value}, {"instance", instanceName(name)}};
        entry["summary"] = component.doc.empty() ? json(nullptr) : json(model::oneLine(component.doc));
        entry["properties"] = deployedProperties(component);
        entry["hasProperties"] = !entry["properties"].empty();
        entry["ports"] = deployedPorts(component, connections);
        entry["hasPorts"] = !entry["ports"].empty();
        list.push_back(entry);
    }
    return list;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<std::string> typekitHeaders(const model::Package& package) {
    std::vector<std::string> headers;
    for (const auto& header : package.typekitHeaders) headers.push_back(header.value);
    return headers;
}

/// Returns all headers that other packages may include.
std::vector<std::string> installedHeaders(const model::Package& package) {
    std::vector<std::string> headers = typekitHeaders(package);
    for (const auto& component : package.components)
        headers.push_back("src/" + model::lastName(component.className.value) + ".hpp");
    for (const auto& service : package.services)
        headers.push_back("src/" + model::lastName(service.className.value) + ".hpp");
    return headers;
}

json serviceEntries(const model::Package& package) {
    json list = json::array();
    for (const model::ServicePlugin& service : package.services) {
        list.push_back({{"class", model::lastName(service.className.value)},
                        {"qualified", service.className.value},
                        {"service", service.name.value},
                        {"target", package.name.value + "-" + service.name.value + "-service"},
                        {"summary", service.doc.empty() ? json(nullptr) : json(model::oneLine(service.doc))}});
    }
    return list;
}

json pluginEntries(const model::Package& package) {
    json list = json::array();
    for (const model::Plugin& plugin : package.plugins) {
        list.push_back({{"name", plugin.name.value},
                        {"plugin", plugin.name.value},
                        {"target", package.name.value + "-" + plugin.name.value + "-plugin"},
                        {"comment", model::commentLines(plugin.doc)}});
    }
    return list;
}

std::set<std::string> ownNamespaces(const model::Package& package) {
    std::set<std::string> spaces{identifier(package.name.value)};
    for (const auto& component : package.components) {
        const std::string space = model::namespaceOf(component.className.value);
        if (!space.empty()) spaces.insert(space);
    }
    for (const auto& service : package.services) {
        const std::string space = model::namespaceOf(service.className.value);
        if (!space.empty()) spaces.insert(space);
    }
    return spaces;
}

std::set<std::string> qualifiedNames(const std::vector<std::string>& types) {
    std::string text;
    for (const std::string& type : types) text += type + ";";
    static const std::regex qualified("[A-Za-z_][A-Za-z0-9_]*(::[A-Za-z_][A-Za-z0-9_]*)+");
    std::set<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), qualified), end; it != end; ++it) names.insert(it->str());
    return names;
}

}  // namespace

json packageView(const model::Package& package, const std::string& manifest) {
    const std::string name = package.name.value;
    json view;
    view["name"] = name;
    view["identifier"] = identifier(name);
    view["class"] = className(name);
    view["guard"] = guardName(name);
    view["version"] = orElse(package.version, "1.0.0");
    view["license"] = xml::escapeText(orElse(package.license, "Apache-2.0"));
    view["description"] = xml::escapeText(package.description.empty() ? "The package " + name : package.description);
    view["summary"] = package.description.empty() ? json(nullptr) : json(package.description);
    view["maintainers"] = maintainersOf(package);
    view["authors"] = people(package.authors);
    view["dependencies"] = json::array();
    for (const auto& dependency : package.dependencies) view["dependencies"].push_back({{"name", dependency.value}});
    view["typekitHeaderList"] = joined(typekitHeaders(package));
    view["installedHeaderList"] = joined(installedHeaders(package));
    view["hasTypekit"] = !package.typekitHeaders.empty();
    view["components"] = componentEntries(package);
    view["hasComponents"] = !package.components.empty();
    // A precompiled header costs as much as it saves for three sources.
    view["manyComponents"] = package.components.size() > 2;
    view["services"] = serviceEntries(package);
    view["plugins"] = pluginEntries(package);
    view["manifest"] = orNull(package.components.empty() && package.services.empty() ? "" : manifest);
    view["hasManifestTests"] = !view["manifest"].is_null();
    view["connections"] = connectionViews(connectionsOf(package));
    view["hasConnections"] = !view["connections"].empty();
    view["skeletons"] = package.skeletons.empty() ? json(nullptr) : skeletonsView(package);
    const json skeletons = skeletonsView(package);
    view["deployedSkeletons"] = skeletons["components"];
    if (!skeletons["topics"].empty()) view["usesTopics"] = true;
    view["deployable"] = view["hasComponents"] || !view["deployedSkeletons"].empty();
    view["hasTests"] = view["hasManifestTests"] || skeletons["hasTests"];
    view["buildTool"] = "cmake";
    return view;
}

json typekitView(const model::Package& package, const std::string& header) {
    const auto spaces = ownNamespaces(package);
    std::map<std::string, std::set<std::string>> structs;
    const auto addStructs = [&](const std::vector<std::string>& types) {
        for (const std::string& name : qualifiedNames(types)) {
            if (spaces.count(model::namespaceOf(name)) != 0)
                structs[model::namespaceOf(name)].insert(model::lastName(name));
        }
    };
    for (const auto& component : package.components) {
        addStructs(typesIn(component, component.required));
    }
    for (const auto& service : package.services) addStructs(typesIn(service, {}));
    json view;
    view["package"] = package.name.value;
    view["guard"] = guardName(includeName(header, package.name.value));
    view["class"] = className(package.name.value);
    view["namespaces"] = json::array();
    for (const auto& [space, names] : structs) {
        view["namespaces"].push_back({{"name", space}, {"structs", names}});
    }
    view["example"] = structs.empty();
    return view;
}

}  // namespace oroforge::view
