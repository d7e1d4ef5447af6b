// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Headers that hand-written typekits use without including them: they get all of these from any generator, constructor
// or operator.
#ifndef ORO_TYPEKIT_BASICS_HPP
#define ORO_TYPEKIT_BASICS_HPP

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/mystd.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/PropertyComposition.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/carray.hpp>

#include <boost/lexical_cast.hpp>

#endif
