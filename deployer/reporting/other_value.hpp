// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_OTHER_VALUE_HPP
#define ORO_OCL_REPORTING_OTHER_VALUE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace OCL::reporting {

/** The text of a value that is neither a number nor a string, made by its type (for example the name of an enumerator)
    or by its stream operator. Allocates. */
std::string textOf(const RTT::base::DataSourceBase::shared_ptr& value);

/** Storage for values of a type that can be copied byte by byte, which the writing thread turns into text. */
class OtherValue {
public:
    OtherValue(RTT::base::DataSourceBase::shared_ptr place, std::size_t size);

    std::size_t size() const { return size_; }
    /** The text of the value with these bytes. */
    std::string text(const char* bytes) const;

private:
    const RTT::base::DataSourceBase::shared_ptr place_;
    const std::size_t size_;
};

/** One OtherValue for each such type in a report; they live as long as this. */
class OtherValues {
public:
    /** Null if values of this type cannot be copied byte by byte. */
    const OtherValue* of(const RTT::types::TypeInfo& type);
    /** The types of elements that are being taken apart: a type may have a sequence of itself. */
    std::set<const RTT::types::TypeInfo*> open;

private:
    std::map<const RTT::types::TypeInfo*, std::unique_ptr<OtherValue>> known_;
};

}  // namespace OCL::reporting

#endif
