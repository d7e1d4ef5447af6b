// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The generator for classes that an adapter describes as sequences or matrices.
#include <rtt/types/AdaptedTable.hpp>

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/types/SequenceMembers.hpp>
#include "count_data_source.hpp"
#include <rtt/types/member_update.hpp>
#include "table_generator.hpp"

namespace RTT::types::detail {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

class AdaptedTable : public TableGenerator, public SequenceMembers {
public:
    AdaptedTable(const char* name, const char* doc, const SequenceOps& elements, const TypeOps& ops,
                 const TypeThunks& thunks, std::size_t (*columns)(const void*))
        : TableGenerator(name, doc, ops, thunks), SequenceMembers(elements), elements_(elements), columns_(columns) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<AdaptedTable>(getSharedPtr());
        info->setMemberFactory(self);
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        info->addConstructor(newSequenceConstructor(elements_, thunks()));
        return false;
    }

    using SequenceMembers::getMember;
    SourcePtr getMember(SourcePtr item, const std::string& name) const override {
        if (columns_ && name == "rows") return new CountDataSource(item, elements_.size);
        if (columns_ && name == "columns") return new CountDataSource(item, columns_);
        return SequenceMembers::getMember(item, name);
    }

    bool composeType(SourcePtr source, SourcePtr target) const override {
        const auto* bag =
            columns_ ? static_cast<const PropertyBag*>(valueOfType(source, typeid(PropertyBag))) : nullptr;
        return (!bag || isRectangle(*bag)) && SequenceMembers::composeType(source, target);
    }

private:
    static const PropertyBag* rowOf(const PropertyBag& bag, std::size_t index) {
        return static_cast<const PropertyBag*>(
            valueOfType(bag.getItem(static_cast<int>(index))->getDataSource(), typeid(PropertyBag)));
    }
    static bool isRectangle(const PropertyBag& bag) {
        const std::size_t begin = firstElement(bag);
        for (std::size_t i = begin + 1; i < bag.size(); ++i) {
            const PropertyBag* const first = rowOf(bag, begin);
            const PropertyBag* const row = rowOf(bag, i);
            if (!first || !row || first->size() == row->size()) continue;
            reportRow(i - begin, row->size(), first->size());
            return false;
        }
        return true;
    }

    const SequenceOps& elements_;
    std::size_t (*columns_)(const void*);
};

}  // namespace

void reportRow(std::size_t row, std::size_t size, std::size_t columns) {
    log(Error) << "row " << row << " of " << size << " elements does not fit a matrix of " << columns << " columns"
               << endlog();
}

TypeInfoGenerator* newAdaptedGenerator(const char* name, const char* doc, const SequenceOps& elements,
                                       const TypeOps& ops, const TypeThunks& thunks,
                                       std::size_t (*columns)(const void*)) {
    return new AdaptedTable(name, doc, elements, ops, thunks, columns);
}

}  // namespace RTT::types::detail
