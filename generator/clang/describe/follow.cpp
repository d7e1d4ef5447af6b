// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "follow.hpp"

#include "evaluator.hpp"
#include "interface_calls.hpp"

namespace oroforge::cxx {

namespace {

/// All parts; each of them knows the others.
struct Parts {
    Findings findings;
    Memory memory{findings};
    CallStack stack{findings};
    Registry registry;
    Part all;
    Statements statements{all};
    Expressions values{all};
    Calls calls{all};
    Objects objects{all};
    Texts texts{all};
    Containers containers{all};
    KnownObjects known{all};
    InterfaceCalls interface { all };

    Parts(clang::ASTContext& context, const SourcePlaces& places, diag::Sink& remarks)
        : findings(context.getSourceManager(), places, remarks), all{context,    findings, memory,   stack,   registry,
                                                                     statements, values,   calls,    objects, texts,
                                                                     containers, known,    interface} {}
};

}  // namespace

Followed follow(const clang::CXXConstructorDecl& constructor, const SourcePlaces& places, diag::Sink& remarks) {
    Parts parts(constructor.getASTContext(), places, remarks);
    CallStack::Frame outermost;
    outermost.self = Place::component();
    parts.stack.enter(outermost);
    Values arguments;
    for (const clang::ParmVarDecl* parameter : constructor.parameters()) {
        // An inherited constructor is called with the defaults of the one in the base class.
        const unsigned i = parameter->getFunctionScopeIndex();
        const clang::CXXConstructorDecl* inherited = constructor.getInheritedConstructor().getConstructor();
        if (inherited != nullptr) parameter = inherited->getParamDecl(i);
        const bool hasDefault = parameter->hasDefaultArg() && !parameter->hasUninstantiatedDefaultArg();
        arguments.push_back(hasDefault ? parts.values.eval(parameter->getDefaultArg()) : Value());
    }
    parts.objects.construct(Place::component(), constructor, arguments);
    Followed made;
    readResult(parts.all, made);
    followLate(parts.all, *constructor.getParent());
    made.hasMore = parts.findings.hasMore();
    made.unseen = parts.findings.unseen();
    return made;
}

}  // namespace oroforge::cxx
