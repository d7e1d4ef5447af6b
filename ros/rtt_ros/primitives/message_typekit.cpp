// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_typekit.hpp"

#include "primitives_typekit.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/GlobalsRepository.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace rtt_ros {

namespace {

using RTT::base::AttributeBase;

template <class T>
AttributeBase* constantOf(const MessageConstant& one, T value) {
    return new RTT::Constant<T>(one.name, std::move(value));
}

AttributeBase* constantOf(const MessageConstant& one) {
    const std::string type = one.type, text = one.value;
    if (type == "string") return constantOf(one, text);
    if (type == "bool") return constantOf<std::uint8_t>(one, text == "True" || text == "1");
    if (type == "float32") return constantOf(one, std::strtof(one.value, nullptr));
    if (type == "float64") return constantOf(one, std::strtod(one.value, nullptr));
    if (type == "uint64") return constantOf<std::uint64_t>(one, std::strtoull(one.value, nullptr, 10));
    const long long number = std::strtoll(one.value, nullptr, 10);
    if (type == "int8" || type == "byte") return constantOf(one, static_cast<std::int8_t>(number));
    if (type == "uint8" || type == "char") return constantOf(one, static_cast<std::uint8_t>(number));
    if (type == "int16") return constantOf(one, static_cast<std::int16_t>(number));
    if (type == "uint16") return constantOf(one, static_cast<std::uint16_t>(number));
    if (type == "int32") return constantOf(one, static_cast<std::int32_t>(number));
    if (type == "uint32") return constantOf(one, static_cast<std::uint32_t>(number));
    return constantOf<std::int64_t>(one, number);
}

}  // namespace

void needTypes(const char* package) {
    using RTT::types::TypekitRepository;
    if (!package) {
        if (!TypekitRepository::hasTypekit("ros-primitives")) TypekitRepository::Import(new PrimitivesTypekit());
        return;
    }
    const std::string name = package;
    if (TypekitRepository::hasTypekit("ros-" + name)) return;
    RTT::plugin::PluginLoader::Instance()->loadTypekit("rtt_" + name);
    if (TypekitRepository::hasTypekit("ros-" + name)) return;
    RTT::log(RTT::Warning) << "the types of " << name << " are missing, of which others are made: import(\"rtt_" << name
                           << "\"); if there is no such package, create_rtt_msgs makes it" << RTT::endlog();
}

void addConstants(const MessageConstant* first, std::size_t count) {
    const auto globals = RTT::types::GlobalsRepository::Instance();
    for (const MessageConstant* one = first; one != first + count; ++one)
        if (!globals->hasAttribute(one->name)) globals->setValue(constantOf(*one));
}

}  // namespace rtt_ros
