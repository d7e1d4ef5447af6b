// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "evaluator.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;

constexpr unsigned kMostRounds = 1000;  // of a loop

/// Finds statements that may leave the function: then what follows is not certain either.
class LeavesFinder : public clang::RecursiveASTVisitor<LeavesFinder> {
public:
    explicit LeavesFinder(bool ownsBreaks) : loops_(ownsBreaks ? 1 : 0) {}
    bool found = false;
    bool VisitReturnStmt(clang::ReturnStmt*) { return !(found = true); }
    bool VisitBreakStmt(clang::BreakStmt*) { return !(found = found || loops_ == 0); }
    bool VisitContinueStmt(clang::ContinueStmt*) { return !(found = found || loops_ == 0); }
    bool TraverseLambdaExpr(clang::LambdaExpr*) { return true; }
    bool TraverseForStmt(clang::ForStmt* loop) { return within(loop, &RecursiveASTVisitor::TraverseForStmt); }
    bool TraverseWhileStmt(clang::WhileStmt* loop) { return within(loop, &RecursiveASTVisitor::TraverseWhileStmt); }
    bool TraverseDoStmt(clang::DoStmt* loop) { return within(loop, &RecursiveASTVisitor::TraverseDoStmt); }
    bool TraverseSwitchStmt(clang::SwitchStmt* choice) {
        return within(choice, &RecursiveASTVisitor::TraverseSwitchStmt);
    }
    bool TraverseCXXForRangeStmt(clang::CXXForRangeStmt* loop) {
        return within(loop, &RecursiveASTVisitor::TraverseCXXForRangeStmt);
    }

private:
    template <class Statement>
    bool within(Statement* statement, bool (RecursiveASTVisitor::*traverse)(Statement*, DataRecursionQueue*)) {
        ++loops_;
        const bool goesOn = (this->*traverse)(statement, nullptr);
        --loops_;
        return goesOn;
    }

    unsigned loops_;
};

/// `ownsBreaks`: the statement is the body of a loop or a switch.
bool mayLeave(const clang::Stmt* statement, bool ownsBreaks) {
    LeavesFinder finder(ownsBreaks);
    finder.TraverseStmt(const_cast<clang::Stmt*>(statement));
    return finder.found;
}

}  // namespace

void Statements::runUndecided(const clang::Stmt* statement, const std::string& why, bool ownsBreaks) {
    if (statement == nullptr) return;
    findings_.doubt(why);
    run(statement);
    findings_.settle();
    // This doubt remains until the end of the function, which removes all its doubts.
    if (mayLeave(statement, ownsBreaks)) findings_.doubt(why + ", which may leave the function before");
}

Statements::Flow Statements::run(const clang::Stmt* statement) {
    if (statement == nullptr || stack_.isTooMuch(statement->getBeginLoc())) return Flow::Next;
    if (const auto* block = dyn_cast<clang::CompoundStmt>(statement)) {
        for (const clang::Stmt* part : block->body()) {
            const Flow flow = run(part);
            if (flow != Flow::Next) return flow;
        }
        return Flow::Next;
    }
    if (const auto* declaration = dyn_cast<clang::DeclStmt>(statement)) {
        for (const clang::Decl* one : declaration->decls()) {
            if (const auto* variable = dyn_cast<clang::VarDecl>(one)) declare(*variable);
        }
        return Flow::Next;
    }
    if (const auto* choice = dyn_cast<clang::IfStmt>(statement)) return runIf(*choice);
    if (const auto* loop = dyn_cast<clang::ForStmt>(statement)) {
        run(loop->getInit());
        return runRounds(loop->getCond(), loop->getInc(), loop->getBody());
    }
    if (const auto* loop = dyn_cast<clang::CXXForRangeStmt>(statement)) return runEach(*loop);
    if (const auto* loop = dyn_cast<clang::WhileStmt>(statement))
        return runRounds(loop->getCond(), nullptr, loop->getBody());
    if (const auto* choice = dyn_cast<clang::SwitchStmt>(statement)) return runSwitch(*choice);
    if (const auto* loop = dyn_cast<clang::DoStmt>(statement)) {
        const Flow flow = run(loop->getBody());
        return flow == Flow::Next || flow == Flow::Continue ? runRounds(loop->getCond(), nullptr, loop->getBody())
               : flow == Flow::Break                        ? Flow::Next
                                                            : flow;
    }
    if (const auto* attempt = dyn_cast<clang::CXXTryStmt>(statement)) {
        const Flow flow = run(attempt->getTryBlock());
        for (unsigned i = 0; i != attempt->getNumHandlers(); ++i)
            runUndecided(attempt->getHandler(i)->getHandlerBlock(), "in a 'catch'");
        return flow;
    }
    if (const auto* end = dyn_cast<clang::ReturnStmt>(statement)) {
        if (end->getRetValue() != nullptr) stack_.top().result = values_.eval(end->getRetValue());
        // A doubtful return does not end the branch: the rest is followed, too.
        return findings_.isCertain() ? Flow::Return : Flow::Next;
    }
    if (llvm::isa<clang::BreakStmt>(statement)) return Flow::Break;
    if (llvm::isa<clang::ContinueStmt>(statement)) return Flow::Continue;
    if (const auto* label = dyn_cast<clang::SwitchCase>(statement)) return run(label->getSubStmt());
    if (const auto* label = dyn_cast<clang::LabelStmt>(statement)) return run(label->getSubStmt());
    if (const auto* attributed = dyn_cast<clang::AttributedStmt>(statement)) return run(attributed->getSubStmt());
    if (const auto* expression = dyn_cast<clang::Expr>(statement)) values_.eval(expression);
    return Flow::Next;
}

