// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Does what C++ says, as far as the source tells the values.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_EVALUATOR_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_EVALUATOR_HPP

#include <set>

#include "part.hpp"

namespace oroforge::cxx {

/// Statements, branches and loops whose conditions are constant.
class Statements : Part {
public:
    explicit Statements(const Part& parts) : Part(parts) {}
    enum class Flow { Next, Break, Continue, Return };
    Flow run(const clang::Stmt* statement);

private:
    Flow runIf(const clang::IfStmt& statement);
    /// `next` may be null, and so may the condition.
    Flow runRounds(const clang::Expr* condition, const clang::Expr* next, const clang::Stmt* body);
    Flow runEach(const clang::CXXForRangeStmt& statement);
    Flow runSwitch(const clang::SwitchStmt& statement);
    void declare(const clang::VarDecl& variable);
    /// What is done there is not certain to happen. `ownsBreaks`: it is the body of a loop or a switch.
    void runUndecided(const clang::Stmt* statement, const std::string& why, bool ownsBreaks = false);
};

/// Expressions and constants.
class Expressions : Part {
public:
    explicit Expressions(const Part& parts) : Part(parts) {}
    Value eval(const clang::Expr* expression);
    /// Of an object too: what is stored there.
    Value content(const clang::Expr* expression);
    /// Of pointers and iterators: what they point to.
    Value pointed(const clang::Expr* expression);
    std::optional<std::string> textOf(const clang::Expr* expression);
    std::optional<bool> truth(const clang::Expr* condition);
    Value converted(Value value, clang::QualType type) const;
    /// And the objects that they were made in.
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

/// The user's functions, and the few of the standard library that names are made with.
class Calls : Part {
public:
    explicit Calls(const Part& parts) : Part(parts) {}
    Value call(const clang::CallExpr& expression);
    Value invoke(const clang::FunctionDecl& function, const Values& arguments, const Place& self, bool lambda = false);
    Values argumentsOf(const clang::CallExpr& expression, unsigned first = 0);
    CallStack::Frame frameOf(const clang::FunctionDecl& function, const Values& arguments, const Place& self);
    /// Also as an instance of what has parameters of 'auto'.
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

/// Constructors: of the component, of helpers, of base classes.
class Objects : Part {
public:
    explicit Objects(const Part& parts) : Part(parts) {}
    void initialise(const Place& at, clang::QualType type, const clang::Expr* init);
    void construct(const Place& at, clang::QualType type, const clang::CXXConstructExpr& expression);
    void construct(const Place& at, const clang::CXXConstructorDecl& declared, const Values& arguments);
    Value make(clang::QualType type, const Values& arguments, clang::SourceLocation where);
    void makeAt(const Place& at, clang::QualType type, const Values& arguments, clang::SourceLocation where);
    /// The constructor of the object that the place is a part of, if that is not known.
    const clang::FunctionDecl* unseenMaker(const Place& place) const;

private:
    void initialiseList(const Place& at, clang::QualType type, const clang::InitListExpr& list);
    void constructBase(const Place& at, const clang::CXXCtorInitializer& init, const Values& inherited);
    /// The C++ of a value that is made of constants alone; unknown if it is not.
    Value constantObject(clang::QualType type, const clang::Expr& init) const;

    std::map<Place, const clang::FunctionDecl*> unseen_;  ///< by constructors without definition
};

/// Strings and streams. What is no value is another function.
class Texts : Part {
public:
    explicit Texts(const Part& parts) : Part(parts) {}
    std::optional<Value> operate(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> call(const clang::CXXMemberCallExpr& expression, const std::string& name, const Value& object);
    /// As a stream prints it.
    Value printed(const clang::Expr& expression);
    /// Into a stream, if its text is known.
    void stream(const Place& into, const clang::Expr& what);
};

/// Vectors and the like, and iterators. What is no value is another function.
class Containers : Part {
public:
    explicit Containers(const Part& parts) : Part(parts) {}
    void construct(const Place& at, const Values& arguments);
    std::optional<Value> operate(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> call(const clang::CXXMemberCallExpr& expression, const std::string& name, const Value& object);
    /// std::begin(), std::end()
    Value endOf(const clang::CallExpr& expression, const std::string& name);
    /// std::for_each()
    Value eachOf(const clang::CallExpr& expression);

private:
    void append(const clang::CXXMemberCallExpr& expression, const Place& to, bool constructs);
};

}  // namespace oroforge::cxx

#endif
