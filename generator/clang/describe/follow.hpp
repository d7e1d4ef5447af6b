// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Follows the constructor of a component as a processor would, as far as its source tells what happens:
///
///     follow_statements.cpp   statements, branches and loops whose conditions are constant
///     follow_values.cpp       expressions and constants
///     follow_memory.cpp       what variables hold
///     follow_calls.cpp        the user's functions, and the few of the standard library that names are made with
///     follow_texts.cpp        strings and streams
///     follow_containers.cpp   vectors and the like, and iterators
///     follow_late.cpp         functions that the constructor does not call
///     follow_objects.cpp      constructors: of the component, of helpers, of base classes
///     follow_library.cpp      constructors of RTT's classes: ports, properties, activities …
///     follow_interface.cpp    what the functions of RTT add to the interface
///     follow_services.cpp     services, documentation, activities
///     follow_result.cpp       the interface that came out of it
///
/// What cannot be told is a remark (a warning with a place); what is done there is left out.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <clang/base/parse_files.hpp>
#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

#include "component_state.hpp"

namespace oroforge::cxx {

/// The object whose constructor is followed.
inline constexpr const char* kRoot = "this";

class Follower {
public:
    Follower(clang::ASTContext& context, const SourcePlaces& places, diag::Sink& remarks);

    /// Makes an object of the class with this constructor, whose parameters are not known.
    Followed follow(const clang::CXXConstructorDecl& constructor);

    /// Constructors that would have to be known, but only their declarations are.
    const std::set<const clang::FunctionDecl*>& unseen() const { return unseen_; }

private:
    enum class Flow { Next, Break, Continue, Return };
    using Values = std::vector<Value>;

    struct Frame {
        Place self;
        std::map<const clang::ValueDecl*, Place> locals;
        Value result;
        bool lambda = false;  ///< sees the locals of the frames below
    };

    // --- statements
    Flow run(const clang::Stmt* statement);
    Flow runIf(const clang::IfStmt& statement);
    Flow runFor(const clang::ForStmt& statement);
    Flow runRounds(const clang::Expr* condition, const clang::Stmt* body);
    Flow runEach(const clang::CXXForRangeStmt& statement);
    Flow runSwitch(const clang::SwitchStmt& statement);
    void declare(const clang::VarDecl& variable);
    /// What is done there is not certain to happen: nothing is added, and variables that change are not known any more.
    void runUndecided(const clang::Stmt* statement, const std::string& why, bool ownsBreaks = false);

    // --- expressions
    Value eval(const clang::Expr* expression);
    Value evalPlain(const clang::Expr* expression);
    Value cast(const clang::CastExpr& expression);
    Value declared(const clang::DeclRefExpr& expression);
    Value member(const clang::MemberExpr& expression);
    Value unary(const clang::UnaryOperator& expression);
    Value binary(const clang::BinaryOperator& expression);
    Value conditional(const clang::ConditionalOperator& expression);
    Value folded(const clang::Expr* expression);
    Value converted(Value value, clang::QualType type) const;
    Value load(const Value& value) const;
    /// Of an object too: what is stored there.
    Value content(const clang::Expr* expression);
    std::optional<std::string> textOf(const clang::Expr* expression);
    std::optional<bool> truth(const clang::Expr* condition);
    void assign(const Place& place, Value value);
    void noteChange(const Place& place);
    void forget(const Place& place);
    void copyObject(const Place& from, const Place& to);

