// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Instantiates everything typed around a C++ type. For typekits only: components should not include it.
#ifndef ORO_TYPE_THUNKS_HPP
#define ORO_TYPE_THUNKS_HPP

#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/ElementDataSource.hpp>
#include <rtt/internal/PartDataSource.hpp>
#include "TypeOps.hpp"
#include "TypeThunkTable.hpp"
#include "carray.hpp"

namespace RTT {
namespace types {

namespace detail {

/** The thunks of an ordinary value type. */
template <class T>
struct Thunks {
    using Source = base::DataSourceBase;
    using Assignable = internal::AssignableDataSource<T>;

    /** A new variable with the value of `from`; null if `from` is of another type. */
    static internal::ValueDataSource<T>* valueOf(Source* from) {
        auto* made = internal::ValueDataSource<T>::make();
        if (!from) return made;
        base::DataSourceBase::shared_ptr owned(made);
        return made->update(from)
                   ? static_cast<internal::ValueDataSource<T>*>(base::DataSourceBase::release(std::move(owned)))
                   : nullptr;
    }
    static Source* value() { return internal::ValueDataSource<T>::make(); }
    static Source* reference(void* at) { return new internal::ReferenceDataSource<T>(*static_cast<T*>(at)); }
    static Source* part(void* at, std::size_t, Source* parent) {
        return internal::PartDataSource<T>::make(*static_cast<T*>(at), parent);
    }
    static Source* element(Source* parent, Source* index, const SequenceOps* ops) {
        return new internal::ElementDataSource<T>(parent, index, ops);
    }
    static Source* actionAlias(base::ActionInterface* action, Source* source) {
        auto* same = internal::DataSource<T>::narrow(source);
        return same ? new internal::ActionAliasDataSource<T>(action, same) : nullptr;
    }
    static base::AttributeBase* constant(const std::string& name, Source* source) {
        if (!source || !source->getTypeId() || *source->getTypeId() != typeid(T) || !source->evaluate()) return nullptr;
        const T& value = *static_cast<const T*>(source->getRawConstPointer());
        return new Constant<T>(name, internal::ConstantDataSource<T>::make(value));
    }
    static base::AttributeBase* variable(const std::string& name, int) {
        return new Attribute<T>(name, new internal::UnboundDataSource<internal::ValueDataSource<T>>());
    }
    static base::AttributeBase* attribute(const std::string& name, Source* source) {
        if (!source) return new Attribute<T>(name);
        auto* same = Assignable::narrow(source);
        return same ? new Attribute<T>(name, same) : nullptr;
    }
    static base::PropertyBase* property(const std::string& name, const std::string& description, Source* source) {
        if (auto* same = Assignable::narrow(source)) return new Property<T>(name, description, same);
        auto* made = valueOf(source);
        return made ? new Property<T>(name, description, made) : nullptr;
    }
    static base::InputPortInterface* inputPort(const std::string& name) { return new InputPort<T>(name); }
    static base::OutputPortInterface* outputPort(const std::string& name) { return new OutputPort<T>(name); }

    static base::ChannelElementBase::shared_ptr dataStorage(const ConnPolicy& policy) {
        return internal::ConnFactory::buildDataStorage<T>(policy);
    }

    static constexpr TypeThunks table() {
        TypeThunks t{};
        t.value = &value;
        t.reference = &reference;
        t.part = &part;
        t.element = &element;
        t.actionAlias = &actionAlias;
        t.constant = &constant;
        t.variable = &variable;
        t.attribute = &attribute;
        t.property = &property;
        if constexpr (isSample<T>) {
            t.inputPort = &inputPort;
            t.outputPort = &outputPort;
            t.dataStorage = &dataStorage;
        }
        t.schema = &schemaOf<T>;
        return t;
    }
};

/** Views on arrays: parts, variables and properties, no ports (a view must not travel to another component). */
template <class E>
struct Thunks<carray<E>> {
    using T = carray<E>;
    using Source = base::DataSourceBase;

    static Source* value() { return new internal::ArrayDataSource<T>(); }
    static Source* reference(void* at) { return new internal::ReferenceDataSource<T>(*static_cast<T*>(at)); }
    static Source* part(void* at, std::size_t count, Source* parent) {
        return new internal::ArrayPartDataSource<E>(static_cast<E*>(at), count, parent);
    }
    static base::AttributeBase* variable(const std::string& name, int sizehint) {
        return new Attribute<T>(name, new internal::ArrayDataSource<T>(sizehint > 0 ? std::size_t(sizehint) : 0));
    }
    static base::AttributeBase* attribute(const std::string& name, Source* source) {
        auto* same = internal::AssignableDataSource<T>::narrow(source);
        return same ? new Attribute<T>(name, same) : nullptr;
    }
    static base::PropertyBase* property(const std::string& name, const std::string& description, Source* source) {
        auto* same = internal::AssignableDataSource<T>::narrow(source);
        return same ? new Property<T>(name, description, same) : nullptr;
    }
    static constexpr TypeThunks table() {
        TypeThunks t{};
        t.value = &value;
        t.reference = &reference;
        t.part = &part;
        t.variable = &variable;
        t.attribute = &attribute;
        t.property = &property;
        return t;
    }
};

}  // namespace detail

/** The table of T; its address is not identity. */
template <class T>
const TypeThunks& typeThunks() {
    static constexpr TypeThunks table = detail::Thunks<T>::table();
    return table;
}

}  // namespace types
}  // namespace RTT

#endif
