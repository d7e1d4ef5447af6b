// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_HPP
#define ORO_PROPERTY_HPP

#include <rtt/base/PropertyBase.hpp>
#include <rtt/internal/DataSources.hpp>
#include <iosfwd>

namespace RTT {

class PropertyBag;

namespace internal {
namespace detail {
/** Logs that the value of `from` cannot be used as a Property of type `destination`. */
RTT_API void logPropertyMismatch(const base::PropertyBase& from, const std::string& destination);
/** These return an empty string if `property` is null. */
RTT_API const std::string& nameOf(const base::PropertyBase* property);
RTT_API const std::string& descriptionOf(const base::PropertyBase* property);
}  // namespace detail
}  // namespace internal

/**
 * A property of type T. get() and set() are real-time safe if copying T is.
 * Using the value of a property that is not ready() is a programming error.
 */
template <typename T>
class Property : public base::PropertyBase {
public:
    typedef T value_t;
    typedef internal::AssignableDataSource<T> DataSourceType;
    typedef DataSourceType SourceType;
    typedef typename SourceType::param_t param_t;
    typedef typename SourceType::reference_t reference_t;
    typedef typename SourceType::const_reference_t const_reference_t;

    /** Not ready. */
    Property() {}
    [[gnu::cold]] explicit Property(const std::string& name)
        : PropertyBase(name, ""), _value(internal::ValueDataSource<T>::make()) {}
    [[gnu::cold]] Property(const std::string& name, const std::string& description,
                           const T& value = types::ValueTraits<T>::make())
        : PropertyBase(name, description), _value(internal::ValueDataSource<T>::make(value)) {}
    template <class P, class = internal::IfSource<P, internal::AssignableDataSource<T>>>
    [[gnu::cold]] Property(const std::string& name, const std::string& description, const P& source)
        : PropertyBase(name, description), _value(source) {}
    /** Copies the value. */
    [[gnu::cold]] Property(const Property<T>& other)
        : PropertyBase(other), _value(other._value ? internal::ValueDataSource<T>::make(other.rvalue()) : nullptr) {}
    /** Shares the value of `source`; not ready, with an error logged, if that has another type. */
    [[gnu::cold]] Property(base::PropertyBase* source)
        : PropertyBase(internal::detail::nameOf(source), internal::detail::descriptionOf(source)),
          _value(source ? SourceType::narrow(source->getDataSource().get()) : nullptr) {
        if (source && !_value) internal::detail::logPropertyMismatch(*source, internal::DataSource<T>::GetType());
    }

    [[gnu::cold]] Property<T>& operator=(base::PropertyBase* source) {
        Property<T> made(source);
        _name = made._name;
        _description = made._description;
        _value = made._value;
        return *this;
    }
    /** Assigns name, description and value. */
    Property<T>& operator=(const Property<T>& other) {
        if (this == &other) return *this;
        PropertyBase::operator=(other);
        if (!other._value)
            _value = nullptr;
        else if (_value)
            set(other.rvalue());
        else
            _value = internal::ValueDataSource<T>::make(other.rvalue());
        return *this;
    }
    Property<T>& operator=(param_t value) {
        set(value);
        return *this;
    }
    Property<T>& operator<<=(const Property<T>& source) {
        this->update(&source);
        return *this;
    }

    operator T() const { return _value->get(); }
    T get() const { return _value->get(); }
    const_reference_t rvalue() const { return _value->rvalue(); }
    void set(param_t value) {
        _value->set(value);
        _value->updated();
    }
    /** The stored value, to be changed in place. */
    reference_t set() { return _value->set(); }
    reference_t value() { return _value->set(); }
    const_reference_t value() const { return _value->rvalue(); }

    Property<T>& doc(const std::string& text) {
        _description = text;
        return *this;
    }

    base::DataSourceBase::shared_ptr getDataSource() const override { return _value; }
    typename SourceType::shared_ptr getAssignableDataSource() const { return _value; }
    [[gnu::cold]] bool setDataSource(const base::DataSourceBase::shared_ptr& source) override {
        auto* same = SourceType::narrow(source.get());
        if (same) _value = same;
        return same != nullptr;
    }
    /** Fills the value from the members in `bag`; false if the type cannot be composed from it. */
    [[gnu::cold]] bool compose(const PropertyBag& bag);

    std::string getType() const override { return internal::DataSource<T>::GetType(); }
    const types::TypeInfo* getTypeInfo() const override { return internal::DataSource<T>::GetTypeInfo(); }

    [[gnu::cold]] Property<T>* clone() const override { return new Property<T>(*this); }
    [[gnu::cold]] Property<T>* create() const override {
        return new Property<T>(_name, _description, internal::ValueDataSource<T>::make());
    }
    [[gnu::cold]] base::PropertyBase* create(const base::DataSourceBase::shared_ptr& source) const override {
        auto* same = SourceType::narrow(source.get());
        return same ? new Property<T>(_name, _description, same) : nullptr;
    }

    static Property<T>* narrow(base::PropertyBase* property) { return dynamic_cast<Property<T>*>(property); }

protected:
    typename SourceType::shared_ptr _value;
};

template <typename T>
std::ostream& operator<<(std::ostream& os, const Property<T>& property) {
    return os << property.rvalue();
}

/** Sets the property if a value can be read. */
template <typename T>
std::istream& operator>>(std::istream& is, Property<T>& property) {
    T value{};
    if (is >> value) property.set(value);
    return is;
}

}  // namespace RTT

#include "PropertyBag.hpp"

namespace RTT {
template <typename T>
bool Property<T>::compose(const PropertyBag& bag) {
    return _value && internal::detail::composeFromBag(bag, _value);
}
}  // namespace RTT

#endif
