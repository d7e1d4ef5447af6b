// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_BASE_HPP
#define ORO_OPERATION_BASE_HPP

#include <rtt/base/OperationCallerInterface.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class OperationInterfacePart;
class Service;
namespace internal {
struct OperationTable;
}
namespace base {

/** The texts of an operation. Shared by the operation object and its registration, which may outlive each other. */
struct OperationDescription {
    std::string name;
    /** The documentation, then name and documentation of each argument in turn. */
    std::vector<std::string> texts;
};

/** An operation object without its signature: name, documentation, thread. Not thread safe. */
class RTT_API OperationBase {
public:
    virtual ~OperationBase();
    /** Both objects share the function and its subscribers, also later ones. Name, documentation, thread and a function
        that is set later belong to one of them. A service continues to offer the operation that was added to it. */
    OperationBase(const OperationBase& other);
    OperationBase& operator=(const OperationBase& other);

    const std::string& getName() const { return description_->name; }
    /** The documentation, then name and documentation of each argument in turn. */
    const std::vector<std::string>& getDescriptions() const { return description_->texts; }
    /** True if there is a function to call and a component that provides it. */
    bool ready() const { return hasFunction() && implementation_->getOwner(); }
    /** True if there is a function to call. */
    bool hasFunction() const { return implementation_->ready(); }

    /** The engine of the component that provides this. */
    void setOwner(ExecutionEngine* owner);
    void setThread(ExecutionThread et);

    const OperationCallerInterface::shared_ptr& implementation() const { return implementation_; }
    DisposableInterface::shared_ptr getImplementation() const { return implementation_; }
    const internal::OperationTable& table() const { return *table_; }
    /** A new description of this for generic callers. With `callOnly` it cannot be sent. The caller owns it. */
    OperationInterfacePart* makePart(bool callOnly) const;

protected:
    /** Takes ownership of `implementation`. */
    OperationBase(const std::string& name, OperationCallerInterface* implementation,
                  const internal::OperationTable& table);

    /** Subscribers of the previous function stay subscribed. A null function or owner keeps the current one. */
    void setFunction(internal::CalleeBase* function, ExecutionThread et, ExecutionEngine* owner);
    void setDoc(const std::string& text) { description_->texts[0] = text; }
    void addArgument(const std::string& name, const std::string& text);
    /** From now on both have the name and documentation of `other`. */
    void shareDescription(const OperationBase& other) { description_ = other.description_; }

private:
    friend class RTT::Service;

    std::shared_ptr<OperationDescription> description_;
    OperationCallerInterface::shared_ptr implementation_;
    const internal::OperationTable* table_;
};

}  // namespace base
}  // namespace RTT

#endif
