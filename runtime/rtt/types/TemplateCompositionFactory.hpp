// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_COMPOSITION_FACTORY_HPP
#define ORO_TEMPLATE_COMPOSITION_FACTORY_HPP

#include "CompositionFactory.hpp"
#include "CompositionHooks.hpp"

namespace RTT {
namespace types {

/** Base of factories that turn a T into a property bag and back: override composeTypeImpl() and decomposeTypeImpl(). */
template <class T>
class TemplateCompositionFactory : public CompositionByBag<T, CompositionFactory> {};

}  // namespace types
}  // namespace RTT

#endif
