// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Instantiates everything that depends on a C++ type. Only for typekits; components should not include it.
#ifndef ORO_TYPE_THUNKS_HPP
#define ORO_TYPE_THUNKS_HPP

#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/DataSources.hpp>
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

    /** `source` if it can be assigned; otherwise null. */
    [[gnu::cold]] static Assignable* assignable(Source* source) {
        auto* const same = Assignable::narrow(source);
        return same && (!std::is_copy_assignable<T>::value || same->isAssignable()) ? same : nullptr;
    }
    /** A new variable with the value of `from`; null if `from` is of another type. */
    [[gnu::cold]] static internal::ValueDataSource<T>* valueOf(Source* from) {
        auto* made = internal::ValueDataSource<T>::make();
        if (!from) return made;
        base::DataSourceBase::shared_ptr owned(made);
        return made->update(from)
                   ? static_cast<internal::ValueDataSource<T>*>(base::DataSourceBase::release(std::move(owned)))
                   : nullptr;
    }
    [[gnu::cold]] static Source* value() { return internal::ValueDataSource<T>::make(); }
    [[gnu::cold]] static Source* reference(void* at) {
        return new internal::ReferenceDataSource<T>(*static_cast<T*>(at));
    }
    [[gnu::cold, gnu::noinline]] static Source* placed(internal::ValuePlace* place) {
        return new internal::PlacedDataSource<T>(place);
    }
    [[gnu::cold]] static Source* part(void* at, std::size_t, Source* parent) {
        return placed(new internal::PartPlace(at, parent, typeOps<T>()));
    }
    [[gnu::cold]] static Source* element(Source* parent, Source* index, const SequenceOps* ops) {
        return placed(new internal::ElementPlace(parent, index, ops, value(), &resetValueAt<T>));
    }
    [[gnu::cold]] static Source* actionAlias(base::ActionInterface* action, Source* source) {
        return internal::DataSource<T>::narrow(source) ? placed(new internal::ActionPlace(action, source)) : nullptr;
    }
    [[gnu::cold]] static base::AttributeBase* constant(const std::string& name, Source* source) {
        const auto* const value = static_cast<const T*>(valueOfType(source, typeid(T)));
        return value ? new Alias(name, internal::ConstantDataSource<T>::make(*value)) : nullptr;
    }
    [[gnu::cold]] static base::AttributeBase* variable(const std::string& name, int) {
        auto* const local = internal::ValueDataSource<T>::make();
        local->copiesAnew();
        return new Attribute<T>(name, local);
    }
    [[gnu::cold]] static base::AttributeBase* attribute(const std::string& name, Source* source) {
        auto* same = source ? assignable(source) : internal::ValueDataSource<T>::make();
        return same ? new Attribute<T>(name, same) : nullptr;
    }
    [[gnu::cold]] static base::PropertyBase* property(const std::string& name, const std::string& description,
                                                      Source* source) {
        Assignable* value = assignable(source);
        if (!value) value = valueOf(source);
        return value ? new Property<T>(name, description, value) : nullptr;
    }
    [[gnu::cold]] static base::InputPortInterface* inputPort(const std::string& name) { return new InputPort<T>(name); }
    [[gnu::cold]] static base::OutputPortInterface* outputPort(const std::string& name) {
        return new OutputPort<T>(name);
    }

    static constexpr TypeThunks table() {
        TypeThunks t{};
        t.value = &value;
        t.reference = &reference;
        t.part = &part;
        t.element = &element;
        t.placed = &placed;
        t.actionAlias = &actionAlias;
        t.constant = &constant;
        t.variable = &variable;
        t.attribute = &attribute;
        t.property = &property;
        if constexpr (isSample<T>) {
            t.inputPort = &inputPort;
            t.outputPort = &outputPort;
            t.dataStorage = &internal::ChannelStorage<T>::make;
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

    [[gnu::cold]] static Source* value() { return new internal::ArrayDataSource<T>(); }
    [[gnu::cold]] static Source* reference(void* at) {
        return new internal::ReferenceDataSource<T>(*static_cast<T*>(at));
    }
    [[gnu::cold]] static Source* part(void* at, std::size_t count, Source* parent) {
        return new internal::ArrayPartDataSource<E>(static_cast<E*>(at), count, parent);
    }
    [[gnu::cold]] static base::AttributeBase* variable(const std::string& name, int sizehint) {
        return new Attribute<T>(name, new internal::ArrayDataSource<T>(sizehint > 0 ? std::size_t(sizehint) : 0));
    }
    [[gnu::cold]] static base::AttributeBase* attribute(const std::string& name, Source* source) {
        auto* same = internal::AssignableDataSource<T>::narrow(source);
        return same && same->isAssignable() ? new Attribute<T>(name, same) : nullptr;
    }
    [[gnu::cold]] static base::PropertyBase* property(const std::string& name, const std::string& description,
                                                      Source* source) {
        auto* same = internal::AssignableDataSource<T>::narrow(source);
        if (!same) return nullptr;
        if (same->isAssignable()) return new Property<T>(name, description, same);
        // A view on a read-only array must refer to a copy.
        same->evaluate();
        return new Property<T>(name, description, new internal::ArrayDataSource<T>(same->rvalue()));
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

/** The table of T, which plugins may have several times: do not compare addresses. */
template <class T>
const TypeThunks& typeThunks() {
    static constexpr TypeThunks table = detail::Thunks<T>::table();
    return table;
}

}  // namespace types
}  // namespace RTT

#endif
