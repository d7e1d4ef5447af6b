// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The effects of RTT's classes and functions on the interface of a component.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_INTERFACE_CALLS_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_INTERFACE_CALLS_HPP

#include "part.hpp"

namespace oroforge::cxx {

/// Follows constructors: ports, properties, services, activities …
class KnownObjects : Part {
public:
    explicit KnownObjects(const Part& parts) : Part(parts) {}
    /// Returns false for other classes. A null `constructor` is not known.
    bool construct(const Place& at, clang::QualType type, const clang::CXXConstructorDecl* constructor,
                   const Values& arguments, clang::SourceLocation where);
    void constructElement(const Place& at, const std::string& name, clang::QualType type, const Values& arguments,
                          clang::SourceLocation where);
    void constructScope(const Place& at, const std::string& name, const Values& arguments, clang::SourceLocation where);
    /// Follows ConnPolicy::buffer(10) and the like.
    Value policyCall(const clang::CallExpr& expression, const std::string& name);
    void describeFunction(Element& element, const clang::FunctionDecl* function, clang::QualType signature) const;

private:
    void constructActivity(const Place& at, const std::string& name, const clang::CXXConstructorDecl* constructor,
                           const Values& arguments, clang::SourceLocation where);
    model::Policy policyAt(const Value& value, bool& known) const;
};

/// Follows calls of ports, properties, operations … Here and below, no value means another function.
class ElementCalls : Part {
public:
    explicit ElementCalls(const Part& parts) : Part(parts) {}
    std::optional<Value> call(const clang::CallExpr& expression, const std::string& name, const Place& object);
};

/// Follows calls of the component, its services, or services that it requires.
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

/// Finds the component's activity.
class ActivityCalls : Part {
public:
    explicit ActivityCalls(const Part& parts) : Part(parts) {}
    std::optional<Value> call(const clang::CallExpr& expression, const std::string& name, const Place& object);

private:
    Value setPeriod(const clang::CallExpr& expression, model::Activity* activity);
    void note(const clang::CallExpr& expression, const model::Activity* activity);
};

/// Follows addPort(…) and the like, and passes other calls to the classes above.
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
    /// Returns the place of an argument's element; makes one from the type of an unknown object. May be empty.
    Place elementOf(const clang::Expr* expression, ElementKind kind);
    /// Adds the element to the scope, with the name from the call, if all that is certain. Returns its place.
    Value add(const clang::CallExpr& expression, const std::string& what, const Place& place, Scope& scope);

    ElementCalls elements_;
    ServiceCalls services_;
    ActivityCalls activities_;
};

model::Number numberOf(double value, const diag::Location& where);

}  // namespace oroforge::cxx

#endif