void Statements::declare(const clang::VarDecl& variable) {
    if (variable.isStaticLocal() && !variable.getType().isConstQualified()) return;  // it may have changed since
    if (variable.getType()->isReferenceType()) {
        const Value target = values_.eval(variable.getInit());
        stack_.top().locals[&variable] = target.is(Value::Kind::Place) ? target.place : memory_.fresh();
        return;
    }
    const Place place = memory_.fresh();
    stack_.top().locals[&variable] = place;
    if (variable.getInit() != nullptr) objects_.initialise(place, variable.getType(), variable.getInit());
}

Statements::Flow Statements::runIf(const clang::IfStmt& statement) {
    run(statement.getInit());
    if (const clang::VarDecl* variable = statement.getConditionVariable()) declare(*variable);
    const auto decided = values_.truth(statement.getCond());
    if (decided) return run(*decided ? statement.getThen() : statement.getElse());
    runUndecided(statement.getThen(), "in an 'if' whose condition is not constant");
    runUndecided(statement.getElse(), "in an 'else' whose condition is not constant");
    return Flow::Next;
}

Statements::Flow Statements::runRounds(const clang::Expr* condition, const clang::Expr* next, const clang::Stmt* body) {
    for (unsigned round = 0; round != kMostRounds; ++round) {
        const auto goesOn = condition == nullptr ? std::optional(true) : values_.truth(condition);
        if (goesOn && !*goesOn) return Flow::Next;
        if (!goesOn || !findings_.isCertain()) break;
        const Flow flow = run(body);
        if (flow == Flow::Break) return Flow::Next;
        if (flow == Flow::Return) return flow;
        values_.eval(next);
    }
    // The loop's counter becomes unknown, and so do names made from it.
    findings_.doubt("");
    values_.eval(next);
    findings_.settle();
    runUndecided(body, "in a loop whose rounds are not constant", true);
    return Flow::Next;
}

Statements::Flow Statements::runEach(const clang::CXXForRangeStmt& statement) {
    run(statement.getInit());
    const Value range = values_.eval(statement.getRangeInit());
    const clang::VarDecl& variable = *statement.getLoopVariable();
    clang::QualType type = statement.getRangeInit()->getType().getNonReferenceType();
    std::optional<std::uint64_t> size;
    if (const auto* array = context_.getAsConstantArrayType(type)) size = array->getSize().getZExtValue();
    const auto* record = type->getAsCXXRecordDecl();
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
    if (instance != nullptr && instance->isInStdNamespace() && instance->getName() == "array")
        size = instance->getTemplateArgs()[1].getAsIntegral().getZExtValue();
    // Lists in braces have a known length, and so do containers made from one, except those that sort their elements.
    const bool sorts = record != nullptr && (record->getName().contains("map") || record->getName().contains("set"));
    if (const auto known = sorts ? std::nullopt : memory_.sizeOf(range.place))
        size = static_cast<std::uint64_t>(*known);
    if (!range.is(Value::Kind::Place) || !size || *size > kMostRounds) {
        runUndecided(statement.getBody(), "in a loop over elements that are not constant", true);
        return Flow::Next;
    }
    for (std::uint64_t i = 0; i != *size; ++i) {
        const Place element = range.place.element(i);
        if (variable.getType()->isReferenceType()) {
            stack_.top().locals[&variable] = element;
        } else {
            const Place own = memory_.fresh();
            memory_.copy(element, own);
            stack_.top().locals[&variable] = own;
        }
        const Flow flow = run(statement.getBody());
        if (flow == Flow::Break) return Flow::Next;
        if (flow == Flow::Return) return flow;
    }
    return Flow::Next;
}

Statements::Flow Statements::runSwitch(const clang::SwitchStmt& statement) {
    run(statement.getInit());
    const Value value = values_.content(statement.getCond());
    const auto* block = dyn_cast<clang::CompoundStmt>(statement.getBody());
    const clang::SwitchCase* taken = nullptr;
    bool decided = value.is(Value::Kind::Number) && block != nullptr;
    for (const clang::SwitchCase* one = statement.getSwitchCaseList(); one != nullptr; one = one->getNextSwitchCase()) {
        const auto* label = dyn_cast<clang::CaseStmt>(one);
        if (label == nullptr) {
            if (taken == nullptr) taken = one;  // 'default'
            continue;
        }
        const Value wanted = values_.content(label->getLHS());
        decided = decided && wanted.is(Value::Kind::Number) && label->getRHS() == nullptr;
        if (decided && wanted.number == value.number) taken = one;
    }
    if (!decided || !findings_.isCertain()) {
        runUndecided(statement.getBody(), "in a 'switch' whose value is not constant", true);
        return Flow::Next;
    }
    bool reached = false;
    for (const clang::Stmt* part : block->body()) {
        // In "case 1: case 2: …" the second label is within the first.
        for (const clang::Stmt* label = part; !reached && llvm::isa<clang::SwitchCase>(label);
             label = llvm::cast<clang::SwitchCase>(label)->getSubStmt())
            reached = label == taken;
        const Flow flow = reached ? run(part) : Flow::Next;
        if (flow == Flow::Break) return Flow::Next;
        if (flow != Flow::Next) return flow;
    }
    return Flow::Next;
}

}  // namespace oroforge::cxx
