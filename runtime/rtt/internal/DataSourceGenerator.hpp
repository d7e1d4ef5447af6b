// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DATASOURCE_GENERATOR_HPP
#define ORO_DATASOURCE_GENERATOR_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <vector>

namespace RTT {
namespace internal {

/** Makes an argument list of sources: GenerateDataSource()(a.get(), b.get()). */
struct GenerateDataSource {
    typedef std::vector<base::DataSourceBase::shared_ptr> result_type;
    template <class... Sources>
    result_type operator()(Sources&&... sources) const {
        return result_type{base::DataSourceBase::shared_ptr(sources)...};
    }
};

}  // namespace internal
}  // namespace RTT

#endif
