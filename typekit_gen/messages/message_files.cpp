// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/message_files.hpp>

#include <algorithm>
#include <set>

#include <emit/banner.hpp>
#include <messages/identity.hpp>
#include <nlohmann/json.hpp>
#include <plan/cpp_words.hpp>
#include <plan/sources.hpp>
#include <plan/typekit_files.hpp>
#include <plan/typekit_view.hpp>

namespace oroforge::messages {

namespace {

using nlohmann::json;
using typekit::cppLetters;
using typekit::cppString;

constexpr const char* kTool = "typegen-ros";

std::string typekitName(const std::string& package) { return "ros-" + package; }
std::string servicesName(const std::string& package) { return "ros-" + package + "-services"; }

std::vector<std::string> withPackage(const std::string& package, const std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) all.push_back(package + "/" + name);
    return all;
}

std::vector<std::string> halves(const std::vector<std::string>& services) {
    std::vector<std::string> all;
    for (const std::string& name : services)
        for (const char* half : {"Request", "Response"}) all.push_back(name + half);
    return all;
}

std::string typekitHeader(const std::string& package, const std::string& name) {
    return package + "/typekit/" + name + ".h";
}
std::string boostHeader(const std::string& fullName) {
    const std::size_t slash = fullName.find('/');
    return fullName.substr(0, slash) + "/boost" + fullName.substr(slash) + ".h";
}

json front(const std::string& source, const std::string& header) {
    json view = {{"banner", emit::banner(kTool, source)}};
    view["guard"] = "OROFORGE_" + cppLetters(header);
    return view;
}

json tableOf(const std::vector<const Message*>& messages, const MessageSet& set) {
    json table = json::array();
    for (const Message* one : messages)
        table.push_back({{"type", cppString("/" + one->fullName())},
                         {"name", cppString(one->fullName())},
                         {"md5", cppString(md5Of(*one, set))},
                         {"definition", typekit::cppLines(definitionOf(*one, set))}});
    return table;
}

void addConstants(json& view, const std::vector<const Message*>& messages) {
    view["constants"] = json::array();
    for (const Message* message : messages)
        for (const Constant& one : message->constants)
            view["constants"].push_back({{"name", cppString(message->package + "." + message->name + "." + one.name)},
                                         {"type", cppString(one.type)},
                                         {"value", cppString(one.value)}});
    view["hasConstants"] = !view["constants"].empty();
}

/// What the plugin of a package is rendered from.
json pluginView(const json& typekitView, const std::string& package, const std::vector<const Message*>& messages) {
    json view = {{"pluginBanner", emit::banner(kTool, "the messages of " + package)}};
    for (const char* key : {"versionGuard", "identifier", "quotedName"}) view[key] = typekitView[key];
    view["sources"] = json::array();
    for (const json& source : typekitView["sources"]) view["sources"].push_back({{"word", source["word"]}});
    view["dependencies"] = json::array();
    for (const std::string& name : dependenciesOf(package, messages))
        view["dependencies"].push_back({{"name", cppString(name)}});
    addConstants(view, messages);
    return view;
}

std::string renderTypekitHeader(const Message& message, const json& typekitView, const render::Renderer& renderer) {
    const std::string name = message.fullName();
    json view = front(name + ".msg", typekitHeader(message.package, message.name));
    view["include"] = name + ".h";
    view["cpp"] = cppOf(name);
    view["schemas"] = json::array();
    for (const json& schema : typekitView["schemas"])
        if (schema["of"] == "/" + name) view["schemas"].push_back(schema);
    return renderer.render("messages/typekit_header", view);
}

std::string renderBoostHeader(const Message& message, const render::Renderer& renderer) {
    const std::string name = message.fullName();
    json view = front(name + ".msg", boostHeader(name));
    view["include"] = name + ".h";
    view["type"] = "::" + message.package + "::" + message.name + "_";
    view["fields"] = json::array();
    std::set<std::string> headers;
    for (const Field& field : message.fields) {
        if (field.extent == Extent::Fixed && field.count == 0) continue;
        view["fields"].push_back({{"name", field.name}});
        if (field.extent == Extent::Any) headers.insert("boost/serialization/vector.hpp");
        if (field.extent == Extent::Fixed) headers.insert("boost/serialization/boost_array.hpp");
        if (field.type.name == "string") headers.insert("boost/serialization/string.hpp");
        if (field.type.name == "time" || field.type.name == "duration")
            headers.insert("rtt_ros/primitives/boost_time.h");
        if (!field.type.isBuiltin) headers.insert(boostHeader(field.type.name));
    }
    view["headers"] = json::array();
    for (const std::string& header : headers) view["headers"].push_back({{"path", header}});
    return renderer.render("messages/boost_header", view);
}

std::vector<std::string> sourceNames(const std::vector<std::string>& fullNames, const ModelRules& rules) {
    std::vector<std::string> names;
    for (const typekit::Source& source : typekit::sourcesOf(headersOf(fullNames, rules)))
        names.push_back(typekit::sourceName(source.word));
    return names;
}

}  // namespace

