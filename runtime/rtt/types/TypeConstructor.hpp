// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_CONSTRUCTOR_HPP
#define ORO_TYPE_CONSTRUCTOR_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace types {

/** Makes values of one type from arguments of other types; scripts write `type(arguments)`. */
class RTT_API TypeConstructor {
public:
    virtual ~TypeConstructor();

    /** The value, computed whenever it is evaluated; null if this constructor does not take these arguments. */
    virtual base::DataSourceBase::shared_ptr build(
        const std::vector<base::DataSourceBase::shared_ptr>& arguments) const = 0;
    /** The same for an implicit conversion; logs a warning unless the constructor is automatic. */
    virtual base::DataSourceBase::shared_ptr convert(base::DataSourceBase::shared_ptr argument) const;
};

namespace detail {
RTT_API void warnConversion(const base::DataSourceBase& from, const base::DataSourceBase& to);
}

}  // namespace types
}  // namespace RTT

#endif