    // --- calls
    Value call(const clang::CallExpr& expression);
    Value operatorCall(const clang::CXXOperatorCallExpr& expression);
    Value memberCall(const clang::CXXMemberCallExpr& expression);
    // --- texts, containers and iterators
    std::optional<Value> textOperator(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> textCall(const clang::CXXMemberCallExpr& expression, const std::string& name,
                                  const Value& object);
    /// Into a stream; false if it is none whose text is known.
    bool stream(const Place& into, const clang::Expr& what);
    bool isStream(const Place& place) const { return memory_.count(place + "#text") != 0; }
    std::optional<Value> iteratorOperator(const clang::CXXOperatorCallExpr& expression);
    std::optional<Value> containerCall(const clang::CXXMemberCallExpr& expression, const std::string& name,
                                       const Value& object);
    void constructContainer(const Place& at, const Values& arguments);
    void append(const clang::CXXMemberCallExpr& expression, const Place& to, bool constructs);
    Value eachOf(const clang::CallExpr& expression);
    /// std::begin(), std::end()
    Value endOf(const clang::CallExpr& expression, const std::string& name);
    Value asText(const clang::Expr& expression);
    std::optional<long long> sizeOf(const Place& container) const;
    /// Of pointers and iterators: what they point to.
    Value pointed(const clang::Expr* expression);
    std::optional<Value> standardCall(const clang::CallExpr& expression, const clang::FunctionDecl& function);
    Value callUser(const clang::CallExpr& expression, const clang::FunctionDecl& function, const Place& self,
                   unsigned firstArgument = 0);
    Value invoke(const clang::FunctionDecl& function, const Values& arguments, const Place& self, bool lambda);
    Value unknownCall(const clang::CallExpr& expression, const clang::FunctionDecl* function, unsigned firstArgument);
    Values argumentsOf(const clang::CallExpr& expression, unsigned first);
    void bind(const clang::FunctionDecl& function, const Values& arguments, Frame& frame);
    const clang::FunctionDecl* definitionOf(const clang::FunctionDecl& function) const;
    const clang::CXXMethodDecl& overriderOf(const clang::CXXMethodDecl& method, const Place& self) const;

    // --- objects
    void initialise(const Place& at, clang::QualType type, const clang::Expr* init);
    void initialiseList(const Place& at, clang::QualType type, const clang::InitListExpr& list);
    void construct(const Place& at, clang::QualType type, const clang::CXXConstructExpr& expression);
    void construct(const Place& at, const clang::CXXConstructorDecl& constructor, const Values& arguments);
    /// Of a class of RTT's, or one that is not looked into. Without `constructor` it is not known which one it is.
    bool constructKnown(const Place& at, clang::QualType type, const clang::CXXConstructorDecl* constructor,
                        const Values& arguments, clang::SourceLocation where);
    void constructElement(const Place& at, const std::string& name, clang::QualType type, const Values& arguments,
                          clang::SourceLocation where);
    void constructScope(const Place& at, const std::string& name, const Values& arguments, clang::SourceLocation where);
    Value policyCall(const clang::CallExpr& expression, const std::string& name);
    void store(const Place& at, const Value& value);
    void constructBase(const Place& at, const clang::CXXCtorInitializer& init, const Values& inherited);
    void constructActivity(const Place& at, const std::string& name, const clang::CXXConstructorDecl* constructor,
                           const Values& arguments, clang::SourceLocation where);
    Value make(clang::QualType type, const Values& arguments, clang::SourceLocation where);
    void makeAt(const Place& at, clang::QualType type, const Values& arguments, clang::SourceLocation where);
    /// The C++ of a value that is made of constants alone; unknown if it is not.
    Value constantObject(clang::QualType type, const clang::Expr& init) const;
    Place fresh(const char* what) { return std::string(what) + " " + std::to_string(++made_); }

    // --- the interface
    bool isInterface(const clang::CXXMethodDecl& method) const;
    Value interfaceCall(const clang::CallExpr& expression, const clang::CXXMethodDecl& method, const Place& object);
    std::optional<Value> addCall(const clang::CallExpr& expression, const std::string& name, Scope& scope);
    Value addPort(const clang::CallExpr& expression, bool event, Scope& scope);
    Value addProperty(const clang::CallExpr& expression, Scope& scope);
    Value addAttribute(const clang::CallExpr& expression, bool constant, Scope& scope);
    Value addOperation(const clang::CallExpr& expression, Scope& scope);
    Value addCaller(const clang::CallExpr& expression, Requester& requester);
    Value addService(const clang::CallExpr& expression, Scope& scope);
    std::optional<Value> elementCall(const clang::CallExpr& expression, const std::string& name, const Place& object);
    std::optional<Value> serviceCall(const clang::CallExpr& expression, const std::string& name, const Place& object);
    Value callHook(const std::string& name);
    Value addRequester(const clang::CallExpr& expression);
    std::optional<Value> activityCall(const clang::CallExpr& expression, const std::string& name, const Place& object);
    bool named(const clang::CallExpr& expression) const;
    void describeFunction(Element& element, const clang::FunctionDecl* function, clang::QualType signature) const;
    Element* elementAt(const Place& place);
    /// Of an argument; made of its type if it is an object that is not known. Empty if that tells nothing either.
    Place elementOf(const clang::Expr* expression, ElementKind kind);
    Scope* scopeAt(const Place& place);
    Place serviceNamed(Scope& scope, const std::string& name, const clang::Expr& at);
    Place requesterNamed(const std::string& name, const clang::Expr& at);
    /// False, and a remark, if it is not certain that it happens.
    bool certain(const clang::CallExpr& expression, const std::string& what);
    /// Puts it into the scope, with the name that the call gives it, if all that is certain.
    void add(const clang::CallExpr& expression, const std::string& what, const Place& place, Scope& scope);
    void noteActivity(const clang::CallExpr& expression, std::optional<model::Activity> activity);
    model::Policy policyAt(const Value& value, bool& known) const;

    // --- what is not called
    /// Tells what it would add.
    void followLate(const clang::CXXRecordDecl& made);
    bool isInvoked(const clang::FunctionDecl& lambda) const;
    void invokeLate(const clang::FunctionDecl& function, const Place& self, const std::string& why);

    // --- what came out
    void result(const Scope& scope, model::Interface& into);
    void resultOf(Element& element, model::Interface& into);
    model::Operation operationOf(const Element& element) const;
    /// The constructor of the object that it is part of, if that is not known.
    const clang::FunctionDecl* unseenMaker(const Place& place) const;
    void giveValue(const Element& element, model::Text& value, const std::string& what);
    std::optional<std::string> literal(const Value& value, clang::QualType type) const;

    /// True, and a remark the first time, if there were too many steps, or too many calls within calls.
    bool isTooMuch(clang::SourceLocation at);
    bool isTooDeep(clang::SourceLocation at);
    diag::Location locate(clang::SourceLocation at) const;
    diag::Diagnostic& remark(clang::SourceLocation at, const char* code, const std::string& message);

    clang::ASTContext& context_;
    const SourcePlaces& places_;
    diag::Sink& remarks_;
    diag::Sink unused_;
    std::map<Place, Value> memory_;
    std::map<Place, Element> elements_;
    std::map<Place, Scope*> scopes_;
    std::map<Place, Requester*> requesters_;
    std::map<Place, model::Activity> activities_;
    std::map<Place, const clang::FunctionDecl*> unseenObjects_;  ///< by constructors without definition
    std::vector<std::unique_ptr<Scope>> allScopes_;
    std::vector<std::unique_ptr<Requester>> allRequesters_;
    std::vector<Frame> frames_;
    std::set<const clang::FunctionDecl*> invoked_;
    std::vector<std::pair<const clang::FunctionDecl*, Place>> lambdas_;  ///< and the objects they were made in
    bool hasMore_ = false;  ///< adds ports or properties, or maybe, that are not in the result
    std::string late_;      ///< why what is followed does not happen while the component is made; empty: it does
    std::set<const clang::FunctionDecl*> unseen_;
    std::vector<std::string> undecided_;  ///< why, the innermost last
    std::optional<model::Activity> activity_;
    model::InitialState initial_ = model::InitialState::Stopped;
    const clang::CXXRecordDecl* dynamic_ = nullptr;  ///< the class whose constructor runs: virtual calls go there
    std::vector<clang::QualType> uses_;
    unsigned made_ = 0;
    unsigned steps_ = 0;
};

/// Name of a class of RTT, or "": TaskContext, InputPort …
std::string toolchainName(const clang::CXXRecordDecl& record);
/// Calls visit(class) for the class and for those of the user's that it is derived from, bases last.
template <class Visit>
void eachOwn(const clang::CXXRecordDecl& type, const Visit& visit) {
    if (isLibrary(type)) return;
    visit(type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) {
        const auto* record = base.getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->hasDefinition()) eachOwn(*record->getDefinition(), visit);
    }
}
/// std::shared_ptr, boost::intrusive_ptr … and iterators: their value is the place that they point to.
bool isPointerLike(clang::QualType type);
bool isStdString(clang::QualType type);
/// std::vector, std::deque, std::list: elements in the order in which they were put there.
bool isSequence(clang::QualType type);
/// std::ostringstream, std::stringstream.
bool isTextStream(clang::QualType type);

}  // namespace oroforge::cxx

#endif
