// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/options.hpp>

#include <iostream>

#include <CLI/CLI.hpp>

#include <diag/nearest_match.hpp>
#include <report/report.hpp>

namespace oroforge::driver {

namespace {

constexpr const char* kUsage =
    "Makes a package of components.\n"
    "\n"
    "  orocreate-pkg NAME [KIND...]           a new package in ./NAME from skeletons\n"
    "  orocreate-pkg NAME --from MANIFEST     a new package in ./NAME with the components that MANIFEST describes\n"
    "  orocreate-pkg --generate MANIFEST --output DIR\n"
    "                                         the base classes alone; what the package's build calls\n"
    "  orocreate-pkg --explain [CODE...]      what a code means, as the OM003 in \"error: [OM003] ...\"; none = list "
    "them\n"
    "\n"
    "Kinds, any number of them, none = all: component plugin service support typekit;\n"
    "cmake (only the build files), empty (only package.xml).\n";

constexpr const char* kHelpHint = "orocreate-pkg --help explains the command line";

void declare(CLI::App& app, Options& options) {
    app.add_option("words", options.words, "Name of the package, then its kinds")->type_name("NAME [KIND...]");
    app.add_option("--from", options.from, "Component manifest (XML) of the new package")->type_name("MANIFEST");
    app.add_option("--generate", options.generate, "Component manifest to generate base classes from")
        ->type_name("MANIFEST");
    app.add_option("-o,--output", options.output, "Directory for generated files")->type_name("DIR");
    app.add_flag("--list-outputs", options.listOutputs, "Print the files that --generate would write, and stop");
    app.add_option("--depfile", options.depfile, "Also write dependencies for make or ninja")->type_name("FILE");
    app.add_option("--depfile-target", options.depfileTarget, "What it is about, instead of the generated files")
        ->type_name("FILE");
    app.add_option("--template-dir", options.templateDir, "Templates here replace the built-in ones of the same name")
        ->type_name("DIR");
    app.add_option("--dump", options.dump, "Print an intermediate step of --generate as JSON: model or view")
        ->check(CLI::IsMember({"model", "view"}));
    app.add_option("--format", options.format, "How errors and warnings are told: text, json or sarif")
        ->check(CLI::IsMember(report::formatNames()));
    app.add_flag("--explain", options.explain, "Print what these codes of errors mean; without any list them all");
    app.add_flag("-f,--force", options.force,
                 "Write into an existing directory; sources there are kept, build files are kept as *.old");
    app.set_version_flag("--version", "orocreate-pkg (Oroforge) " OROFORGE_VERSION);
}

std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    }
    return names;
}

/// What is wrong with the command line, one text each.
std::vector<std::string> wordings(const CLI::App& app, const CLI::ParseError& error) {
    std::vector<std::string> texts;
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        for (const std::string& word : app.remaining()) {
            texts.push_back("unknown option '" + word + "'" + diag::didYouMean(word, optionNames(app)));
        }
    } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        const std::string text = error.what();
        texts.push_back("option '" + text.substr(0, text.find(':')) + "' needs a value");
    } else {
        texts.push_back(std::string("cannot use the command line: ") + error.what());
    }
    return texts;
}

/// Options that make no sense together.
void checkCombination(const Options& options, diag::Sink& sink) {
    const diag::Location here{"orocreate-pkg", 0, 0};
    const auto complain = [&](bool wrong, const char* text) {
        if (wrong) sink.error(here, "OC001", text).hint(kHelpHint);
    };
    if (options.explain) {
        complain(options.format != "text", "--explain prints text, so it takes no --format");
        complain(!options.generate.empty() || !options.from.empty(), "--explain takes codes and no manifest");
        return;
    }
    complain(options.format != "text" && (options.listOutputs || !options.dump.empty()),
             "--format excludes --list-outputs and --dump: both write to standard output");
    if (options.generate.empty()) {
        complain(options.words.empty() && options.from.empty(),
                 "no package name given, expected orocreate-pkg NAME [KIND...]");
        complain(options.listOutputs, "--list-outputs needs --generate MANIFEST");
        complain(!options.depfile.empty(), "--depfile needs --generate MANIFEST");
        complain(!options.depfileTarget.empty(), "--depfile-target needs --generate MANIFEST");
        complain(!options.output.empty(), "--output needs --generate MANIFEST");
        complain(!options.dump.empty(), "--dump needs --generate MANIFEST");
        complain(!options.from.empty() && options.words.size() > 1,
                 "--from and kinds exclude each other: the manifest says what the package contains");
        return;
    }
    complain(!options.words.empty() || !options.from.empty(), "--generate takes no package name and no --from");
    complain(options.output.empty() && options.dump.empty(), "--generate needs --output DIR");
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv, diag::Sink& sink, int& status) {
    Options options;
    CLI::App app(kUsage, "orocreate-pkg");
    app.set_help_flag("-h,--help", "Print this and stop");
    declare(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            status = app.exit(error);
            return std::nullopt;
        }
        for (const std::string& text : wordings(app, error))
            sink.error({"orocreate-pkg", 0, 0}, "OC001", text).hint(kHelpHint);
    }
    if (!sink.hadErrors()) checkCombination(options, sink);
    if (!sink.hadErrors()) return options;
    status = 1;
    return std::nullopt;
}

}  // namespace oroforge::driver
