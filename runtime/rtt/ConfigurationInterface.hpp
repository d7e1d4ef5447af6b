// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CONFIGURATION_INTERFACE_HPP
#define ORO_CONFIGURATION_INTERFACE_HPP

#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace RTT {

/**
 * The attributes, constants and properties of a service. They refer to variables of the component, which must outlive
 * them. Not thread safe; adding and removing are not real-time safe.
 */
class RTT_API ConfigurationInterface {
public:
    typedef std::vector<base::AttributeBase*> AttributeObjects;
    typedef std::vector<std::string> AttributeNames;

    ConfigurationInterface() = default;
    virtual ~ConfigurationInterface();
    ConfigurationInterface(const ConfigurationInterface&) = delete;
    ConfigurationInterface& operator=(const ConfigurationInterface&) = delete;

    /** Names a variable; returns the new attribute, which this owns. Without a name it cannot be found. */
    template <class T>
    Attribute<T>& addAttribute(const std::string& name, T& variable) {
        auto* made = new Attribute<T>(name, new internal::ReferenceDataSource<T>(variable));
        ownValue(made);
        return *made;
    }
    template <class T>
    Attribute<T>& addAttribute(const std::string& name, Attribute<T>& attribute) {
        attribute.setName(name);
        addAttribute(attribute);
        return attribute;
    }
    /** Shares the value of `attribute`; false if it has none. */
    bool addAttribute(base::AttributeBase& attribute);

    /** Names a variable that cannot be changed through this name; returns the new constant, which this owns. */
    template <class T>
    Constant<T>& addConstant(const std::string& name, const T& variable) {
        auto* made = new Constant<T>(name, new internal::ConstReferenceDataSource<T>(variable));
        ownValue(made);
        return *made;
    }
    /** The same for a value that is not a variable, of which it keeps a copy. */
    template <class T, std::enable_if_t<!std::is_lvalue_reference<T>::value, int> = 0>
    Constant<std::remove_const_t<T>>& addConstant(const std::string& name, T&& value) {
        typedef std::remove_const_t<T> Value;
        auto* made = new Constant<Value>(name, new internal::ConstantDataSource<Value>(std::forward<T>(value)));
        ownValue(made);
        return *made;
    }
    template <class T>
    Constant<T>& addConstant(const std::string& name, Constant<T>& constant) {
        constant.setName(name);
        addConstant(constant);
        return constant;
    }
    bool addConstant(base::AttributeBase& constant);

    /** Names a variable that is saved to and loaded from property files. */
    template <class T>
    Property<T>& addProperty(const std::string& name, T& variable) {
        auto* made = new Property<T>(name, "", new internal::ReferenceDataSource<T>(variable));
        ownProperty(made);
        return *made;
    }
    template <class T>
    Property<T>& addProperty(const std::string& name, Property<T>& property) {
        property.setName(name);
        addProperty(property);
        return property;
    }
    /** Refers to `property`; false if it is not ready or the name is taken. */
    bool addProperty(base::PropertyBase& property);

    /** Takes ownership; deletes it and returns false if it has no name or no value. */
    bool setValue(base::AttributeBase* attribute);
    bool hasAttribute(const std::string& name) const { return getValue(name) != nullptr; }
    /** The first of that name, or null. */
    base::AttributeBase* getValue(const std::string& name) const;
    base::AttributeBase* getAttribute(const std::string& name) const { return getValue(name); }
    base::AttributeBase* getConstant(const std::string& name) const { return getValue(name); }
    bool removeAttribute(const std::string& name) { return removeValue(name); }
    bool removeValue(const std::string& name);
    const AttributeObjects& getValues() const { return values_; }
    AttributeNames getAttributeNames() const;
    /** Takes ownership of all of them. */
    void loadValues(const AttributeObjects& values);
    ConfigurationInterface* attributes() { return this; }

    bool hasProperty(const std::string& name) const { return getProperty(name) != nullptr; }
    bool removeProperty(base::PropertyBase& property);
    /** The first of that name at the top level, or null. */
    base::PropertyBase* getProperty(const std::string& name) const { return bag_.find(name); }
    PropertyBag* properties() { return &bag_; }
    const PropertyBag* properties() const { return &bag_; }

    /** Removes everything. */
    void clear();

private:
    void ownProperty(base::PropertyBase* property);
    void ownValue(base::AttributeBase* value);

    AttributeObjects values_;
    AttributeObjects nameless_;  // the code that added one may refer to it
    PropertyBag bag_;
};

}  // namespace RTT

#endif
