// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "DataSources.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include "FusedFunctorDataSource.hpp"
#include <algorithm>

namespace RTT::internal {

namespace detail {

types::TypeInfo* typeInfoFor(const std::type_info& id, std::atomic<types::TypeInfo*>& cache) {
    const auto repository = types::Types();
    if (types::TypeInfo* found = repository->getTypeById(&id)) {
        // Release: a thread that reads the pointer sees the complete object.
        cache.store(found, std::memory_order_release);
        return found;
    }
    // Not remembered: a typekit that knows the type may be loaded later.
    return repository->unknownType();
}

const std::string& plainTypeName(const types::TypeInfo* info) { return info->getTypeName(); }

std::string fullTypeName(const types::TypeInfo* info, const std::string& qualifier) {
    return plainTypeName(info) + qualifier;
}

const std::string& qualifierText(bool isConst, bool isReference, bool isPointer) {
    static const std::string none, reference = " &", constReference = " const&", constant = " const", pointer = "*",
                                   constPointer = " const*";
    if (isReference) return isConst ? constReference : reference;
    if (isPointer) return isConst ? constPointer : pointer;
    return isConst ? constant : none;
}

namespace {

bool isOfType(const base::DataSourceBase::shared_ptr& source, const std::type_info& id) {
    return source && source->getTypeId() && *source->getTypeId() == id;
}

bool isArgument(const ArgumentType& type, const base::DataSourceBase::shared_ptr& source) {
    return isOfType(source, *type.id) && (!type.isOutput || source->isAssignable());
}

[[noreturn]] void refuse(const ArgumentType& type, const base::DataSourceBase::shared_ptr& source, int number) {
    if (isOfType(source, *type.id)) throw non_lvalue_args_exception(number, source->getType());
    const types::TypeInfo* wanted = types::Types()->getTypeById(type.id);
    throw wrong_types_of_args_exception(number, wanted ? wanted->getTypeName() : type.id->name(),
                                        source ? source->getType() : "nothing");
}

}  // namespace

std::vector<base::DataSourceBase::shared_ptr> convertedTo(const ArgumentType* types, std::size_t count,
                                                          const std::vector<base::DataSourceBase::shared_ptr>& list) {
    auto converted = list;
    for (std::size_t i = 0; i != count && list.size() == count; ++i) {
        const types::TypeInfo* wanted = types[i].isOutput ? nullptr : types::Types()->getTypeById(types[i].id);
        if (wanted && list[i]) converted[i] = wanted->convert(list[i]);
    }
    return converted;
}

bool areArguments(const ArgumentType* types, std::size_t count,
                  const std::vector<base::DataSourceBase::shared_ptr>& list) {
    return std::equal(types, types + count, list.begin(), list.end(), isArgument);
}

std::vector<base::DataSourceBase::shared_ptr> checkedArguments(
    const ArgumentType* types, std::size_t count, const std::vector<base::DataSourceBase::shared_ptr>& list) {
    if (list.size() != count)
        throw wrong_number_of_args_exception(static_cast<int>(count), static_cast<int>(list.size()));
    auto converted = convertedTo(types, count, list);
    for (std::size_t i = 0; i != count; ++i)
        if (!isArgument(types[i], converted[i])) refuse(types[i], list[i], static_cast<int>(i + 1));
    return converted;
}

}  // namespace detail

}  // namespace RTT::internal
