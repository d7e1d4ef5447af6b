// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef PI_PROPERTIES_PROPERTYBAG
#define PI_PROPERTIES_PROPERTYBAG

#include <rtt/base/PropertyBase.hpp>
#include <string>
#include <vector>

namespace RTT {

template <typename T>
class Property;

/**
 * Ordered container of properties, itself usable as the value of a property. Refers to added properties; owns those
 * given to ownProperty() and deletes them with the bag. Names may occur more than once. Not thread safe and not for
 * real-time contexts, except looking at properties.
 */
class RTT_API PropertyBag {
public:
    typedef std::vector<base::PropertyBase*> Properties;
    typedef Properties PropertyContainerType;
    typedef Properties::iterator iterator;
    typedef Properties::const_iterator const_iterator;
    typedef std::vector<std::string> Names;

    /** A bag of type "PropertyBag". */
    PropertyBag();
    explicit PropertyBag(const std::string& type);
    /** Owned properties are cloned, the others are shared. */
    PropertyBag(const PropertyBag& other);
    PropertyBag& operator=(const PropertyBag& other);
    ~PropertyBag();

    bool add(base::PropertyBase* property) { return property && addProperty(*property); }
    /** Refers to `property`, which must outlive the bag or be removed; false if it is not ready. */
    bool addProperty(base::PropertyBase& property);
    /** Adds a property on the variable `attr`, which must outlive the bag. */
    template <class T>
    Property<T>& addProperty(const std::string& name, T& attr);
    /** Takes ownership, also of a property that was only referred to; false if it is null or not ready. */
    bool ownProperty(base::PropertyBase* property);
    bool ownsProperty(const base::PropertyBase* property) const;
    /** Removes this property, and deletes it if owned; false if it is not here. */
    bool removeProperty(base::PropertyBase* property);
    bool remove(base::PropertyBase* property) { return removeProperty(property); }
    /** Removes all. */
    void clear();

    /** The first property of that name, or null. Compares names one by one. */
    base::PropertyBase* find(const std::string& name) const;
    base::PropertyBase* getProperty(const std::string& name) const { return find(name); }
    /** The same, as a property of type T; null if it has another type. */
    template <class T>
    Property<T>* getPropertyType(const std::string& name) const {
        return dynamic_cast<Property<T>*>(find(name));
    }
    /** The first property whose value equals `value`, or null. */
    template <class T>
    base::PropertyBase* findValue(const T& value) const;

    /** Names, in order. */
    Names list() const;
    void list(Names& names) const { names = list(); }
    const Properties& getProperties() const { return mproperties; }
    Properties& getProperties() { return mproperties; }
    Properties getProperties(const std::string& name) const;
    /** Null beyond the end. */
    base::PropertyBase* getItem(std::size_t index) const;
    std::size_t size() const { return mproperties.size(); }
    bool empty() const { return mproperties.empty(); }

    const std::string& getType() const { return type; }
    void setType(const std::string& newType) { type = newType; }

    void identify(base::PropertyIntrospection* visitor) const;

    iterator begin() { return mproperties.begin(); }
    iterator end() { return mproperties.end(); }
    const_iterator begin() const { return mproperties.begin(); }
    const_iterator end() const { return mproperties.end(); }

    /** Adds the properties of `source`, replacing those of the same name. */
    PropertyBag& operator<<=(const PropertyBag& source);

protected:
    Properties mproperties;
    /** The owned properties, sorted by address. */
    Properties mowned_props;
    std::string type;
};

RTT_API std::ostream& operator<<(std::ostream& os, const PropertyBag& bag);

/** The paths of all properties, bags included, depth first. */
RTT_API std::vector<std::string> listProperties(const PropertyBag& bag, const std::string& separator = ".");
/** The descriptions in the order of listProperties(). */
RTT_API std::vector<std::string> listPropertyDescriptions(const PropertyBag& bag, const std::string& separator = ".");
/** The property at a path such as "a.b.c", or null. */
RTT_API base::PropertyBase* findProperty(const PropertyBag& bag, const std::string& path,
                                         const std::string& separator = ".");
/** Puts `item` into the bag at `path`, creating bags on the way; the bag takes ownership. */
RTT_API bool storeProperty(PropertyBag& bag, const std::string& path, base::PropertyBase* item,
                           const std::string& separator = ".");
RTT_API bool removeProperty(PropertyBag& bag, const std::string& path, const std::string& separator = ".");

/**
 * Assigns the values of `source` to the properties of `target`. False if the type of one does not fit or, with
 * `allprops`, if `source` lacks one.
 */
RTT_API bool refreshProperties(const PropertyBag& target, const PropertyBag& source, bool allprops = false);
/** Refreshes the property that has the name of `source`. */
RTT_API bool refreshProperty(const PropertyBag& target, const base::PropertyBase& source);
RTT_API bool refreshProperty(const PropertyBag& target, const PropertyBag& source, const std::string& path,
                             const std::string& separator = ".");
/** Like refreshProperties(), and adds copies of the properties that `target` lacks. */
RTT_API bool updateProperties(PropertyBag& target, const PropertyBag& source);
RTT_API bool updateProperty(PropertyBag& target, const PropertyBag& source, const std::string& path,
                            const std::string& separator = ".");
/** Adds clones of all properties of `source`. */
RTT_API bool copyProperties(PropertyBag& target, const PropertyBag& source);
/** Deletes the properties of the bag, owned or not. */
RTT_API void deleteProperties(PropertyBag& bag);
/** The same, with those of all inner bags. */
RTT_API void deletePropertyBag(PropertyBag& bag);
/** Moves the properties of inner bags up into `bag`, as "outer.inner"; empty bags stay. */
RTT_API void flattenPropertyBag(PropertyBag& bag, const std::string& separator = ".");

namespace internal {
namespace detail {
RTT_API bool composeFromBag(const PropertyBag& bag, base::DataSourceBase::shared_ptr target);
}
}  // namespace internal

}  // namespace RTT

#include "Property.hpp"

namespace RTT {

template <class T>
Property<T>& PropertyBag::addProperty(const std::string& name, T& attr) {
    auto* made = new Property<T>(name, "", new internal::ReferenceDataSource<T>(attr));
    ownProperty(made);
    return *made;
}

template <class T>
base::PropertyBase* PropertyBag::findValue(const T& value) const {
    for (auto* property : mproperties) {
        auto* typed = dynamic_cast<Property<T>*>(property);
        if (typed && typed->rvalue() == value) return property;
    }
    return nullptr;
}

}  // namespace RTT

#endif
