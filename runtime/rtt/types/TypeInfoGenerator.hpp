// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_INFO_GENERATOR_HPP
#define ORO_TYPE_INFO_GENERATOR_HPP

#include <rtt/rtt-config.h>
#include <boost/shared_ptr.hpp>
#include <string>

namespace RTT {
namespace types {

class TypeInfo;

/**
 * Describes one C++ type to the repository: names it and installs factories into its TypeInfo.
 * Generators that are factories themselves install getSharedPtr() and return false from installTypeInfoObject().
 */
class RTT_API TypeInfoGenerator {
public:
    virtual ~TypeInfoGenerator();

    /** The name to register the type under. */
    virtual const std::string& getTypeName() const = 0;
    /** The object known for this C++ type, or a new one. */
    virtual TypeInfo* getTypeInfoObject() const = 0;
    /** Installs factories; true if the generator may be deleted afterwards. */
    virtual bool installTypeInfoObject(TypeInfo* info) = 0;

    /** Shared ownership of this generator; only for generators allocated with new. */
    boost::shared_ptr<TypeInfoGenerator> getSharedPtr();

private:
    friend class TypeInfoRepository;
    boost::shared_ptr<TypeInfoGenerator> self_;
};

}  // namespace types
}  // namespace RTT

#endif
