// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Executes C++ as far as the source reveals the values.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_EVALUATOR_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_EVALUATOR_HPP

#include <set>

#include "part.hpp"

namespace oroforge::cxx {

/// Follows statements: branches and loops whose conditions are constant.
class Statements : Part {
public:
    explicit Statements(const Part& parts) : Part(parts) {}
    enum class Flow { Next, Break, Continue, Return };
    Flow run(const clang::Stmt* statement);

private:
    Flow runIf(const clang::IfStmt& statement);
    /// `next` and the condition may be null.
    Flow runRounds(const clang::Expr* condition, const clang::Expr* next, const clang::Stmt* body);
    Flow runEach(const clang::CXXForRangeStmt& statement);
    Flow runSwitch(const clang::SwitchStmt& statement);
    void declare(const clang::VarDecl& variable);
    /// Follows a statement that may not happen. `ownsBreaks`: it is the body of a loop or a switch.
    void runUndecided(const clang::Stmt* statement, const std::string& why, bool ownsBreaks = false);
};

/// Follows expressions.
class Expressions : Part {
public:
    explicit Expressions(const Part& parts) : Part(parts) {}
    Value eval(const clang::Expr* expression);
    /// Like eval(), but returns the contents of an object.
    Value content(const clang::Expr* expression);
    /// Like eval(), but returns the target of a pointer or iterator.
    Value pointed(const clang::Expr* expression);
    std::optional<std::string> textOf(const clang::Expr* expression);
    std::optional<bool> truth(const clang::Expr* condition);
    Value converted(Value value, clang::QualType type) const;
    /// The lambdas so far, with the objects in which they were made.
    const std::vector<std::pair<const clang::FunctionDecl*, Place>>& lambdas() const { return lambdas_; }

private:
    Value evalPlain(const clang::Expr* expression);
    Value cast(const clang::CastExpr& expression);
    Value declared(const clang::DeclRefExpr& expression);
    Value member(const clang::MemberExpr& expression);
    Value unary(const clang::UnaryOperator& expression);
    Value binary(const clang::BinaryOperator& expression);
    Value conditional(const clang::ConditionalOperator& expression);
    Value folded(const clang::Expr* expression);

    std::vector<std::pair<const clang::FunctionDecl*, Place>> lambdas_;
};

/// Follows the user's functions, and the few of the standard library that names are made with.
class Calls : Part {
public:
    explicit Calls(const Part& parts) : Part(parts) {}
    Value call(const clang::CallExpr& expression);
    Value invoke(const clang::FunctionDecl& function, const Values& arguments, const Place& self, bool lambda = false);
    Values argumentsOf(const clang::CallExpr& expression, unsigned first = 0);
    CallStack::Frame frameOf(const clang::FunctionDecl& function, const Values& arguments, const Place& self);
    /// True also for a generic function if one of its instances was invoked.
    bool isInvoked(const clang::FunctionDecl& function) const;

private:
    Value operatorCall(const clang::CXXOperatorCallExpr& expression);
    Value memberCall(const clang::CXXMemberCallExpr& expression);
    std::optional<Value> standardCall(const clang::CallExpr& expression, const clang::FunctionDecl& function);
    Value callUser(const clang::CallExpr& expression, const clang::FunctionDecl& function, const Place& self,
                   unsigned firstArgument = 0);
    Value unknownCall(const clang::CallExpr& expression, const clang::FunctionDecl* function, unsigned firstArgument);

    std::set<const clang::FunctionDecl*> invoked_;
};

/// Follows constructors: of the component, of helpers, of base classes.
class Objects : Part {
public:
    explicit Objects(const Part& parts) : Part(parts) {}
    void initialise(const Place& at, clang::QualType type, const clang::Expr* init);
    void construct(const Place& at, clang::QualType type, const clang::CXXConstructExpr& expression);
    void construct(const Place& at, const clang::CXXConstructorDecl& declared, const Values& arguments);
    Value make(clang::QualType type, const Values& arguments, clang::SourceLocation where);
    void makeAt(const Place& at, clang::QualType type, const Values& arguments, clang::SourceLocation where);
    /// Returns the unknown constructor, if any, of the object around the place.
    const clang::FunctionDecl* unseenMaker(const Place& place) const;

private:
    void initialiseList(const Place& at, clang::QualType type, const clang::InitListExpr& list);
    void constructBase(const Place& at, const clang::CXXCtorInitializer& init, const Values& inherited);
    /// Returns the C++ of a value made only of constants; otherwise unknown.
    Value constantObject(clang::QualType type, const clang::Expr& init) const;

    std::map<Place, const clang::FunctionDecl*> unseen_;  ///< objects made by constructors without definition
};

/// Follows strings and streams. Returns no value for other functions.
class Texts : Part {
public:
    explicit Texts(const Part& parts) : Part(parts) {}
    std::optional<Value> operate(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> call(const clang::CXXMemberCallExpr& expression, const std::string& name, const Value& object);
    /// Returns the text that a stream prints.
    Value printed(const clang::Expr& expression);
    /// Adds to the text of a stream, if that is known.
    void stream(const Place& into, const clang::Expr& what);
};

/// Follows vectors and the like, and iterators. Returns no value for other functions.
class Containers : Part {
public:
    explicit Containers(const Part& parts) : Part(parts) {}
    void construct(const Place& at, const Values& arguments);
    std::optional<Value> operate(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> call(const clang::CXXMemberCallExpr& expression, const std::string& name, const Value& object);
    /// Follows std::begin() and std::end().
    Value endOf(const clang::CallExpr& expression, const std::string& name);
    /// Follows std::for_each().
    Value eachOf(const clang::CallExpr& expression);

private:
    void append(const clang::CXXMemberCallExpr& expression, const Place& to, bool constructs);
};

}  // namespace oroforge::cxx

#endif
