// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_CONSTRUCTOR_HPP
#define ORO_TEMPLATE_CONSTRUCTOR_HPP

#include "ErasedFunction.hpp"
#include "TypeConstructor.hpp"
#include "Types.hpp"
#include <rtt/internal/FusedFunctorDataSource.hpp>  // typekits get newFunctorDataSource() from here
#include <boost/function.hpp>

namespace RTT {
namespace types {

namespace detail {
RTT_API TypeConstructor* newErasedConstructor(const ErasedFunction& function, bool automatic);
}

/** A constructor by a function of that signature; newConstructor() makes one from anything that has a signature. */
template <class Signature>
struct TemplateConstructor : public TypeConstructor {
    explicit TemplateConstructor(boost::function<Signature> function, bool automatic = false)
        : erased_(detail::newErasedConstructor(detail::eraseAs(std::move(function), detail::Signature<Signature>()),
                                               automatic)) {}

    base::DataSourceBase::shared_ptr build(
        const std::vector<base::DataSourceBase::shared_ptr>& arguments) const override {
        return erased_->build(arguments);
    }
    base::DataSourceBase::shared_ptr convert(base::DataSourceBase::shared_ptr argument) const override {
        return erased_->convert(argument);
    }

private:
    boost::shared_ptr<TypeConstructor> erased_;
};

/**
 * A constructor from a function or function object of values, for TypeInfo::addConstructor().
 * With one argument it is also a conversion, which logs a warning unless it is `automatic`.
 */
template <class F>
TypeConstructor* newConstructor(F function, bool automatic = false) {
    return detail::newErasedConstructor(eraseFunction(std::move(function)), automatic);
}

}  // namespace types
}  // namespace RTT

#include <rtt/types/typekit_basics.hpp>

#endif
