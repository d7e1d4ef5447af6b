// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Only this file includes clang and llvm headers: adapt to another LLVM version here.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_LLVM_COMPAT_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_LLVM_COMPAT_HPP

// Their headers do not meet our warning level.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wextra"
#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/RawCommentList.h>
#include <clang/AST/RecordLayout.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/AST/StmtCXX.h>
#include <clang/Basic/DiagnosticSema.h>
#include <clang/Basic/Version.inc>
#include <clang/Format/Format.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/CompilerInvocation.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/Utils.h>
#include <clang/Lex/HeaderSearch.h>
#include <clang/Lex/LexDiagnostic.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/LiteralSupport.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Lex/PreprocessorOptions.h>
#include <clang/Sema/Initialization.h>
#include <clang/Sema/Sema.h>
#include <clang/Sema/SemaConsumer.h>
#include <llvm/ADT/SmallString.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/VirtualFileSystem.h>
#pragma GCC diagnostic pop

#if CLANG_VERSION_MAJOR != 19
#error "typegen is written against clang 19; adapt generator/clang/llvm_compat.hpp to this version"
#endif

#endif
