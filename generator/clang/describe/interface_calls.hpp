// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What RTT's own classes and functions do to the interface of a component.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_INTERFACE_CALLS_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_INTERFACE_CALLS_HPP

#include "part.hpp"

namespace oroforge::cxx {

/// Constructors: ports, properties, services, activities …
class KnownObjects : Part {
public:
    explicit KnownObjects(const Part& parts) : Part(parts) {}
    /// False if it is another class. Without `constructor` it is not known which one it is.
    bool construct(const Place& at, clang::QualType type, const clang::CXXConstructorDecl* constructor,
                   const Values& arguments, clang::SourceLocation where);
    void constructElement(const Place& at, const std::string& name, clang::QualType type, const Values& arguments,
                          clang::SourceLocation where);
    void constructScope(const Place& at, const std::string& name, const Values& arguments, clang::SourceLocation where);
    /// ConnPolicy::buffer(10) and the like.
    Value policyCall(const clang::CallExpr& expression, const std::string& name);
    void describeFunction(Element& element, const clang::FunctionDecl* function, clang::QualType signature) const;

private:
    void constructActivity(const Place& at, const std::string& name, const clang::CXXConstructorDecl* constructor,
                           const Values& arguments, clang::SourceLocation where);
    model::Policy policyAt(const Value& value, bool& known) const;
};

/// What is asked of a port, a property, an operation … What is no value is another function, here and below.
class ElementCalls : Part {
public:
    explicit ElementCalls(const Part& parts) : Part(parts) {}
    std::optional<Value> call(const clang::CallExpr& expression, const std::string& name, const Place& object);
};

/// What is asked of the component or one of its services, or of what it requires.
class ServiceCalls : Part {
public:
    explicit ServiceCalls(const Part& parts) : Part(parts) {}
    std::optional<Value> call(const clang::CallExpr& expression, const std::string& name, const Place& object);

private:
    Value require(const clang::CallExpr& expression, const Place& object);
    Value provide(const clang::CallExpr& expression, const Place& object, Scope& scope);
    Value findOrRemove(const clang::CallExpr& expression, bool removes, Scope& scope);
    Value addRequester(const clang::CallExpr& expression);
    Value callHook(const std::string& name);
    Place serviceNamed(Scope& scope, const std::string& name, const clang::Expr& at);
    Place requesterNamed(const std::string& name, const clang::Expr& at);
};

/// Which activity the component has.
class ActivityCalls : Part {
public:
    explicit ActivityCalls(const Part& parts) : Part(parts) {}
    std::optional<Value> call(const clang::CallExpr& expression, const std::string& name, const Place& object);

private:
    Value setPeriod(const clang::CallExpr& expression, model::Activity* activity);
    void note(const clang::CallExpr& expression, const model::Activity* activity);
};

/// addPort(…) and the like; all others are left to the classes above.
class InterfaceCalls : Part {
public:
    explicit InterfaceCalls(const Part& parts) : Part(parts), elements_(parts), services_(parts), activities_(parts) {}
    Value call(const clang::CallExpr& expression, const clang::CXXMethodDecl& method, const Place& object);

private:
    std::optional<Value> addCall(const clang::CallExpr& expression, const std::string& name, Scope& scope);
    Value addPort(const clang::CallExpr& expression, bool event, Scope& scope);
    Value addVariable(const clang::CallExpr& expression, ElementKind kind, const std::string& what, Scope& scope);
    Value addOperation(const clang::CallExpr& expression, Scope& scope);
    Value addCaller(const clang::CallExpr& expression, Requester& requester);
    Value addService(const clang::CallExpr& expression, Scope& scope);
    Value createService(const clang::CallExpr& expression);
    /// Of an argument; made of its type if it is an object that is not known. Empty if that tells nothing either.
    Place elementOf(const clang::Expr* expression, ElementKind kind);
    /// Puts it into the scope, with the name that the call gives it, if all that is certain. Gives the place.
    Value add(const clang::CallExpr& expression, const std::string& what, const Place& place, Scope& scope);

    ElementCalls elements_;
    ServiceCalls services_;
    ActivityCalls activities_;
};

model::Number numberOf(double value, const diag::Location& where);

}  // namespace oroforge::cxx

#endif
