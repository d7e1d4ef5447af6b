// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "found_value.hpp"

#include "failure.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/base/PropertyBase.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kMostText = 64 * 1024, kMostValue = 1024 * 1024;

bool isIndex(const std::string& part) { return part.find_first_not_of("0123456789") == std::string::npos; }

/** "comment [unit] (range)" of the last field. */
std::string docOfField(const Source& whole, const std::vector<std::string>& parts, const std::string& path) {
    const std::vector<std::string> before(parts.begin(), parts.end() - 1);
    const Source owner = partOf(whole, before, path);
    const auto factory = owner->getTypeInfo()->getMemberFactory();
    return factory ? factory->describeMember(parts.back()) : "";
}

void findIn(RTT::Service& service, const Found& at, const KnownPorts& known, FoundValue& to) {
    const std::string& name = at.rest.front();
    if (const auto* const property = service.getProperty(name)) {
        to.head = propertyHead(*property);
        to.head["kind"] = "property";
        to.original = property->getDataSource();
    } else if (const auto* const attribute = service.getValue(name)) {
        to.head = attributeHead(*attribute);
        to.head["kind"] = "attribute";
        to.original = attribute->getDataSource();
    } else if (const auto* const port = service.getPort(name)) {
        to.head = {{"name", name},
                   {"type", typeOfPort(*port)},
                   {"unit", ""},
                   {"doc", port->getDescription()},
                   {"writable", false},
                   {"kind", "port"},
                   {"direction", port->asInput() ? "in" : "out"}};
        to.sample = known.lastSample(*port);
    } else if (service.hasMember(name)) {
        throw Failure(kUnknownName, "'" + to.whole +
                                        "' is an operation, expected a property, attribute or port; the verb "
                                        "'call' calls it");
    } else {
        unknown(at, "property, attribute or port");
    }
}

}  // namespace

FoundValue findValue(const Asked& asked, const std::string& path) {
    Visits visits;
    const Found at = find(asked.root, visits, path);
    if (at.rest.empty())
        throw Failure(kUnknownName, "'" + path + "' is a " + (at.isComponent ? "component" : "service") +
                                        ", expected a property, attribute or port; the verb 'show' lists those in it");
    FoundValue made;
    made.whole = at.pathWith(at.rest.front());
    made.path = made.whole;
    made.gate = at.gate;
    made.component = at.componentName();
    made.parts.assign(at.rest.begin() + 1, at.rest.end());
    for (const std::string& part : made.parts) made.path += isIndex(part) ? "[" + part + "]" : "." + part;
    const KnownPorts known({asked.root.gate}, visits);
    findIn(*at.service, at, known, made);
    made.head["path"] = made.path;
    return made;
}

void fill(const Gate& gate, const std::string& component, const Limit& limit,
          const std::vector<std::shared_ptr<Copied>>& copies) {
    // A value may grow from one time to the next.
    constexpr int kTries = 4;
    const auto isWhole = std::make_shared<bool>(copies.empty());
    const auto work = [copies, isWhole] {
        *isWhole = true;
        for (const auto& each : copies) *isWhole = each->fill() && *isWhole;
    };
    for (int i = 1; !*isWhole; ++i) {
        for (const auto& each : copies) i < kTries ? each->grow() : each->mayAllocate();
        if (gate)
            inThreadOf(gate, component, limit, work);
        else
            work();
    }
}

Source read(const FoundValue& found, const Limit& limit) {
    if (!found.original) return found.sample;
    const auto copied = std::make_shared<Copied>(found.original);
    fill(found.gate, found.component, limit, {copied});
    if (!copied->value())
        throw Failure(kNoForm, "values of type " + typeOf(found.original) + " cannot be copied, so '" + found.whole +
                                   "' cannot be read from outside");
    return copied->value();
}

json described(const FoundValue& found, const Source& whole) {
    json made = found.head;
    if (!whole) {  // a port without a sample
        if (!found.parts.empty()) throw Failure(kUnknownName, "port '" + found.whole + "' has no sample yet");
        made["value"] = nullptr;
        made["text"] = "";
        return made;
    }
    const Source part = partOf(whole, found.parts, found.whole);
    if (!found.parts.empty()) {
        std::string doc = docOfField(whole, found.parts, found.whole);
        made["unit"] = unitOf(doc);
        made["doc"] = doc;
        made["name"] = found.parts.back();
    }
    const std::string text = textOf(part, std::string::npos);
    bool wasCut = text.size() > kMostText;
    made["type"] = typeOf(part);
    made["text"] = wasCut ? textOf(part, kMostText) : text;
    json value = jsonOf(part, kMostValue, wasCut);
    made["value"] = std::move(value);
    if (wasCut) made["cut"] = true;
    return made;
}

json get(const Asked& asked) {
    const FoundValue found = findValue(asked, asked.request.at("path"));
    return described(found, read(found, asked.limit));
}

}  // namespace OCL::live
