// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_THUNK_TABLE_HPP
#define ORO_TYPE_THUNK_TABLE_HPP

#include "SequenceOps.hpp"
#include <rtt/rtt-config.h>
#include <boost/intrusive_ptr.hpp>
#include <string>
#include <typeinfo>

namespace RTT {

class ConnPolicy;
namespace base {
class DataSourceBase;
class ActionInterface;
class AttributeBase;
class PropertyBase;
class InputPortInterface;
class OutputPortInterface;
class ChannelElementBase;
}  // namespace base

namespace internal {
class ValuePlace;
}

namespace types {

struct Schema;

/**
 * Makes the typed objects around one C++ type. All return new objects, or null if the type cannot have such an
 * object or a given source is of another type. Sources given may be null where marked.
 */
struct TypeThunks {
    base::DataSourceBase* (*value)();
    base::DataSourceBase* (*reference)(void* at);
    base::DataSourceBase* (*part)(void* at, std::size_t count, base::DataSourceBase* parent);
    base::DataSourceBase* (*element)(base::DataSourceBase* parent, base::DataSourceBase* index, const SequenceOps* ops);
    base::DataSourceBase* (*placed)(internal::ValuePlace* place);  ///< takes ownership; null for views on arrays
    base::DataSourceBase* (*actionAlias)(base::ActionInterface* action, base::DataSourceBase* source);
    base::AttributeBase* (*constant)(const std::string& name, base::DataSourceBase* source);
    base::AttributeBase* (*variable)(const std::string& name, int sizehint);
    base::AttributeBase* (*attribute)(const std::string& name, base::DataSourceBase* sourceOrNull);
    base::PropertyBase* (*property)(const std::string& name, const std::string& description,
                                    base::DataSourceBase* sourceOrNull);
    base::InputPortInterface* (*inputPort)(const std::string& name);
    base::OutputPortInterface* (*outputPort)(const std::string& name);
    boost::intrusive_ptr<base::ChannelElementBase> (*dataStorage)(const ConnPolicy& policy);
    const Schema& (*schema)();  ///< the type as the typekit knows it
};

namespace detail {
/** The evaluated value of `source`; null if there is no source, it has another type, or it cannot be evaluated. */
RTT_API const void* valueOfType(base::DataSourceBase* source, const std::type_info& id);
}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
