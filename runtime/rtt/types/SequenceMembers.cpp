// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "SequenceMembers.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include "Operators.hpp"
#include "TypeThunkTable.hpp"
#include "Types.hpp"
#include <rtt/types/detail/count_data_source.hpp>
#include <rtt/types/member_update.hpp>
#include <cstdlib>
#include <istream>
#include <ostream>

namespace RTT::types {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

bool isIndexText(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

const TypeThunks* SequenceMembers::elementThunks() const {
    const TypeInfo* type = Types()->getTypeById(ops_.elementType());
    const TypeThunks* thunks = type ? type->getThunks() : nullptr;
    if (!thunks || !thunks->element)
        log(Error) << "no access to the elements of a sequence: their C++ type " << ops_.elementType()
                   << " is not registered" << endlog();
    return thunks && thunks->element ? thunks : nullptr;
}

SourcePtr SequenceMembers::elementAt(const SourcePtr& item, std::size_t index) const {
    const TypeThunks* thunks = elementThunks();
    if (!thunks) return nullptr;
    return thunks->element(item.get(), new internal::ConstantDataSource<unsigned int>(static_cast<unsigned int>(index)),
                           &ops_);
}

std::size_t SequenceMembers::sizeOf(const SourcePtr& item) const {
    const void* container = item->evaluate() ? item->getRawConstPointer() : nullptr;
    return container ? ops_.size(container) : 0;
}

bool SequenceMembers::resize(SourcePtr value, int size) const {
    void* container = value->isAssignable() && size >= 0 && ops_.resize ? value->getRawPointer() : nullptr;
    if (!container || !ops_.resize(container, static_cast<std::size_t>(size))) return false;
    value->updated();
    return true;
}

std::vector<std::string> SequenceMembers::getMemberNames() const { return {"size", "capacity"}; }

SourcePtr SequenceMembers::getMember(SourcePtr item, const std::string& name) const {
    if (name == "size") return new detail::CountDataSource(item, ops_.size);
    if (name == "capacity") return new detail::CountDataSource(item, ops_.capacity);
    if (isIndexText(name)) return elementAt(item, std::strtoul(name.c_str(), nullptr, 10));
    if (const SourcePtr computed = operators()->applyDot(name, item.get())) return computed;
    log(Error) << "a sequence has no member " << name << "; it has size, capacity, and elements by index" << endlog();
    return nullptr;
}

SourcePtr SequenceMembers::getMember(SourcePtr item, SourcePtr id) const {
    if (const void* name = detail::valueOfType(id, typeid(std::string)))
        return getMember(item, *static_cast<const std::string*>(name));
    const TypeInfo* number = Types()->getTypeInfo<int>();
    const std::type_info* type = id->getTypeId();
    if (number && type && *type != typeid(int) && *type != typeid(unsigned int)) {
        id = number->convert(id);
        type = id->getTypeId();
    }
    if (!type || (*type != typeid(int) && *type != typeid(unsigned int))) {
        log(Error) << "the index of a sequence must be an int, not " << id->getType() << endlog();
        return nullptr;
    }
    const TypeThunks* thunks = elementThunks();
    return thunks ? thunks->element(item.get(), id.get(), &ops_) : nullptr;
}

SourcePtr SequenceMembers::decomposeType(SourcePtr source) const {
    boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> result(new internal::ValueDataSource<PropertyBag>());
    result->set().setType(source->getTypeName());
    std::size_t count = 0;
    const bool complete = forEach(source, [&](const SourcePtr& element) {
        result->set().ownProperty(
            element->getTypeInfo()->buildProperty("Element" + std::to_string(count++), "Sequence Element", element));
    });
    return complete ? result : nullptr;
}

bool SequenceMembers::forEach(const SourcePtr& source, const std::function<void(const SourcePtr&)>& action) const {
    const std::size_t size = sizeOf(source);
    const TypeThunks* const thunks = size ? elementThunks() : nullptr;
    if (size && !thunks) return false;
    if (!ops_.visit) {
        for (std::size_t i = 0; i != size; ++i) action(elementAt(source, i));
        return true;
    }
    struct Context {
        const TypeThunks* thunks;
        const std::function<void(const SourcePtr&)>& action;
    } context = {thunks, action};
    const auto each = [](void* to, const void* element) {
        const auto& [of, act] = *static_cast<Context*>(to);
        const SourcePtr copy(of->value());
        copy->assignValue(element);
        act(copy);
    };
    if (size) ops_.visit(source->getRawConstPointer(), each, &context);
    return true;
}

// If two elements have the same key, the first stays, as in the container itself.
bool SequenceMembers::insertAll(const PropertyBag& bag, void* container) const {
    const TypeThunks* const thunks = elementThunks();
    if (!thunks || !ops_.resize(container, 0)) return false;
    for (std::size_t i = detail::firstElement(bag); i != bag.size(); ++i) {
        const base::PropertyBase* const item = bag.getItem(i);
        const SourcePtr element(thunks->value());
        if (!detail::updateWithConversion(element, item->getDataSource())) return reportElement(element, *item);
        ops_.insert(container, element->getRawConstPointer());
    }
    return true;
}

bool SequenceMembers::reportElement(const SourcePtr& element, const base::PropertyBase& item) const {
    log(Error) << "element " << item.getName() << " of type " << (element ? element->getTypeName() : "unknown_t")
               << " cannot take a value of type " << item.getType() << endlog();
    return false;
}

bool SequenceMembers::composeType(SourcePtr source, SourcePtr target) const {
    const auto* bag = static_cast<const PropertyBag*>(detail::valueOfType(source, typeid(PropertyBag)));
    if (!bag || !target->isAssignable()) return false;
    if (ops_.insert) {
        if (!insertAll(*bag, target->getRawPointer())) return false;
        target->updated();
        return true;
    }
    const std::size_t first = detail::firstElement(*bag), count = bag->size() - first;
    if (ops_.resize) {
        if (!resize(target, static_cast<int>(count))) return false;
    } else if (sizeOf(target) != count) {
        log(Error) << "an array of " << sizeOf(target) << " elements cannot take " << count << endlog();
        return false;
    }
    for (std::size_t i = 0; i != count; ++i) {
        const base::PropertyBase* item = bag->getItem(first + i);
        const SourcePtr element = elementAt(target, i);
        if (!element || !detail::updateWithConversion(element, item->getDataSource()))
            return reportElement(element, *item);
    }
    target->updated();
    return true;
}

std::ostream& SequenceMembers::write(std::ostream& os, SourcePtr source) const {
    os << '{';
    const char* separator = "";
    forEach(source, [&](const SourcePtr& element) {
        element->evaluate();
        element->write(os << separator);
        separator = ", ";
    });
    return os << '}';
}

std::istream& SequenceMembers::read(std::istream& is, SourcePtr) const {
    is.setstate(std::ios::failbit);
    return is;
}

}  // namespace RTT::types
