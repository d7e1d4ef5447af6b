// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_ATTRIBUTE_BASE_HPP
#define ORO_CORELIB_ATTRIBUTE_BASE_HPP

#include "DataSourceBase.hpp"

namespace RTT {
namespace base {

/** A named value without documentation. Not thread safe; not for real-time contexts except reading the value. */
class RTT_API AttributeBase {
public:
    AttributeBase() = default;
    explicit AttributeBase(const std::string& name) : mname(name) {}
    AttributeBase(const AttributeBase&) = default;
    AttributeBase& operator=(const AttributeBase&) = default;
    virtual ~AttributeBase();

    /** True if the attribute has a value. */
    bool ready() const { return getDataSource() != nullptr; }
    explicit operator bool() const { return ready(); }
    virtual DataSourceBase::shared_ptr getDataSource() const = 0;

    /** A new attribute on the same data source. The caller owns it. */
    virtual AttributeBase* clone() const = 0;
    /** For copies of programs: a new attribute whose data source is copied or, if `instantiate`, cloned. */
    virtual AttributeBase* copy(std::map<const DataSourceBase*, DataSourceBase*>& replacements,
                                bool instantiate) const = 0;

    const std::string& getName() const { return mname; }
    void setName(const std::string& name) { mname = name; }

protected:
    /** Empty if `other` is null. */
    static const std::string& nameOf(const AttributeBase* other);

    std::string mname;
};

}  // namespace base
}  // namespace RTT

#endif
