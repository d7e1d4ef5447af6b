// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A compiled piece of script: instructions on addresses, with everything to which they refer.
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

/** Executes the instruction and returns the next one, or null if the process stops for now. An exception ends the
    statement. */
typedef const Instruction* (*Action)(const Instruction& self, Process& process);

struct Instruction {
    Action act;
    const void* a;  ///< the operand that the action reads; jumps use `offset`
    union {
        const void* b;
        std::ptrdiff_t offset;  ///< the distance of a jump, in instructions
    };
    void* to;  ///< the operand that it writes
};

/** An intermediate number or truth value of an expression. */
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
 * The code of a program, function body, condition and so on. It belongs to one Process at a time, because its
 * instructions contain the addresses of its variables. It does not change or move after it was made.
 */
class Code {
public:
    Code() = default;
    Code(const Code&) = delete;
    Code& operator=(const Code&) = delete;

    const Instruction* begin() const { return instructions_.data(); }
    /** The last instruction ends the process or returns from the function. */
    std::size_t size() const { return instructions_.size(); }

    /** The place of the instruction's statement. */
    ast::Place placeOf(const Instruction* at) const;
    /** True for the first instruction of a statement. */
    bool beginsStatement(const Instruction* at) const;
    /** The first instruction of the same statement. */
    const Instruction* statementOf(const Instruction* at) const;
    /** The instruction to continue at if `at` fails; null if nothing catches the failure. */
    const Instruction* handlerOf(const Instruction* at) const;
    std::size_t statementCount() const { return marks_.size(); }

    // -- For the compiler -----------------------------------------------------------------------------------
    /** The index of the new instruction. */
    std::size_t add(Action act, const void* a = nullptr, const void* b = nullptr, void* to = nullptr);
    Instruction& at(std::size_t index) { return instructions_[index]; }
    /** Begins the statement at `place` with the next instruction. */
    void beginStatement(ast::Place place);
    /** Lets failures in [from, until) continue at `handler`. Inner guards are added first. */
    void guard(std::size_t from, std::size_t until, std::size_t handler);
    Cell* newCell();
    /** Moves the last instruction to that index. There must be no jumps from or to the instructions between. */
    void moveLast(std::size_t to);
    /** Removes the instructions from index `size` on. */
    void truncate(std::size_t size);
    /** Keeps an object as long as the code. */
    template <class Owned>
    void keep(Owned owned) {
        kept_.push_back(std::make_shared<Owned>(std::move(owned)));
    }
    base::DataSourceBase* keepSource(base::DataSourceBase::shared_ptr source) {
        sources_.push_back(std::move(source));
        return sources_.back().get();
    }

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
