// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The generator for structs that are described by a constant table of their fields.
#include <rtt/types/StructMembers.hpp>

#include "table_generator.hpp"

namespace RTT::types::detail {

namespace {

class StructTable : public TableGenerator, public StructMembers {
public:
    StructTable(const char* name, const Member* members, std::size_t count, const char* doc, const TypeOps& ops,
                const TypeThunks& thunks)
        : TableGenerator(name, doc, ops, thunks), StructMembers(members, count, ops, thunks) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<StructTable>(getSharedPtr());
        info->setMemberFactory(self);
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        return false;
    }
};

}  // namespace

TypeInfoGenerator* newStructGenerator(const char* name, const Member* members, std::size_t count, const char* doc,
                                      const TypeOps& ops, const TypeThunks& thunks) {
    return new StructTable(name, members, count, doc, ops, thunks);
}

}  // namespace RTT::types::detail
