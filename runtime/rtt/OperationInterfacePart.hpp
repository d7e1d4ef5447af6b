// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_INTERFACE_PART_HPP
#define ORO_OPERATION_INTERFACE_PART_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/OperationCallerInterface.hpp>

#include <string>
#include <vector>

namespace RTT {

class ExecutionEngine;
namespace types {
class TypeInfo;
}
namespace internal {
template <typename T>
class DataSource;
}

/** What users are told of an argument. */
struct ArgumentDescription {
    typedef std::vector<ArgumentDescription> Descriptions;
    ArgumentDescription(const std::string& n, const std::string& d, const std::string& t)
        : name(n), description(d), type(t) {}
    std::string name, description, type;
};

/**
 * One operation of a service, for users that learn its signature at run time: scripts, consoles, transports. Nothing
 * here is real-time safe, but evaluating what produce() returns is, if the operation is.
 */
class RTT_API OperationInterfacePart {
public:
    typedef std::vector<base::DataSourceBase::shared_ptr> Args;

    virtual ~OperationInterfacePart();
    virtual std::string getName() const = 0;
    virtual std::string description() const = 0;
    virtual std::vector<ArgumentDescription> getArgumentList() const = 0;
    virtual std::string resultType() const = 0;
    virtual unsigned arity() const = 0;
    /** Type of argument `index`; 0 is the result, arguments count from 1. */
    virtual const types::TypeInfo* getArgumentType(unsigned index) const = 0;
    /** Number of values collected from a sent call: the result and arguments by reference. */
    virtual unsigned collectArity() const = 0;
    /** Type of the value `index`, counted from 1, that is collected. */
    virtual const types::TypeInfo* getCollectType(unsigned index) const = 0;

    /** A source whose evaluation calls the operation. Throws wrong_number_of_args_exception and its siblings. */
    virtual base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const = 0;
    /** A source whose evaluation sends the operation; its value is the handle. */
    virtual base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const = 0;
    /** A variable that can hold a handle. */
    virtual base::DataSourceBase::shared_ptr produceHandle() const = 0;
    /** A source whose evaluation collects. The first argument is the handle, then the values to fill; `blocking` decides
        whether it waits. Its value is the SendStatus. */
    virtual base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const = 0;
    /** The operation itself, to be narrowed to OperationCallerBase<Signature>; null if it is remote. */
    virtual base::OperationCallerInterface::shared_ptr getLocalOperation() const { return nullptr; }
    /** False for operations that can only be called. */
    virtual bool isSynchronous() const { return false; }
};

}  // namespace RTT

#endif
