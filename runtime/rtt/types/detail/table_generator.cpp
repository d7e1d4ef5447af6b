// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "table_generator.hpp"

#include <rtt/types/ValueFactory.hpp>
#include <rtt/types/TypeOps.hpp>
#include "member_update.hpp"

namespace RTT {
namespace types {
namespace detail {

TableGenerator::TableGenerator(const char* name, const char* doc, const TypeOps& ops, const TypeThunks& thunks)
    : name_(name), doc_(doc), ops_(&ops), thunks_(&thunks) {}

TypeInfo* TableGenerator::getTypeInfoObject() const { return knownOrNewType(name_, *ops_->id); }

bool TableGenerator::installTypeInfoObject(TypeInfo* info) {
    info->setTypeId(ops_->id);
    info->setOps(ops_);
    info->setThunks(thunks_);
    // A value factory of an earlier registration would hide the thunks, and what it made was the same.
    info->setValueFactory(ValueFactoryPtr());
    if (doc_ && *doc_) info->setDescription(doc_);
    return false;
}

bool updateByAnyMeans(base::DataSourceBase::shared_ptr target, base::DataSourceBase::shared_ptr source) {
    if (!target || !source) return false;
    if (target->update(source.get())) return true;
    const TypeInfo* type = target->getTypeInfo();
    const auto converted = type->convert(source);
    if (converted != source && target->update(converted.get())) return true;
    return type->composeType(source, target);
}

}  // namespace detail
}  // namespace types
}  // namespace RTT
