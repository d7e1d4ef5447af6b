// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_COMPOSITION_FACTORY_HPP
#define ORO_COMPOSITION_FACTORY_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace types {

/** Takes values of one type apart for files and displays, and puts them together again. */
class RTT_API CompositionFactory {
public:
    virtual ~CompositionFactory();

    /** A simpler form of `source`, mostly a source of PropertyBag; null if there is none. */
    virtual base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const = 0;
    /** Sets `target` from such a form; false, and `target` unchanged where possible, if it does not fit. */
    virtual bool composeType(base::DataSourceBase::shared_ptr source,
                             base::DataSourceBase::shared_ptr target) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
