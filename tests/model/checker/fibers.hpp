// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Fibers: stacks that one system thread switches between, each with its own copy of chosen thread-local variables.
#ifndef OROFORGE_MODEL_FIBERS_HPP
#define OROFORGE_MODEL_FIBERS_HPP

#include <cstddef>
#include <vector>

namespace model {

class Fibers {
public:
    explicit Fibers(unsigned count);
    ~Fibers();
    Fibers(const Fibers&) = delete;
    Fibers& operator=(const Fibers&) = delete;

    /** Starts anew with fiber `number`; returns when a fiber calls leave(). All others are forgotten. `body` gets the
        number of each fiber that is entered for the first time, and never returns. */
    void run(unsigned number, void (*body)(unsigned));
    void leave();
    void switchTo(unsigned number);
    unsigned current() const { return current_; }

    void threadLocal(void* variable, std::size_t size);

private:
    struct Fiber;
    struct Variable {
        unsigned char* at;
        std::size_t size;
    };
    void prepare(unsigned number);
    void swap(Fiber& from, Fiber& to);
    static void entry();

    std::vector<Fiber*> fibers_;  // the last one is the host
    std::vector<Variable> variables_;
    unsigned current_ = 0;
    void (*body_)(unsigned) = nullptr;
};

}  // namespace model

#endif
