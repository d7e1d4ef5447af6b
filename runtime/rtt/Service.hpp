// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SERVICE_HPP
#define ORO_SERVICE_HPP

#include <rtt/ConfigurationInterface.hpp>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/Operation.hpp>
#include <rtt/OperationInterface.hpp>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>

#include <map>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

namespace RTT {

class ServiceRequester;
class TaskContext;

namespace internal {
class PortOperation;

[[noreturn]] RTT_API void throwNoObject();

/** A member function of an object that each call looks up and holds. Throws std::runtime_error if there is none. */
template <class Member, class Object, class Signature = typename SignatureOf<Member>::type>
struct LateMember;
template <class Member, class Object, class R, class... A>
struct LateMember<Member, Object, R(A...)> {
    Member member;
    boost::intrusive_ptr<DataSource<boost::shared_ptr<Object>>> source;
    R operator()(A... args) const {
        const boost::shared_ptr<Object> object = source->get();
        if (!object) throwNoObject();
        return ((*object).*member)(static_cast<A>(args)...);
    }
};

/** A function whose first argument is an object that is looked up in the same way. */
template <class Object, class Signature>
struct LateFirst;
template <class Object, class R, class First, class... A>
struct LateFirst<Object, R(First, A...)> {
    boost::intrusive_ptr<Callee<R(First, A...)>> function;
    boost::intrusive_ptr<DataSource<boost::shared_ptr<Object>>> source;
    R operator()(A... args) const {
        const boost::shared_ptr<Object> object = source->get();
        if (!object) throwNoObject();
        if constexpr (std::is_pointer_v<First>)
            return (*function)(object.get(), static_cast<A>(args)...);
        else
            return (*function)(object, static_cast<A>(args)...);
    }
};

/** A member function of the object that is its first argument. Throws std::runtime_error if that is null. */
template <class Object, class Member, class Signature>
struct MemberOf;
template <class Object, class Member, class R, class... A>
struct MemberOf<Object, Member, R(A...)> {
    typedef R ByPointer(Object*, A...);
    typedef R BySharedPointer(boost::shared_ptr<Object>, A...);
    Member member;
    template <class Pointer>
    R operator()(const Pointer& object, A... args) const {
        if (!object) throwNoObject();
        return ((*object).*member)(static_cast<A>(args)...);
    }
};
}  // namespace internal

/**
 * A named group of operations, ports, attributes, properties and further services, in a component or process-wide.
 * Not thread safe, except calling operations; not real-time safe.
 */
class RTT_API Service : public OperationInterface,
                        public ConfigurationInterface,
                        public DataFlowInterface,
                        public boost::enable_shared_from_this<Service> {
public:
    typedef boost::shared_ptr<Service> shared_ptr;
    typedef boost::shared_ptr<const Service> shared_constptr;
    typedef std::vector<std::string> ProviderNames;

    /** Makes a service and adds it to `owner`, if given. */
    static shared_ptr Create(const std::string& name, TaskContext* owner = nullptr);
    explicit Service(const std::string& name, TaskContext* owner = nullptr);
    ~Service() override;

    const std::string& getName() const { return name_; }
    void setName(const std::string& name) { name_ = name; }
    const std::string& doc() const { return doc_; }
    void doc(const std::string& text) { doc_ = text; }

    /** Null if there is none or it was destroyed. */
    TaskContext* getOwner() const { return owner_gate_ && owner_gate_->closed() ? nullptr : owner_; }
    /** For the component, which releases its services before it is destroyed. */
    void setOwner(TaskContext* owner);
    /** For the component: adds the operations that every component has when operations are first looked up. */
    void addStandardLater() { addCommonLater(); }
    ExecutionEngine* getOwnerExecutionEngine() const;
    /** Null for the root. */
    shared_ptr getParent() const;
    void setParent(shared_ptr parent);

    shared_ptr provides();
    /** The service of that name, made if there is none; "this" is this one. */
    shared_ptr provides(const std::string& name);
    /** The same, but null if there is none. */
    shared_ptr getService(const std::string& name);
    bool hasService(const std::string& name) const;
    ProviderNames getProviderNames() const;
    /** False if the name is taken. */
    virtual bool addService(shared_ptr service);
    virtual void removeService(const std::string& name);
    /** Removes everything. */
    void clear() override;

    /** Null, with a warning logged, if there is none. */
    OperationInterfacePart* getOperation(const std::string& name);
    /** The implementation for an OperationCaller, also of a local operation; null if there is none, or it is remote. */
    base::DisposableInterface::shared_ptr getLocalOperation(const std::string& name);
    /** Like getOperation(), but includes local operations and gives no warning. */
    OperationInterfacePart* findOperation(const std::string& name) const;
    /** Includes local operations. */
    bool hasOperation(const std::string& name) const;
    std::vector<std::string> getOperationNames() const;
    /** Registers an operation for getLocalOperation() only: scripts, tools and other processes do not see it. False,
        with an error logged, if it has no name or no function. */
    bool addLocalOperation(base::OperationBase& operation);
    void removeOperation(const std::string& name);
    /** For local operations; callers made before are not affected. */
    bool setOperationThread(const std::string& name, ExecutionThread et);
    /** Gives the operation `name` the function and the thread of another one, for callers made from now on. It keeps
        its name, description and subscribers. False, with an error logged, if there is no local operation of that name,
        its signature is another one or the new one has no function. */
    bool resetOperation(const std::string& name, base::OperationBase* operation);
    OperationInterface* operations() { return this; }
    DataFlowInterface* ports() { return this; }

    /** Registers an operation that belongs to the caller. */
    template <class Signature>
    Operation<Signature>& addOperation(Operation<Signature>& operation) {
        registerOperation(operation, false);
        return operation;
    }
    /** Registers a member function of an object, given by pointer or smart pointer. */
    template <class Function, class Object, std::enable_if_t<std::is_member_function_pointer_v<Function>, int> = 0>
    Operation<typename internal::SignatureOf<Function>::type>& addOperation(const std::string& name, Function function,
                                                                            Object object,
                                                                            ExecutionThread et = ClientThread) {
        return make<typename internal::SignatureOf<Function>::type>(
            name, internal::BoundMember<Function, Object>{function, object}, et, false);
    }
    /** Registers a callable with a single signature: function, lambda, boost::function. */
    template <class Function, std::enable_if_t<!std::is_member_function_pointer_v<Function>, int> = 0>
    Operation<typename internal::SignatureOf<Function>::type>& addOperation(const std::string& name, Function function,
                                                                            ExecutionThread et = ClientThread) {
        return make<typename internal::SignatureOf<Function>::type>(name, std::move(function), et, false);
    }
    /** Registers a member function of the object that the source gives at the time, and in the thread, of the call. C++
        callers may instead pass an object as first argument: a pointer or a boost::shared_ptr. */
    template <class Function, class Object>
    Operation<typename internal::SignatureOf<Function>::type>& addOperationDS(
        const std::string& name, Function function, internal::DataSource<boost::shared_ptr<Object>>* object,
        ExecutionThread et = ClientThread) {
        auto& made = addOperation(name, internal::LateMember<Function, Object>{function, object}, et);
        addMemberOverloads<Object>(name, function);
        return made;
    }
    template <class Function, class Source>
    Operation<typename internal::SignatureOf<Function>::type>& addOperationDS(const std::string& name,
                                                                              Function function,
                                                                              boost::intrusive_ptr<Source> object,
                                                                              ExecutionThread et = ClientThread) {
        return addOperationDS(name, function, object.get(), et);
    }
    /** Registers an operation whose first argument is an object: `Object*` or a boost::shared_ptr. C++ callers pass it.
        For scripts and tools the operation lacks that argument: the source gives the object. */
    template <class Object, class R, class First, class... Args>
    Operation<R(First, Args...)>& addOperationDS(internal::DataSource<boost::shared_ptr<Object>>* object,
                                                 Operation<R(First, Args...)>& operation) {
        typedef R Signature(First, Args...);
        auto* const function = static_cast<internal::Callee<Signature>*>(operation.implementation()->callee());
        auto* const late = new Operation<R(Args...)>(operation.getName());
        registerLate(late, internal::makeCallee<R(Args...)>(internal::LateFirst<Object, Signature>{function, object}),
                     operation, typeid(Signature));
        return operation;
    }
    template <class Source, class Signature>
    Operation<Signature>& addOperationDS(boost::intrusive_ptr<Source> object, Operation<Signature>& operation) {
        return addOperationDS(object.get(), operation);
    }
    /** Registers another function for an operation of this service, in the same thread, for C++ callers with another
        signature. Scripts and tools do not see it. False if there is no such operation in this process. */
    template <class Signature, class Function>
    bool addOverload(const std::string& name, Function function) {
        auto* const made = new internal::LocalOperationCaller<Signature>();
        return overload(name, typeid(Signature), made, internal::makeCallee<Signature>(std::move(function)));
    }
    /** The same for a member function, whose object is the first argument: a pointer or a boost::shared_ptr. */
    template <class Object, class Function>
    void addMemberOverloads(const std::string& name, Function function) {
        typedef typename internal::SignatureOf<Function>::type Signature;
        typedef internal::MemberOf<Object, Function, Signature> Member;
        addOverload<typename Member::ByPointer>(name, Member{function});
        addOverload<typename Member::BySharedPointer>(name, Member{function});
    }

    /** Can be called, in the caller's thread, but not sent. */
    template <class Signature>
    Operation<Signature>& addSynchronousOperation(Operation<Signature>& operation) {
        registerOperation(operation, true);
        return operation;
    }
    template <class Function, class Object, std::enable_if_t<std::is_member_function_pointer_v<Function>, int> = 0>
    Operation<typename internal::SignatureOf<Function>::type>& addSynchronousOperation(
        const std::string& name, Function function, Object object, ExecutionThread et = ClientThread) {
        return make<typename internal::SignatureOf<Function>::type>(
            name, internal::BoundMember<Function, Object>{function, object}, et, true);
    }
    template <class Function, std::enable_if_t<!std::is_member_function_pointer_v<Function>, int> = 0>
    Operation<typename internal::SignatureOf<Function>::type>& addSynchronousOperation(
        const std::string& name, Function function, ExecutionThread et = ClientThread) {
        return make<typename internal::SignatureOf<Function>::type>(name, std::move(function), et, true);
    }
    /** An operation with a signal, to which others can subscribe. */
    template <class Signature>
    Operation<Signature>& addEventOperation(Operation<Signature>& operation) {
        operation.signals();
        return addOperation(operation);
    }
    template <class... Arguments>
    auto& addEventOperation(const std::string& name, Arguments... arguments) {
        return addOperation(name, arguments...).signals();
    }

private:
    template <class Signature, class Function>
    Operation<Signature>& make(const std::string& name, Function function, ExecutionThread et, bool callOnly) {
        internal::CalleeBase* const callee = internal::makeCallee<Signature>(std::move(function));
        auto* const made = new Operation<Signature>(name);
        adopt(made, callee, et, callOnly);
        return *made;
    }
    friend class internal::PortOperation;
    void adopt(base::OperationBase* operation, internal::CalleeBase* function, ExecutionThread et, bool callOnly);
    bool registerOperation(base::OperationBase& operation, bool callOnly);
    void registerLate(base::OperationBase* late, internal::CalleeBase* function, base::OperationBase& operation,
                      const std::type_info& signature);
    bool overload(const std::string& name, const std::type_info& signature, base::OperationCallerInterface* made,
                  internal::CalleeBase* function);
    bool accepts(const base::OperationBase& operation) const;
    void replaceEarlier(const base::OperationBase& operation);
    bool isCommon(const std::string& name) const override;
    void addCommon() override;
    void leaveComponent();
    void knowOwner(TaskContext* owner);

    typedef std::map<std::string, shared_ptr> Services;
    Services services_;
    std::vector<std::unique_ptr<base::OperationBase>> owned_;  // other operations belong to the component
    Parts local_;                                              // operations for callers in this process only
    std::string name_, doc_;
    TaskContext* owner_;
    boost::intrusive_ptr<const internal::EngineGate> owner_gate_;  // of its engine, shows that the owner is gone
    Service* holder_ = nullptr;  // has this in services_; no pointer may own the parent yet, in its constructor
    boost::weak_ptr<Service> parent_;
};

typedef boost::shared_ptr<Service> ServicePtr;

}  // namespace RTT

// Users rely on this include, which the header itself does not need.
#include <rtt/usual_includes.hpp>

#endif
