// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/checker/fibers.hpp>

#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <memory>
#include <ucontext.h>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif

namespace model {

namespace {
constexpr std::size_t kStack = std::size_t(256) << 10;
Fibers* active = nullptr;
}  // namespace

struct Fibers::Fiber {
    ucontext_t context;
    std::unique_ptr<unsigned char[]> stack;
    std::vector<unsigned char> variables;
    bool prepared = false;
    void* fake = nullptr;          // of AddressSanitizer
    const void* bottom = nullptr;  // of the stack
    std::size_t size = 0;
};

Fibers::Fibers(unsigned count) {
    for (unsigned i = 0; i <= count; ++i) {
        fibers_.push_back(new Fiber);
        if (i == count) break;
        fibers_[i]->stack.reset(new unsigned char[kStack]);
        fibers_[i]->bottom = fibers_[i]->stack.get();
        fibers_[i]->size = kStack;
    }
}

Fibers::~Fibers() {
    for (Fiber* fiber : fibers_) delete fiber;
}

void Fibers::entry() {
    Fibers& self = *active;
#if defined(__SANITIZE_ADDRESS__)
    Fiber& host = *self.fibers_.back();
    const void* bottom;
    std::size_t size;
    __sanitizer_finish_switch_fiber(nullptr, &bottom, &size);
    if (!host.bottom) {
        host.bottom = bottom;
        host.size = size;
    }
#endif
    self.body_(self.current_);
    std::abort();
}

void Fibers::prepare(unsigned number) {
    Fiber& fiber = *fibers_[number];
    if (fiber.prepared) return;
    fiber.prepared = true;
    fiber.fake = nullptr;
#if defined(__SANITIZE_ADDRESS__)
    ASAN_UNPOISON_MEMORY_REGION(fiber.stack.get(), kStack);  // of a forgotten run
#endif
    getcontext(&fiber.context);
    fiber.context.uc_stack.ss_sp = fiber.stack.get();
    fiber.context.uc_stack.ss_size = kStack;
    fiber.context.uc_link = nullptr;
    makecontext(&fiber.context, &Fibers::entry, 0);
}

void Fibers::swap(Fiber& from, Fiber& to) {
    std::size_t at = 0;
    for (const Variable& variable : variables_) {
        std::memcpy(&from.variables[at], variable.at, variable.size);
        std::memcpy(variable.at, &to.variables[at], variable.size);
        at += variable.size;
    }
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_start_switch_fiber(&from.fake, to.bottom, to.size);
#endif
    swapcontext(&from.context, &to.context);
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_finish_switch_fiber(from.fake, nullptr, nullptr);
#endif
}

void Fibers::run(unsigned number, void (*body)(unsigned)) {
    active = this;
    body_ = body;
    variables_.clear();
    for (Fiber* fiber : fibers_) {
        fiber->prepared = false;
        fiber->variables.clear();
    }
    threadLocal(abi::__cxa_get_globals(), 2 * sizeof(void*));  // the exceptions being handled
    current_ = number;
    prepare(number);
    swap(*fibers_.back(), *fibers_[number]);
}

void Fibers::leave() { swap(*fibers_[current_], *fibers_.back()); }

void Fibers::switchTo(unsigned number) {
    if (number == current_) return;
    Fiber& from = *fibers_[current_];
    current_ = number;
    prepare(number);
    swap(from, *fibers_[number]);
}

void Fibers::threadLocal(void* variable, std::size_t size) {
    variables_.push_back({static_cast<unsigned char*>(variable), size});
    for (Fiber* fiber : fibers_) fiber->variables.resize(fiber->variables.size() + size, 0);
    if (variables_.size() > 1) std::memset(variable, 0, size);  // the scenario's own copy; the host has none
}

}  // namespace model
