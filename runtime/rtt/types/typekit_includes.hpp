// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Headers that hand-written typekits use without including them: they get all of these from any generator or operator.
#ifndef ORO_TYPEKIT_INCLUDES_HPP
#define ORO_TYPEKIT_INCLUDES_HPP

#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/typekit_basics.hpp>

#endif
