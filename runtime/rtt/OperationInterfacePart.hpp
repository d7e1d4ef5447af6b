// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_INTERFACE_PART_HPP
#define ORO_OPERATION_INTERFACE_PART_HPP

#include <rtt/FactoryExceptions.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/OperationCallerInterface.hpp>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>

#include <string>
#include <vector>

namespace RTT {

class ExecutionEngine;
class Handle;
namespace base {
class ActionInterface;
}
namespace types {
class TypeInfo;
}
namespace internal {
template <typename T>
class DataSource;
struct OperationSignature;
}  // namespace internal

/** The description of an argument for users. */
struct ArgumentDescription {
    typedef std::vector<ArgumentDescription> Descriptions;
    ArgumentDescription(const std::string& n, const std::string& d, const std::string& t)
        : name(n), description(d), type(t) {}
    std::string name, description, type;
};

/**
 * One operation of a service, for users that learn its signature at run time: scripts, consoles, transports. Nothing
 * here is real-time safe, but evaluating the result of produce() is if the operation is. Belongs to its service; users
 * that may outlive the registration hold() it.
 */
class RTT_API OperationInterfacePart : public boost::enable_shared_from_this<OperationInterfacePart> {
public:
    typedef boost::shared_ptr<const OperationInterfacePart> shared_constptr;
    typedef std::vector<base::DataSourceBase::shared_ptr> Args;

    virtual ~OperationInterfacePart();
    virtual std::string getName() const = 0;
    virtual std::string description() const = 0;
    virtual std::vector<ArgumentDescription> getArgumentList() const = 0;
    virtual std::string resultType() const = 0;
    virtual unsigned arity() const = 0;
    /** The type of argument `index`; 0 is the result, arguments count from 1. */
    virtual const types::TypeInfo* getArgumentType(unsigned index) const = 0;
    /** The number of values collected from a sent call: the result and arguments by reference. */
    virtual unsigned collectArity() const = 0;
    /** The type of the collected value `index`, counted from 1. */
    virtual const types::TypeInfo* getCollectType(unsigned index) const = 0;

    /** All of the above, also what is no text: which arguments are assigned. */
    virtual internal::OperationSignature signature() const;

    /** A source whose evaluation calls the operation. Throws wrong_number_of_args_exception and its siblings. */
    virtual base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const = 0;
    /** A source whose evaluation sends the operation; its value is the handle. */
    virtual base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const = 0;
    /** A variable that can hold a handle. */
    virtual base::DataSourceBase::shared_ptr produceHandle() const = 0;
    /** A source whose evaluation collects. The first argument is the handle, then the values to fill; `blocking`
        decides whether it waits. Its value is the SendStatus. */
    virtual base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const = 0;
    /**
     * Has `action` executed with each call of the operation, before the operation itself, after assigning the arguments
     * of the call to the variables `args`. The thread of `subscriber` executes it, by a message if another thread
     * calls; with a null subscriber, the calling thread does. The subscription owns `action`, which may be null. Calls
     * by other threads than the subscriber's allocate memory. Throws no_asynchronous_operation_exception if the
     * operation is no signal (see Service::addEventOperation()), and wrong_number_of_args_exception and its siblings.
     */
    virtual Handle produceSignal(base::ActionInterface* action, const Args& args, ExecutionEngine* subscriber) const;
    /** The operation itself, for narrowing to OperationCallerBase<Signature>; null if it is remote. */
    virtual base::DisposableInterface::shared_ptr getLocalOperation() const;
    /** False for operations that can only be called. */
    virtual bool isSynchronous() const { return false; }

    /** Shares ownership of `part`. If that belongs to no service, it has to outlive its users. */
    static shared_constptr hold(const OperationInterfacePart* part);
};

}  // namespace RTT

#endif
