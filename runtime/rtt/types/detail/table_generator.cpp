// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "table_generator.hpp"

#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/StreamFactory.hpp>
#include <rtt/types/ValueFactory.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/member_update.hpp>

#include <charconv>
#include <initializer_list>
#include <string>

namespace RTT::types::detail {

TableGenerator::TableGenerator(const char* name, const char* doc, const TypeOps& ops, const TypeThunks& thunks)
    : name_(name), doc_(doc), ops_(&ops), thunks_(&thunks) {}

TypeInfo* TableGenerator::getTypeInfoObject() const { return knownOrNewType(name_, *ops_->id); }

bool TableGenerator::installTypeInfoObject(TypeInfo* info) {
    info->setTypeId(ops_->id);
    info->setOps(ops_);
    info->setThunks(thunks_);
    // A value factory of an earlier registration would be used instead of the thunks, which make the same objects.
    info->setValueFactory(ValueFactoryPtr());
    if (doc_ && *doc_) info->setDescription(doc_);
    return false;  // the repository keeps this generator
}

namespace {

template <class T>
std::optional<long long> numberOf(const base::DataSourceBase::shared_ptr& source) {
    const void* value = valueOfType(source, typeid(T));
    if (!value) return std::nullopt;
    return static_cast<long long>(*static_cast<const T*>(value));
}

}  // namespace

const Enumeration* enumerationOf(const TypeInfo* type) {
    return type ? dynamic_cast<const Enumeration*>(type->getCompositionFactory().get()) : nullptr;
}

std::optional<long long> wholeNumberIn(const base::DataSourceBase::shared_ptr& source) {
    if (const void* text = valueOfType(source, typeid(std::string))) {
        const std::string& digits = *static_cast<const std::string*>(text);
        long long number = 0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return std::nullopt;
        return number;
    }
    for (const auto read : {&numberOf<int>, &numberOf<unsigned>, &numberOf<long long>, &numberOf<unsigned long long>})
        if (const auto number = read(source)) return number;
    return std::nullopt;
}

bool updateWithConversion(base::DataSourceBase::shared_ptr target, base::DataSourceBase::shared_ptr source) {
    if (!target || !source) return false;
    if (target->update(source.get())) return true;
    const TypeInfo* type = target->getTypeInfo();
    if (const Enumeration* values = enumerationOf(type)) {
        const std::optional<long long> number = wholeNumberIn(source);
        if (number && !values->takesNumber(*number)) return false;
    }
    const auto converted = type->convert(source);
    if (converted != source && target->update(converted.get())) return true;
    return type->composeType(source, target);
}

}  // namespace RTT::types::detail
