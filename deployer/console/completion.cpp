// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "completion.hpp"

#include "commands.hpp"
#include "scripted.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <system_error>

namespace OCL::console {
namespace {

typedef std::vector<std::string> Words;

void add(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

/** The words that begin with `typed`, which is at `begin`. */
Completion matching(Words words, const std::string& typed, std::size_t begin) {
    words.erase(std::remove_if(words.begin(), words.end(),
                               [&](const std::string& word) { return word.compare(0, typed.size(), typed) != 0; }),
                words.end());
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return {begin, std::move(words)};
}

void addValues(Words& words, const RTT::ConfigurationInterface& values) {
    add(words, values.getAttributeNames());
    add(words, values.properties()->list());
}

Words membersOf(RTT::Service& service) {
    Words words = service.getProviderNames();
    add(words, service.getNames());
    add(words, service.getPortNames());
    addValues(words, service);
    return words;
}

/** The words that may begin a path. */
Words topLevel(RTT::TaskContext& context) {
    Words words = membersOf(*context.provides());
    add(words, context.getPeerList());
    add(words, context.requires_()->getRequesterNames());
    const auto global = RTT::internal::GlobalService::Instance();
    add(words, global->getProviderNames());
    add(words, global->getNames());
    if (context.provides()->hasService("scripting"))
        add(words, context.provides()->getService("scripting")->getNames());
    addValues(words, *RTT::types::GlobalsRepository::Instance());
    add(words, RTT::types::Types()->getDottedTypes());
    return words;
}

RTT::base::DataSourceBase::shared_ptr valueIn(RTT::Service& service, const std::string& name) {
    if (auto* const attribute = service.getValue(name)) return attribute->getDataSource();
    if (auto* const property = service.getProperty(name)) return property->getDataSource();
    return nullptr;
}

/** The types whose names continue this path and its dot. */
Words typesBehind(const std::string& path) {
    Words words;
    const std::string start = path.empty() ? "" : path + ".";
    for (const std::string& type : RTT::types::Types()->getDottedTypes())
        if (type.compare(0, start.size(), start) == 0) words.push_back(type.substr(start.size()));
    return words;
}

/** What may follow an operation: ways to call it, or parts of its result if it takes no arguments, as in `port.last.x`;
    `rest` is the path after its name. */
Words behindOperation(RTT::Service& service, const std::string& name, const std::string& rest) {
    Words words;
    if (rest.empty()) words = {"call", "cmd", "send"};
    const RTT::types::TypeInfo* const type =
        service.getArity(name) == 0 ? RTT::types::Types()->type(service.getResultType(name)) : nullptr;
    auto value = type ? type->buildValue() : nullptr;
    if (value && !rest.empty()) value = value->getMember(rest.substr(1));
    if (value) add(words, value->getMemberNames());
    return words;
}

/** What may follow the name of a value, an operation or a type. */
Words behindName(RTT::TaskContext& context, const std::string& path) {
    const ResolvedName lookup = RTT::internal::resolve(context, path);
    const std::string before = lookup.wrongAt ? path.substr(0, lookup.wrongAt - 1) : "";
    const NamedObject owner = RTT::internal::resolve(context, before).target;
    if (!owner.service) return {};
    const std::string rest = path.substr(lookup.wrongAt + lookup.wrong.size());
    if (owner.service->hasMember(lookup.wrong)) return behindOperation(*owner.service, lookup.wrong, rest);
    Words words = typesBehind(path);
    auto value = valueIn(*owner.service, lookup.wrong);
    if (value && !rest.empty()) value = value->getMember(rest.substr(1));
    if (!value) return words;
    value->evaluate();
    const auto* const bag = RTT::internal::DataSource<RTT::PropertyBag>::narrow(value.get());
    add(words, bag ? bag->rvalue().list() : value->getMemberNames());
    return words;
}

bool isOfPath(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '/'; }

/** True if the last word must be a type, because the word before it is `var` or `const`. */
bool isDeclaration(const std::string& line) {
    std::size_t end = line.size();
    while (end > 0 && isOfPath(line[end - 1])) --end;
    std::size_t before = line.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
    if (end == 0 || before == end - 1 || before == std::string::npos) return false;
    std::size_t begin = ++before;
    while (begin > 0 && isOfPath(line[begin - 1])) --begin;
    const std::string word = line.substr(begin, before - begin);
    return word == "var" || word == "const";
}

/** Completes a dotted path at the end of the line; `membersBehind` gives what may follow a path. */
template <class Members>
Completion completePath(RTT::TaskContext& context, const std::string& line, Members membersBehind) {
    std::size_t begin = line.size();
    while (begin > 0 && isOfPath(line[begin - 1])) --begin;
    const std::string typed = line.substr(begin);
    const std::size_t dot = typed.rfind('.');
    const std::size_t last = dot == std::string::npos ? 0 : dot + 1;
    Completion found = matching(membersBehind(typed.substr(0, last ? last - 1 : 0)), typed.substr(last), begin + last);
    if (found.words.size() == 1) {
        const std::string path = typed.substr(0, last) + found.words[0];
        if (RTT::internal::resolve(context, path).target.service && !membersBehind(path).empty()) found.behind = ".";
    }
    return found;
}

Words expressionMembers(RTT::TaskContext& context, const std::string& path) {
    if (path.empty()) return topLevel(context);
    const NamedObject target = RTT::internal::resolve(context, path).target;
    if (!target.service) return behindName(context, path);
    Words words = membersOf(*target.service);
    if (target.component) add(words, target.component->getPeerList());
    return words;
}

Words peersAndServices(RTT::TaskContext& context, const std::string& path, bool servicesToo) {
    const NamedObject target = RTT::internal::resolve(context, path).target;
    Words words;
    if (target.component) words = target.component->getPeerList();
    if (target.service && servicesToo) add(words, target.service->getProviderNames());
    return words;
}

Words portsBehind(RTT::TaskContext& context, const std::string& path) {
    const NamedObject target = RTT::internal::resolve(context, path).target;
    Words words = peersAndServices(context, path, true);
    if (target.service) add(words, target.service->getPortNames());
    return words;
}

Completion completeFile(const std::string& typed, std::size_t begin) {
    namespace fs = std::filesystem;
    const std::size_t slash = typed.rfind('/');
    const std::string directory = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
    Words words;
    std::error_code ignored;
    for (fs::directory_iterator at(directory.empty() ? "." : directory, ignored), end; at != end;
         at.increment(ignored)) {
        const std::string name = at->path().filename().string();
        if (name[0] == '.' && typed.size() == directory.size()) continue;  // hidden files only if their dot is typed
        words.push_back(name + (at->is_directory(ignored) ? "/" : ""));
    }
    return matching(std::move(words), typed.substr(directory.size()), begin + directory.size());
}

/** Completes a command, or another name that `help` explains. */
Completion completeName(RTT::TaskContext& context, const std::string& line, std::size_t begin) {
    Words words;
    for (const Command& command : dotCommands()) words.push_back(command.word);
    if (begin < line.size() && line[begin] == '.') return matching(std::move(words), line.substr(begin), begin);
    return completePath(context, line, [&](const std::string& path) {
        Words members = expressionMembers(context, path);
        if (path.empty())
            for (const Command& command : commands()) members.push_back(command.word);
        return members;
    });
}

Completion completeArgument(RTT::TaskContext& context, const std::string& line, Argument argument) {
    const std::size_t begin = line.find_last_of(" \t") + 1;
    const std::string typed = line.substr(begin);
    const auto services = [&](bool too) {
        return completePath(context, line,
                            [&](const std::string& path) { return peersAndServices(context, path, too); });
    };
    switch (argument) {
        case Argument::Component: return services(false);
        case Argument::Path: return services(true);
        case Argument::Name: return completeName(context, line, begin);
        case Argument::Port:
            return completePath(context, line, [&](const std::string& path) { return portsBehind(context, path); });
        case Argument::Scripted: return matching(scriptedNames(context), typed, begin);
        case Argument::Service: return matching(RTT::plugin::PluginLoader::Instance()->listServices(), typed, begin);
        case Argument::File: return completeFile(typed, begin);
        case Argument::None: break;
    }
    return {line.size(), {}};
}

/** True if the text that begins there is the second argument of loadComponent, the type of a component. */
bool isComponentType(const std::string& line, std::size_t text) {
    constexpr std::size_t kLongest = 500;  // std::regex recurses for each letter
    const std::size_t at = line.rfind("loadComponent", text);
    if (at == std::string::npos || text - at > kLongest || (at != 0 && line[at - 1] != '.' && isOfPath(line[at - 1])))
        return false;
    static const std::regex before(R"(loadComponent\s*\(\s*("[^"]*"|[\w.]+)\s*,\s*")");
    return std::regex_match(line.substr(at, text - at), before);
}

Completion completeText(const std::string& line, std::size_t begin) {
    const std::string typed = line.substr(begin);
    Completion found = completeFile(typed, begin);
    if (!isComponentType(line, begin)) return found;
    Completion types = matching(RTT::ComponentLoader::Instance()->listComponentTypes(), typed, begin);
    return types.words.empty() ? found : types;
}

/** The beginning of the quoted text that is open at the end of the line; npos if there is none. */
std::size_t openText(const std::string& line) {
    std::size_t open = std::string::npos;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '\\')
            ++at;
        else if (line[at] == '"')
            open = open == std::string::npos ? at + 1 : std::string::npos;
    }
    return open;
}

}  // namespace

