// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The syntax tree of a script, with places, before any name is resolved.
#ifndef ORO_SCRIPTING_DETAIL_AST_HPP
#define ORO_SCRIPTING_DETAIL_AST_HPP

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace RTT::scripting::detail {
namespace ast {

/** A place in the script; lines and columns count from 1, columns in bytes. */
struct Place {
    unsigned line = 0, column = 0;
};

struct Identifier {
    std::string text;
    Place at;
};

struct Expression;
typedef std::unique_ptr<Expression> ExpressionPtr;
typedef std::vector<ExpressionPtr> Expressions;

/** A number, text or truth value as written. `1.0f` is a float, `1.0` a double, `0xFF` and `1u` unsigned. */
typedef std::variant<bool, char, int, unsigned int, long long, unsigned long long, float, double, std::string> Value;

struct Literal {
    Value value;
};
/** The word `time`: the present time in seconds. */
struct CurrentTime {};
/** `a.b.c`, `a.b.c(…)`, `KDL.Vector(…)`, `ints[](…)`, `vector<double>(…)`: its meaning depends on the names at run
    time. A type name with template arguments is one part. */
struct Name {
    std::vector<Identifier> parts;  ///< at least one
    bool called = false;            ///< has an argument list, perhaps an empty one
    Expressions arguments;
};
/** `of.member`, where `of` is not a plain name. */
struct Member {
    ExpressionPtr of;
    Identifier member;
};
struct Index {
    ExpressionPtr of, index;
};
struct Unary {
    char op;  ///< '+', '-', '!'
    ExpressionPtr operand;
};
/** Operators in a row, from left to right: `((first op right) op right) …`. A list, so that long rows are not
    nested. */
struct Binary {
    struct Step {
        std::string op;  ///< && || != == >= > <= < + - % * /
        Place at;        ///< the operator
        ExpressionPtr right;
    };
    ExpressionPtr first;
    std::vector<Step> steps;  ///< at least one
};
struct Assignment {
    ExpressionPtr to, value;
};

struct Expression {
    Place at;  ///< its first letter; of an assignment, the operator; of binary operations, the last of them
    std::variant<Literal, CurrentTime, Name, Member, Index, Unary, Binary, Assignment> what;
};

struct Statement;
typedef std::unique_ptr<Statement> StatementPtr;

struct Block {
    Place at;   ///< its first statement or '{'
    Place end;  ///< its last statement or '}'
    std::vector<StatementPtr> statements;
};

/** One name of a `var`, `const`, `alias` or `param`. */
struct Declarator {
    Identifier name;
    ExpressionPtr size;   ///< of `name(size)`; or null
    ExpressionPtr value;  ///< or null
};
struct Declaration {
    enum class Kind { Variable, Constant, Alias, Parameter };
    Kind kind;
    Identifier type;
    std::vector<Declarator> names;
};
/** An expression whose value is not used; also after `do`, `set`, `call`. */
struct Do {
    ExpressionPtr expression;
};
struct Nothing {};
struct Yield {};
struct Try {
    ExpressionPtr attempt;
    std::unique_ptr<Block> handler;  ///< null without `catch`
};
struct Return {
    ExpressionPtr value;  ///< or null
};
struct If {
    ExpressionPtr condition;
    Block then;
    std::unique_ptr<Block> otherwise;  ///< or null
};
struct While {
    ExpressionPtr condition;
    Block body;
};
struct For {
    StatementPtr first;  ///< a Declaration, Do or Nothing
    ExpressionPtr condition;
    ExpressionPtr next;
    Block body;
};
struct Break {};

struct Statement {
    Place at;
    std::variant<Declaration, Do, Nothing, Yield, Try, Return, If, While, For, Break> what;
};

struct Function {
    enum class Scope { Local, Exported, Global };  ///< Local: without a keyword, or with `local`
    struct Argument {
        Identifier type, name;
        ExpressionPtr size;  ///< of `name(size)`; or null
    };
    Scope scope = Scope::Local;
    Identifier type;  ///< "void" for `function`
    Identifier name;
    std::vector<Argument> arguments;
    Block body;
};

struct Program {
    Identifier name;
    Block body;
};

/** `select A or B`, `{ program } select A`: the next state. Without a state, the machine stays. */
struct Selection {
    Place at;
    std::vector<Identifier> states;
    std::unique_ptr<Block> program;  ///< or null
};
/** `if c then select A else select B`, `select A`, `port(x) select A`, `peer.event(a, b) if c then …`. */
struct Transition {
    Place at;
    std::vector<Identifier> event;  ///< path of the operation or port; empty without
    Expressions arguments;          ///< of the event
    ExpressionPtr condition;        ///< null: always
    Selection selection;
    std::unique_ptr<Selection> otherwise;  ///< or null
};
struct State {
    Identifier name;
    bool initial = false, final = false;
    Place end;                                        ///< its '}'
    std::vector<StatementPtr> locals;                 ///< Declarations
    std::unique_ptr<Block> entry, run, handle, exit;  ///< or null
    Expressions preconditions;
    std::vector<Transition> detours;  ///< of `preconditions { if c then select S }`; without events
    std::vector<Transition> transitions;
};
/** `SubMachine Type name(p = 1, q = 2)` and `RootMachine …`. */
struct Instance {
    struct Argument {
        Identifier name;
        ExpressionPtr value;
    };
    Place at;
    Identifier type, name;
    std::vector<Argument> arguments;
};
struct StateMachine {
    Identifier type;
    Place end;                         ///< its '}'
    std::vector<StatementPtr> locals;  ///< Declarations, in the order of the text
    std::vector<Instance> subMachines;
    std::vector<Transition> transitions;  ///< transitions from every state
    std::vector<State> states;
};

/** An item at the top level of a file. */
struct Item {
    Place at, end;                                                               ///< first and last letter
    std::size_t begin = 0, size = 0;                                             ///< its bytes in the text
    std::variant<StatementPtr, Function, Program, StateMachine, Instance> what;  ///< Instance: RootMachine
};

struct Script {
    std::vector<Item> items;
};

}  // namespace ast
}  // namespace RTT::scripting::detail

#endif
