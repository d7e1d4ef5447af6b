// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `describe`.
#include "failure.hpp"
#include "fields.hpp"
#include "values.hpp"
#include "verbs.hpp"

#include <console/type_name.hpp>
#include <diag/nearest_match.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;
using RTT::types::TypeInfo;
using RTT::types::Types;

constexpr std::size_t kMostText = 1024;

json enumeratorsOf(const TypeInfo& type, const std::vector<std::string>& names) {
    json all = json::array();
    const TypeInfo* const whole = Types()->getTypeInfo<int>();
    for (const std::string& name : names) {
        const Source value = type.buildValue();
        const bool known = value && type.fromString(name, value);
        const Source number = known && whole ? whole->convert(value) : nullptr;
        auto* const as = number ? RTT::internal::DataSource<int>::narrow(number.get()) : nullptr;
        all.push_back({{"name", name}, {"value", as ? json(as->get()) : json()}});
    }
    return all;
}

json fieldsOf(const TypeInfo& type, const Source& value) {
    json all = json::array();
    const auto factory = type.getMemberFactory();
    for (const std::string& name : value->getMemberNames()) {
        const Source member = value->getMember(name);
        if (!member) continue;
        std::string doc = factory ? factory->describeMember(name) : "";
        const std::string unit = unitOf(doc);
        all.push_back({{"name", name},
                       {"type", typeOf(member)},
                       {"unit", unit},
                       {"doc", doc},
                       {"text", textOf(member, kMostText)}});
    }
    return all;
}

json otherNames(const TypeInfo& type) {
    std::set<std::string> names;
    for (const std::string& name : type.getTypeNames()) names.insert(console::dotted(name));
    names.erase(console::dotted(type.getTypeName()));
    return names;
}

}  // namespace

json describe(const Asked& asked) {
    const std::string name = textField(asked.request, "type");
    const TypeInfo* const type = Types()->type(name);
    if (!type)
        throw Failure(kUnknownName,
                      "there is no type '" + name + "'" + oroforge::diag::didYouMean(name, Types()->getDottedTypes()));
    json made = {{"name", console::dotted(type->getTypeName())},
                 {"names", otherNames(*type)},
                 {"doc", type->getDescription()},
                 {"kind", "value"}};
    const auto factory = type->getCompositionFactory();
    const Source value = type->buildValue();
    const auto members = value ? value->getMemberNames() : std::vector<std::string>();
    if (const auto* const enumeration = dynamic_cast<const RTT::types::Enumeration*>(factory.get())) {
        made["kind"] = "enum";
        made["enumerators"] = enumeratorsOf(*type, enumeration->enumerators());
    } else if (std::find(members.begin(), members.end(), "capacity") != members.end()) {
        made["kind"] = "sequence";
        if (const Source element = value->getMember("0")) made["element"] = typeOf(element);
    } else if (!members.empty()) {
        made["kind"] = "struct";
        made["fields"] = fieldsOf(*type, value);
    }
    return made;
}

}  // namespace OCL::live
