// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_INTERFACE_HPP
#define ORO_OPERATION_INTERFACE_HPP

#include <rtt/OperationInterfacePart.hpp>

#include <atomic>
#include <map>
#include <string>
#include <vector>

namespace RTT {
namespace internal {
class OperationCallerC;
}

/**
 * The operations of a service by name. Not thread safe, not real-time safe; any number of threads may look operations
 * up while none is added or removed.
 */
class RTT_API OperationInterface {
public:
    typedef OperationInterfacePart Factory;
    typedef OperationInterfacePart::Args Args;
    typedef std::vector<ArgumentDescription> Descriptions;

    OperationInterface();
    virtual ~OperationInterface();
    OperationInterface(const OperationInterface&) = delete;
    OperationInterface& operator=(const OperationInterface&) = delete;

    /** In alphabetical order. */
    std::vector<std::string> getNames() const;
    std::vector<std::string> getOperationNames() const { return getNames(); }
    bool hasMember(const std::string& name) const;
    bool hasOperation(const std::string& name) const { return hasMember(name); }
    /** Null if there is none. */
    OperationInterfacePart* getPart(const std::string& name) const;

    // All of these throw name_not_found_exception; the first five also what OperationInterfacePart throws.
    base::DataSourceBase::shared_ptr produce(const std::string& name, const Args& args, ExecutionEngine* caller) const;
    base::DataSourceBase::shared_ptr produceSend(const std::string& name, const Args& args,
                                                 ExecutionEngine* caller) const;
    base::DataSourceBase::shared_ptr produceHandle(const std::string& name) const;
    base::DataSourceBase::shared_ptr produceCollect(const std::string& name, const Args& args,
                                                    boost::intrusive_ptr<internal::DataSource<bool>> blocking) const;
    /** Owns `action` only if it does not throw. */
    Handle produceSignal(const std::string& name, base::ActionInterface* action, const Args& args,
                         ExecutionEngine* subscriber) const;
    Descriptions getArgumentList(const std::string& name) const;
    std::string getResultType(const std::string& name) const;
    std::string getDescription(const std::string& name) const;
    int getArity(const std::string& name) const;
    int getCollectArity(const std::string& name) const;
    const types::TypeInfo* getCollectType(const std::string& name, int index) const;
    bool isSynchronous(const std::string& name) const;

    /** A generic caller of an operation, for the component of that engine: `create("add", engine()).argC(2).ret(sum)`.
        Not ready, with a warning logged, if there is no such operation. */
    internal::OperationCallerC create(const std::string& name, ExecutionEngine* caller) const;

    /** Takes ownership; replaces an operation of that name. */
    void add(const std::string& name, OperationInterfacePart* part);
    void remove(const std::string& name);
    virtual void clear();

protected:
    typedef std::map<std::string, boost::shared_ptr<OperationInterfacePart>> Parts;

    /** Has addCommon() called once, before operations are looked up, or a common one is added or removed. */
    void addCommonLater() { common_ = Common::Later; }
    /** Calls addCommon() now if that would add an operation of this name. */
    void completeFor(const std::string& added);
    /** The operations added so far. */
    const Parts& partsNow() const { return parts_; }

private:
    /** Operations that many services have in common, and that are rarely looked up. */
    virtual bool isCommon(const std::string& name) const;
    virtual void addCommon();

    const Parts& parts() const;
    OperationInterfacePart& part(const std::string& name) const;
    void complete();

    Parts parts_;
    enum class Common { None, Later, Now };
    std::atomic<Common> common_{Common::None};
};

}  // namespace RTT

#endif
