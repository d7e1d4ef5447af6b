// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <algorithm>
#include <charconv>

#include <cxxabi.h>

#include <rtt/RTT.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include "interface_lines.hpp"

namespace oroforge::test {

namespace {

std::string nameOf(const std::type_info& type) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, &status),
                                                      std::free);
    return status == 0 ? name.get() : type.name();
}

/// "double (int)" of "RTT::internal::LocalOperationCaller<double (int)>", with the common spelling of each type.
std::string signatureOf(const std::type_info& caller) {
    const std::string name = nameOf(caller);
    const std::size_t begin = name.find('<') + 1;
    const std::string inner = name.substr(begin, name.rfind('>') - begin);
    const std::size_t open = inner.rfind(" (") + 1;
    std::string result = commonSpelling(inner.substr(0, open - 1)) + " (";
    int depth = 0;
    std::string argument;
    for (const char c : inner.substr(open + 1, inner.rfind(')') - open - 1) + ",") {
        depth += c == '<' ? 1 : c == '>' ? -1 : 0;
        if (c != ',' || depth != 0) {
            if (c != ' ' || !argument.empty()) argument += c;
            continue;
        }
        if (!argument.empty()) result += (result.back() == '(' ? "" : ", ") + commonSpelling(argument);
        argument.clear();
    }
    return result + ")";
}

template <class T>
std::string shown(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<T, std::string>) {
        return value;
    } else if constexpr (std::is_same_v<T, char>) {
        return value == 0 ? std::string() : std::string(1, value);
    } else {
        std::array<char, 64> text{};
        return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
    }
}

template <class... T>
std::string shownAs(const RTT::base::DataSourceBase::shared_ptr& source) {
    std::string text = "?";
    const auto take = [&](auto* typed) {
        if (typed != nullptr) text = shown(typed->get());
    };
    (take(RTT::internal::DataSource<T>::narrow(source.get())), ...);
    return text;
}

std::string valueOf(const RTT::base::DataSourceBase::shared_ptr& source) {
    return shownAs<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long,
                   float, double, std::string>(source);
}

std::string typeOf(const RTT::base::DataSourceBase::shared_ptr& source) {
    return commonSpelling(nameOf(*source->getTypeId()));
}

std::string policyOf(const RTT::ConnPolicy& policy) {
    const char* const types[] = {"data", "buffer", "circular_buffer"};
    return std::string(types[policy.type]) + " " + std::to_string(policy.size);
}

void addPorts(RTT::Service& service, const std::string& path, Lines& lines) {
    for (RTT::base::PortInterface* port : service.getPorts()) {
        const auto* input = dynamic_cast<RTT::base::InputPortInterface*>(port);
        lines.push_back(path + "port " + port->getName() + ": " + (input != nullptr ? "in " : "out ") +
                        commonSpelling(nameOf(*port->sampleOps()->id)) +
                        (input != nullptr && input->signalsInterface() ? ", event" : "") + " // " +
                        port->getDescription());
        if (input == nullptr || policyOf(input->getDefaultPolicy()) == policyOf(RTT::ConnPolicy())) continue;
        lines.push_back(path + "policy " + port->getName() + ": " + policyOf(input->getDefaultPolicy()));
    }
}

void addOperations(RTT::Service& service, const RTT::Service* common, const std::string& path, Lines& lines) {
    for (const std::string& name : service.getOperationNames()) {
        RTT::OperationInterfacePart* const part = service.getPart(name);
        // One that every component has, unless the component has replaced it.
        if (common != nullptr && common->hasOperation(name) &&
            common->getPart(name)->description() == part->description())
            continue;
        const auto local = boost::dynamic_pointer_cast<RTT::base::OperationCallerInterface>(part->getLocalOperation());
        std::string line = path + "operation " + name + ": " + signatureOf(typeid(*local)) +
                           (local->getThread() == RTT::OwnThread ? ", own thread" : "") + " // " + part->description();
        for (const RTT::ArgumentDescription& argument : part->getArgumentList())
            line += "; " + argument.name + ": " + argument.description;
        lines.push_back(line);
    }
}

void addService(RTT::Service& service, const RTT::Service* common, const std::string& path, Lines& lines) {
    addPorts(service, path, lines);
    for (const RTT::base::PropertyBase* property : *service.properties())
        lines.push_back(path + "property " + property->getName() + ": " + typeOf(property->getDataSource()) + " = " +
                        valueOf(property->getDataSource()) + " // " + property->getDescription());
    for (const RTT::base::AttributeBase* attribute : service.getValues()) {
        if (common != nullptr && common->hasAttribute(attribute->getName())) continue;
        const bool constant = !attribute->getDataSource()->isAssignable();
        lines.push_back(path + (constant ? "constant " : "attribute ") + attribute->getName() + ": " +
                        typeOf(attribute->getDataSource()) + " = " + valueOf(attribute->getDataSource()));
    }
    addOperations(service, common, path, lines);
    for (const std::string& name : service.getProviderNames()) {
        // Each port has a service of its own.
        if (service.getPort(name) != nullptr || (common != nullptr && common->hasService(name))) continue;
        lines.push_back(path + "service " + name + " // " + service.provides(name)->doc());
        addService(*service.provides(name), nullptr, path + name + ".", lines);
    }
}

void addCallers(RTT::ServiceRequester& requester, const std::string& name, Lines& lines) {
    for (const std::string& caller : requester.getOperationCallerNames())
        lines.push_back("requires " + name + "." + caller + ": " +
                        signatureOf(typeid(*requester.getOperationCaller(caller))));
    for (const std::string& inner : requester.getRequesterNames())
        addCallers(*requester.requires_(inner), inner, lines);
}

std::string activityOf(RTT::TaskContext& component) {
    RTT::base::ActivityInterface* const activity = component.getActivity();
    const bool sequential = dynamic_cast<RTT::extras::SequentialActivity*>(activity) != nullptr;
    const bool slave = dynamic_cast<RTT::extras::SlaveActivity*>(activity) != nullptr;
    return std::string("activity ") +
           (sequential ? "sequential"
            : slave    ? "slave"
                       : "thread") +
           " " + shown(static_cast<double>(activity->getPeriod()));
}

}  // namespace

Lines linesOf(RTT::TaskContext& component) {
    const RTT::TaskContext bare("bare");
    const bool stopped = component.getTaskState() == RTT::TaskContext::Stopped;
    Lines lines = {stopped ? "Stopped" : "PreOperational", activityOf(component)};
    addService(*component.provides(), const_cast<RTT::TaskContext&>(bare).provides().get(), "", lines);
    Lines callers;
    addCallers(*component.requires_(), "this", callers);
    std::sort(callers.begin(), callers.end());
    lines.insert(lines.end(), callers.begin(), callers.end());
    return lines;
}

Lines linesOf(RTT::Service& service) {
    Lines lines = {"service " + service.getName() + " // " + service.doc()};
    addService(service, nullptr, "", lines);
    return lines;
}

}  // namespace oroforge::test