std::vector<std::string> dependenciesOf(const std::string& package, const std::vector<const Message*>& messages) {
    std::set<std::string> names;
    for (const Message* message : messages)
        for (const Field& field : message->fields)
            if (!field.type.isBuiltin) names.insert(field.type.name.substr(0, field.type.name.find('/')));
    names.erase(package);
    return {names.begin(), names.end()};
}

std::vector<std::string> messageOutputs(const std::string& package, const std::vector<std::string>& names,
                                        const ModelRules& rules) {
    std::vector<std::string> outputs = sourceNames(withPackage(package, names), rules);
    for (const char* name : {"Plugin.cpp", "Transport.cpp"}) outputs.push_back(name);
    for (const char* name : {"Types.h", "Types.hpp"}) outputs.push_back("include/" + package + "/typekit/" + name);
    for (const std::string& name : names) {
        outputs.push_back("include/" + typekitHeader(package, name));
        outputs.push_back("include/" + boostHeader(package + "/" + name));
    }
    return outputs;
}

emit::Outputs renderMessages(const std::string& package, const std::vector<const Message*>& messages,
                             const MessageSet& set, const ModelRules& rules, const render::Renderer& renderer) {
    const json view = typekit::makeView(modelOf(messages, set, rules), typekitName(package), kTool);
    emit::Outputs outputs = typekit::renderSources(view, renderer);
    outputs["Plugin.cpp"] = renderer.render("messages/Plugin.cpp", pluginView(view, package, messages));
    json table = {{"pluginBanner", emit::banner(kTool, "the messages of " + package)},
                  {"versionGuard", view["versionGuard"]},
                  {"package", cppString(package)}};
    table["messages"] = tableOf(messages, set);
    outputs["Transport.cpp"] = renderer.render("messages/Transport.cpp", table);
    json all = front("the messages of " + package, package + "/typekit/Types.h");
    all["headers"] = json::array();
    for (const Message* message : messages) {
        const std::string header = typekitHeader(package, message->name);
        all["headers"].push_back({{"path", header}});
        outputs["include/" + header] = renderTypekitHeader(*message, view, renderer);
        outputs["include/" + boostHeader(message->fullName())] = renderBoostHeader(*message, renderer);
    }
    outputs["include/" + package + "/typekit/Types.h"] = renderer.render("messages/all_headers", all);
    all.update(front("the messages of " + package, package + "/typekit/Types.hpp"));
    all["headers"] = json::array({{{"path", package + "/typekit/Types.h"}}});
    outputs["include/" + package + "/typekit/Types.hpp"] = renderer.render("messages/all_headers", all);
    return outputs;
}

std::vector<std::string> serviceOutputs(const std::string& package, const std::vector<std::string>& names,
                                        const ModelRules& rules) {
    std::vector<std::string> outputs = sourceNames(withPackage(package, halves(names)), rules);
    outputs.emplace_back("Services.cpp");
    return outputs;
}

emit::Outputs renderServices(const std::string& package, const std::vector<const Service*>& services,
                             const MessageSet& set, const ModelRules& rules, const render::Renderer& renderer) {
    std::vector<const Message*> messages;
    json table = json::array();
    for (const Service* service : services) {
        messages.push_back(&service->request);
        messages.push_back(&service->response);
        table.push_back({{"name", cppString(package + "/" + service->name)},
                         {"md5", cppString(md5Of(*service, set))},
                         {"request", cppString("/" + service->request.fullName())},
                         {"response", cppString("/" + service->response.fullName())}});
    }
    const json typekitView = typekit::makeView(modelOf(messages, set, rules), servicesName(package), kTool);
    emit::Outputs outputs = typekit::renderSources(typekitView, renderer);
    json view = pluginView(typekitView, package, messages);
    view["pluginBanner"] = emit::banner(kTool, "the services of " + package);
    view["pluginName"] = cppString("rtt_" + package + "_ros_service_proxies");
    view["services"] = table;
    outputs["Services.cpp"] = renderer.render("messages/Services.cpp", view);
    return outputs;
}

}  // namespace oroforge::messages