std::string Completion::common() const {
    if (words.empty()) return {};
    const std::string &first = words.front(), &last = words.back();
    std::size_t size = 0;
    while (size < first.size() && size < last.size() && first[size] == last[size]) ++size;
    return first.substr(0, size);
}

std::string Completion::more(const std::string& line) const {
    return common().substr(std::min(line.size() - begin, common().size())) + behind;
}

Completion completionOf(RTT::TaskContext& context, const std::string& line, bool commandsToo) {
    const std::size_t text = openText(line);
    if (text != std::string::npos) return completeText(line, text);
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const std::size_t end = line.find_first_of(" \t", begin);
    const bool first = end == std::string::npos;
    if (commandsToo && !first)
        if (const Command* const command = commandIn(Input("", 1, line.substr(0, end))))
            return completeArgument(context, line, command->argument);
    if (commandsToo && first && begin < line.size() && line[begin] == '.') {
        Words words;
        for (const Command& command : dotCommands()) words.push_back(command.word);
        Completion found = matching(std::move(words), line.substr(begin), begin);
        for (const Command& command : dotCommands())
            if (found.words.size() == 1 && found.words[0] == command.word && *command.arguments) found.behind = " ";
        return found;
    }
    if (isDeclaration(line)) return completePath(context, line, typesBehind);
    const bool word = std::all_of(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(), isOfPath);
    return completePath(context, line, [&](const std::string& path) {
        Words words = expressionMembers(context, path);
        if (commandsToo && word && path.empty())
            for (const Command& command : commands()) words.push_back(command.word);
        return words;
    });
}

}  // namespace OCL::console
