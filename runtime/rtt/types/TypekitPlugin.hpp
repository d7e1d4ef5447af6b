// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPEKIT_PLUGIN_HPP
#define ORO_TYPEKIT_PLUGIN_HPP

#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <string>

namespace RTT {

class TaskContext;

namespace types {

/** A library of types. TypekitRepository::Import() calls the functions in the order given here. */
class RTT_API TypekitPlugin {
public:
    virtual ~TypekitPlugin();

    /** Adds the types; false if that failed. */
    virtual bool loadTypes() = 0;
    virtual bool loadConstructors() = 0;
    virtual bool loadOperators() = 0;
    virtual bool loadGlobals();
    /** Unique name of the typekit. */
    virtual std::string getName() = 0;
};

}  // namespace types
}  // namespace RTT

#include "TypekitRepository.hpp"

// Users rely on it for more than this header needs.
#include <rtt/usual_includes.hpp>

#endif
