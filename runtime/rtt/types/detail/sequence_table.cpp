// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Generators for containers and arrays.
#include <rtt/types/SequenceTable.hpp>

#include <rtt/types/SequenceMembers.hpp>
#include "table_generator.hpp"

namespace RTT::types::detail {

namespace {

class SequenceTable : public TableGenerator, public SequenceMembers {
public:
    SequenceTable(const char* name, const SequenceOps& sequence, const TypeOps& ops, const TypeThunks& thunks,
                  bool array)
        : TableGenerator(name, "", ops, thunks), SequenceMembers(sequence), sequence_(sequence), array_(array) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<SequenceTable>(getSharedPtr());
        info->setMemberFactory(self);
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        if (array_)
            info->setArrayElement(sequence_.elementType());
        else
            info->addConstructor(newSequenceConstructor(sequence_, thunks()));
        return false;
    }

private:
    const SequenceOps& sequence_;
    bool array_;
};

}  // namespace

TypeInfoGenerator* newSequenceGenerator(const char* name, const SequenceOps& sequence, const TypeOps& ops,
                                        const TypeThunks& thunks) {
    return new SequenceTable(name, sequence, ops, thunks, false);
}

TypeInfoGenerator* newArrayGenerator(const char* name, const SequenceOps& sequence, const TypeOps& ops,
                                     const TypeThunks& thunks) {
    return new SequenceTable(name, sequence, ops, thunks, true);
}

}  // namespace RTT::types::detail
