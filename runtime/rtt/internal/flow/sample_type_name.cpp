// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/sample_type_name.hpp>

#include <rtt/base/PortInterface.hpp>
#include <rtt/types/Schema.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt/types/TypeOps.hpp>

#include <boost/core/demangle.hpp>

namespace RTT::internal {

namespace {
const char kUnknown[] = "unknown_t";

std::string cppName(const types::TypeOps& ops) {
    return boost::core::demangle(ops.id->name()) + " (of no loaded typekit)";
}
}  // namespace

std::string sampleTypeName(const base::PortInterface& port) {
    const types::TypeInfo* const type = port.getTypeInfo();
    const std::string name = type ? type->getTypeName() : kUnknown;
    return name == kUnknown && port.sampleOps() ? cppName(*port.sampleOps()) : name;
}

std::string sampleTypeName(const types::TypeOps& ops) {
    const types::TypeInfo* const type = types::TypeInfoRepository::Instance()->getTypeById(ops.id);
    return type ? type->getTypeName() : cppName(ops);
}

std::string sampleDifference(const base::PortInterface& a, const base::PortInterface& b) {
    if (!a.sampleSchema() || !b.sampleSchema()) return "";
    return types::schemaDifference(*a.sampleSchema(), *b.sampleSchema(), "in the plugin of " + a.getFullName(),
                                   "in that of " + b.getFullName());
}

}  // namespace RTT::internal
