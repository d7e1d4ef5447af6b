// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STREAM_FACTORY_HPP
#define ORO_STREAM_FACTORY_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace types {

/** Writes values of one type as text and reads them. */
class RTT_API StreamFactory {
public:
    virtual ~StreamFactory();

    virtual std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const = 0;
    virtual std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const = 0;
    /** True if read() understands what write() writes. */
    virtual bool isStreamable() const = 0;
    virtual std::string toString(base::DataSourceBase::shared_ptr source) const;
    virtual bool fromString(const std::string& text, base::DataSourceBase::shared_ptr target) const;
};

namespace detail {
/** The evaluated value of `source` if it has that C++ type; otherwise null. */
RTT_API const void* valueOfType(const base::DataSourceBase::shared_ptr& source, const std::type_info& id);
/** The storage of such a value if it can be changed; otherwise null. */
RTT_API void* storageOfType(const base::DataSourceBase::shared_ptr& source, const std::type_info& id);
}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
