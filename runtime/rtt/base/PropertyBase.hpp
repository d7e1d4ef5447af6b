// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTYBASE_HPP
#define ORO_PROPERTYBASE_HPP

#include "DataSourceBase.hpp"
#include <rtt/types/TypeInfo.hpp>

namespace RTT {
namespace base {

class PropertyIntrospection;

/**
 * A named, documented value that tools may read, change, save and load. Not thread safe. Only reading and setting the
 * value is real-time safe, if copying its type is.
 */
class RTT_API PropertyBase {
public:
    PropertyBase();
    PropertyBase(const std::string& name, const std::string& description);
    PropertyBase(const PropertyBase& other);
    PropertyBase& operator=(const PropertyBase& other);
    virtual ~PropertyBase();

    const std::string& getName() const { return _name; }
    void setName(const std::string& name) { _name = name; }
    const std::string& getDescription() const { return _description; }
    void setDescription(const std::string& description) { _description = description; }

    /** True if the property has a value. */
    virtual bool ready() const;
    virtual DataSourceBase::shared_ptr getDataSource() const = 0;
    /** Uses the value of `source` from now on; false if that is read-only or has another type. */
    virtual bool setDataSource(const DataSourceBase::shared_ptr& source) = 0;
    /** The name of the value's type. */
    virtual std::string getType() const;
    virtual const types::TypeInfo* getTypeInfo() const;

    /** Calls the visitor's function for the type of this property. */
    virtual void identify(PropertyIntrospection* visitor) const;

    /**
     * update: assigns the value, adds items that a bag lacks, and the description if this has none.
     * refresh: assigns only the value. copy: assigns name, description and value.
     * Values of other types are converted or composed if their types allow it; otherwise false and nothing changes.
     */
    virtual bool update(const PropertyBase* other);
    virtual bool refresh(const PropertyBase* other);
    virtual bool copy(const PropertyBase* other);
    bool update(const PropertyBase& other) { return update(&other); }
    bool refresh(const PropertyBase& other) { return refresh(&other); }
    bool copy(const PropertyBase& other) { return copy(&other); }
    /** The same as actions, for programs; null if the types do not fit. The caller owns them. */
    virtual ActionInterface* updateCommand(const PropertyBase* other);
    virtual ActionInterface* refreshCommand(const PropertyBase* other);
    virtual ActionInterface* copyCommand(const PropertyBase* other);

    /** A new property with a copy of name, description and value. The caller owns it. */
    virtual PropertyBase* clone() const = 0;
    /** A new property with a copy of name and description and a default value. The caller owns it. */
    virtual PropertyBase* create() const = 0;
    /** Like create(), with the value of `source`; null if that has another type. */
    virtual PropertyBase* create(const DataSourceBase::shared_ptr& source) const = 0;

    DataSourceBase::shared_ptr getMember(const std::string& name) const;

protected:
    std::string _name;
    std::string _description;
};

RTT_API std::ostream& operator<<(std::ostream& os, PropertyBase* property);

}  // namespace base
}  // namespace RTT

#endif
