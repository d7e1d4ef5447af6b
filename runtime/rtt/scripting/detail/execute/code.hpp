// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A piece of script in executable form: instructions on addresses, with everything they refer to.
#ifndef ORO_SCRIPTING_DETAIL_CODE_HPP
#define ORO_SCRIPTING_DETAIL_CODE_HPP

#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace RTT::scripting::detail {

class Process;
struct Instruction;

/** Does what the instruction says; returns the one to go on with, or null if the process stops here for now. What it throws
    ends the statement. */
typedef const Instruction* (*Action)(const Instruction& self, Process& process);

struct Instruction {
    Action act;
    const void* a;  ///< what the action reads; for jumps see `offset`
    union {
        const void* b;
        std::ptrdiff_t offset;  ///< of a jump: instructions from this one to its target
    };
    void* to;  ///< what it changes
};

/** A number or truth value that an expression computes on its way. */
union Cell {
    bool truth;
    char letter;
    int whole;
    unsigned int natural;
    long long wide;
    unsigned long long wideNatural;
    float single;
    double real;
};

/**
 * One program, function body, condition, … Made once; belongs to one Process at a time, since its instructions contain the
 * addresses of its variables. Does not move once it is made.
 */
class Code {
public:
    Code() = default;
    Code(const Code&) = delete;
    Code& operator=(const Code&) = delete;

    const Instruction* begin() const { return instructions_.data(); }
    /** The last instruction ends the process or returns from the function. */
    std::size_t size() const { return instructions_.size(); }

    /** Where the statement of that instruction begins. */
    ast::Place placeOf(const Instruction* at) const;
    /** True for the first instruction of a statement. */
    bool beginsStatement(const Instruction* at) const;
    /** The first instruction of that statement. */
    const Instruction* statementOf(const Instruction* at) const;
    /** Where to go on if `at` fails; null if nothing catches it. */
    const Instruction* handlerOf(const Instruction* at) const;
    std::size_t statementCount() const { return marks_.size(); }

    // -- For the compiler -----------------------------------------------------------------------------------
    std::size_t add(const Instruction& instruction);
    Instruction& at(std::size_t index) { return instructions_[index]; }
    /** The statement at `place` begins with the next instruction. */
    void beginStatement(ast::Place place);
    /** What fails in [from, until) goes on at `handler`. Inner ones are added first. */
    void guard(std::size_t from, std::size_t until, std::size_t handler);
    Cell* newCell();
    /** The last instruction becomes the one with that index. No jumps lead from and to those between. */
    void moveLast(std::size_t to);
    /** Takes back what was added since its size was `size`. */
    void truncate(std::size_t size);
    /** Keeps it alive as long as the code. */
    template <class Owned>
    void keep(Owned owned) {
        kept_.push_back(std::make_shared<Owned>(std::move(owned)));
    }
    void keep(base::DataSourceBase::shared_ptr source) { sources_.push_back(std::move(source)); }

private:
    struct Mark {
        std::uint32_t at;
        ast::Place place;
    };
    struct Guard {
        std::uint32_t from, until, handler;
    };
    const Mark* markOf(const Instruction* at) const;

    std::vector<Instruction> instructions_;
    std::vector<Mark> marks_;  // ascending
    std::vector<Guard> guards_;
    std::deque<Cell> cells_;
    std::vector<base::DataSourceBase::shared_ptr> sources_;
    std::vector<std::shared_ptr<void>> kept_;
};

}  // namespace RTT::scripting::detail

#endif
