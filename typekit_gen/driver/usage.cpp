// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "options.hpp"

namespace oroforge::typekit {

std::string usage() {
    return
        R"(usage: typegen [options] NAME HEADER...

Makes the source of a typekit plugin called NAME for the structs, classes and enums that are defined in the headers
(files, or folders to search), and for the types they use.

  -o, --output=DIR          where to generate; default ./NAME
  -i, --import=PACKAGE      add the include folders of PACKAGE, as pkg-config knows them; may be repeated
  -t, --transports=A,B      transports to generate for, instead of all that are installed (none, today)
  -n, --notransports=A,B    transports not to generate for
  -v, --verbose             say what is described and written
  -I DIR  -isystem DIR  -D MACRO[=VALUE]  -U MACRO  -include FILE  -std=STANDARD
                            as for a compiler; the default standard is c++17
      --list-outputs        print the names of the files that would be written, and do nothing else
      --flags-from=FILE     more of these options, one word a line; others that a compiler may have are left out
  -p, --compile-database=FILE|DIR
                            take these options from a compile_commands.json: from the entry of the source that includes
                            most of the headers, else is called as one of them, else lies next to them
      --compile-database-for=SOURCE|TARGET
                            from the entry of this source (or the end of its path), or of a source of this target
      --include-as=HEADER=NAME
                            generated code includes HEADER as <NAME>; may be repeated
      --pieces=HEADER=NUMBER
                            so many source files for the types of HEADER; may be repeated. Otherwise its size decides
      --check[=HOW]         write nothing; fail if the output folder does not hold what would be written. HOW: what to do
                            then, told instead of the command to run
      --adapters=FILE       how classes with private storage are seen, as XML; may be repeated. Those for Eigen and KDL are
                            built in
      --depfile=FILE        write the names of all files that were read, for make or ninja
      --depfile-target=FILE what depends on them; default all files that are generated
      --diff OLD NEW        instead of NAME HEADER...: tell what changed between two headers or folders, and whether it
                            breaks what was built before (exit status 1) or is compatible (0)
      --dump=model|view     print the model, or what the templates are filled with, as JSON and write nothing
      --format=text|json|sarif
                            how errors and warnings are told: text on standard error, or a document on standard output
      --strict              a class that is no value (virtual functions, private data) is an error, not left out with a
                            warning
      --explain [CODE...]   print what these codes mean, as the TK014 in "error: [TK014] ..."; without CODE list them all
      --template-dir=DIR    templates that replace the built-in ones
      --version, -h, --help

While the headers are read the macros __orogen, __orogen2 and OROCOS_TARGET are defined.
Nothing is read when neither the headers, nor what they include, nor the generated files have changed since the last run.
Environment: OROCOS_TARGET, PKG_CONFIG_PATH, TYPEGEN_RESOURCE_DIR (clang's builtin headers), TYPEGEN_CACHE (where to note
what the last run read and wrote; empty: nowhere).
)";
}

}  // namespace oroforge::typekit
