// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_COMPOSITION_FACTORY_HPP
#define ORO_COMPOSITION_FACTORY_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <string>
#include <vector>

namespace RTT {
namespace types {

/** Takes values of a type apart for files and displays, and composes them again. */
class RTT_API CompositionFactory {
public:
    virtual ~CompositionFactory();

    /** A simpler form of `source`, mostly a source of PropertyBag; null if there is none. */
    virtual base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const = 0;
    /** Sets `target` from such a form. If it does not fit, returns false and, if possible, leaves `target`
        unchanged. */
    virtual bool composeType(base::DataSourceBase::shared_ptr source,
                             base::DataSourceBase::shared_ptr target) const = 0;
};

/** An additional interface of the composition factory of an enum, so that messages can name its values. */
class RTT_API Enumeration {
public:
    virtual ~Enumeration();

    /** The names of its values. */
    virtual std::vector<std::string> enumerators() const = 0;
    /** False if property files may not give that number, because it is not a value of the enum. */
    virtual bool takesNumber(long long number) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
